"""From a plane quartic Bézier curve back to an SG-Bézier segment.

The quartic points Q0..Q4 belong to a segment when

    P1 = Q0 + x D1,  P2 = Q4 + y D2,  Q2 = b P1 + (1 − b) P2,

where D1, D2 are the directions of the end legs, Q1 − Q0 = κ1 D1, Q3 − Q4 = κ2 D2, and the leg
fractions a = κ1/x, b and c = κ2/y lie in [0, 1]. With p = b x and q = (1 − b) y this is *linear*:

    Q2 − Q4 = b (Q0 − Q4) + p D1 + q D2,   0 ≤ b ≤ 1,  p ≥ κ1 b,  q ≥ κ2 (1 − b),

two equations for three unknowns within a convex polyhedron. Nothing divides by a, c, or the
cross product of the legs, so vanishing end derivatives (κ = 0) and parallel legs are ordinary.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np

from sgb_core.arrays import Floats, distinct
from sgb_core.curves import search
from sgb_core.curves.segment import (
    LAMBDAS,
    NEUTRAL,
    PARAMETER_RANGES,
    Segment,
    ShapeParameters,
)
from sgb_core.values import dataclass

# The cubic's own leg fractions, to which the chosen member of the family is nearest.
CUBIC_FRACTIONS = NEUTRAL.leg_fractions
# A control point lies at most this many leg directions away: farther out, rounding would
# show in the curve.
_FARTHEST = 1e3
# In a fitted segment b keeps this distance from 0 and 1, for the same reason.
_FIT_MARGIN = 0.01
# Leg fractions nearer than this to the plain cubic's are those, but for rounding.
_ROUNDING = 1e-12
# Of the distance that free control points should keep, the largest of these shares is kept.
_FLOOR_SHARES = (1.0, 1 / 4, 1 / 16, 1 / 64, 1 / 256, 0.0)
# Singular values below this part of the largest are rounding.
_RANK = 1e-12
# Closer than this to b = 0 or 1 the far control point is free; its place would be noise.
_CORNER = 1e-11


@dataclass(frozen=True, slots=True)
class Leg:
    """An end leg's direction D and how much of it the end derivative takes: Q1 − Q0 = κ D.

    Where κ = 0 the control point is free along D; if it can, it stays ``least`` times D away
    from the end, so that the leg does not vanish.
    """

    direction: Floats
    part: float
    least: float = 0.0

    def measured_in(self, length: float) -> Leg:
        """Return the same leg with a direction of that length; one without any stays."""
        factor = float(np.hypot(*self.direction)) / (length or 1.0)
        if factor == 0.0:
            return self
        return Leg(self.direction / factor, factor * self.part, factor * self.least)


def to_segment(quartic: Floats, start: Leg, end: Leg, omega: float = 1.0) -> tuple[Segment, Floats]:
    """Return (segment, its quartic error) for quartic points of shape (5, 2).

    ``start`` and ``end`` say along which directions P1 and P2 lie. Of all segments that are
    this curve the one is taken whose leg fractions are nearest the cubic's; ``omega`` is kept
    where those fractions can be reached with it, else it becomes 1. Where there is none, Q1 and
    Q3 are kept, so that both end derivatives are, and Q2 is as near as it can be. The error is
    the displacement of each of the five quartic points, shape (5, 2).
    """
    # In one measure: near the end of a curve one leg can be a million times the other.
    extent = float(np.ptp(quartic, axis=0).max())
    start, end = start.measured_in(extent), end.measured_in(extent)
    system = np.column_stack([quartic[0] - quartic[4], start.direction, end.direction])
    wanted = quartic[2] - quartic[4]
    # Rounding is relative to the extent, and to the distance from the origin.
    scale = extent + 0.25 * float(np.abs(quartic).max())
    solution = None
    for share in _FLOOR_SHARES:
        floors = max(start.part, share * start.least), max(end.part, share * end.least)
        solution = _nearest_member(system, wanted, start.part, end.part, floors, scale)
        if solution is not None:
            break
    if solution is None:
        solution = _nearest_point(system, wanted, start.part, end.part)
    segment = _build(quartic, start, end, _snapped(solution), omega)
    return segment, segment.quartic - quartic


def _limits(part1: float, part2: float, margin: float = 0.0) -> tuple[Floats, Floats]:
    """Return (G, g): the admissible z = (b, p, q) are those with G z ≥ g."""
    far1, far2 = (_FARTHEST * max(part, 1.0) for part in (part1, part2))
    matrix = np.array(
        [
            [1.0, 0.0, 0.0],
            [-1.0, 0.0, 0.0],
            [-part1, 1.0, 0.0],
            [part2, 0.0, 1.0],
            [far1, -1.0, 0.0],
            [-far2, 0.0, -1.0],
        ]
    )
    return matrix, np.array([margin, margin - 1.0, 0.0, part2, 0.0, -far2])


def _snapped(z: Floats) -> Floats:
    """Return a solution with b at 0 or 1 made exact, where one control point is free."""
    b, p, q = z
    if b < _CORNER and p < _CORNER * _FARTHEST:
        return np.array([0.0, 0.0, q])
    if 1.0 - b < _CORNER and q < _CORNER * _FARTHEST:
        return np.array([1.0, p, 0.0])
    return z


def _fractions(z: Floats, part1: float, part2: float) -> Floats:
    """Return the leg fractions (a, b, c), shape (..., 3), of solutions z = (b, p, q)."""
    b, p, q = z[..., 0], z[..., 1], z[..., 2]
    # At b = 0 and p = 0 the control point, and with it the fraction, is free.
    a = np.divide(part1 * b, p, out=np.full_like(b, CUBIC_FRACTIONS[0]), where=p > 0.0)
    c = np.divide(part2 * (1.0 - b), q, out=np.full_like(b, CUBIC_FRACTIONS[2]), where=q > 0.0)
    return np.stack([a, b, c], axis=-1)


def _cost(z: Floats, part1: float, part2: float) -> Floats:
    difference = _fractions(z, part1, part2) - np.array(CUBIC_FRACTIONS)
    cost: Floats = (difference**2).sum(axis=-1)
    return cost


def _nearest_member(
    system: Floats,
    wanted: Floats,
    part1: float,
    part2: float,
    floors: tuple[float, float],
    scale: float,
) -> Floats | None:
    """Return the admissible exact solution nearest the cubic's fractions, or None.

    The control points keep at least ``floors`` leg directions away from their ends.
    """
    a, b, c = CUBIC_FRACTIONS
    cubic = np.array([b, b * part1 / a, (1.0 - b) * part2 / c])
    if part1 > 0.0 and part2 > 0.0 and np.abs(system @ cubic - wanted).max() <= 4e-15 * scale:
        return cubic

    limits = _limits(*floors)

    parts = (part1, part2)
    u, sigma, vt = np.linalg.svd(system)
    rank = int((sigma > _RANK * sigma[0]).sum())
    base = vt[:rank].T @ ((u.T @ wanted)[:rank] / sigma[:rank])
    if np.abs(system @ base - wanted).max() > 1e-14 * scale:
        return None
    if rank == 2:
        return _best_on_line(base, vt[2], limits, parts)
    # All points lie in one line: one equation k·z = w is left, and a family of two parameters.
    k, w = vt[0], float(vt[0] @ base)
    legs = float(k[1] ** 2 + k[2] ** 2)
    if legs <= _RANK**2:
        return np.array([w / k[0], 0.0, 0.0]) if rank else cubic

    def foot(b: float) -> Floats:
        return np.array([b, *(k[1:] * (w - k[0] * b) / legs)])

    across = np.array([0.0, k[2], -k[1]])

    def at(b: float) -> Floats | None:
        return _best_on_line(foot(b), across, limits, parts)

    low, high = _range_of_b(foot(0.0), foot(1.0) - foot(0.0), across, limits)
    step = (high - low) / 32
    candidates = [
        (float(_cost(z, *parts)), b)
        for b in np.linspace(low, high, 33).tolist()
        if (z := at(b)) is not None
    ]
    if not candidates:
        return None
    best = min(candidates)[1]

    def cost_at(b: float) -> float:
        z = at(b)
        return float("inf") if z is None else float(_cost(z, *parts))

    return at(search.least(cost_at, max(best - step, low), best, min(best + step, high)))


def _range_of_b(
    base: Floats, along: Floats, across: Floats, limits: tuple[Floats, Floats]
) -> tuple[float, float]:
    """Return the least and greatest b of the admissible part of a plane, from its corners.

    Points of the plane are base + b·along + t·across. (0, 1) where no corner is admissible.
    """
    matrix, least = limits
    rows = np.column_stack([matrix @ along, matrix @ across])
    right = least - matrix @ base
    corners = []
    for i, j in combinations(range(len(rows)), 2):
        pair = rows[[i, j]]
        if abs(np.linalg.det(pair)) > 1e-12 * np.abs(pair).max() ** 2:
            corner = np.linalg.solve(pair, right[[i, j]])
            if (rows @ corner - right >= -1e-10 * np.abs(rows).max(axis=1)).all():
                corners.append(float(corner[0]))
    return (min(corners), max(corners)) if corners else (0.0, 1.0)


def _best_on_line(
    base: Floats,
    along: Floats,
    limits: tuple[Floats, Floats],
    parts: tuple[float, float],
) -> Floats | None:
    """Return the cheapest admissible point of a line in (b, p, q), or None if there is none."""
    matrix, least = limits
    slope, slack = matrix @ along, matrix @ base - least
    # Being inside but for rounding is being inside; the bounds on distance magnify it.
    largest = np.abs(matrix).max(axis=1)
    rounding = 2e-12 * largest
    slack = np.where(np.abs(slack) < rounding, 0.0, slack)
    flat = np.abs(slope) < 1e-14 * largest
    if (slack[flat] < 0.0).any():
        return None
    bounds = -slack[~flat] / slope[~flat]
    low = float(bounds[slope[~flat] > 0.0].max(initial=-_FARTHEST))
    high = float(bounds[slope[~flat] < 0.0].min(initial=_FARTHEST))
    if low > high + 1e-11:
        return None
    low, high = min(low, high), max(low, high)
    # Dense at both ends: with parallel legs the good stretch can be a small part of the line.
    fine = np.geomspace(1e-9, 0.5, 60)
    marks = low + (high - low) * distinct([0.0], fine, 1.0 - fine, [1.0])
    costs = _cost(base + marks[:, None] * along, *parts)
    k = int(np.argmin(costs))
    before, after = max(k - 1, 0), min(k + 1, len(marks) - 1)
    # The golden section works on plain floats, which cost a tenth of small arrays.
    part1, part2 = parts

    def nearness(b: float, p: float, q: float) -> float:
        a = part1 * b / p if p > 0.0 else CUBIC_FRACTIONS[0]
        c = part2 * (1.0 - b) / q if q > 0.0 else CUBIC_FRACTIONS[2]
        return ((a - CUBIC_FRACTIONS[0]) ** 2 + (b - CUBIC_FRACTIONS[1]) ** 2) + (
            c - CUBIC_FRACTIONS[2]
        ) ** 2

    (b0, p0, q0), (b1, p1, q1) = base.tolist(), along.tolist()
    best = search.least(
        lambda t: nearness(b0 + t * b1, p0 + t * p1, q0 + t * q1),
        float(marks[before]),
        float(marks[k]),
        float(marks[after]),
    )
    z: Floats = base + best * along
    return z


def _nearest_point(system: Floats, wanted: Floats, part1: float, part2: float) -> Floats:
    """Return the admissible z whose Q2 is nearest the wanted one: a small quadratic program.

    The optimum has some set of at most three limits active; each set is tried.
    """
    matrix, least = _limits(part1, part2, _FIT_MARGIN)
    best, best_distance = np.array([0.5, part1, part2]), float("inf")
    for count in range(4):
        for active in combinations(range(len(least)), count):
            rows, values = matrix[list(active)], least[list(active)]
            if count and np.linalg.matrix_rank(rows) < count:
                continue
            # Minimise |S z − w|² with the active limits met exactly.
            start = np.linalg.lstsq(rows, values, rcond=None)[0] if count else np.zeros(3)
            free = np.linalg.svd(rows)[2][count:].T if count else np.eye(3)
            step = np.linalg.lstsq(system @ free, wanted - system @ start, rcond=None)[0]
            z = start + free @ step
            if (matrix @ z - least < -1e-12).any():
                continue
            distance = float(np.hypot(*(system @ z - wanted)))
            if distance < best_distance:
                best, best_distance = z, distance
    return best


def _build(quartic: Floats, start: Leg, end: Leg, z: Floats, omega: float) -> Segment:
    b = min(max(float(z[0]), 0.0), 1.0)
    fractions = _fractions(z, start.part, end.part)
    points = np.array([quartic[0], quartic[0], quartic[4], quartic[4]])
    ends = []
    for row, leg, share, weight, fraction in (
        (1, start, float(z[1]), b, float(fractions[0])),
        (2, end, float(z[2]), 1.0 - b, float(fractions[2])),
    ):
        cubic = CUBIC_FRACTIONS[0]
        if not leg.direction.any():
            # A leg without length: every fraction gives the same curve.
            ends.append(cubic)
            continue
        if weight > 0.0:
            reach = share / weight
        else:
            # Q2 does not see this control point: only the end derivative decides.
            reach, fraction = (leg.part / cubic, cubic) if leg.part else (1.0, 0.0)
        points[row] += reach * leg.direction
        ends.append(min(max(fraction, 0.0), 1.0))
    return Segment(points, _shape(ends[0], b, ends[1], omega))


def _shape(a: float, b: float, c: float, omega: float) -> ShapeParameters:
    """Return parameters with these leg fractions, at this ω where it reaches them, else at 1."""
    if max(abs(f - cubic) for f, cubic in zip((a, b, c), CUBIC_FRACTIONS, strict=True)) < _ROUNDING:
        return ShapeParameters(omega=omega) if omega else NEUTRAL
    # Far below, the division would lose the digits that the fractions need.
    if omega >= 0.05:
        lambdas = (1 + (3 - 4 * a) / omega, 3 + (6 * b - 3) / omega, 1 + (3 - 4 * c) / omega)
        ranges = [PARAMETER_RANGES[name] for name in LAMBDAS]
        if all(low <= x <= high for x, (low, high) in zip(lambdas, ranges, strict=True)):
            return ShapeParameters(*lambdas, omega)
    return ShapeParameters.from_leg_fractions(a, b, c)
