"""What all edits share: checked arguments in, a document that can be saved out."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from math import isfinite

import numpy as np

from sgb_core.curves.continuity import JointClass, JointReport, measure_joint
from sgb_core.curves.profile import GAP, JointRule, Profile
from sgb_core.document.edits.renumber_paint import look_follows
from sgb_core.document.errors import EditError
from sgb_core.document.file.reader import MAX_COORDINATE, MAX_SEGMENTS
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoEdit, NoSuch, PulledApart, TooMany
from sgb_core.surfaces.variation import Law


def segment_number(document: Document, segment: int) -> int:
    """Return the number of a segment. Raises EditError where there is no such segment."""
    count = len(document.profile)
    if not 0 <= segment < count:
        raise EditError(NoSuch("segment", segment, count))
    return segment


def joint_number(document: Document, joint: int) -> int:
    """Return the number of a joint. Raises EditError where there is no such joint."""
    count = len(document.profile.joints)
    if not 0 <= joint < count:
        raise EditError(NoSuch("joint", joint, count))
    return joint


def finite(value: float, what: str) -> float:
    """Return a finite number. Raises EditError on anything else, true and false included."""
    if isinstance(value, bool) or not isinstance(value, (int, float, np.floating, np.integer)):
        raise EditError(f"{what} is {value!r}; allowed is a number")
    if not isfinite(value):
        raise EditError(f"{what} is {value!r}; allowed is a finite number")
    return float(value)


def positive(value: float, what: str) -> float:
    """Return a positive finite number. Raises EditError on anything else."""
    number = finite(value, what)
    if number <= 0.0:
        raise EditError(f"{what} is {number:g}; allowed is a positive number")
    return number


def with_profile(
    document: Document,
    profile: Profile,
    variation: tuple[Law, ...] | None = None,
    origin: Sequence[int | None] | None = None,
) -> Document:
    """Return the document with another profile that a file can hold.

    Where segments got other numbers, ``origin[k]`` is the old one of segment k, None for a new
    segment; the paint follows.
    Ends apart by no more than rounding are made to meet exactly, since a later edit may make
    the profile, and with it the tolerance, smaller. Raises EditError where a point would lie
    beyond 1e9, a joint would come apart, or there would be too many segments.
    """
    if len(profile) > MAX_SEGMENTS:
        raise EditError(TooMany("segments", MAX_SEGMENTS))
    points = profile.control_points
    if not np.abs(points).max() <= MAX_COORDINATE:
        raise EditError(NoEdit.TOO_FAR)
    gaps = np.roll(points[:, 0], -1, axis=0) - points[:, 3]
    if np.any(gaps):
        profile = _welded(document, profile, np.hypot(gaps[:, 0], gaps[:, 1]).tolist())
    laws = document.variation if variation is None else variation
    look = document.appearance if origin is None else look_follows(document.appearance, origin)
    if (profile, laws, look) == (document.profile, document.variation, document.appearance):
        return document
    return replace(document, profile=profile, variation=laws, appearance=look)


def _welded(document: Document, profile: Profile, gaps: list[float]) -> Profile:
    tolerance = GAP * max(profile.size, document.profile.size)
    for joint in profile.joints:
        if gaps[joint] == 0.0 or not is_held(profile, joint):
            continue
        if gaps[joint] > tolerance:
            raise EditError(PulledApart(*profile.neighbours(joint)))
        before, after = profile.neighbours(joint)
        points = np.array(profile.segments[after].points)
        points[0] = profile.segments[before].points[3]
        profile = profile.with_segment(after, profile.segments[after].with_points(points))
    return profile


def is_held(profile: Profile, joint: int) -> bool:
    """Return whether a joint's ends must meet: by its rule, or because it closes a ring."""
    closing = profile.closed and joint == len(profile) - 1
    return closing or profile.rules[joint] is not JointRule.FREE


def keeping_ring(profile: Profile, edit: Callable[[Profile], Profile]) -> Profile:
    """Apply an edit while a ring's closing joint, should its rule be free, counts as joined."""
    if not profile.closed or profile.rules[-1] is not JointRule.FREE:
        return edit(profile)
    closing = len(profile) - 1
    edited = edit(with_rules(profile, {closing: JointRule.G0}))
    return with_rules(edited, {closing: JointRule.FREE})


def with_rules(profile: Profile, rules: dict[int, JointRule]) -> Profile:
    """Return the profile with the rules of some joints replaced."""
    return replace(profile, rules=tuple(rules.get(k, rule) for k, rule in enumerate(profile.rules)))


def lowered(profile: Profile, joints: Iterable[int]) -> Profile:
    """Return the profile with the rules of these joints lowered to what is truly there.

    For edits that cannot keep a rule by their nature, such as C1 beside a split segment.
    """
    rules: dict[int, JointRule] = {}
    for joint in joints:
        report = measure_joint(profile, joint)
        if not report.holds:
            rules[joint] = _kept(report)
    return with_rules(profile, rules) if rules else profile


def _kept(report: JointReport) -> JointRule:
    if report.measured is JointClass.GAP:
        return JointRule.FREE
    if report.measured is JointClass.G2:
        return JointRule.G1
    return JointRule(report.measured)


def met(profile: Profile, joints: Iterable[int]) -> list[int]:
    """Return those of the joints whose rule is satisfied."""
    return [joint for joint in joints if measure_joint(profile, joint).holds]
