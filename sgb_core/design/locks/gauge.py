"""One chain as dimensions ask about it: its curve, its extremes, and slopes by all its numbers.

The curve is sampled once for all that ask; samples near the best are led to the exact place by
Newton's method.
"""

from __future__ import annotations

from functools import cached_property
from math import pi

import numpy as np

from sgb_core.arrays import Floats, frozen
from sgb_core.curves import basis
from sgb_core.curves.nodes import gauss
from sgb_core.design.demands.chain import BLOCK, Chain
from sgb_core.values import dataclass

SAMPLES = 33
_S = np.linspace(0.0, 1.0, SAMPLES)
_STEP = float(_S[1])
_ROWS = basis.bernstein(4, _S)
# From the Bernstein polynomials of degree 4 to powers of s.
POWERS = np.array(
    [
        [1.0, 0.0, 0.0, 0.0, 0.0],
        [-4.0, 4.0, 0.0, 0.0, 0.0],
        [6.0, -12.0, 6.0, 0.0, 0.0],
        [-4.0, 12.0, -12.0, 4.0, 0.0],
        [1.0, -4.0, 6.0, -4.0, 1.0],
    ]
)
_ROUNDS = 8
_VOLUME_NODES, _VOLUME_WEIGHTS = gauss(6)
_VOLUME_ROWS = basis.bernstein(4, _VOLUME_NODES)
_VOLUME_RATES = 4.0 * basis.bernstein(3, _VOLUME_NODES) @ np.diff(np.eye(5), axis=0)
# Of the size: samples within this of the extreme one are looked at more closely.
_NEAR = 5e-3
_FLAT = 1e-12


@dataclass(frozen=True, slots=True)
class Reading:
    """A value and its slope by the numbers of a chain, flat, shape (11 n,)."""

    value: float
    slope: Floats

    def times(self, factor: float) -> Reading:
        """Return the reading in another unit."""
        return Reading(self.value * factor, self.slope * factor)

    def __sub__(self, other: Reading) -> Reading:
        return Reading(self.value - other.value, self.slope - other.slope)


NO_SLOPE = frozen(np.zeros(1))


@dataclass(frozen=True, slots=True)
class Spot:
    """A place on a chain: a segment and a parameter."""

    segment: int
    s: float


# The same of the first and the second derivative.
_DERIVED = tuple(
    np.array(
        [
            np.prod(np.arange(k + 1, k + order + 1)) * POWERS[k + order]
            if k + order < 5
            else np.zeros(5)
            for k in range(5)
        ]
    )
    for order in range(3)
)


def row(s: float, order: int = 0) -> Floats:
    """Return what the quartic points contribute to the curve, or to its derivative, at s."""
    square = s * s
    return np.asarray(np.array([1.0, s, square, square * s, square * square]) @ _DERIVED[order])


