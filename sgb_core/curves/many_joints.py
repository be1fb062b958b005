"""What many joints are at once, by arrays: as :mod:`sgb_core.curves.continuity` measures one.

For searches over many angles, where one joint after another would take a hundred times as long.
Numbers agree with those of one joint up to rounding; who reports a joint measures it there.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.continuity import (
    EQUAL_CURVATURES,
    EQUAL_DERIVATIVES,
    KINK_DEG,
    JointClass,
)
from sgb_core.curves.profile import GAP
from sgb_core.curves.segment import DEGENERATE_LEG
from sgb_core.values import dataclass

RANKS = tuple(JointClass)


@dataclass(frozen=True, slots=True, eq=False)
class ManyEnds:
    """Ends as :class:`sgb_core.curves.continuity.EndView` has one, each walked away from.

    ``at`` has shape (..., 2), ``legs`` (3, ..., 2); the three numbers have shape (...) and
    broadcast against them. ``bend`` is what curves the ends beside what their legs do.
    """

    at: Floats
    legs: Floats
    fraction: Floats
    weight: Floats
    far_fraction: Floats
    bend: Floats | float = 0.0

    def reach(self) -> Floats:
        """Return a quarter of the end derivatives' length."""
        return np.asarray(self.fraction * _length(self.legs[0]))

    def is_degenerate(self, reach: Floats, size: float) -> NDArray[np.bool_]:
        """Whether the end derivatives vanish, ``reach`` given."""
        return np.asarray((reach < DEGENERATE_LEG * size) | (reach == 0.0))

    def curvature(self) -> Floats:
        """Return the signed curvatures; infinite or nan where a leg or its fraction is zero."""
        first, second, _ = self.legs
        below = self.fraction**2 * _length(first) ** 3
        above = 0.75 * self.weight * _cross(first, second)
        return np.asarray(above / below + self.bend)

    def tangent(self, size: float) -> Floats:
        """Return the true unit tangents, shape (..., 2); nan where all is a single point."""
        first, second, third = self.legs
        a, weight, far = (
            part[..., None] for part in (self.fraction, self.weight, 1.0 - self.far_fraction)
        )
        both = first + second
        later = ((first, weight, second), (both, far, third), (both, 1.0, third))
        found: Floats = a * first
        length = _length(found)
        for start, part, leg in later:
            short = (length == 0.0) | (length < DEGENERATE_LEG * size)
            if not short.any():
                break
            found = np.where(short[..., None], start + part * leg, found)
            length = _length(found)
        short = (length == 0.0) | (length < DEGENERATE_LEG * size)
        return np.asarray(found / np.where(short, np.nan, length)[..., None])


@dataclass(frozen=True, slots=True, eq=False)
class ManyJoints:
    """What joints are, each shape (...); nan where a report has None.

    ``rank`` is the place in RANKS of the class, ``kink`` in degrees, ``jump`` the size of the jump
    of curvature, ``off`` how far the logarithm of the speed ratio is from 0.
    """

    rank: NDArray[np.intp]
    kink: Floats
    jump: Floats
    off: Floats
    degenerate: NDArray[np.bool_]


def measure_many(before: ManyEnds, after: ManyEnds, size: float) -> ManyJoints:
    """Return what ends that meet are, both seen from their joints."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        gap = _length(after.at - before.at) > GAP * size
        back, ahead = before.reach(), after.reach()
        flat1, flat2 = before.is_degenerate(back, size), after.is_degenerate(ahead, size)
        either = flat1 | flat2
        off = np.abs(np.log(ahead / back))
        off = np.where(either | ~np.isfinite(off), np.nan, off)
        k1, k2 = -before.curvature(), after.curvature()
        jump = np.abs(k2 - k1)
        jump = np.where(either | ~np.isfinite(jump), np.nan, jump)
        one, two = -before.tangent(size), after.tangent(size)
        along = one[..., 0] * two[..., 0] + one[..., 1] * two[..., 1]
        kink = np.degrees(np.arctan2(np.abs(_cross(one, two)), along))
        kink = np.where(gap, np.nan, kink)

        smooth = kink < KINK_DEG
        level = jump <= EQUAL_CURVATURES * np.maximum(np.maximum(abs(k1), abs(k2)), 1.0 / size)
        v1 = -(before.fraction[..., None] * before.legs[0])
        v2 = after.fraction[..., None] * after.legs[0]
        alike = _length(v2 - v1) < EQUAL_DERIVATIVES * np.maximum(back, ahead)
    equal = (flat1 & flat2) | alike
    rank = np.select([gap, ~smooth, level, equal], [0, 1, 4, 3], 2)
    return ManyJoints(rank, kink, jump, off, either)


def _length(vectors: Floats) -> Floats:
    return np.asarray(np.hypot(vectors[..., 0], vectors[..., 1]))


def _cross(one: Floats, two: Floats) -> Floats:
    return np.asarray(one[..., 0] * two[..., 1] - one[..., 1] * two[..., 0])
