"""Measures of a chain with their derivatives by its quartic points.

Lengths are in the chain's own size-1 units. Extremes move with the place where they occur (the
derivative of the place itself drops out: it is an extreme, or an end).
"""

from __future__ import annotations

from itertools import pairwise
from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.nodes import gauss
from sgb_core.curves.roots import evaluate, real_roots
from sgb_core.design.demands.foot import foot_of
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class Measured:
    """A value, its slope (n, 10) by the quartic points, and its bend (n, 10, 10) where known."""

    value: float
    slope: Floats
    bend: Floats | None = None


def volume(quartics: Floats) -> Measured:
    """Return the signed volume π ∫ r² h' ds of a full turn; 6 Gauss points are exact."""
    s, weights = gauss(6)
    rows, rates = _rows(s)
    r, dh = quartics[..., 0] @ rows.T, quartics[..., 1] @ rates.T
    value = pi * float(((r * r * dh) @ weights).sum())
    slope = np.zeros((len(quartics), 5, 2))
    slope[..., 0] = 2.0 * pi * (r * dh * weights) @ rows
    slope[..., 1] = pi * (r * r * weights) @ rates
    bend = np.zeros((len(quartics), 5, 2, 5, 2))
    bend[:, :, 0, :, 0] = 2.0 * pi * (rows.T * (dh * weights)[:, None, :]) @ rows
    mixed = 2.0 * pi * (rows.T * (r * weights)[:, None, :]) @ rates
    bend[:, :, 0, :, 1] = mixed
    bend[:, :, 1, :, 0] = np.swapaxes(mixed, 1, 2)
    return Measured(value, slope.reshape(-1, 10), bend.reshape(-1, 10, 10))


def height(quartics: Floats) -> Measured:
    """Return how far the curve reaches along the axis."""
    low, high = _extreme(quartics, 1, -1.0), _extreme(quartics, 1, 1.0)
    return Measured(high.value - low.value, high.slope - low.slope)


def lowest(quartics: Floats) -> Measured:
    """Return the least height of the curve."""
    return _extreme(quartics, 1, -1.0)


def largest_diameter(quartics: Floats) -> Measured:
    """Return twice the largest distance of the curve from the axis, on whichever side."""
    right, left = _extreme(quartics, 0, 1.0), _extreme(quartics, 0, -1.0)
    if right.value >= -left.value:
        return Measured(2.0 * right.value, 2.0 * right.slope)
    return Measured(-2.0 * left.value, -2.0 * left.slope)


def end_diameter(quartics: Floats, upper: bool) -> Measured:
    """Return twice the distance from the axis of the upper end (rim) or of the foot.

    The foot is where ``foot_of`` says. Where both ends are at one height the last is the rim.
    """
    if upper:
        segment, point = end_of(quartics, upper)
        s = 1.0 if point == 4 else 0.0
    else:
        foot = foot_of(quartics)
        segment, s = foot.segment, foot.s
    row = basis.bernstein(4, s)
    r = float(row @ quartics[segment, :, 0])
    slope = np.zeros((len(quartics), 5, 2))
    slope[segment, :, 0] = row
    if 0.0 < s < 1.0:
        # There h' = 0: the place itself moves by −δh'/h''.
        rates = 4.0 * basis.bernstein(3, s) @ np.diff(np.eye(5), axis=0)
        bends = 12.0 * basis.bernstein(2, s) @ np.diff(np.eye(5), 2, axis=0)
        across, _ = (rates @ quartics[segment]).tolist()
        slope[segment, :, 1] = -across / float(bends @ quartics[segment, :, 1]) * rates
    return Measured(2.0 * abs(r), (2.0 if r >= 0.0 else -2.0) * slope.reshape(-1, 10))


def end_of(quartics: Floats, upper: bool) -> tuple[int, int]:
    """Return (segment, quartic point) of the upper or the lower end of an open chain."""
    last_is_upper = bool(quartics[-1, 4, 1] >= quartics[0, 0, 1])
    return (len(quartics) - 1, 4) if last_is_upper == upper else (0, 0)


def _extreme(quartics: Floats, coordinate: int, sign: float) -> Measured:
    """Return the greatest (least, where ``sign`` is negative) value of a coordinate."""
    values = sign * quartics[..., coordinate]
    best, place = -np.inf, (0, 0.0)
    # The curve lies in the hull of its points: most segments cannot reach the extreme.
    reached = float(np.maximum(values[:, 0], values[:, 4]).max())
    for k in np.flatnonzero(values.max(axis=1) >= reached).tolist():
        coefficients = values[k].tolist()
        slopes = [after - before for before, after in pairwise(coefficients)]
        for s in (0.0, 1.0, *real_roots(slopes)):
            value = evaluate(coefficients, s)
            if value > best:
                best, place = value, (k, s)
    segment, s = place
    slope = np.zeros((len(quartics), 5, 2))
    slope[segment, :, coordinate] = basis.bernstein(4, s)
    return Measured(sign * best, slope.reshape(-1, 10))


def _rows(s: Floats) -> tuple[Floats, Floats]:
    rows = basis.bernstein(4, s)
    rates = 4.0 * basis.bernstein(3, s) @ np.diff(np.eye(5), axis=0)
    return rows, rates
