"""What lies inside a wall's curve between two levels: a model of capacities, and its slopes.

The curve is the drawn one moved along its normal, from foot to rim, cut at a floor and a brim.
Loops of a tight bend and corners of the wall are not resolved: the model tells how a volume
changes, not what it is; whoever uses it sets it right by the body's own measure.
"""

from __future__ import annotations

from enum import Enum, auto
from math import comb, hypot, pi

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.nodes import gauss
from sgb_core.design.locks.gauge import POWERS, Gauge, Reading, slope_at, value_at
from sgb_core.values import dataclass

_NODES, _WEIGHTS = gauss(12)
_SEARCH = np.linspace(0.0, 1.0, 17)
_ENDS = np.array([0.0, 1.0])
_ROUNDS = 40
_STILL = 1e-12
# A rim whose normal rises more steeply than this across its height ends nearly level.
_LEVEL = 0.3
_BACK = np.linalg.inv(POWERS)


def _rows(s: Floats) -> tuple[Floats, Floats, Floats]:
    """Return what the quartic points contribute to the curve and to its two derivatives."""
    steps = np.diff(np.eye(5), axis=0)
    return (
        basis.bernstein(4, s),
        4.0 * basis.bernstein(3, s) @ steps,
        12.0 * basis.bernstein(2, s) @ np.diff(steps, axis=0),
    )


_AT_NODES, _AT_SEARCH, _AT_ENDS = _rows(_NODES), _rows(_SEARCH), _rows(_ENDS)


class Base(Enum):
    """What a level goes with."""

    NOTHING = auto()
    FOOT = auto()
    RIM = auto()
    LOWEST = auto()


@dataclass(frozen=True, slots=True)
class Level:
    """A level so far above an end or the lowest place of a chain; lengths in the chain's size."""

    above: float
    base: Base = Base.NOTHING


@dataclass(frozen=True, slots=True)
class _Path:
    """The quartics (n, 5, 2) from foot to rim on the right of the axis, moved to their left."""

    quartics: Floats
    offset: float

    def at(self, rows: tuple[Floats, Floats, Floats]) -> tuple[Floats, Floats, Floats]:
        """Return points, normals to the right, and signed speeds, at m parameters' rows.

        With the curvature κ of the drawn curve the moved one is 1 − offset·κ times as fast.
        """
        points, first, second = (each @ self.quartics for each in rows)
        speed = np.hypot(first[..., 0], first[..., 1])
        safe = np.where(speed > _STILL, speed, 1.0)
        right = np.stack([first[..., 1], -first[..., 0]], axis=-1) / safe[..., None]
        bend = (first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]) / safe**2
        return points - self.offset * right, right, speed - self.offset * bend

    def passes(self, segment: int, low: float, high: float, level: float) -> float:
        """Return where one segment passes a level, by false position (the Illinois rule)."""
        r, h = (POWERS @ self.quartics[segment]).T.tolist()

        def excess(u: float) -> float:
            # The moved curve's height is h + offset · r' / speed.
            across, along = slope_at(r, u), slope_at(h, u)
            speed = hypot(across, along) or 1.0
            return value_at(h, u) + self.offset * across / speed - level

        first, last, u = excess(low), excess(high), low
        for _ in range(_ROUNDS):
            if first == last:
                break
            u = low - first * (high - low) / (last - first)
            value = excess(u)
            if abs(value) <= 1e-14 or high - low <= 1e-15:
                break
            if (value < 0.0) == (first < 0.0):
                low, first, last = u, value, 0.5 * last
            else:
                high, last, first = u, value, 0.5 * first
        return u


