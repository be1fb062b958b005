"""Edits that add, remove, reverse and reorder the segments of the chain."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sgb_core.curves.constraints import enforce, move_control_points
from sgb_core.curves.head_to_tail import joined_head_to_tail
from sgb_core.curves.profile import GAP, STRICTNESS, JointRule, Profile
from sgb_core.document.edits.checks import (
    as_edit_error,
    lowered,
    segment_number,
    with_profile,
    with_rules,
)
from sgb_core.document.edits.continuation import bridge, continuation
from sgb_core.document.edits.joints import split_segment
from sgb_core.document.edits.renumber_laws import follow
from sgb_core.document.edits.renumber_paint import look_reversed
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoEdit, NoPlace


@as_edit_error()
def append_segment(document: Document) -> Document:
    """Add a segment that goes on smoothly from the end, bending upright, with the rule G1.

    Its size is the average of the others. It keeps to its side of the axis; where the end runs
    straight into the axis the new segment starts with a kink and the rule G0. Raises EditError
    on a ring, which has no end.
    """
    profile = document.profile
    if profile.closed:
        raise EditError(NoEdit.RING_HAS_NO_END)
    segment, rule = continuation(profile)
    longer = replace(profile, segments=(*profile.segments, segment), rules=(*profile.rules, rule))
    origin = [*range(len(profile)), None]
    return with_profile(document, longer, follow(document.variation, origin), origin)


@as_edit_error()
def prepend_segment(document: Document) -> Document:
    """Add a segment before the first, as :func:`append_segment` does after the last."""
    return reverse_profile(append_segment(reverse_profile(document)))


@as_edit_error()
def insert_segment(document: Document, index: int) -> Document:
    """Add a segment that gets the number ``index``.

    At either end of an open profile it continues the chain. Inside, what follows is shifted
    along the axis to make room, so that no radius changes, and the new segment connects both
    sides smoothly, rules G1. A ring has no room to shift anything: there segment ``index`` is
    split in half. Raises EditError where ``index`` is neither a segment's number nor one more
    than the last.
    """
    profile = document.profile
    count = len(profile)
    if not 0 <= index <= count:
        raise EditError(NoPlace(index, count))
    if profile.closed:
        return split_segment(document, index % count, 0.5)[0]
    if index == count:
        return append_segment(document)
    if index == 0:
        return prepend_segment(document)
    between, shift = bridge(profile, index)
    later = [s.with_points(s.points + shift) for s in profile.segments[index:]]
    segments = (*profile.segments[:index], between, *later)
    joint = index - 1
    rules = (
        *profile.rules[:joint],
        JointRule.G1,
        profile.rules[joint] if profile.rules[joint] is JointRule.FREE else JointRule.G1,
        *profile.rules[index:],
    )
    longer = lowered(replace(profile, segments=segments, rules=rules), (joint, index))
    origin = [*range(index), None, *range(index, count)]
    return with_profile(document, longer, follow(document.variation, origin), origin)


@as_edit_error()
def remove_segment(document: Document, index: int) -> Document:
    """Remove a segment and join its neighbours.

    Their ends meet halfway and carry their legs; the new joint has the weaker of the two rules
    and keeps it. Where that is "free" nothing moves. A ring of two segments is opened. Raises
    EditError on the only segment.
    """
    segment_number(document, index)
    profile = document.profile
    count = len(profile)
    if count == 1:
        raise EditError(NoEdit.ONLY_SEGMENT)
    origin = [k for k in range(count) if k != index]
    segments = tuple(profile.segments[k] for k in origin)
    laws = follow(document.variation, origin)
    if profile.closed and count == 2:
        return with_profile(
            document, replace(profile, segments=segments, rules=(), closed=False), laws, origin
        )
    if not profile.closed and index in (0, count - 1):
        rules = profile.rules[1:] if index == 0 else profile.rules[:-1]
        shorter = replace(profile, segments=segments, rules=rules)
        return with_profile(document, shorter, laws, origin)
    joint = (index - 1) % len(profile.rules)
    rule = _weaker(profile.rules[joint], profile.rules[index])
    if profile.closed and rule is JointRule.FREE and index in (0, count - 1):
        rule = JointRule.G0
    rules = tuple(
        JointRule.FREE if k == joint else kept for k, kept in enumerate(profile.rules) if k != index
    )
    joint -= joint > index
    shorter = replace(profile, segments=segments, rules=rules)
    if rule is not JointRule.FREE:
        shorter = _rejoined(shorter, joint, rule)
    return with_profile(document, shorter, laws, origin)


def _weaker(first: JointRule, second: JointRule) -> JointRule:
    if {first, second} == {JointRule.C1, JointRule.G2}:
        return JointRule.G1
    return min(first, second, key=STRICTNESS.index)


def _rejoined(profile: Profile, joint: int, rule: JointRule) -> Profile:
    """Return the profile with a free joint closed halfway and under a rule."""
    before, after = profile.neighbours(joint)
    points = profile.control_points
    middle = (points[before, 3] + points[after, 0]) / 2.0
    profile = move_control_points(
        profile,
        {
            (before, 2): points[before, 2] + (middle - points[before, 3]),
            (before, 3): middle,
            (after, 0): middle,
            (after, 1): points[after, 1] + (middle - points[after, 0]),
        },
    ).profile
    profile = enforce(with_rules(profile, {joint: rule}), joint).profile
    return lowered(profile, [joint])


@as_edit_error()
def reverse_segment(document: Document, index: int) -> Document:
    """Run one segment from its end to its start, in place; its laws follow.

    Where its ends then no longer meet their neighbours the joint becomes free, and a ring whose
    last joint comes apart becomes open; a free joint whose ends come to meet gets the rule G0.
    No point moves, and reversing again gives the same curve.
    """
    segment_number(document, index)
    profile = document.profile
    count = len(profile)
    if count == 1:
        return reverse_profile(document)
    turned = profile.with_segment(index, profile.segments[index].reversed())
    rules = dict(enumerate(profile.rules))
    size = profile.size
    for joint in profile.joints:
        before, after = profile.neighbours(joint)
        if index not in (before, after):
            continue
        apart = turned.segments[after].points[0] - turned.segments[before].points[3]
        if np.hypot(*apart) > GAP * size:
            rules[joint] = JointRule.FREE
        elif rules[joint] is JointRule.FREE:
            rules[joint] = JointRule.G0
    closing = count - 1
    if turned.closed and index in (0, closing) and rules[closing] is JointRule.FREE:
        del rules[closing]
        turned = replace(turned, closed=False, rules=tuple(rules.values()))
    else:
        turned = replace(turned, rules=tuple(rules.values()))
    near = [k for k in turned.joints if index in turned.neighbours(k)]
    laws = follow(document.variation, range(count), {index})
    return with_profile(document, lowered(turned, near), laws)


@as_edit_error()
def reverse_profile(document: Document) -> Document:
    """Run the whole chain from its end to its start: the same curve, rules and surface."""
    profile = document.profile
    count = len(profile)
    origin = range(count)[::-1]
    laws = follow(document.variation, origin, range(count))
    turned = with_profile(document, profile.reversed(), laws, origin)
    return replace(turned, appearance=look_reversed(turned.appearance))


@as_edit_error()
def head_to_tail(document: Document) -> Document:
    """Reverse whole runs of the chain so that all runs meet end to end.

    Two halves of a ring given in the same direction, as the paper prints them, become a closed
    ring. Raises EditError where nothing is apart or reversing does not make all ends meet.
    """
    ordered = joined_head_to_tail(document.profile)
    if ordered is None:
        raise EditError(NoEdit.NO_HEAD_TO_TAIL)
    laws = follow(document.variation, ordered.origin, ordered.backwards)
    joined = lowered(ordered.profile, ordered.profile.joints)
    return with_profile(document, joined, laws, ordered.origin)
