"""What all edits share: checked arguments in, a document that can be saved out."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from enum import StrEnum
from typing import TypeVar

import numpy as np

from sgb_core.curves.continuity import JointClass, JointReport, measure_joint
from sgb_core.curves.profile import GAP, MAX_SEGMENTS, JointRule, Profile
from sgb_core.document.edits.pictures import used_pictures
from sgb_core.document.edits.renumber_dimensions import dimensions_follow
from sgb_core.document.edits.renumber_paint import look_follows
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.kinds import FINITE, Choice, Range, Said
from sgb_core.findings.edits import NoEdit, NoSuch, PulledApart, TooMany
from sgb_core.findings.refusal import Argument, Refusal, RefusalError, Unknown
from sgb_core.surfaces.laws.law import Law

T = TypeVar("T")
Name = TypeVar("Name", bound=StrEnum)
_NUMBER = Said("a number")
POSITIVE = Range(above=0.0, said="a positive number")


def checked(make: Callable[[], T]) -> T:
    """Return what is made. Raises EditError for a value that is not allowed in it."""
    with as_edit_error():
        return make()


def changed(section: T, **fields: object) -> T:
    """Return a section with those fields changed that are not None; raises EditError."""
    given = {key: value for key, value in fields.items() if value is not None}
    return checked(lambda: replace(section, **given))  # type: ignore[type-var]


@contextmanager
def as_edit_error() -> Iterator[None]:
    """Raise EditError where what an edit makes cannot be; also a decorator of edits."""
    try:
        yield
    except RefusalError as error:
        if error.finding.path[:2] == ("segment", "points"):
            raise EditError(NoEdit.TOO_FAR) from None
        if error.finding.path == ("profile", "segments"):
            raise EditError(TooMany("segments", MAX_SEGMENTS)) from None
        raise EditError(error.finding) from None


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
        raise EditError(Argument(what, value, _NUMBER))
    return within(value, what, FINITE)


def positive(value: float, what: str) -> float:
    """Return a positive finite number. Raises EditError on anything else."""
    return within(finite(value, what), what, POSITIVE)


def within(value: float, what: str, allowed: Range) -> float:
    """Return a number in a range. Raises EditError on one that lies outside."""
    try:
        return allowed.take(value, (what,))
    except RefusalError as error:
        found = error.finding
        said = found.allowed if isinstance(found, Refusal) else allowed
        raise EditError(Argument(what, value, said)) from None


def member(name: str, names: type[Name], what: str) -> Name:
    """Return the member of some names. Raises EditError on a name that is none of them."""
    try:
        return names(name)
    except ValueError:
        raise EditError(Unknown(what, name, Choice(names))) from None


def with_profile(
    document: Document,
    profile: Profile,
    variation: tuple[Law, ...] | None = None,
    origin: Sequence[int | None] | None = None,
) -> Document:
    """Return the document with another profile that a file can hold.

    Where segments got other numbers, ``origin[k]`` is the old one of segment k, None for a new
    segment; paint and dimensions follow.
    Ends apart by no more than rounding are made to meet exactly, since a later edit may make
    the profile, and with it the tolerance, smaller. Raises EditError where a joint would come
    apart.
    """
    gaps = profile.gaps
    if any(gaps):
        profile = _welded(document, profile, gaps)
    laws = document.variation if variation is None else variation
    told = dimensions_follow(document.dimensions, document.profile, profile, origin)
    look = document.appearance if origin is None else look_follows(document.appearance, origin)
    if (profile, laws, look, told) == (
        document.profile,
        document.variation,
        document.appearance,
        document.dimensions,
    ):
        return document
    if look is not document.appearance:
        look = replace(look, pictures=used_pictures(document, look))
    return replace(document, profile=profile, variation=laws, appearance=look, dimensions=told)


def _welded(document: Document, profile: Profile, gaps: Sequence[float]) -> Profile:
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
    with as_edit_error():
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
