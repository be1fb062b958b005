"""Where a dragged point lands: keys, grid, axis, and the points with which it lines up."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from app.hand.coordinates import DesignPoint, GridSteps
from app.hand.hit_test import PointId, twin
from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.values import dataclass

AXIS_REACH = 6.0
# While it snaps a dragged point is drawn this far, in pixels, to where it lines up with others.
MAGNET_REACH = 6.0
# Without, it lines up only where it stays under the cursor.
ALIGN_REACH = 0.7
# Values nearer than this part of the larger one lie on one line.
_SAME = 1e-9

Direction = tuple[float, float]


@dataclass(frozen=True, slots=True)
class DragKeys:
    """The modifier keys by what they mean during a drag."""

    free: bool = False  # Ctrl: no snapping
    constrain: bool = False  # Shift: horizontal, vertical or along the leg
    break_rule: bool = False  # Alt: the joint's rule does not hold for this drag


@dataclass(frozen=True, slots=True)
class Snapping:
    """What a drag may snap to; both reaches are in design units.

    ``others``, shape (m, 2), are the points with whose r or h the dragged one may line up;
    ``guides`` the radii and the heights of guides, which draw it to themselves.
    """

    grid: GridSteps | None
    axis_reach: float
    others: Floats | None = None
    align_reach: float = 0.0
    guides: tuple[tuple[float, ...], tuple[float, ...]] = ((), ())
    guide_reach: float = 0.0

    def pulled(self, value: float, coordinate: int) -> tuple[float, float | None]:
        """Return where an r (0) or h (1) is drawn to, and that of a point it then lines up with.

        A guide comes before another point, and this before the grid, which is near everywhere.
        """
        lines = self.guides[coordinate]
        onto = min(lines, key=lambda line: abs(line - value), default=None)
        if onto is not None and abs(onto - value) <= self.guide_reach:
            return onto, onto
        beside = self._nearest(value, coordinate, self.align_reach)
        if beside is None and self.grid is not None:
            value = self.grid.snapped(value)
            beside = self._nearest(value, coordinate, _SAME * abs(value))
        return (value, None) if beside is None else (beside, beside)

    def _nearest(self, value: float, coordinate: int, reach: float) -> float | None:
        if self.others is None or len(self.others) == 0:
            return None
        values = self.others[:, coordinate]
        nearest = float(values[np.abs(values - value).argmin()])
        return nearest if abs(nearest - value) <= reach else None


@dataclass(frozen=True, slots=True)
class Landing:
    """Where a dragged point lands, along which direction it was held, and on what it snapped.

    ``factors`` is by what a grip scales in r and in h.
    """

    point: DesignPoint
    guide: Direction | None = None
    on_axis: bool = False
    aligned: tuple[float | None, float | None] = (None, None)
    factors: tuple[float, float] | None = None


def leg_directions(profile: Profile, point: PointId) -> list[Direction]:
    """Return the unit directions of the legs that meet at a control point."""
    segment, index = point
    places = profile.segments[segment].points
    found = []
    for other in (index - 1, index + 1):
        if 0 <= other <= 3:
            step = places[other] - places[index]
            length = math.hypot(*step)
            if length > 0.0:
                found.append((float(step[0]) / length, float(step[1]) / length))
    return found


def other_points(profile: Profile, moved: Iterable[PointId]) -> Floats:
    """Return the points, shape (m, 2), that stay where they are while some are moved.

    A joint, and an end, carries its legs.
    """
    going: set[PointId] = set()
    for point in moved:
        for segment, index in {point, twin(profile, point) or point}:
            carried = {0: (0, 1), 3: (2, 3)}.get(index, (index,))
            going.update((segment, other) for other in carried)
    keys = [(s, k) for s in range(len(profile)) for k in range(4) if (s, k) not in going]
    points = profile.control_points
    return np.array([points[key] for key in keys]).reshape(-1, 2)


def land(
    start: DesignPoint,
    cursor: DesignPoint,
    keys: DragKeys,
    snapping: Snapping,
    legs: Iterable[Direction] = (),
) -> Landing:
    """Return where a point dragged from ``start`` to the cursor lands."""
    if keys.constrain:
        return _land_along(start, cursor, keys, snapping, legs)
    if keys.free:
        return Landing(cursor)
    (r, beside), (h, level) = snapping.pulled(cursor.r, 0), snapping.pulled(cursor.h, 1)
    if abs(cursor.r) <= snapping.axis_reach:
        return Landing(DesignPoint(0.0, h), on_axis=True, aligned=(None, level))
    return Landing(DesignPoint(r, h), aligned=(beside, level))


def _land_along(
    start: DesignPoint,
    cursor: DesignPoint,
    keys: DragKeys,
    snapping: Snapping,
    legs: Iterable[Direction],
) -> Landing:
    dr, dh = cursor.r - start.r, cursor.h - start.h
    directions = [(1.0, 0.0), (0.0, 1.0), *legs]
    # The direction that the hand is nearest to is the one along which it gets farthest.
    ur, uh = max(directions, key=lambda u: abs(u[0] * dr + u[1] * dh))
    along = ur * dr + uh * dh
    r, h = start.r + along * ur, start.h + along * uh
    guide = (ur, uh)
    if keys.free:
        return Landing(DesignPoint(r, h), guide)
    if abs(r) <= snapping.axis_reach and abs(ur) > 1e-9:
        # Still on the guide: where it meets the axis.
        return Landing(DesignPoint(0.0, start.h - start.r * uh / ur), guide, on_axis=True)
    beside = level = None
    if uh == 0.0:
        r, beside = snapping.pulled(r, 0)
    elif ur == 0.0:
        h, level = snapping.pulled(h, 1)
    return Landing(DesignPoint(r, h), guide, aligned=(beside, level))
