"""The axis in the viewport: the dot at its tip is dragged towards x, y or z."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.hand.coordinates import ScreenPoint
from app.hand.snapping import DragKeys
from app.state.presenter import Frame, Presenter
from app.viewport.half_plane import Lens
from sgb_core.arrays import Floats
from sgb_core.document import edits
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.values import dataclass

# The tip stands this far above the profile, as a part of its largest extent.
ABOVE = 0.08


@dataclass(frozen=True, slots=True)
class AxisTip:
    """The handle at the upper end of the axis; there is one."""


@dataclass(frozen=True, slots=True)
class AxisDrag:
    """A drag of the axis, begun once the hand has moved far enough from ``press``."""

    press: ScreenPoint
    moved: bool = False
    label = "Axis"
    held = AxisTip()

    def pulled(
        self, presenter: Presenter, frame: Frame, lens: Lens, at: ScreenPoint, _keys: DragKeys
    ) -> AxisDrag:
        """Turn about the axis whose end is nearest to the hand."""
        seen = frame.evaluation
        axis = AxisChoice.of(seen.surface, *seen.bounds).nearest(lens, at)
        presenter.apply(lambda d: edits.set_revolution(d, axis=axis))
        return replace(self, moved=True)


@dataclass(frozen=True, slots=True, eq=False)
class AxisChoice:
    """The three axes that there are to choose from, placed in space.

    ``tips`` (3, 3) are the ends of the axes x, y and z as far from ``origin`` (3,) as the
    present one reaches.
    """

    origin: Floats
    tips: Floats

    @classmethod
    def of(cls, surface: RevolutionSurface, low: Floats, high: Floats) -> AxisChoice:
        """Return the choice for a profile that lies between the corners ``low`` and ``high``."""
        extent = max(float(np.max(np.abs((low[0], high[0])))), float(high[1] - low[1]))
        length = max(float(high[1]), 0.0) + ABOVE * extent
        origin = np.asarray(surface.placement.translation, dtype=np.float64)
        return cls(origin, origin + length * surface.placement.apply_to_directions(np.eye(3)))

    def tip(self, axis: Axis) -> Floats:
        """Return the end of one axis, shape (1, 3)."""
        return self.tips[[tuple(Axis).index(axis)]]

    def nearest(self, lens: Lens, at: ScreenPoint) -> Axis:
        """Return the axis whose end is seen nearest to a pixel."""
        away = lens.to_screen(self.tips) - (at.x, at.y)
        return tuple(Axis)[int(np.hypot(*away.T).argmin())]

    @property
    def lines(self) -> tuple[Floats, ...]:
        """The three axes from the origin to their ends, each of shape (2, 3)."""
        return tuple(np.stack([self.origin, tip]) for tip in self.tips)
