"""Legs that follow an end or a joint in proportion to the segment's chord."""

from __future__ import annotations

from math import hypot

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves.constraints import PointKey
from sgb_core.curves.profile import GAP, Profile

# A chord below this part of the new one has no proportions that legs could keep.
_NO_CHORD = 1e-6


def scaled_legs(profile: Profile, moved: PointKey, to: ArrayLike) -> dict[PointKey, Floats]:
    """Return the handles of the segments at an end or joint that moves; none for a handle.

    Every leg beside the point keeps its direction, and its length the part of its segment's chord
    that it was, at both ends of these segments. A segment whose ends nearly coincide carries its
    handles.
    """
    place = np.asarray(to, dtype=np.float64)
    found: dict[PointKey, Floats] = {}
    for segment, index in _ends_at(profile, moved):
        points = profile.segments[segment].points
        far = points[3 - index]
        chord, wanted = points[index] - far, place - far
        long = hypot(*chord)
        factor = hypot(*wanted) / long if long > _NO_CHORD * hypot(*wanted) else 1.0
        near, other = (1, 2) if index == 0 else (2, 1)
        found[segment, near] = place + factor * (points[near] - points[index])
        found[segment, other] = far + factor * (points[other] - far)
    return found


def _ends_at(profile: Profile, moved: PointKey) -> list[PointKey]:
    segment, index = moved
    if index not in (0, 3):
        return []
    ends = [moved]
    joint = segment if index == 3 else (segment - 1) % len(profile)
    inside = joint in profile.joints and (index == 3 or segment > 0 or profile.closed)
    if inside and profile.gaps[joint] <= GAP * profile.size and len(profile) > 1:
        before, after = profile.neighbours(joint)
        ends.append((after, 0) if index == 3 else (before, 3))
    return ends
