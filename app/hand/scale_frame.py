"""The frame around several selected points: handles that scale them together, a body to move."""

from __future__ import annotations

import math
from collections.abc import Collection

import numpy as np
from PySide6.QtCore import QRectF, Qt

from app.hand.canvas import Canvas
from app.hand.coordinates import Area, DesignPoint, Paper, ScreenPoint, decimals_for, number
from app.hand.hit_test import Handle, PointId, Target, canonical
from sgb_core.curves.profile import Profile
from sgb_core.values import dataclass

# The frame keeps this far, in pixels, from the points; a handle is grabbed this near.
MARGIN = 15.0
REACH = 7.0
_HANDLE = 3.5
# Points are never scaled to less than this: they could not be drawn apart again.
LEAST = 1e-3
# Where the handles sit, counter-clockwise from the lower left: −1, 0, 1 in r and in h.
SIDES = ((-1, -1), (0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0))


@dataclass(frozen=True, slots=True)
class PointFrame:
    """The box around selected points, from ``low`` to ``high`` in design coordinates."""

    points: tuple[PointId, ...]
    low: DesignPoint
    high: DesignPoint

    @classmethod
    def of(cls, profile: Profile, chosen: Collection[PointId]) -> PointFrame | None:
        """Return the frame of the chosen points; None for less than two different places."""
        points = tuple(canonical(profile, chosen))
        if len(points) < 2:
            return None
        places = np.array([profile.segments[segment].points[k] for segment, k in points])
        low, high = places.min(axis=0), places.max(axis=0)
        return (
            None
            if np.array_equal(low, high)
            else cls(points, DesignPoint.of(low), DesignPoint.of(high))
        )

    @property
    def sides(self) -> list[int]:
        """The handles that there are: none across a direction in which all points are level."""
        wide, tall = self.high.r > self.low.r, self.high.h > self.low.h
        return [k for k, (x, y) in enumerate(SIDES) if (wide or x == 0) and (tall or y == 0)]

    def place(self, side: int) -> DesignPoint:
        """Return where a corner, or the middle of an edge, lies."""
        x, y = SIDES[side]
        return self._at(x, y)

    def _at(self, x: float, y: float) -> DesignPoint:
        r = self.low.r + 0.5 * (1 + x) * (self.high.r - self.low.r)
        h = self.low.h + 0.5 * (1 + y) * (self.high.h - self.low.h)
        return DesignPoint(r, h)

    def fixed(self, side: int, *, centred: bool) -> DesignPoint:
        """Return what stays where it is: the opposite side, or the centre."""
        x, y = SIDES[side]
        return self._at(0, 0) if centred else self._at(-x, -y)

    def factors(
        self, side: int, to: DesignPoint, *, proportional: bool, centred: bool
    ) -> tuple[float, float]:
        """Return by what the points are scaled in r and in h when a handle is drawn somewhere."""
        fixed, begun = self.fixed(side, centred=centred), self.place(side)
        arm = np.array((begun.r - fixed.r, begun.h - fixed.h))
        now = np.array((to.r - fixed.r, to.h - fixed.h))
        if proportional:
            # An edge counts across itself only; a corner where the hand is along its diagonal.
            arm *= np.abs(SIDES[side])
            both = _at_least(float(now @ arm) / float(arm @ arm))
            return both, both
        x, y = SIDES[side]
        return (
            _at_least(float(now[0] / arm[0])) if x else 1.0,
            _at_least(float(now[1] / arm[1])) if y else 1.0,
        )

    def area(self, paper: Paper) -> Area:
        """Return the frame on the screen."""
        (left, bottom), (right, top) = paper.map((self.low.pair, self.high.pair)).tolist()
        return Area(left, top, right, bottom).grown(MARGIN)

    def grip(self, side: int, paper: Paper) -> ScreenPoint:
        """Return where a handle is on the screen."""
        area, (x, y) = self.area(paper), SIDES[side]
        return ScreenPoint(
            area.left + 0.5 * (1 + x) * area.width, area.bottom - 0.5 * (1 + y) * area.height
        )

    def pick_grip(self, paper: Paper, at: ScreenPoint) -> Handle | None:
        """Return the handle under the pointer."""
        for side in self.sides:
            place = self.grip(side, paper)
            if max(abs(place.x - at.x), abs(place.y - at.y)) <= REACH:
                return Handle(Target.GRIP, self.points[0][0], side)
        return None

    def pick_body(self, paper: Paper, at: ScreenPoint) -> Handle | None:
        """Return the whole frame where the pointer is inside."""
        inside = self.area(paper).contains(at)
        return Handle(Target.BODY, self.points[0][0]) if inside else None

    def nearest(self, profile: Profile, to: DesignPoint) -> PointId:
        """Return the point of the frame that is nearest to a place."""
        places = np.array([profile.segments[segment].points[k] for segment, k in self.points])
        return self.points[int(np.hypot(*(places - to.pair).T).argmin())]

    def lines(self, factors: tuple[float, float] | None, scale: float, unit: str) -> list[str]:
        """Return what the heads-up label says: how many, how large, and by what they are scaled."""
        decimals = decimals_for(1.0 / scale)
        sides = (self.high.r - self.low.r, self.high.h - self.low.h)
        lines = [
            f"{len(self.points)} points",
            " × ".join(number(side, decimals) for side in sides) + f" {unit}",
        ]
        if factors is not None:
            r, h = (number(factor, 3) for factor in factors)
            lines.insert(1, f"r × {r}   h × {h}" if r != h else f"× {r}")
        return lines


def _at_least(factor: float) -> float:
    return math.copysign(max(abs(factor), LEAST), factor)


def draw_frame(canvas: Canvas, frame: PointFrame, active: Handle | None) -> None:
    """Draw the frame and its handles, the one under the pointer full."""
    area, painter = frame.area(canvas.transform), canvas.painter
    painter.setPen(canvas.pen("accent", 1.0, 150, Qt.PenStyle.DashLine))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRect(QRectF(area.left, area.top, area.width, area.height))
    painter.setPen(canvas.pen("accent", 1.4))
    for side in frame.sides:
        at = frame.grip(side, canvas.transform)
        lit = active is not None and active.target is Target.GRIP and active.index == side
        painter.setBrush(canvas.color("accent" if lit else "canvas"))
        half = _HANDLE + (1.0 if lit else 0.0)
        painter.drawRect(QRectF(at.x - half, at.y - half, 2.0 * half, 2.0 * half))
        canvas.occupy(QRectF(at.x - 7.0, at.y - 7.0, 14.0, 14.0))
    painter.setBrush(Qt.BrushStyle.NoBrush)
