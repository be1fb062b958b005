"""What the window shows beyond the document: selection, overlays, projection. Never undone."""

from __future__ import annotations

from typing import Literal, TypedDict

from app.state.cut import Cut
from app.state.overlays import SHOWN_AT_FIRST, Overlay
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import ParameterName
from sgb_core.document.model import Document
from sgb_core.values import dataclass

Compare = Literal["saved", "cubic"]
LiveFairing = Literal["bending", "variation", "surface"]


@dataclass(frozen=True, slots=True)
class Hover:
    """The slider under the pointer: which parameter of which segment (None: of all)."""

    parameter: ParameterName
    segment: int | None

    def segments(self, count: int) -> list[int]:
        """Return which segments of ``count`` the slider acts on: one, all, or one that is gone."""
        if self.segment is None:
            return list(range(count))
        return [self.segment] if 0 <= self.segment < count else []


@dataclass(frozen=True, slots=True)
class ViewState:
    """A frozen snapshot of everything on screen that the document does not hold.

    ``segment`` is the selected segment and ``points`` the selected control points as
    (segment, index) pairs. ``ghost_state`` names the state of the document that is laid over it,
    ``ghost`` is a version from elsewhere that is.
    ``tool`` names the tool in the hand of the profile editor.
    ``angle`` is the one that is pointed at, in degrees from the start; ``compare`` what the
    document is compared with; ``influence`` the parameter whose influence colours the surface,
    with ``influence_follows`` always that of the slider used last;
    ``comb_length`` scales the curvature comb; ``mark`` is a place (segment, s) pointed at
    elsewhere; ``preview`` a profile that is offered but not yet accepted; ``before`` the document
    before the last edit, where that edit is to be seen beside it, combs included; ``cut`` what is
    left away to look inside; ``live_fair`` the energy that segments beside points in the hand
    are to have least of while these move, None where they stay as they are;
    ``dimensions_in_space`` whether the viewport shows the dimensions, too; ``path_measure`` is what
    a print path is coloured by (of :data:`app.state.path_colours.MEASURES`) and ``path_moment`` up
    to which share of its time it is shown.
    """

    segment: int = 0
    points: frozenset[tuple[int, int]] = frozenset()
    all_segments: bool = False
    show: frozenset[Overlay] = SHOWN_AT_FIRST
    projection: Literal["perspective", "parallel"] = "perspective"
    snap: bool = False
    tool: str = "select"
    hover: Hover | None = None
    angle: float | None = None
    compare: Compare | None = None
    influence: ParameterName | None = None
    influence_follows: bool = False
    comb_length: float = 1.0
    mark: tuple[int, float] | None = None
    preview: Profile | None = None
    before: Document | None = None
    ghost_state: str | None = None
    ghost: Document | None = None
    cut: Cut = Cut.NONE
    live_fair: LiveFairing | None = None
    dimensions_in_space: bool = False
    path_measure: str = "lean"
    path_moment: float = 1.0

    @property
    def influenced(self) -> int | None:
        """The segment whose parameter colours the surface, None for all: the one in use."""
        if self.influence_follows and self.hover is not None:
            return self.hover.segment
        return None if self.all_segments else self.segment

    def shows(self, overlay: Overlay) -> bool:
        """Whether an overlay is switched on."""
        return overlay in self.show


class ViewChanges(TypedDict, total=False):
    """What :meth:`app.state.presenter.Presenter.set_view` takes: the fields of ViewState."""

    segment: int
    points: frozenset[tuple[int, int]]
    all_segments: bool
    show: frozenset[Overlay]
    projection: Literal["perspective", "parallel"]
    snap: bool
    tool: str
    hover: Hover | None
    angle: float | None
    compare: Compare | None
    influence: ParameterName | None
    influence_follows: bool
    comb_length: float
    mark: tuple[int, float] | None
    preview: Profile | None
    before: Document | None
    ghost_state: str | None
    ghost: Document | None
    cut: Cut
    live_fair: LiveFairing | None
    dimensions_in_space: bool
    path_measure: str
    path_moment: float