def enclosed(gauge: Gauge, offset: float, floor: Level | None, brim: Level | None) -> Reading:
    """Return the volume of a full turn inside the curve moved by ``offset``, with its slope.

    In the chain's size; above ``floor`` and below ``brim``, where there are such levels. A curve
    that ends below the brim goes straight on.
    """
    q = gauge.quartics
    downwards = bool(q[-1, 4, 1] < q[0, 0, 1])
    quartics = q[::-1, ::-1].copy() if downwards else q.copy()
    mirrored = bool(quartics[..., 0].sum() < 0.0)
    if mirrored:
        quartics[..., 0] *= -1.0
    whole = _Path(quartics, offset)
    low, high = _height(gauge, whole, floor), _height(gauge, whole, brim)
    starts, ends = _cuts(whole, low, high)
    counted = np.flatnonzero(ends > starts)
    slope = np.zeros_like(quartics)
    if len(counted) == 0:
        return Reading(0.0, gauge.lifted_all(slope))
    path, cuts = _cut(whole, starts, ends, counted)
    points, right, speed = path.at(_AT_NODES)
    scale = _WEIGHTS * speed
    # The height of the tangent is the radius of the normal.
    value = float((points[..., 0] ** 2 * right[..., 0] * scale).sum())
    pull = (2.0 * points[..., 0] * scale)[..., None] * right
    slope[counted] = _AT_NODES[0].T @ pull
    for place, matrix in cuts:
        slope[counted[place]] = matrix.T @ slope[counted[place]]
    edges, out, _ = path.at(_AT_ENDS)
    value += _cones(edges[:-1, 1], edges[1:, 0])
    top = edges[-1, 1]
    if brim is not None and high is not None:
        if ends[-1] == 1.0:
            across, up = float(out[-1, 1, 0]), float(out[-1, 1, 1])
            # Of a rim that ends level the straight way on is endless: it leans ever less.
            lean = -up * across / (across * across + _LEVEL * _LEVEL)
            top = np.array([top[0] + lean * (high - top[1]), high])
            value += _cones(edges[-1:, 1], top[None])
        _moves(slope, brim, float(top[0]) ** 2)
    if floor is not None:
        _moves(slope, floor, -(float(edges[0, 0, 0]) ** 2))
    if mirrored:
        slope[..., 0] *= -1.0
    if downwards:
        slope = np.ascontiguousarray(slope[::-1, ::-1])
    return Reading(pi * value, pi * gauge.lifted_all(slope))


def _cones(starts: Floats, ends: Floats) -> float:
    """Return ∫ r² dh along straight lines, (n, 2) each."""
    near, far = starts[:, 0], ends[:, 0]
    rise = ends[:, 1] - starts[:, 1]
    return float((rise * (near * near + near * far + far * far)).sum()) / 3.0


def _cut(
    path: _Path, starts: Floats, ends: Floats, counted: NDArray[np.intp]
) -> tuple[_Path, list[tuple[int, Floats]]]:
    """Return the parts that count, and the matrices that cut those quartics that are cut."""
    parts = path.quartics[counted]
    cuts = []
    for place, segment in enumerate(counted.tolist()):
        low, high = float(starts[segment]), float(ends[segment])
        if (low, high) == (0.0, 1.0):
            continue
        # s = low + (high − low) t in powers of t.
        powers = np.zeros((5, 5))
        for k in range(5):
            for j in range(k + 1):
                powers[j, k] = comb(k, j) * low ** (k - j) * (high - low) ** j
        matrix = _BACK @ powers @ POWERS
        parts[place] = matrix @ parts[place]
        cuts.append((place, matrix))
    return _Path(parts, path.offset), cuts


def _height(gauge: Gauge, path: _Path, level: Level | None) -> float | None:
    if level is None:
        return None
    base = {
        Base.NOTHING: 0.0,
        Base.FOOT: float(path.quartics[0, 0, 1]),
        Base.RIM: float(path.quartics[-1, 4, 1]),
        Base.LOWEST: float(gauge.samples[..., 1].min()),
    }[level.base]
    return base + level.above


def _moves(slope: Floats, level: Level, rate: float) -> None:
    """Add what a volume gains as a level goes with an end."""
    if level.base in (Base.FOOT, Base.LOWEST):
        slope[0, 0, 1] += rate
    elif level.base is Base.RIM:
        slope[-1, 4, 1] += rate


def _cuts(path: _Path, low: float | None, high: float | None) -> tuple[Floats, Floats]:
    """Return between which parameters each segment counts."""
    count = len(path.quartics)
    starts, ends = np.zeros(count), np.ones(count)
    if low is None and high is None:
        return starts, ends
    heights = path.at(_AT_SEARCH)[0][..., 1].ravel()
    begun = 0
    if low is not None:
        under = np.flatnonzero(heights[:-1] < low)
        if len(under):
            begun = int(under[-1])
            segment, u = _step(path, begun, low)
            ends[:segment] = 0.0
            starts[segment] = u
    if high is not None:
        over = np.flatnonzero(heights[begun + 1 :] > high) + begun + 1
        if len(over):
            segment, u = _step(path, int(over[0]) - 1, high)
            ends[segment] = max(u, starts[segment])
            ends[segment + 1 :] = 0.0
            starts[segment + 1 :] = 0.0
    return starts, np.maximum(starts, ends)


def _step(path: _Path, number: int, level: float) -> tuple[int, float]:
    """Return (segment, u) where the level lies between a sample and the next one."""
    segment, place = divmod(number, len(_SEARCH))
    if place == len(_SEARCH) - 1:
        return min(segment + 1, len(path.quartics) - 1), 0.0
    return segment, path.passes(segment, float(_SEARCH[place]), float(_SEARCH[place + 1]), level)
