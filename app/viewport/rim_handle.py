"""The rim in the viewport: taken hold of and turned, it twists what stands below it."""

from __future__ import annotations

from dataclasses import replace
from math import pi, tau

import numpy as np

from app.hand.coordinates import ScreenPoint
from app.hand.snapping import DragKeys
from app.state.presenter import Frame, Presenter
from app.viewport.half_plane import Lens, Ring
from sgb_core.arrays import Floats
from sgb_core.document import edits
from sgb_core.document.evaluation import Evaluation
from sgb_core.values import dataclass

# The ring stands this far outside the widest place; dragging snaps to parts of a turn.
_OUTSIDE = 1.06
_SNAP = 1.0 / 24.0


@dataclass(frozen=True, slots=True)
class RimGrip:
    """The handle on the rim that twists; there is one."""


@dataclass(frozen=True, slots=True)
class RimDrag:
    """A drag of the rim: the twist before it, and the angle under the hand, its turns counted."""

    press: ScreenPoint
    before: float
    grabbed: float
    angle: float
    moved: bool = False
    label = "Twist"
    held = RimGrip()

    def pulled(
        self, presenter: Presenter, frame: Frame, lens: Lens, at: ScreenPoint, keys: DragKeys
    ) -> RimDrag:
        """Twist as far as the hand has turned the rim."""
        angle = Rim(frame.evaluation).ring.angle_at(lens, at, self.angle)
        drag = replace(self, angle=angle, moved=True)
        turns = drag.turns(snap=not keys.free)
        presenter.apply(lambda d: edits.set_twist(d, turns=turns))
        return drag

    def turns(self, *, snap: bool) -> float:
        """Return the twist that the hand asks for, to 24ths of a turn where it snaps."""
        wanted = self.before + (self.angle - self.grabbed) / tau
        return _SNAP * round(wanted / _SNAP) if snap else wanted


@dataclass(frozen=True, slots=True, eq=False)
class Rim:
    """Where the handle is: on a ring around the top, opposite the start, turned by the twist."""

    evaluation: Evaluation

    @property
    def shown(self) -> bool:
        """Whether there is anything to twist: laws, or a twist to take back."""
        document = self.evaluation.document
        return bool(document.variation) or document.twist.turns != 0.0

    @property
    def ring(self) -> Ring:
        """The circle on which the handle goes."""
        low, high = self.evaluation.bounds
        radius = _OUTSIDE * max(abs(float(low[0])), abs(float(high[0])))
        return Ring.of(self.evaluation.surface, radius, float(high[1]))

    @property
    def angle(self) -> float:
        """Where on it the handle is."""
        surface = self.evaluation.surface
        away = min(pi, surface.sweep / 2.0)
        return surface.start + away + tau * surface.twist.turns

    @property
    def place(self) -> Floats:
        """Where the handle is in space, shape (1, 3), or (0, 3) where there is none."""
        return self.ring.in_space((self.angle,)) if self.shown else np.zeros((0, 3))

    def grab(self, lens: Lens, at: ScreenPoint) -> RimDrag:
        """Return the drag that a press begins."""
        angle = self.ring.angle_at(lens, at, self.angle)
        return RimDrag(at, self.evaluation.document.twist.turns, angle, angle)

    @property
    def lines(self) -> tuple[Floats, ...]:
        """The ring, and the spokes to where the rim would be untwisted and to where it is."""
        ring, surface = self.ring, self.evaluation.surface
        plain = self.angle - tau * surface.twist.turns
        spokes = (np.stack([ring.centre, ring.in_space(a)]) for a in (plain, self.angle))
        return ring.in_space(np.linspace(0.0, tau, 97)), *spokes
