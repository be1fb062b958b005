"""Edits of joints: rules, closing and opening, and joints that come and go."""

from __future__ import annotations

from dataclasses import replace
from typing import get_args

import numpy as np

from sgb_core.curves import subdivision
from sgb_core.curves.constraints import keep_rule
from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.head_to_tail import joined_head_to_tail
from sgb_core.curves.moved import moved
from sgb_core.curves.profile import GAP, STRICTNESS, JointRule
from sgb_core.curves.rule_chain import Yielding
from sgb_core.curves.segment import NEUTRAL, READY, Segment
from sgb_core.document.edits.checks import (
    as_edit_error,
    finite,
    joint_number,
    lowered,
    member,
    met,
    segment_number,
    with_profile,
    with_rules,
)
from sgb_core.document.edits.law_deviation import divided_deviation, merged_deviation
from sgb_core.document.edits.renumber_laws import follow, laws_of
from sgb_core.document.edits.split_textures import texture_halves
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Choice, Said
from sgb_core.findings.edits import LastSegment, NoEdit, NotJoined
from sgb_core.findings.joints import RuleMoves
from sgb_core.findings.refusal import Argument, Unknown

_RANK = ("gap", "G0", "G1", "C1", "G2")
SIDES: tuple[Yielding, ...] = get_args(Yielding)


@as_edit_error()
def set_rule(document: Document, joint: int, rule: JointRule | str) -> Document:
    """Set the rule of a joint and move what must move to satisfy it; the later segment yields.

    A gap is closed by moving the later segment's start. A rule that cannot be satisfied moves
    nothing else, and the joint is reported as what it is; :func:`rule_moves` says what one that
    can be has moved. Raises EditError on an unknown rule, and on "free" for the joint that closes
    a ring.

    >>> legs = [sgb.line((20, 0), (20, 30)), sgb.line((20, 30), (50, 60))]
    >>> smooth = sgb.edits.set_rule(sgb.Document(sgb.Profile.of(legs)), 0, "G1")
    >>> str(smooth.joints[0].measured)
    'G1'
    """
    joint_number(document, joint)
    wanted = member(rule, JointRule, "joint rule")
    profile = document.profile
    if wanted is JointRule.FREE and profile.closed and joint == len(profile) - 1:
        raise EditError(NoEdit.RING_HOLDS_TOGETHER)
    ruled = with_rules(profile, {joint: wanted})
    return with_profile(document, keep_rule(ruled, joint).profile)


def rule_moves(document: Document, ruled: Document, joint: int) -> RuleMoves:
    """Return what choosing the rule of a joint has moved in a document.

    >>> legs = [sgb.line((20, 0), (20, 30)), sgb.line((20, 30), (50, 60))]
    >>> kinked = sgb.Document(sgb.Profile.of(legs))
    >>> sgb.say(sgb.edits.rule_moves(kinked, sgb.edits.set_rule(kinked, 0, "G1"), 0))
    'G1 at joint 0 moved P1 of segment 1 from (30, 40) to (20, 44.1421)'
    """
    profile = ruled.profile
    first, second = profile.neighbours(joint_number(ruled, joint))
    return RuleMoves(first, second, profile.rules[joint].value, moved(document.profile, profile))


