"""What one segment does at one of its ends to keep the rule of the joint there.

The other side, the master, stays; this side yields: its leg turns (G1), turns and scales (C1), or
its shape parameters follow in closed form (G2). Chains of joints are the business of
:mod:`sgb_core.curves.constraints`.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot, inf, sqrt

import numpy as np

from sgb_core.curves import basis
from sgb_core.curves.continuity import EndView, Vector, end_view, start_view
from sgb_core.curves.segment import DEGENERATE_LEG, LAMBDAS, PARAMETER_RANGES, Segment
from sgb_core.findings.joints import Hindrance
from sgb_core.values import dataclass

# A leg that would move by less than this part of its length is already right.
_ALREADY_RIGHT = 1e-13
# Curvatures closer than this part of max(|κ|, 1/size) are already equal: far inside what
# a measured G2 allows, far outside rounding.
_SAME_CURVATURE = 1e-11
# Solving for a leg fraction stops short of 0, where the curvature would be infinite.
_LEAST_FRACTION = 1e-6
# A solved λ so near the end of its range is at that end: the rest is rounding.
_AT_THE_END = 1e-12
# Two legs whose cross product is below this part of their lengths' product are in line.
_IN_LINE = 1e-14


@dataclass(frozen=True, slots=True)
class Yielded:
    """What became of the yielding segment, and why the rule could not be met."""

    segment: Segment
    hindrance: Hindrance | None = None
    middle_changed: bool = False


def view_from(segment: Segment, at_start: bool) -> EndView:
    """Return a segment seen from its start or from its end."""
    return start_view(segment) if at_start else end_view(segment)


def turn_leg(
    master: EndView,
    segment: Segment,
    at_start: bool,
    *,
    size: float,
    equal_speed: bool = False,
    limit: float = inf,
) -> Yielded:
    """Return the segment with its leg in line with the master's, beyond the joint.

    Theorem 1, (2): P1,2 = P3,1 + c1/(α a2) (P3,1 − P2,1). Without ``equal_speed`` (G1) the leg
    keeps its length, which fixes α; with it (C1) α = 1. The rule is suspended where an end
    derivative vanishes, and no leg's end moves farther than ``limit``.
    """
    own = view_from(segment, at_start)
    heading = _heading(master, size)
    if heading is None:
        return Yielded(segment, Hindrance.POINT_BESIDE)
    length = own.leg_length
    if length < DEGENERATE_LEG * size or length == 0.0:
        return Yielded(segment, Hindrance.NO_LEG)
    wanted = length
    hindrance: Hindrance | None = None
    if master.is_degenerate(size) or own.is_degenerate(size):
        hindrance = Hindrance.STILL_END
    elif equal_speed:
        wanted = master.fraction * master.leg_length / own.fraction
    x, y = own.legs[0]
    if hypot(heading[0] * wanted - x, heading[1] * wanted - y) > limit:
        # The farthest point of the heading's ray that lies within the limit.
        along = heading[0] * x + heading[1] * y
        wanted = along + sqrt(max(along * along - length * length + limit * limit, 0.0))
        hindrance = Hindrance.FARTHEST
    return Yielded(_with_leg(segment, at_start, own, heading, wanted), hindrance)


def match_curvature(
    master: EndView, segment: Segment, at_start: bool, *, size: float, middle_is_free: bool = True
) -> Yielded:
    """Return the segment with the curvature at this end that makes the joint G2.

    The curvature here is K·w/f², K = ¾ (d1×d2)/|d1|³ from the polygon, f the leg fraction at
    this end and w = 1 − b (or b, seen from the end). First f is solved for, through λ1 (λ3),
    which changes the curvature at this end only; what is then still missing is left to w,
    through λ2, unless ``middle_is_free`` is false. Where no value lies in range the nearest one
    is taken: the result depends continuously on the master.
    """
    own = view_from(segment, at_start)
    if master.is_degenerate(size):
        return Yielded(segment, Hindrance.STILL_BESIDE)
    if own.leg_length < DEGENERATE_LEG * size or own.leg_length == 0.0:
        return Yielded(segment, Hindrance.NO_LEG)
    target = -master.curvature()
    tolerance = _SAME_CURVATURE * max(abs(target), 1.0 / size)
    if not own.is_degenerate(size) and abs(own.curvature() - target) <= tolerance:
        return Yielded(segment)
    omega = segment.shape.omega
    if omega == 0.0:
        return Yielded(segment, Hindrance.PLAIN_CUBIC)
    stiffness = _stiffness(own)
    if stiffness == 0.0:
        return Yielded(segment, Hindrance.STRAIGHT)

    ratio = target / stiffness
    low, high = max(0.75 * (1.0 - omega), _LEAST_FRACTION), 0.25 * (3.0 + omega)
    fraction, weight = own.fraction, own.weight
    if ratio <= 0.0:
        fraction = high
    elif weight > 0.0:
        fraction = min(max(sqrt(weight / ratio), low), high)
    fraction = max(fraction, low)
    reached = stiffness * weight / fraction**2
    if middle_is_free and abs(reached - target) > tolerance:
        weight = min(max(ratio * fraction**2, 0.5 * (1.0 - omega)), 0.5 * (1.0 + omega))
        reached = stiffness * weight / fraction**2
    missed = abs(reached - target) > tolerance
    return Yielded(
        _with_fractions(segment, at_start, own, fraction, weight),
        Hindrance.OUT_OF_RANGE if missed else None,
        middle_changed=weight != own.weight,
    )


def _heading(master: EndView, size: float) -> Vector | None:
    """Return the unit direction in which the leg beyond the joint has to point."""
    x, y = master.legs[0]
    length = hypot(x, y)
    if length < DEGENERATE_LEG * size or length == 0.0:
        tangent = master.tangent(size)
        if tangent is None:
            return None
        x, y = tangent
        length = hypot(x, y)
    return -x / length, -y / length


def _stiffness(own: EndView) -> float:
    (x1, y1), (x2, y2), _ = own.legs
    cross = x1 * y2 - y1 * x2
    if abs(cross) <= _IN_LINE * own.leg_length * hypot(x2, y2):
        return 0.0
    return 0.75 * cross / own.leg_length**3


def _with_leg(
    segment: Segment, at_start: bool, own: EndView, heading: Vector, length: float
) -> Segment:
    x, y = heading[0] * length, heading[1] * length
    if hypot(x - own.legs[0][0], y - own.legs[0][1]) <= _ALREADY_RIGHT * own.leg_length:
        return segment
    points = np.array(segment.points)
    points[1 if at_start else 2] = own.at[0] + x, own.at[1] + y
    return segment.with_points(points)


def _with_fractions(
    segment: Segment, at_start: bool, own: EndView, fraction: float, weight: float
) -> Segment:
    """Return the segment with λ1 (λ3) and λ2 solved from its fractions at the same ω."""
    shape = segment.shape
    wanted: dict[int, float] = {}
    if fraction != own.fraction:
        wanted[0 if at_start else 2] = fraction
    if weight != own.weight:
        wanted[1] = 1.0 - weight if at_start else weight
    solved = {LAMBDAS[leg]: _solved(leg, value, shape.omega) for leg, value in wanted.items()}
    return segment.with_shape(replace(shape, **solved))


def _solved(leg: int, fraction: float, omega: float) -> float:
    """Return the λ that gives a leg its fraction, in its range."""
    low, high = PARAMETER_RANGES[LAMBDAS[leg]]
    value = basis.lambda_at(leg, fraction, omega)
    if value < low + _AT_THE_END:
        return low
    return high if value > high - _AT_THE_END else value
