"""Cut a segment in two without changing the curve, and make one of two."""

from __future__ import annotations

from math import hypot

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.continuity import EndView, end_view, start_view
from sgb_core.curves.conversion import Leg, to_segment
from sgb_core.curves.nearest import distances, farthest
from sgb_core.curves.segment import DEGENERATE_LEG, Segment
from sgb_core.fields.kinds import Said
from sgb_core.findings.errors import FindingError
from sgb_core.findings.refusal import Argument
from sgb_core.values import dataclass

# A split that keeps the curve to this part of its size is exact up to rounding.
EXACT = 1e-12
# Of the largest coordinate: what the rounding of a few sums leaves.
_ROUNDING = 1e-15
# Where a = 0, P1 is free; it stays at least this part of where a cubic's would be.
_STAYS = 0.25
# Points of each segment that a merged one is fitted to, and by which the best fit is chosen.
_FIT_POINTS = 49
_CHOOSING_POINTS = 129
_FIT_ROUNDS = 15


@dataclass(frozen=True, slots=True)
class Split:
    """Two segments in place of one.

    ``exact`` says that the curve is kept up to rounding; ``deviation`` is the largest distance
    between the old curve and the new ones at equal parameters.
    """

    first: Segment
    second: Segment
    exact: bool
    deviation: float


def split(segment: Segment, s: float) -> Split:
    """Return a segment cut at ``s``, 0 < s < 1, as two ordinary segments.

    De Casteljau gives the two quartics; of each one's family of segments
    (:mod:`sgb_core.curves.conversion`) the member nearest the cubic's fractions is taken. Where
    a family is empty, the half is fitted with its end derivatives kept. P1 of the first half
    and P2 of the second stay along the legs of the parent, also where a = 0 or c = 0.
    Raises ValueError unless 0 < s < 1.

    >>> halves = sgb.split(sgb.line((20, 0), (20, 60)), 0.25)
    >>> halves.exact, halves.first.point(1.0).tolist()
    (True, [20.0, 15.0])
    """
    if not 0.0 < s < 1.0:
        raise FindingError(Argument("s", s, Said("above 0 and below 1")))
    left, right = de_casteljau(segment.quartic, s)
    a, _, c = segment.shape.leg_fractions
    size, omega = segment.size, segment.shape.omega
    points = segment.points
    outer_start = Leg(points[1] - points[0], s * a, _STAYS * s)
    outer_end = Leg(points[2] - points[3], (1.0 - s) * c, _STAYS * (1.0 - s))
    first, error1 = to_segment(left, outer_start, _inner(left[::-1], size), omega)
    second, error2 = to_segment(right, _inner(right, size), outer_end, omega)
    deviation = max(_largest(error1), _largest(error2))
    return Split(first, second, deviation <= EXACT * size, deviation)


def merge(first: Segment, second: Segment) -> tuple[Segment, float]:
    """Return (segment, deviation): one segment in place of two that meet.

    It runs from the first one's start to the second one's end, keeps both end tangents (so the
    joints beyond stay as smooth as they are) and fits both curves in the least-squares sense,
    with parameters that follow the foot points. The deviation is the largest distance of a point
    of the old curves from the new one, or of the new one from the old. What :func:`split` cut is
    put together again up to rounding.

    >>> halves = sgb.split(sgb.Segment([(20, 0), (55, 10), (50, 60), (25, 80)]), 0.5)
    >>> whole, deviation = sgb.merge(halves.first, halves.second)
    >>> deviation < 1e-9
    True
    """
    marks = np.linspace(0.0, 1.0, _FIT_POINTS)
    target = np.concatenate([first.point(marks), second.point(marks[1:])])
    share = _share(first, second)
    s = np.concatenate([share * marks, share + (1.0 - share) * marks[1:]])
    size = float(np.hypot(*np.ptp(np.concatenate([first.points, second.points]), axis=0)))
    start = _outer(start_view(first), size)
    end = _outer(end_view(second), size)
    if size == 0.0:
        return first, 0.0
    marks = np.linspace(0.0, 1.0, _CHOOSING_POINTS)
    points = np.concatenate([first.point(marks), second.point(marks[1:])])
    best, least = first, float("inf")
    for _ in range(_FIT_ROUNDS):
        quartic, part1, part2 = _fit(target, s, start, end)
        candidate, _ = to_segment(quartic, Leg(start, part1), Leg(end, part2))
        off = float(distances(candidate, points).max())
        if off < least:
            best, least = candidate, off
        if least <= EXACT * size:
            break
        s = _foot_points(target, quartic, s)
    parts = (first, second)
    return best, max(farthest(parts, (best,)), farthest((best,), parts))


