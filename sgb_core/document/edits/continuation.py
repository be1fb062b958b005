"""Sensible new segments: one that goes on from the end, one that fills a gap inside."""

from __future__ import annotations

from math import hypot

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment

# A smooth leg that the axis would cut to less than this part of a third of the new segment is
# too short to be a leg; the segment starts with a kink then.
SHORTEST_LEG = 1e-3
# A new segment is at most this part of the profile's size: the first one of all goes on, too.
LONGEST_CHORD = 0.4
# An average chord below this part of the profile's size per segment says nothing about size.
SHORTEST_CHORD = 0.05


def continuation(profile: Profile) -> tuple[Segment, JointRule]:
    """Return a segment that goes on from the end of an open profile, and the joint's rule.

    It leaves along the true end tangent and bends upright; its chord is the average of the
    others, and never large beside the whole. It stays on the side of the axis that the profile
    lies on.
    """
    last = profile.segments[-1]
    start = last.points[3]
    length = _typical_length(profile)
    tangent = last.end_tangent(profile.size)
    upright = _upright(profile, tangent)
    if not tangent.any():
        tangent = upright
    side = 1.0 if profile.control_points[..., 0].sum() >= 0.0 else -1.0
    leg, rule = length / 3.0, JointRule.G1
    inward = -side * float(tangent[0])
    room = side * float(start[0])
    if room >= 0.0 and inward > 0.0 and inward * leg > room:
        # The straight leg would pass the axis: shorten it, or turn it back where it cannot be.
        leg = room / inward
        if leg < SHORTEST_LEG * length / 3.0:
            leg, rule = length / 3.0, JointRule.G0
            tangent = np.array([-tangent[0], tangent[1]])
    ahead = tangent + upright
    if hypot(*ahead) < 1e-6:
        ahead = tangent
    end = start + length * ahead / hypot(*ahead)
    if room >= 0.0 and side * end[0] < 0.0:
        end[0] = 0.0
    points = np.stack([start, start + leg * tangent, end - upright * length / 3.0, end])
    return Segment(points), rule


def bridge(profile: Profile, index: int) -> tuple[Segment, Floats]:
    """Return a segment to go in before segment ``index``, and how far that makes the rest move.

    The shift is along the axis only, in the direction in which the chain runs there. The
    segment takes both its tangents from its neighbours.
    """
    before, after = profile.segments[index - 1], profile.segments[index]
    size = profile.size
    length = _typical_length(profile) / 2.0
    leaving, arriving = before.end_tangent(size), after.start_tangent(size)
    upright = _upright(profile, leaving + arriving)
    shift = upright * length
    start, end = before.points[3], after.points[0] + shift
    leaving = leaving if leaving.any() else upright
    arriving = arriving if arriving.any() else upright
    leg = length / 3.0
    return Segment(np.stack([start, start + leg * leaving, end - leg * arriving, end])), shift


def _typical_length(profile: Profile) -> float:
    points = profile.control_points
    chords = points[:, 3] - points[:, 0]
    length = float(np.hypot(chords[:, 0], chords[:, 1]).mean())
    share = profile.size / len(profile)
    # Segments that come back to their start have no chord worth following; a profile of one
    # point has no size either.
    if length <= SHORTEST_CHORD * share:
        return share or 1.0
    return min(length, LONGEST_CHORD * profile.size)


def _upright(profile: Profile, tangent: Floats) -> Floats:
    """Return (0, ±1): along the axis, the way the tangent points, else the way the chain goes."""
    rise = float(tangent[1])
    if abs(rise) < 1e-6:
        rise = float(profile.segments[-1].points[3, 1] - profile.segments[0].points[0, 1])
    return np.array([0.0, -1.0 if rise < 0.0 else 1.0])
