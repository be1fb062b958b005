"""Where an open chain stands: its lower end, or where its bottom ends if it closes on the axis."""

from __future__ import annotations

from itertools import pairwise
from math import atan2, pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.profile import Profile
from sgb_core.curves.roots import evaluate, real_roots
from sgb_core.values import dataclass

# Of the size of the chain.
_ON_AXIS = 1e-9
_LEVEL = 1e-6
# Where a curve turns by this much, a face ends.
_CORNER = pi / 9.0
# How near to an end of a segment its directions are taken.
_BESIDE = basis.bernstein(4, np.array([0.0, 0.02, 0.98, 1.0]))
_ROWS = basis.bernstein(4, np.linspace(0.0, 1.0, 17))


@dataclass(frozen=True, slots=True)
class Foot:
    """A place on a chain: a segment and its parameter s.

    ``after`` is the number of segments between the end on the axis and the place, where it is at
    the end of a segment; 0 at the lower end itself, None within a segment.
    """

    segment: int
    s: float
    after: int | None


def foot_of(quartics: Floats) -> Foot:
    """Return where a chain of quartics (n, 5, 2), of size 1, stands.

    That is its lower end, unless that lies on the axis. Then it is the lowest ring, if the bottom
    is hollow or level, else the first corner of a bottom that rises by less than 45°. A bottom
    without any, such as a sphere's, has no foot, and the place is the end on the axis.
    """
    last = bool(quartics[-1, 4, 1] < quartics[0, 0, 1])
    walked = quartics[::-1, ::-1] if last else quartics
    count = len(quartics)

    def place(number: int, s: float, after: int | None) -> Foot:
        return Foot(count - 1 - number if last else number, 1.0 - s if last else s, after)

    end = place(0, 0.0, 0)
    r, h = walked[0, 0].tolist()
    if abs(r) > _ON_AXIS:
        return end
    number, s, lowest = _lowest(walked)
    if lowest < h - _LEVEL:
        if 0.0 < s < 1.0:
            return place(number, s, None)
        number += int(s)
        return place(number - 1, 1.0, number) if number else end
    level = 0
    while level < count and float(np.abs(_ROWS @ walked[level, :, 1] - h).max()) <= _LEVEL:
        level += 1
    if level:
        return place(level - 1, 1.0, level)
    for number in range(1, count):
        r, rise = walked[number, 0, 0], walked[number, 0, 1] - h
        if abs(rise) > abs(r):
            break
        if _turn(walked[number - 1], walked[number]) >= _CORNER:
            return place(number - 1, 1.0, number)
    return end


def _lowest(walked: Floats) -> tuple[int, float, float]:
    """Return the segment, the parameter and the height of the lowest place."""
    best = (0, 0.0, float(walked[0, 0, 1]))
    for number in np.flatnonzero(walked[..., 1].min(axis=1) < best[2]).tolist():
        heights = walked[number, :, 1].tolist()
        for s in (1.0, *real_roots([after - before for before, after in pairwise(heights)])):
            value = evaluate(heights, s)
            if value < best[2]:
                best = (number, s, value)
    return best


def _turn(before: Floats, after: Floats) -> float:
    """Return by how much the curve turns from one segment to the next, in radians."""
    arriving, leaving = _BESIDE[2:] @ before, _BESIDE[:2] @ after
    (a, b), (c, d) = (arriving[1] - arriving[0]).tolist(), (leaving[1] - leaving[0]).tolist()
    return abs(atan2(a * d - b * c, a * c + b * d))


def standing(profile: Profile) -> frozenset[int]:
    """Return the segments that lie flat at the lowest level: what stands on them stays flat."""
    heights = profile.control_points[..., 1]
    flat = (heights == heights.min()).all(axis=1)
    return frozenset() if flat.all() else frozenset(np.flatnonzero(flat).tolist())