def _outer(end: EndView, size: float) -> Floats:
    """Return the direction that the merged segment keeps at an outer end."""
    if end.leg_length > DEGENERATE_LEG * size:
        return np.array(end.legs[0])
    return np.array(end.tangent(size) or (0.0, 0.0))


def _share(first: Segment, second: Segment) -> float:
    """Return the part of the merged parameter range that the first segment takes.

    Where one curve was cut, its derivative tells: L1'(1) = u L' and L2'(0) = (1 − u) L'. Where
    the derivative vanishes there, the lengths of the control polygons stand in.
    """
    before, after = end_view(first), start_view(second)
    speeds = before.fraction * before.leg_length, after.fraction * after.leg_length
    if min(speeds) <= 1e-9 * max(speeds):
        speeds = _polygon(first), _polygon(second)
    total = sum(speeds)
    # Very unequal pieces would leave one of them without a say in the fit.
    return min(max(speeds[0] / total, 0.02), 0.98) if total > 0.0 else 0.5


def _polygon(segment: Segment) -> float:
    steps = np.diff(segment.quartic, axis=0)
    return float(np.hypot(steps[:, 0], steps[:, 1]).sum())


def _fit(target: Floats, s: Floats, start: Floats, end: Floats) -> tuple[Floats, float, float]:
    """Return the quartic nearest ``target`` at the parameters ``s``, and the parts of its legs.

    Its ends are the target's; Q1 = Q0 + κ1·start and Q3 = Q4 + κ2·end with κ ≥ 0, Q2 is free:
    four unknowns, linear least squares. A κ that would be negative is held at 0.
    """
    weights = basis.bernstein(4, s)
    q0, q4 = target[0], target[-1]
    rest = target - np.outer(weights[:, 0] + weights[:, 1], q0)
    rest = rest - np.outer(weights[:, 3] + weights[:, 4], q4)
    zero = np.zeros_like(s)
    columns = [
        np.concatenate([weights[:, 1] * start[0], weights[:, 1] * start[1]]),
        np.concatenate([weights[:, 3] * end[0], weights[:, 3] * end[1]]),
        np.concatenate([weights[:, 2], zero]),
        np.concatenate([zero, weights[:, 2]]),
    ]
    used = [0, 1, 2, 3]
    solution = np.zeros(4)
    for _ in range(3):
        matrix = np.column_stack([columns[k] for k in used])
        solution = np.zeros(4)
        solution[used] = np.linalg.lstsq(matrix, rest.T.ravel(), rcond=None)[0]
        negative = [k for k in (0, 1) if solution[k] < 0.0]
        if not negative:
            break
        used = [k for k in used if k not in negative]
    part1, part2 = float(solution[0]), float(solution[1])
    middle = solution[2:]
    return np.array([q0, q0 + part1 * start, middle, q4 + part2 * end, q4]), part1, part2


def _foot_points(target: Floats, quartic: Floats, s: Floats) -> Floats:
    """Return parameters moved by one Newton step towards the target's foot points, in order."""
    first = np.diff(quartic, axis=0)
    slopes = 4.0 * basis.bernstein(3, s) @ first
    off = target - basis.bernstein(4, s) @ quartic
    speed2 = (slopes**2).sum(axis=1)
    step = np.divide((off * slopes).sum(axis=1), speed2, out=np.zeros_like(s), where=speed2 > 0.0)
    moved = np.maximum.accumulate(np.clip(s + step, 0.0, 1.0))
    moved[0], moved[-1] = 0.0, 1.0
    return moved


def de_casteljau(quartic: Floats, s: float) -> tuple[Floats, Floats]:
    """Return the Bézier points of a curve, shape (k, 2), up to ``s`` and from there on."""
    row = quartic
    left, right = [row[0]], [row[-1]]
    while len(row) > 1:
        row = row[:-1] + s * np.diff(row, axis=0)
        left.append(row[0])
        right.append(row[-1])
    return np.array(left), np.array(right[::-1])


def _inner(quartic: Floats, size: float) -> Leg:
    """Return the leg at the cut, where the quartic begins."""
    step, chord = quartic[1] - quartic[0], quartic[4] - quartic[0]
    along = chord * (float(step @ chord) / (float(chord @ chord) or 1.0))
    # On a straight curve a short step would lend its rounding to the whole leg's direction.
    if hypot(*(step - along)) <= _ROUNDING * np.abs(quartic).max():
        step = along
    if hypot(*step) > DEGENERATE_LEG * size:
        return Leg(step, 1.0)
    # A cusp at the cut: the true tangent is that of the second derivative.
    return Leg(quartic[2] - quartic[0], 0.0)


def _largest(error: Floats) -> float:
    """Return how far a quartic with these control point errors can move, at most."""
    marks = np.linspace(0.0, 1.0, 65)
    moved = basis.bernstein(4, marks) @ error
    return float(np.hypot(moved[:, 0], moved[:, 1]).max())
