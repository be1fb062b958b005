"""Strokes of a pencil: a freehand line becomes the profile, goes on from it, or redraws a part."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from math import cos, radians

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves.nearest import nearest
from sgb_core.curves.polyline import farthest
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment
from sgb_core.design.tracing import TraceError, trace
from sgb_core.design.tracing.corners import CORNER_DEG
from sgb_core.design.tracing.prepare import checked_points
from sgb_core.document.edits.checks import as_edit_error, lowered, with_profile
from sgb_core.document.edits.joints import split_segment
from sgb_core.document.edits.renumber_laws import follow
from sgb_core.document.edits.source import take_profile
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.values import dataclass

# A stroke that leaves within this angle of the profile goes on smoothly.
_SMOOTH = cos(radians(CORNER_DEG))
# An aligned end may take its run so many tolerances away from the stroke; the shorter its leg the
# less it does. Places along the run that tell.
_MOST_OFF, _LEGS, _PLACES = 1.8, (1.0, 0.7, 0.5, 0.3, 0.2), 17
# Places along a part of a ring that are compared with a stroke.
_LOOKS = 64


class StrokeKind(StrEnum):
    """What a stroke does: it is the whole profile, goes on from an end, or redraws a part."""

    WHOLE = "whole"
    ON = "on"
    PART = "part"


@dataclass(frozen=True, slots=True)
class Stroke:
    """A stroke as it lies to a profile: its points, shape (N, 2), along the profile's direction.

    A stroke that goes on runs away from the end, the start of the profile where ``at_start``.
    ``part`` is the part redrawn, as two places, segment plus s, the first one smaller; of a ring
    it may go on past its end.
    """

    kind: StrokeKind
    points: Floats
    at_start: bool = False
    part: tuple[float, float] = (0.0, 0.0)


def seen(profile: Profile | None, points: ArrayLike, reach: float) -> Stroke:
    """Return what a stroke of (r, h) points, shape (N, 2), means beside a profile.

    One with both ends within ``reach`` of the profile redraws what lies between them; one begun,
    or ended, within reach of an end goes on from there; any other is a whole profile, from foot
    to rim, as each is beside no profile (None). One drawn beyond the axis is mirrored. Raises
    TraceError for what is no stroke.
    """
    stroke = checked_points(points)
    if float(np.median(stroke[:, 0])) < 0.0:
        stroke = stroke * (-1.0, 1.0)
    # A hand that follows the axis shakes to both sides of it.
    shaky = (stroke[:, 0] < 0.0) & (stroke[:, 0] > -reach)
    stroke = np.where(np.stack([shaky, np.zeros_like(shaky)], axis=1), 0.0, stroke)
    upwards = stroke[0, 1] <= stroke[-1, 1]
    whole = Stroke(StrokeKind.WHOLE, stroke if upwards else stroke[::-1])
    if profile is None:
        return whole
    feet = [nearest(profile, end) for end in (stroke[0], stroke[-1])]
    near = [foot.distance <= reach for foot in feet]
    if all(near):
        places = [_snapped(profile, foot.segment + foot.s, reach) for foot in feet]
        if places[0] != places[1]:
            forwards = places[0] < places[1]
            low, high = sorted(places)
            if profile.closed and _goes_round(profile, low, high, stroke):
                low, high, forwards = high, low + len(profile), not forwards
            return Stroke(StrokeKind.PART, stroke if forwards else stroke[::-1], part=(low, high))
    if not profile.closed:
        corners = profile.control_points[[0, -1], [0, 3]]
        for own in (stroke, stroke[::-1]):
            away = np.hypot(*(corners - own[0]).T)
            if away.min() <= reach:
                return Stroke(StrokeKind.ON, own, at_start=bool(away[0] < away[1]))
    return whole


@as_edit_error()
def draw_stroke(document: Document, stroke: Stroke, tolerance: float, reach: float) -> Document:
    """Return the document after a stroke, traced within ``tolerance``.

    A whole profile replaces the old one, with poles where it ends within ``reach`` of the axis. A
    run that goes on, or redraws a part, meets the rest at its ends, smoothly where it was drawn
    so; the rest keeps its place, its joints and their rules. Raises EditError for a stroke that
    is no line.
    """
    try:
        if stroke.kind is StrokeKind.WHOLE:
            points = stroke.points.copy()
            poles = np.abs(points[[0, -1], 0]) <= reach
            points[[0, -1], 0] = np.where(poles, 0.0, points[[0, -1], 0])
            return take_profile(document, _chain(points, tolerance, None), document.reference)
        if stroke.kind is StrokeKind.ON:
            return _drawn_on(document, stroke, tolerance)
        return _redrawn(document, stroke, tolerance)
    except TraceError as error:
        raise EditError(error.finding) from None


def _drawn_on(document: Document, stroke: Stroke, tolerance: float) -> Document:
    profile = document.profile if not stroke.at_start else document.profile.reversed()
    end = profile.segments[-1]
    run = _run(stroke.points, end.points[3], None, tolerance)
    segments, smooth = _aligned(run, end.end_tangent(), None, stroke.points, tolerance)
    rule = JointRule.G1 if smooth[0] else JointRule.G0
    longer = Profile((*profile.segments, *segments), (*profile.rules, rule, *run.rules))
    longer = lowered(longer, range(len(profile) - 1, len(longer) - 1))
    origin: list[int | None] = [*range(len(profile)), *(None for _ in segments)]
    if stroke.at_start:
        longer, origin = longer.reversed(), origin[::-1]
        count = len(profile)
        origin = [None if k is None else count - 1 - k for k in origin]
    return with_profile(document, longer, follow(document.variation, origin), origin)


def _redrawn(document: Document, stroke: Stroke, tolerance: float) -> Document:
    low, high = stroke.part
    if high > len(document.profile):
        # Numbered anew from the part's end on, it does not go round the start.
        high -= len(document.profile)
        if int(low) == int(high) and high % 1.0:
            low = int(low) + 1.0 + (low - high) / (1.0 - high % 1.0)
        elif high % 1.0:
            low += 1.0
        document, shift = _divided(document, high)
        document = _begun_at(document, shift)
        low, high = low - shift, float(len(document.profile))
    # From the end back, so that the numbers before stay as they are.
    document, last = _divided(document, high)
    if int(low) == int(high) and high % 1.0:
        low = int(low) + (low % 1.0) / (high % 1.0)
    document, first = _divided(document, low)
    if low % 1.0:
        last += 1
    profile = document.profile
    count, ring = len(profile), profile.closed
    before = profile.segments[first - 1] if first > 0 or ring else None
    after = profile.segments[last % count] if last < count or ring else None
    start = None if before is None else before.points[3]
    end = None if after is None else after.points[0]
    run = _run(stroke.points, start, end, tolerance)
    incoming = None if before is None else before.end_tangent()
    outgoing = None if after is None else after.start_tangent()
    segments, smooth = _aligned(run, incoming, outgoing, stroke.points, tolerance)
    rules = list(run.rules)
    if before is not None and first > 0:
        rules.insert(0, JointRule.G1 if smooth[0] else JointRule.G0)
    if after is not None:
        rules.append(JointRule.G1 if smooth[1] else JointRule.G0)
    joints = [*profile.rules[: max(first - 1, 0)], *rules, *profile.rules[last:]]
    whole = (*profile.segments[:first], *segments, *profile.segments[last:])
    changed = replace(profile, segments=whole, rules=tuple(joints))
    near = {*range(max(first - 1, 0), min(first + len(segments), len(joints)))}
    changed = lowered(changed, sorted(near | ({len(joints) - 1} if ring else set())))
    origin = [*range(first), *(None for _ in segments), *range(last, count)]
    return with_profile(document, changed, follow(document.variation, origin), origin)


def _begun_at(document: Document, segment: int) -> Document:
    """Return the same ring with another segment as its first."""
    profile = document.profile
    order = [(k + segment) % len(profile) for k in range(len(profile))]
    turned = replace(
        profile,
        segments=tuple(profile.segments[k] for k in order),
        rules=tuple(profile.rules[k] for k in order),
    )
    return with_profile(document, turned, follow(document.variation, order), order)


def _goes_round(profile: Profile, low: float, high: float, stroke: Floats) -> bool:
    """Whether a stroke lies along the part of a ring that goes round its start."""
    middle = stroke[len(stroke) // 2]

    def away(first: float, last: float) -> float:
        places = np.mod(np.linspace(first, last, _LOOKS), len(profile))
        points = [profile.point(int(place), place % 1.0) for place in places.tolist()]
        return float(np.hypot(*(np.array(points) - middle).T).min())

    return away(high, low + len(profile)) < away(low, high)


def _divided(document: Document, place: float) -> tuple[Document, int]:
    """Return the document with a joint at a place, and the number of the segment after it."""
    segment, s = int(place), place % 1.0
    if s == 0.0:
        return document, segment
    return split_segment(document, segment, s)[0], segment + 1


def _snapped(profile: Profile, place: float, reach: float) -> float:
    """Return a place, or the joint or end that is within reach of it."""
    segment = min(int(place), len(profile) - 1)
    here = profile.segments[segment].point(place - segment)
    best, least = place, reach
    for joint, corner in ((segment, 0), (segment + 1, 3)):
        away = float(np.hypot(*(profile.segments[segment].points[corner] - here)))
        if away <= least:
            best, least = float(joint), away
    return best


def _run(points: Floats, start: Floats | None, end: Floats | None, tolerance: float) -> Profile:
    """Return the chain along a stroke whose ends are put where they belong."""
    points = points.copy()
    if start is not None:
        points[0] = start
    if end is not None:
        points[-1] = end
    return _chain(points, tolerance, closed=False)


def _chain(points: Floats, tolerance: float, closed: bool | None) -> Profile:
    # Of places nearer to each other than the hand shakes one is enough.
    kept = [0]
    for number in range(1, len(points) - 1):
        if np.hypot(*(points[number] - points[kept[-1]])) > tolerance:
            kept.append(number)
    return trace(points[[*kept, len(points) - 1]], tolerance, closed=closed).profile


def _aligned(
    run: Profile,
    incoming: Floats | None,
    outgoing: Floats | None,
    stroke: Floats,
    tolerance: float,
) -> tuple[tuple[Segment, ...], tuple[bool, bool]]:
    """Return the run's segments leaving and arriving smoothly where they nearly do, and where."""
    segments, smooth = list(run.segments), [False, False]
    for place, (number, corner, inner, tangent) in enumerate(
        ((0, 0, 1, incoming), (-1, 3, 2, outgoing))
    ):
        if tangent is None:
            continue
        segment = segments[number]
        points = np.array(segment.points)
        leg = points[inner] - points[corner]
        length = float(np.hypot(*leg))
        way = tangent * (1.0 if corner == 0 else -1.0)
        if length == 0.0 or float(leg @ way) < _SMOOTH * length:
            continue
        for part in _LEGS:
            points[inner] = points[corner] + part * length * way
            turned = segment.with_points(points)
            if _off(turned, stroke) <= _MOST_OFF * tolerance:
                segments[number], smooth[place] = turned, True
                break
    return tuple(segments), (smooth[0], smooth[1])


def _off(segment: Segment, stroke: Floats) -> float:
    """Return the largest distance of a segment from the line through a stroke's points."""
    return farthest(segment.point(np.linspace(0.0, 1.0, _PLACES)), stroke)
