"""One hole: an outline, and where its places lie in space.

A place of a hole is (x, y, d): around and up in the plane of the outline, and out of the wall. A
drilled hole is a straight prism; a laid one follows the wall. A twist turns both with their wall.
"""

from __future__ import annotations

from functools import cached_property
from typing import Protocol

import numpy as np

from sgb_core.arrays import Floats, between
from sgb_core.bodies.cut_outs import HoleShape
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# Of the reach of a hole: the step of the differences that tell how its chart leans.
_STEP = 1e-4


class Chart(Protocol):
    """Where the places of a hole lie."""

    def placed(self, places: Floats) -> Floats:
        """Return the points in space of places (x, y, d), shape (n, 3) each."""
        ...


@dataclass(frozen=True, slots=True, eq=False)
class Prism:
    """The frame of a straight hole: its middle, and the unit vectors of x, y and d, (3,) each."""

    centre: Floats
    across: Floats
    up: Floats
    out: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Hole:
    """A hole of an ``outline`` (k, 2), counter-clockwise, from ``inner`` behind to ``outer``.

    ``shape`` says what outline it is. Where its sides follow the wall they are taken apart into
    steps of at most ``step``; 0: they are straight.
    """

    outline: Floats
    shape: HoleShape
    chart: Chart
    inner: float
    outer: float
    step: float = 0.0

    @property
    def prism(self) -> Prism | None:
        """Where it lies, if it is a straight prism."""
        straight = self.step == 0.0 and isinstance(self.chart, DrilledChart)
        if not straight:
            return None
        places = np.concatenate([np.zeros((1, 3)), np.eye(3)])
        centre, *ends = self.chart.placed(places)
        return Prism(centre, *(end - centre for end in ends))

    def normals(self, places: Floats, flat: Floats) -> Floats:
        """Return unit normals in space where the outline's are ``flat`` (n, 2), at (n, 3) places.

        The gradient of what a normal stands on is J⁻ᵀ n, J the derivative of the chart.
        """
        step = _STEP * float(np.ptp(self.outline, axis=0).max())
        shifts = [self.chart.placed(places + step * way) for way in np.eye(3)]
        rest = self.chart.placed(places)
        jacobian = np.stack([(moved - rest) / step for moved in shifts], axis=2)
        full = np.concatenate([flat, np.zeros((len(flat), 1))], axis=1)
        leaning = np.linalg.solve(jacobian.transpose(0, 2, 1), full[..., None])[..., 0]
        return np.asarray(leaning / np.linalg.norm(leaning, axis=1, keepdims=True))


def _in_space(
    surface: RevolutionSurface, side: float, across: Floats, aside: Floats, h: Floats, theta: Floats
) -> Floats:
    """Return points ``across`` from the axis and ``aside`` along the turn, twisted and placed."""
    vectors = side * surface.directions(surface.start + surface.turned(theta, h))
    placed = across[:, None] * vectors[:, 0] + aside[:, None] * vectors[:, 1]
    placed += side * h[:, None] * vectors[:, 2]
    return np.asarray(placed + np.asarray(surface.placement.translation))


@dataclass(frozen=True, slots=True, eq=False)
class DrilledChart:
    """The chart of a prism that stands on the wall: its plane touches it at ``point``.

    ``point`` (r, h), ``tangent`` (2,) upwards and ``theta`` from the start are those of its
    middle; ``side`` is −1 for a profile at negative r.
    """

    surface: RevolutionSurface
    side: float
    theta: float
    point: Floats
    tangent: Floats

    def placed(self, places: Floats) -> Floats:
        """Return the points in space of places (x, y, d), shape (n, 3) each."""
        x, y, d = places.T
        across = self.point[0] + y * self.tangent[0] + d * self.tangent[1]
        h = self.point[1] + y * self.tangent[1] - d * self.tangent[0]
        return _in_space(self.surface, self.side, across, x, h, np.full(len(x), self.theta))


@dataclass(frozen=True, eq=False)
class Sheet:
    """A wall unrolled about a row: ``points`` and ``normals`` (K, M, 2) at K angles.

    The angles are even steps over the ``sweep``, one alone where all are alike; the M samples even
    steps from ``low`` to ``high`` along the wall, 0 being the middle of the row.
    """

    points: Floats
    normals: Floats
    sweep: float
    low: float
    high: float

    @cached_property
    def steepest(self) -> float:
        """How far at most the wall goes in or out for each unit around."""
        if len(self.points) == 1:
            return 0.0
        r = self.points[..., 0]
        step = self.sweep / (len(r) - 1)
        return float((np.abs(np.diff(r, axis=0)) / (step * r[1:])).max())

    def at(self, theta: Floats, y: Floats, d: Floats) -> Floats:
        """Return (r, h) of places, (n, 2); columns repeat after the sweep."""
        count = self.points.shape[1]
        row, up = between((y - self.low) / (self.high - self.low) * (count - 1), count)
        up = up[:, None]

        def along(column: np.ndarray[tuple[int], np.dtype[np.intp]]) -> Floats:
            low = self.points[column, row] + d[:, None] * self.normals[column, row]
            high = self.points[column, row + 1] + d[:, None] * self.normals[column, row + 1]
            return np.asarray((1.0 - up) * low + up * high)

        columns = len(self.points) - 1
        if columns == 0:
            return along(np.zeros(len(y), dtype=np.intp))
        left, right = between(np.mod(theta / self.sweep, 1.0) * columns, columns + 1)
        part = right[:, None]
        return np.asarray((1.0 - part) * along(left) + part * along(left + 1))


@dataclass(frozen=True, slots=True, eq=False)
class LaidChart:
    """The chart of a shape laid on a wall: lengths around are true at the ``radius``."""

    surface: RevolutionSurface
    side: float
    theta: float
    radius: float
    sheet: Sheet

    def placed(self, places: Floats) -> Floats:
        """Return the points in space of places (x, y, d), shape (n, 3) each."""
        x, y, d = places.T
        theta = self.theta + x / self.radius
        across, h = self.sheet.at(theta, y, d).T
        return _in_space(self.surface, self.side, across, np.zeros_like(x), h, theta)