def smooth_joints(document: Document, rule: JointRule | str) -> tuple[Document, tuple[int, ...]]:
    """Give every joint a rule and keep it; return also the joints that it cannot be kept at.

    These keep the rule that they have, as do joints that are smoother already. What moves at one
    joint may be moved again by the next, so that all are looked at until nothing changes.

    >>> legs = [sgb.line((20, 0), (20, 30)), sgb.line((20, 30), (50, 60))]
    >>> smooth, left = sgb.edits.smooth_joints(sgb.Document(sgb.Profile.of(legs)), "G1")
    >>> str(smooth.joints[0].measured), left
    ('G1', ())
    """
    wanted = member(rule, JointRule, "joint rule")
    smoothed = document
    for joint in document.profile.joints:
        if STRICTNESS.index(smoothed.profile.rules[joint]) >= STRICTNESS.index(wanted):
            continue
        ruled = set_rule(smoothed, joint, wanted)
        before = len(met(smoothed.profile, smoothed.profile.joints))
        # One that is kept at the price of another is not smoother.
        after = met(ruled.profile, ruled.profile.joints)
        if joint in after and len(after) >= before:
            smoothed = ruled
    left = tuple(
        report.joint
        for report in measure_joints(smoothed.profile)
        if _RANK.index(report.measured.value) < _RANK.index(wanted.value)
    )
    return smoothed, left


def set_yielding(document: Document, joint: int, yielding: Yielding) -> Document:
    """Choose which side of a joint moves for its rule where both could; the other one holds.

    The later side yields by default. What the hand itself moves is never held, and no point
    moves now.
    """
    joint_number(document, joint)
    if yielding not in SIDES:
        raise EditError(Unknown("side", yielding, Choice(SIDES)))
    profile = document.profile
    before, after = profile.neighbours(joint)
    held = yielding == "earlier"
    # Only the later end is ever marked by hand; a reversed chain may bring a mark on the other.
    segments = list(profile.segments)
    segments[before] = replace(segments[before], holds_end=False)
    segments[after] = replace(segments[after], holds_start=held)
    return with_profile(document, profile.with_segments(segments))


@as_edit_error()
def close_profile(document: Document) -> Document:
    """Close the profile into a ring.

    Halves that run in the same direction are put head to tail. Ends that meet are joined; ends
    that do not are connected by a straight segment. The new joints have the rule G0. Raises
    EditError where the profile is closed already.
    """
    profile = document.profile
    if profile.closed:
        raise EditError(NoEdit.CLOSED_ALREADY)
    ordered = joined_head_to_tail(profile)
    if ordered is not None and ordered.profile.closed:
        laws = follow(document.variation, ordered.origin, ordered.backwards)
        joined = lowered(ordered.profile, ordered.profile.joints)
        return with_profile(document, joined, laws, ordered.origin)
    start, end = profile.segments[0].points[0], profile.segments[-1].points[3]
    segments, rules = profile.segments, (*profile.rules, JointRule.G0)
    origin: list[int | None] = [*range(len(profile))]
    if np.hypot(*(end - start)) > GAP * profile.size:
        parts = np.linspace(0.0, 1.0, 4)[:, None]
        line = Segment((1.0 - parts) * end + parts * start, READY)
        segments, rules = (*segments, line), (*rules, JointRule.G0)
        origin.append(None)
    ring = replace(profile, segments=segments, rules=rules, closed=True)
    return with_profile(document, ring, follow(document.variation, origin), origin)


@as_edit_error()
def open_profile(document: Document) -> Document:
    """Open a ring at its closing joint; no point moves.

    Raises EditError where the profile is open already.
    """
    profile = document.profile
    if not profile.closed:
        raise EditError(NoEdit.OPEN_ALREADY)
    return with_profile(document, replace(profile, closed=False, rules=profile.rules[:-1]))


