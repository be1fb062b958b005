"""Control points and joints of a profile that lie on one another."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import GAP, Profile
from sgb_core.curves.segment import DEGENERATE_LEG
from sgb_core.findings.profile import Crossing, LegsWithoutLength, SegmentIsPoint

# Of segments that are points, or have legs without length, so many are named.
_MOST_NAMED = 16


def coincident_points(profile: Profile) -> tuple[SegmentIsPoint | LegsWithoutLength, ...]:
    """Return the segments that are single points, then those with legs of no length, in one.

    Points count as one within 1e-12 of the size.

    >>> found = coincident_points(sgb.Profile.of([sgb.Segment([(1, 1)] * 4)]))
    >>> found[0].segment, found[0].point
    (0, (1.0, 1.0))
    """
    points = single_points(profile)
    lengths = np.hypot(*np.moveaxis(np.diff(profile.control_points, axis=1), -1, 0))
    short = (lengths <= DEGENERATE_LEG * profile.size).any(axis=1) & ~points
    found: list[SegmentIsPoint | LegsWithoutLength] = []
    for number in np.flatnonzero(points).tolist()[:_MOST_NAMED]:
        r, h = profile.segments[number].points[0].tolist()
        found.append(SegmentIsPoint(number, (r, h)))
    if short.any():
        found.append(LegsWithoutLength(tuple(np.flatnonzero(short).tolist()[:_MOST_NAMED])))
    return tuple(found)


def single_points(profile: Profile) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Return which segments are single points, shape (n,)."""
    points = profile.control_points
    spread = np.abs(points - points[:, :1]).max(axis=(1, 2))
    single: np.ndarray[tuple[int], np.dtype[np.bool_]] = spread <= DEGENERATE_LEG * profile.size
    return single


def joint_touches(profile: Profile, most: int) -> list[Crossing]:
    """Return where joints that are no neighbours lie on one point, at most so many.

    Joints with nothing but single points between them are one joint. Where several lie on one
    point each is named with the next.
    """
    numbers, places = _joints(profile)
    near = GAP * profile.size
    found: list[Crossing] = []
    order = np.lexsort(places.T[::-1]).tolist()
    for index, k in enumerate(order):
        for other in order[index + 1 :]:
            if places[other, 0] - places[k, 0] > near:
                break
            if abs(places[other, 1] - places[k, 1]) <= near:
                first, second = sorted((numbers[k], numbers[other]))
                r, h = places[k].tolist()
                found.append(Crossing(first, 1.0, second, 1.0, (r, h), touches=True))
                break
        if len(found) == most:
            break
    return found


def _joints(profile: Profile) -> tuple[list[int], Floats]:
    """Return the joints whose ends meet, by the segment before each, and where they are."""
    points, ends = single_points(profile), profile.control_points
    near = GAP * profile.size
    solid = np.flatnonzero(~points).tolist()
    pairs = list(pairwise(solid))
    if profile.closed and len(solid) > 1:
        pairs.append((solid[-1], solid[0]))
    met = [a for a, b in pairs if np.hypot(*(ends[b, 0] - ends[a, 3])) <= near]
    return met, ends[met, 3].reshape(-1, 2)
