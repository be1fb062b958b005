"""What the window shows beyond the document: selection, overlays, projection. Never undone."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from sgb_core.curves.segment import ParameterName

Overlay = Literal[
    "surface",
    "generatrix",
    "polygon",
    "circles",
    "axes",
    "mesh",
    "ghost",
    "quartic",
    "comb",
]

DEFAULT_OVERLAYS: frozenset[Overlay] = frozenset(
    ("surface", "generatrix", "polygon", "circles", "ghost", "quartic")
)


@dataclass(frozen=True, slots=True)
class Hover:
    """The slider under the pointer: which parameter of which segment (None: of all)."""

    parameter: ParameterName
    segment: int | None


@dataclass(frozen=True, slots=True)
class ViewState:
    """A frozen snapshot of everything on screen that the document does not hold.

    ``segment`` is the selected segment and ``points`` the selected control points as
    (segment, index) pairs.
    """

    segment: int = 0
    points: frozenset[tuple[int, int]] = frozenset()
    all_segments: bool = False
    show: frozenset[Overlay] = field(default=DEFAULT_OVERLAYS)
    projection: Literal["perspective", "parallel"] = "perspective"
    snap: bool = False
    hover: Hover | None = None

    def shows(self, overlay: Overlay) -> bool:
        """Whether an overlay is switched on."""
        return overlay in self.show