class Gauge:
    """Measures one chain; what several dimensions ask for is computed once.

    Without ``slopes`` readings have none, and take less time.
    """

    def __init__(self, chain: Chain, *, slopes: bool = True) -> None:
        self.chain = chain
        self.quartics = chain.quartics
        self.slopes = slopes
        self._extremes: dict[tuple[int, float], list[Spot]] = {}

    @cached_property
    def moves(self) -> Floats:
        """How the quartic points, flat, move with each number of their block, (n, 10, 11)."""
        return self.chain.slopes()

    @cached_property
    def samples(self) -> Floats:
        """The curve at SAMPLES parameters of each segment, shape (n, SAMPLES, 2)."""
        return np.asarray(_ROWS @ self.quartics)

    def lifted(self, segment: int, rows: Floats) -> Floats:
        """Return the slope by all numbers of what has ``rows`` (5, 2) by one segment's Q."""
        if not self.slopes:
            return NO_SLOPE
        slope = np.zeros(self.chain.blocks.size)
        at = BLOCK * segment
        slope[at : at + BLOCK] = rows.reshape(10) @ self.moves[segment]
        return slope

    def lifted_all(self, rows: Floats) -> Floats:
        """Return the slope by all numbers of what has ``rows`` (n, 5, 2) by the quartics."""
        if not self.slopes:
            return NO_SLOPE
        return np.asarray((rows.reshape(-1, 1, 10) @ self.moves).ravel())

    def at(self, spot: Spot, order: int = 0) -> Floats:
        """Return the curve's point there, or its derivative by the parameter, shape (2,)."""
        return np.asarray(row(spot.s, order) @ self.quartics[spot.segment])

    def volume(self) -> Reading:
        """Return the signed volume π ∫ r² h' ds of a full turn; 6 Gauss points are exact."""
        r, rates = self.quartics[..., 0] @ _VOLUME_ROWS.T, self.quartics[..., 1] @ _VOLUME_RATES.T
        square, pull = r * r * _VOLUME_WEIGHTS, 2.0 * r * rates * _VOLUME_WEIGHTS
        rows = np.stack([pull @ _VOLUME_ROWS, square @ _VOLUME_RATES], axis=-1)
        return Reading(pi * float((square * rates).sum()), pi * self.lifted_all(rows))

    def coordinate(self, spot: Spot, axis: int) -> Reading:
        """Return a coordinate of the curve, in the chain's size, at a fixed parameter."""
        rows = np.zeros((5, 2))
        rows[:, axis] = row(spot.s)
        return Reading(float(self.at(spot)[axis]), self.lifted(spot.segment, rows))

    def follows(self, spot: Spot, axis: int) -> Reading:
        """Return a coordinate of the place where the other one is extreme.

        There f' = 0 of the other coordinate, so the place itself moves by −δf'/f''.
        """
        found = self.coordinate(spot, axis)
        bend = float(self.at(spot, 2)[1 - axis])
        if not 0.0 < spot.s < 1.0 or abs(bend) <= _FLAT:
            return found
        rows = np.zeros((5, 2))
        rows[:, 1 - axis] = row(spot.s, 1)
        moves = self.lifted(spot.segment, rows) * (-float(self.at(spot, 1)[axis]) / bend)
        return Reading(found.value, found.slope + moves)

    def extreme(self, axis: int, sign: float) -> Spot:
        """Return where a coordinate is greatest, least where ``sign`` is negative."""
        return self.peaks(axis, sign)[0]

    def peaks(self, axis: int, sign: float) -> list[Spot]:
        """Return where a coordinate is greatest, and where it is nearly so, the greatest first."""
        found = self._extremes.get((axis, sign))
        if found is None:
            found = self._peaks(sign * self.samples[..., axis], axis, sign)
            self._extremes[axis, sign] = found
        return found

    def neck(self) -> Spot | None:
        """Return the narrowest place between wider ones, None where there is none."""
        side = 1.0 if self.samples[..., 0].sum() >= 0.0 else -1.0
        values = -side * self.samples[..., 0]
        flat = values.ravel()
        narrow = (flat[1:-1] >= flat[:-2]) & (flat[1:-1] >= flat[2:])
        # Wider on both sides, somewhere: a straight wall has no neck.
        widest = np.minimum.accumulate(flat), np.minimum.accumulate(flat[::-1])[::-1]
        inner = flat[1:-1] > np.maximum(widest[0][:-2], widest[1][2:]) + 1e-9
        places = np.flatnonzero(narrow & inner) + 1
        if len(places) == 0:
            return None
        best = int(places[np.argmax(flat[places])])
        segment, number = divmod(best, SAMPLES)
        return self._led(segment, float(_S[number]), 0, -side)

    def _peaks(self, values: Floats, axis: int, sign: float) -> list[Spot]:
        """Return the exact places of the samples' local maxima that are near the greatest."""
        high = values >= float(values.max()) - _NEAR
        high[:, 1:] &= values[:, 1:] >= values[:, :-1]
        high[:, :-1] &= values[:, :-1] >= values[:, 1:]
        spots = []
        for number in np.flatnonzero(high).tolist():
            segment, place = divmod(number, SAMPLES)
            spots.append(self._led(segment, float(_S[place]), axis, sign))
        if len(spots) > 1:
            spots.sort(key=lambda spot: -sign * float(self.at(spot)[axis]))
        return spots

    def _led(self, segment: int, s: float, axis: int, sign: float) -> Spot:
        """Return the greatest place of a coordinate (least, if negative) near a sample's."""
        c = (POWERS @ (sign * self.quartics[segment, :, axis])).tolist()
        low, high = max(0.0, s - _STEP), min(1.0, s + _STEP)
        u = s
        for _ in range(_ROUNDS):
            slope = slope_at(c, u)
            bend = bend_at(c, u)
            if bend >= -_FLAT:
                break
            step = slope / bend
            u = min(max(u - step, low), high)
            if abs(step) <= 1e-15:
                break
        return Spot(segment, u if value_at(c, u) >= value_at(c, s) else s)

    def crossings(self, height: float) -> list[Spot]:
        """Return where the curve passes a height, in the chain's size."""
        values = self.samples[..., 1] - height
        found = []
        for k, number in np.argwhere((values[:, :-1] < 0.0) != (values[:, 1:] < 0.0)).tolist():
            c = (POWERS @ self.quartics[k, :, 1]).tolist()
            c[0] -= height
            found.append(Spot(k, _root(c, float(_S[number]), float(_S[number + 1]))))
        return found


def slope_at(c: list[float], u: float) -> float:
    """Return the derivative of the quartic with these coefficients of powers."""
    return c[1] + u * (2.0 * c[2] + u * (3.0 * c[3] + u * 4.0 * c[4]))


def bend_at(c: list[float], u: float) -> float:
    """Return the second derivative of the quartic with these coefficients of powers."""
    return 2.0 * c[2] + u * (6.0 * c[3] + u * 12.0 * c[4])


def value_at(c: list[float], u: float) -> float:
    """Return the quartic with these coefficients of powers."""
    return c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * c[4])))


def _root(c: list[float], low: float, high: float) -> float:
    """Return the root of a quartic between two places of different signs, by safe Newton steps."""
    rising = value_at(c, low) < 0.0
    u = 0.5 * (low + high)
    for _ in range(60):
        value = value_at(c, u)
        if (value < 0.0) == rising:
            low = u
        else:
            high = u
        slope = slope_at(c, u)
        following = u - value / slope if slope else low
        if not low < following < high:
            following = 0.5 * (low + high)
        if abs(following - u) <= 1e-15:
            break
        u = following
    return u
