"""Edits that add segments of a familiar kind, mirror them and change their order."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from math import atan2, hypot, pi, sqrt

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves import primitives
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.edits.checks import (
    as_edit_error,
    lowered,
    member,
    segment_number,
    with_profile,
)
from sgb_core.document.edits.continuation import continuation
from sgb_core.document.edits.renumber_laws import follow
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Said
from sgb_core.findings.edits import NoChord, NoEdit
from sgb_core.findings.refusal import Argument

# An arc is made smaller by this factor until it keeps to its side of the axis.
_SMALLER = 0.7
_TRIES = 12


class Kind(StrEnum):
    """What an added segment is."""

    LINE = "line"
    ARC = "arc"
    CUBIC = "cubic"


@as_edit_error()
def append_kind(document: Document, kind: Kind | str) -> tuple[Document, float]:
    """Add a line, a quarter arc or a cubic after the end; return also its deviation.

    Each leaves along the end tangent, as long as the other segments are on average, and keeps
    to its side of the axis; where the end runs straight into the axis the new one starts with
    a kink. Lines and cubics are exact, deviation 0; an arc is the best single segment. Raises
    EditError on a ring, which has no end, and on an unknown kind.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> longer, _ = sgb.edits.append_kind(cylinder, "line")
    >>> len(longer.profile), longer.height > cylinder.height
    (2, True)
    """
    wanted = member(kind, Kind, "kind")
    profile = document.profile
    if profile.closed:
        raise EditError(NoEdit.RING_HAS_NO_END)
    following, rule = continuation(profile)
    deviation = 0.0
    if wanted is Kind.LINE:
        following = _line(following, profile)
    elif wanted is Kind.ARC:
        following, deviation = _arc(following, profile)
    longer = replace(profile, segments=(*profile.segments, following), rules=(*profile.rules, rule))
    longer = lowered(longer, [len(profile) - 1])
    origin = [*range(len(profile)), None]
    laws = follow(document.variation, origin)
    return with_profile(document, longer, laws, origin), deviation


def _line(following: Segment, profile: Profile) -> Segment:
    start, end = following.points[0], following.points[3]
    heading = following.points[1] - start
    way = heading * (hypot(*(end - start)) / hypot(*heading))
    side = _side(profile)
    if side * start[0] >= 0.0 > side * (start + way)[0]:
        way = way * (start[0] / -way[0])
    return primitives.line(start, start + way)


def _arc(following: Segment, profile: Profile) -> tuple[Segment, float]:
    """Return the quarter arc that leaves like a segment, towards the side it bends to."""
    start, end = following.points[0], following.points[3]
    heading = following.points[1] - start
    heading = heading / hypot(*heading)
    chord = end - start
    radius = hypot(*chord) / sqrt(2.0)
    bend = heading[0] * chord[1] - heading[1] * chord[0]
    left = np.array([-heading[1], heading[0]])
    # A straight continuation bends away from the axis.
    side = _side(profile)
    turn = 1.0 if bend > 1e-9 * radius else -1.0 if bend < -1e-9 * radius else None
    if turn is None:
        turn = 1.0 if side * left[0] >= 0.0 else -1.0
    for _ in range(_TRIES):
        for way in (turn, -turn):
            # Heading and sideways step of a quarter turn are both one radius long.
            if side * (start + radius * (heading + way * left))[0] >= 0.0 or side * start[0] < 0.0:
                return _quarter(start, left * way, way, radius)
        radius *= _SMALLER
    return _quarter(start, left * turn, turn, radius)


def _quarter(start: Floats, inward: Floats, way: float, radius: float) -> tuple[Segment, float]:
    centre = start + radius * inward
    angle = atan2(-inward[1], -inward[0])
    segment, deviation = primitives.arc(centre, radius, angle, angle + way * pi / 2.0)
    points = np.array(segment.points)
    # The end that joins is the very point, not one a rounding away.
    points[0] = start
    return segment.with_points(points), deviation


def _side(profile: Profile) -> float:
    return 1.0 if profile.control_points[..., 0].sum() >= 0.0 else -1.0


@as_edit_error()
def mirror_segment(document: Document, index: int) -> Document:
    """Mirror a segment between its two ends, which stay; its laws follow.

    The mirror stands upright on the middle of the chord, so that what was at one end is at the
    other. Joints beside it are lowered to what they then are. Raises EditError where the ends
    coincide.
    """
    segment_number(document, index)
    profile = document.profile
    segment = profile.segments[index]
    chord = segment.points[3] - segment.points[0]
    length = hypot(*chord)
    if length <= 1e-12 * profile.size:
        raise EditError(NoChord(index))
    along = chord / length
    middle = (segment.points[0] + segment.points[3]) / 2.0
    offset = segment.points - middle
    mirrored = segment.points - 2.0 * np.outer(offset @ along, along)
    points = mirrored[::-1].copy()
    points[0], points[3] = segment.points[0], segment.points[3]
    turned = replace(segment.reversed(), points=points)
    near = [k for k in profile.joints if index in profile.neighbours(k)]
    laws = follow(document.variation, range(len(profile)), {index})
    return with_profile(document, lowered(profile.with_segment(index, turned), near), laws)


@as_edit_error()
def append_mirror_image(document: Document) -> Document:
    """Double an open profile by its mirror image above (or below) its end; laws follow.

    The mirror is the horizontal plane through the end; the joint there is as smooth as the end
    is upright. Raises EditError on a ring.
    """
    profile = document.profile
    if profile.closed:
        raise EditError(NoEdit.RING_HAS_NO_MIRROR)
    count = len(profile)
    height = profile.segments[-1].points[3, 1]

    def image(segment: Segment) -> Segment:
        points = np.array(segment.points)
        points[:, 1] = 2.0 * height - points[:, 1]
        return segment.with_points(points).reversed()

    images = [image(segment) for segment in reversed(profile.segments)]
    rules = (*profile.rules, JointRule.G1, *reversed(profile.rules))
    doubled = replace(profile, segments=(*profile.segments, *images), rules=rules)
    origin = [*range(count), *reversed(range(count))]
    laws = follow(document.variation, origin, range(count, 2 * count))
    return with_profile(document, lowered(doubled, [count - 1]), laws, origin)


@as_edit_error()
def move_segment(document: Document, index: int, step: int) -> Document:
    """Exchange a segment with the next (``step`` 1) or the one before it (−1).

    Both are shifted so that they stay between the same two places; no other segment moves.
    Joints are lowered to what they then are. Raises EditError at an end of the chain.
    """
    segment_number(document, index)
    profile = document.profile
    count = len(profile)
    if step not in (1, -1):
        raise EditError(Argument("the move", step, Said("by 1 or -1")))
    low = min(index, index + step)
    if low < 0 or low + 1 >= count:
        raise EditError(NoEdit.NONE_ON_THAT_SIDE)
    first, second = profile.segments[low], profile.segments[low + 1]
    gap = second.points[0] - first.points[3]
    earlier = second.with_points(second.points + (first.points[0] - second.points[0]))
    later = first.with_points(first.points + (earlier.points[3] + gap - first.points[0]))
    if not gap.any():
        # What joins beyond is joined to the very point, not to one a rounding away.
        points = np.array(later.points)
        points[3] = second.points[3]
        later = later.with_points(points)
    segments = list(profile.segments)
    segments[low], segments[low + 1] = earlier, later
    origin = list(range(count))
    origin[low], origin[low + 1] = low + 1, low
    swapped = profile.with_segments(segments)
    near = [k for k in profile.joints if {low, low + 1} & set(profile.neighbours(k))]
    laws = follow(document.variation, origin)
    return with_profile(document, lowered(swapped, near), laws, origin)
