"""The joints' rules as equations of a chain's numbers, with first and second derivatives.

Of the segments before and after a joint enter b, c, P1, P2, P3 and a, b, P0, P1, P2: sixteen
numbers. G1 asks that P3 − P2 and P1' − P0' point the same way, C1 also c |P3 − P2| =
a' |P1' − P0'|, G2 also equal curvatures, ¾ b/c² (d2×d3)/|d3|³ = ¾ (1−b')/a'² (d1'×d2')/|d1'|³.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.profile import JointRule
from sgb_core.design.demands.chain import BLOCK, Chain
from sgb_core.values import dataclass

PARTS = ("tangent", "speed", "curvature")
_DIFFERENCE = 1e-5
# Where the sixteen numbers stand in the blocks before and after the joint.
_BEFORE = (1, 2, 5, 6, 7, 8, 9, 10)
_AFTER = (0, 1, 3, 4, 5, 6, 7, 8)


@dataclass(frozen=True, slots=True)
class Equations:
    """Residuals (m,), their slopes (m, N) by all numbers of a chain, and what each belongs to.

    ``bends`` holds second derivatives as (places (k,), matrix (k, k)) for each, where known.
    """

    residual: Floats
    slope: Floats
    bends: tuple[tuple[NDArray[np.intp], Floats] | None, ...]

    @classmethod
    def none(cls, count: int) -> Equations:
        """Return no equations of ``count`` numbers."""
        return cls(np.zeros(0), np.zeros((0, count)), ())

    def __add__(self, other: Equations) -> Equations:
        return Equations(
            np.concatenate([self.residual, other.residual]),
            np.concatenate([self.slope, other.slope]),
            self.bends + other.bends,
        )


@dataclass(frozen=True, slots=True)
class JointEquation:
    """One equation of a joint; ``part`` is one of PARTS."""

    joint: int
    before: int
    after: int
    part: str


def equations_of(
    rules: dict[int, JointRule], count: int, *, points_move: bool
) -> list[JointEquation]:
    """Return the equations that keep the rules of some joints of a chain of ``count`` segments.

    Where no point moves, what holds of the legs' directions goes on holding.
    """
    found = []
    for joint, rule in sorted(rules.items()):
        before, after = joint, (joint + 1) % count
        parts = {
            JointRule.G1: ("tangent",),
            JointRule.C1: ("tangent", "speed"),
            JointRule.G2: ("tangent", "curvature"),
        }.get(rule, ())
        found += [
            JointEquation(joint, before, after, part)
            for part in parts
            if points_move or part != "tangent"
        ]
    return found


def joint_equations(chain: Chain, wanted: list[JointEquation], second: bool) -> Equations:
    """Return the residuals of the wanted equations, each about 1 where it is far from true.

    Tangents: the sine of the kink. Speeds: their difference as a part of their mean. Curvatures:
    κ2 − κ1, times 4/3 a'² c², as a part of what the polygons' own curvatures are. Second
    derivatives are central differences of the first.
    """
    size = chain.blocks.size
    if not wanted:
        return Equations.none(size)
    places, parts = _tables(tuple(wanted))
    values = chain.blocks.ravel()[places]
    scales = _scales(values)
    residual, slopes = _residuals(values, parts, scales)
    slope = np.zeros((len(wanted), size))
    # Added, not set: the two blocks of a ring's only segment are one.
    np.add.at(slope, (np.arange(len(wanted))[:, None], places), slopes)
    if not second:
        return Equations(residual, slope, (None,) * len(wanted))
    steps = _DIFFERENCE * np.concatenate([np.eye(16), -np.eye(16)])
    moved = (values[:, None, :] + steps).reshape(-1, 16)
    repeated = np.repeat(scales[0], 32), np.repeat(scales[1], 32)
    around = _residuals(moved, np.repeat(parts, 32), repeated)[1]
    halves = around.reshape(len(wanted), 2, 16, 16)
    bends = (halves[:, 0] - halves[:, 1]) / (2.0 * _DIFFERENCE)
    bends = (bends + np.swapaxes(bends, 1, 2)) / 2.0
    return Equations(residual, slope, tuple(zip(places, bends, strict=True)))


@lru_cache(maxsize=32)
def _tables(wanted: tuple[JointEquation, ...]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return where the numbers of equations stand in a chain, (m, 16), and their parts (m,)."""
    before = BLOCK * np.array([[each.before] for each in wanted])
    after = BLOCK * np.array([[each.after] for each in wanted])
    places = np.concatenate([before + np.array(_BEFORE), after + np.array(_AFTER)], axis=1)
    return places, np.array([PARTS.index(each.part) for each in wanted])