@as_edit_error()
def split_segment(document: Document, index: int, s: float) -> tuple[Document, float]:
    """Divide a segment at 0 < s < 1; return also how far the surface moved, 0 where exact.

    The new joint has the rule G1, and both halves keep the segment's laws or lose them,
    whichever stays nearer: with laws there is in general no exact split. The C1 rule of a joint
    beside them is lowered, since a half runs slower than the whole.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> divided, deviation = sgb.edits.split_segment(cylinder, 0, 0.5)
    >>> len(divided.profile)
    2
    """
    segment_number(document, index)
    at = finite(s, "s")
    if not 0.0 < at < 1.0:
        raise EditError(Argument("s", at, Said("above 0 and below 1")))
    profile = document.profile
    count = len(profile)
    whole = profile.segments[index]
    parts = subdivision.split(whole, at)
    halves = (
        replace(parts.first, extra=whole.extra, holds_start=whole.holds_start),
        replace(parts.second, extra=whole.extra, holds_end=whole.holds_end),
    )
    lawless = not laws_of(document.variation, index)
    if lawless:
        # The halves of a plain cubic are plain cubics; with ω = 1 each λ reshapes them.
        halves = (_ready(halves[0]), _ready(halves[1]))
    before, later = profile.segments[:index], profile.segments[index + 1 :]
    segments = (*before, *halves, *later)
    rules = (*profile.rules[:index], JointRule.G1, *profile.rules[index:])
    longer = replace(profile, segments=segments, rules=rules)
    beside = [k for k in profile.joints if index in profile.neighbours(k)]
    kept = [k if k < index else k + 1 for k in met(profile, beside)]
    longer = lowered(longer, [index, *kept])
    origin = [*range(index + 1), *range(index, count)]
    laws = follow(document.variation, origin)
    divided = texture_halves(with_profile(document, longer, laws, origin), index)
    if lawless:
        return divided, 0.0 if parts.exact else parts.deviation
    bare: list[int | None] = [*origin]
    bare[index] = bare[index + 1] = None
    return _nearest(document, divided, bare, index, at)


def _ready(segment: Segment) -> Segment:
    return segment.with_shape(READY) if segment.shape == NEUTRAL else segment


def _nearest(
    document: Document, divided: Document, bare: list[int | None], index: int, s: float
) -> tuple[Document, float]:
    """Return whichever of the halves with and without laws stays nearer to the original."""
    explicit = tuple(
        replace(law, segments=tuple(range(len(document.profile)))) if law.segments is None else law
        for law in document.variation
    )
    plain = replace(divided, variation=follow(explicit, bare))
    ways = [(way, divided_deviation(document, way, index, s)) for way in (divided, plain)]
    return min(ways, key=lambda way: way[1])


@as_edit_error()
def merge_segments(document: Document, index: int) -> tuple[Document, float]:
    """Replace a segment and the next by the one that fits both best; return how far it moved.

    In a ring the last merges with the first. Laws that govern both go on; others are dropped.
    Raises EditError where there is no next segment or the two do not meet.
    """
    segment_number(document, index)
    profile = document.profile
    count = len(profile)
    if count == 1:
        raise EditError(NoEdit.NONE_TO_MERGE)
    if index == count - 1 and not profile.closed:
        raise EditError(LastSegment(index))
    after = (index + 1) % count
    first, second = profile.segments[index], profile.segments[after]
    if np.hypot(*(second.points[0] - first.points[3])) > GAP * profile.size:
        raise EditError(NotJoined(index, after))
    merged, deviation = subdivision.merge(first, second)
    merged = replace(
        merged, extra=first.extra, holds_start=first.holds_start, holds_end=second.holds_end
    )
    kept = met(profile, profile.joints)
    segments = tuple(
        merged if k == index else part for k, part in enumerate(profile.segments) if k != after
    )
    rules = tuple(rule for k, rule in enumerate(profile.rules) if k != index)
    shorter = replace(profile, segments=segments, rules=rules)
    was_kept = [k for k in profile.joints if k != index]
    shorter = lowered(shorter, [new for new, old in enumerate(was_kept) if old in kept])
    shared = tuple(
        law
        if law.segments is None or {index, after} <= set(law.segments)
        else replace(law, segments=tuple(k for k in law.segments if k not in (index, after)))
        for law in document.variation
    )
    left = [k for k in range(count) if k != after]
    result = with_profile(document, shorter, follow(shared, left), left)
    if laws_of(document.variation, index) or laws_of(document.variation, after):
        deviation = merged_deviation(document, (index, after), result, index - (after < index))
    return result, deviation
