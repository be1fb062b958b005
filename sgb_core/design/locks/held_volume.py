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
from sgb_core.design.locks.gauge import POWERS, Gauge, Reading, bend_at, slope_at, value_at
from sgb_core.values import dataclass

_NODES, _WEIGHTS = gauss(12)
_SEARCH = np.linspace(0.0, 1.0, 17)
_ROUNDS = 40
_STILL = 1e-12
# A rim whose normal rises more steeply than this across its height ends nearly level.
_LEVEL = 0.3
_BACK = np.linalg.inv(POWERS)
_DEGREES = np.arange(5)
_BINOMIALS = np.array([[comb(k, j) for k in range(5)] for j in range(5)], dtype=np.float64)
_REST = np.maximum(_DEGREES[None, :] - _DEGREES[:, None], 0)


def _rows(s: Floats) -> Floats:
    """Return what quartic points contribute to the curve and two derivatives, (5, 3 len(s))."""
    steps = np.diff(np.eye(5), axis=0)
    rows = (
        basis.bernstein(4, s),
        4.0 * basis.bernstein(3, s) @ steps,
        12.0 * basis.bernstein(2, s) @ np.diff(steps, axis=0),
    )
    return np.ascontiguousarray(np.concatenate(rows).T)


# The nodes, and the two ends after them.
_INNER = len(_NODES)
_AT_PLACES = _rows(np.concatenate([_NODES, (0.0, 1.0)]))
_AT_NODES = basis.bernstein(4, _NODES)
_AT_SEARCH = _rows(_SEARCH)[:, : 2 * len(_SEARCH)]


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

    def at(self, rows: Floats) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """Return r, h, both parts of the normal to the right, and signed speeds, each (n, m).

        With the curvature κ of the drawn curve the moved one is 1 − offset·κ times as fast.
        """
        across, up = self.quartics[..., 0] @ rows, self.quartics[..., 1] @ rows
        m = rows.shape[1] // 3
        dr, dh = across[:, m : 2 * m], up[:, m : 2 * m]
        speed = np.hypot(dr, dh)
        safe = np.where(speed > _STILL, speed, 1.0)
        out, rise = dh / safe, -dr / safe
        if self.offset == 0.0:
            return across[:, :m], up[:, :m], out, rise, speed
        bend = -(rise * up[:, 2 * m :] + out * across[:, 2 * m :]) / safe
        return (
            across[:, :m] - self.offset * out,
            up[:, :m] - self.offset * rise,
            out,
            rise,
            speed - self.offset * bend,
        )

    def heights(self) -> Floats:
        """Return how high the moved curve is at the places of the search, shape (n, m)."""
        across, up = self.quartics[..., 0] @ _AT_SEARCH, self.quartics[..., 1] @ _AT_SEARCH
        m = len(_SEARCH)
        if self.offset == 0.0:
            return up[:, :m]
        dr = across[:, m:]
        speed = np.hypot(dr, up[:, m:])
        return np.asarray(up[:, :m] + self.offset * dr / np.where(speed > _STILL, speed, 1.0))

    def passes(self, segment: int, low: float, high: float, level: float) -> float:
        """Return where one segment passes a level, by Newton steps that stay between bounds."""
        r, h = (POWERS @ self.quartics[segment]).T.tolist()
        rising = value_at(h, high) + self._lift(r, h, high)[0] >= level
        u = 0.5 * (low + high)
        for _ in range(_ROUNDS):
            lift, speed, bend = self._lift(r, h, u)
            excess = value_at(h, u) + lift - level
            if (excess < 0.0) == rising:
                low = u
            else:
                high = u
            # The moved curve rises 1 − offset·κ times as fast as the drawn one.
            rate = slope_at(h, u) * (1.0 - self.offset * bend / speed)
            following = u - excess / rate if rate else low
            if not low <= following <= high:
                following = 0.5 * (low + high)
            if abs(following - u) <= 1e-15 or abs(excess) <= 1e-15:
                break
            u = following
        return u

    def _lift(self, r: list[float], h: list[float], u: float) -> tuple[float, float, float]:
        """Return by how much the moved curve is higher, and speed and turning of the drawn one."""
        across, along = slope_at(r, u), slope_at(h, u)
        speed = hypot(across, along) or 1.0
        turn = across * bend_at(h, u) - along * bend_at(r, u)
        return self.offset * across / speed, speed, turn / (speed * speed)


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
    r, h, out, rise, speed = path.at(_AT_PLACES)
    radius, scale = r[:, :_INNER], _WEIGHTS * speed[:, :_INNER]
    pull = 2.0 * radius * scale
    # The height of the tangent is the radius of the normal.
    value = 0.5 * float((radius * pull * out[:, :_INNER]).sum())
    if gauge.slopes:
        slope[counted, :, 0] = (pull * out[:, :_INNER]) @ _AT_NODES
        slope[counted, :, 1] = (pull * rise[:, :_INNER]) @ _AT_NODES
        for place, matrix in cuts:
            slope[counted[place]] = matrix.T @ slope[counted[place]]
    value += _cones(r[:-1, -1], h[:-1, -1], r[1:, -2], h[1:, -2])
    top = float(r[-1, -1])
    if brim is not None and high is not None:
        if ends[-1] == 1.0:
            across, up = float(out[-1, -1]), float(rise[-1, -1])
            # Of a rim that ends level the straight way on is endless: it leans ever less.
            lean = -up * across / (across * across + _LEVEL * _LEVEL)
            near, below = r[-1:, -1], h[-1:, -1]
            top += lean * (high - float(below[0]))
            value += _cones(near, below, np.array((top,)), np.array((high,)))
        _moves(slope, brim, top**2)
    if floor is not None:
        _moves(slope, floor, -(float(r[0, -2]) ** 2))
    if mirrored:
        slope[..., 0] *= -1.0
    if downwards:
        slope = np.ascontiguousarray(slope[::-1, ::-1])
    return Reading(pi * value, pi * gauge.lifted_all(slope))


def _cones(near: Floats, low: Floats, far: Floats, high: Floats) -> float:
    """Return ∫ r² dh along straight lines from (near, low) to (far, high), each shape (n,)."""
    return float(((high - low) * (near * near + near * far + far * far)).sum()) / 3.0


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
        powers = _BINOMIALS * low**_REST * ((high - low) ** _DEGREES)[:, None]
        matrix = _BACK @ powers @ POWERS
        parts[place] = matrix @ parts[place]
        cuts.append((place, matrix))
    return _Path(parts, path.offset), cuts


def _height(gauge: Gauge, path: _Path, level: Level | None) -> float | None:
    if level is None:
        return None
    if level.base is Base.FOOT:
        return float(path.quartics[0, 0, 1]) + level.above
    if level.base is Base.RIM:
        return float(path.quartics[-1, 4, 1]) + level.above
    lowest = level.base is Base.LOWEST
    return (float(gauge.samples[..., 1].min()) if lowest else 0.0) + level.above


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
    heights = path.heights().ravel()
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