def _scales(v: Floats) -> tuple[Floats, Floats]:
    """Return the mean of the two speeds and the sum of the two polygons' curvatures."""
    d2, d3, e1, e2 = _legs(v)
    length1, length2 = np.hypot(*d3), np.hypot(*e1)
    speeds = (v[:, 1] * length1 + v[:, 8] * length2) / 2.0
    bends = np.abs(_cross(d2, d3)) / length1**3 + np.abs(_cross(e1, e2)) / length2**3
    return np.asarray(speeds), np.asarray(np.maximum(bends, 1.0))


def _residuals(
    v: Floats, parts: NDArray[np.intp], scales: tuple[Floats, Floats]
) -> tuple[Floats, Floats]:
    """Return residuals (k,) and slopes (k, 16) of the numbers ``v`` (k, 16)."""
    residual, slope = np.empty(len(v)), np.zeros((len(v), 16))
    for part, expand in enumerate((_tangents, _speeds, _curvatures)):
        rows = np.flatnonzero(parts == part)
        if len(rows) == 0:
            continue
        found, by_numbers, by_legs = expand(v[rows], scales[0][rows], scales[1][rows])
        residual[rows] = found
        own = np.zeros((len(rows), 16))
        for k, values in by_numbers.items():
            own[:, k] = values
        # By the legs d2, d3 before the joint and d1, d2 after it, that is by the points.
        for (low, high), rate in zip(((2, 4), (4, 6), (10, 12), (12, 14)), by_legs, strict=True):
            if rate is not None:
                own[:, low : low + 2] -= rate.T
                own[:, high : high + 2] += rate.T
        slope[rows] = own
    return residual, slope


_Expanded = tuple[Floats, dict[int, Floats], tuple[Floats | None, ...]]


def _tangents(v: Floats, _: Floats, __: Floats) -> _Expanded:
    _, d3, e1, _ = _legs(v)
    length1, length2 = np.hypot(*d3), np.hypot(*e1)
    sine = _cross(d3, e1) / (length1 * length2)
    by_d3 = np.stack([e1[1], -e1[0]]) / (length1 * length2) - sine * d3 / length1**2
    by_e1 = np.stack([-d3[1], d3[0]]) / (length1 * length2) - sine * e1 / length2**2
    return sine, {}, (None, by_d3, by_e1, None)


def _speeds(v: Floats, mean: Floats, _: Floats) -> _Expanded:
    _, d3, e1, _ = _legs(v)
    c1, a2 = v[:, 1], v[:, 8]
    length1, length2 = np.hypot(*d3), np.hypot(*e1)
    residual = (a2 * length2 - c1 * length1) / mean
    by_numbers = {1: -length1 / mean, 8: length2 / mean}
    by_legs = (None, -c1 * d3 / (length1 * mean), a2 * e1 / (length2 * mean), None)
    return residual, by_numbers, by_legs


def _curvatures(v: Floats, _: Floats, bends: Floats) -> _Expanded:
    d2, d3, e1, e2 = _legs(v)
    b1, c1, a2, b2 = v[:, 0], v[:, 1], v[:, 8], v[:, 9]
    length1, length2 = np.hypot(*d3), np.hypot(*e1)
    bend1, bend2 = _cross(d2, d3) / length1**3, _cross(e1, e2) / length2**3
    first, last = b1 * a2 * a2 / bends, (1.0 - b2) * c1 * c1 / bends
    by_numbers = {
        0: -bend1 * a2 * a2 / bends,
        1: 2.0 * (1.0 - b2) * c1 * bend2 / bends,
        8: -2.0 * b1 * a2 * bend1 / bends,
        9: -c1 * c1 * bend2 / bends,
    }
    by_legs = (
        -first * np.stack([d3[1], -d3[0]]) / length1**3,
        -first * (np.stack([-d2[1], d2[0]]) / length1**3 - 3.0 * bend1 * d3 / length1**2),
        last * (np.stack([e2[1], -e2[0]]) / length2**3 - 3.0 * bend2 * e1 / length2**2),
        last * np.stack([-e1[1], e1[0]]) / length2**3,
    )
    return last * bend2 - first * bend1, by_numbers, by_legs


def _legs(v: Floats) -> tuple[Floats, ...]:
    """Return the legs d2, d3 before the joint and d1, d2 after it, shape (2, k) each."""
    before, after = v[:, 2:8].reshape(-1, 3, 2), v[:, 10:16].reshape(-1, 3, 2)
    d, e = np.diff(before, axis=1), np.diff(after, axis=1)
    return d[:, 0].T, d[:, 1].T, e[:, 0].T, e[:, 1].T


def _cross(u: Floats, v: Floats) -> Floats:
    return np.asarray(u[0] * v[1] - u[1] * v[0])
