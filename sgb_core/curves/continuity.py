"""What a joint of two segments truly is, measured from the curve.

Nothing here trusts a setting: Theorem 1 of the paper proves nothing where an end derivative
vanishes, and the paper's own figures use such settings.
"""

from __future__ import annotations

from enum import StrEnum
from math import atan2, degrees, hypot, isfinite

from sgb_core.curves.profile import GAP, JointRule, Profile
from sgb_core.curves.segment import DEGENERATE_LEG, Segment
from sgb_core.findings.joints import Gap, Hindrance, UnmetRule
from sgb_core.values import dataclass

# A smaller angle between the end tangents, in degrees, is no kink.
KINK_DEG = 1e-6
# End derivatives that differ by a smaller part of their length are equal.
EQUAL_DERIVATIVES = 1e-9
# A curvature jump of at most this part of max(|κ|, 1/size) is none.
EQUAL_CURVATURES = 1e-6

Vector = tuple[float, float]


class JointClass(StrEnum):
    """What a joint is, from worst to best; a joint that is C1 and G2 is called G2."""

    GAP = "gap"
    G0 = "G0"
    G1 = "G1"
    C1 = "C1"
    G2 = "G2"


# Both enumerations are strings, and the same ones where a rule asks for a class.
_RANKS: dict[str, int] = {name: rank for rank, name in enumerate(JointClass)}


@dataclass(frozen=True, slots=True)
class JointReport:
    """One joint as measured.

    ``kink_deg`` is the angle between the true tangents, None at a gap and where a segment is a
    single point. ``speed_ratio`` is |L2'(0)|/|L1'(1)| and ``curvature_jump`` κ2(0) − κ1(1),
    signed; each is None where it is not finite. ``gap`` is the distance between the ends.
    ``degenerate`` says that at least one end derivative vanishes. Where the joint varies with the
    angle the report is that of the worst, and ``at_deg`` the angle from the start, in degrees, at
    which its class is lowest.
    """

    joint: int
    rule: JointRule
    measured: JointClass
    kink_deg: float | None
    speed_ratio: float | None
    curvature_jump: float | None
    gap: float
    degenerate: bool
    at_deg: float | None = None

    @property
    def holds(self) -> bool:
        """Whether the joint is at least what its rule asks for."""
        if self.rule == JointRule.FREE:
            return True
        if self.rule == JointRule.C1 and self.measured == JointClass.G2:
            # G2 says nothing about speeds.
            ratio = self.speed_ratio
            return ratio is not None and abs(ratio - 1.0) < EQUAL_DERIVATIVES
        return _RANKS[self.measured] >= _RANKS[self.rule.value]


@dataclass(frozen=True, slots=True)
class EndView:
    """A segment seen from one of its ends, looking along the curve away from that end.

    ``fraction`` is the leg fraction at this end (a or c), ``weight`` the part of the middle leg
    that Q2 is away from the far side (1 − b or b), ``legs`` the three legs of the control
    polygon walked from this end. Read from either end, the formulas are the same.
    """

    at: Vector
    legs: tuple[Vector, Vector, Vector]
    fraction: float
    weight: float
    far_fraction: float

    @property
    def leg_length(self) -> float:
        """The length of the leg at this end."""
        return hypot(*self.legs[0])

    def is_degenerate(self, size: float) -> bool:
        """Whether the end derivative vanishes: leg fraction × leg length < 1e-12·size."""
        reach = self.fraction * self.leg_length
        return reach < DEGENERATE_LEG * size or reach == 0.0

    def derivative(self) -> Vector:
        """Return the derivative at this end, walking away from it, (7): 4a(P1 − P0)."""
        x, y = self.legs[0]
        return 4.0 * self.fraction * x, 4.0 * self.fraction * y

    def curvature(self) -> float:
        """Return the signed curvature at this end, walking away from it.

        ¾ (1−b)/a² · (d1×d2)/|d1|³; infinite or nan where the leg or its fraction is zero.
        """
        (x1, y1), (x2, y2), _ = self.legs
        below = self.fraction**2 * self.leg_length**3
        above = 0.75 * self.weight * (x1 * y2 - y1 * x2)
        if below == 0.0:
            return float("nan") if above == 0.0 else float("inf")
        return above / below

    def tangent(self, size: float) -> Vector | None:
        """Return the true tangent's direction, not of unit length, or None for a single point.

        It points to the first quartic point that differs from the end by at least 1e-12·size.
        """
        (x1, y1), (x2, y2), (x3, y3) = self.legs
        a, weight, far = self.fraction, self.weight, 1.0 - self.far_fraction
        # Differences of quartic points written in legs: no cancellation far from the origin.
        steps = (
            (a * x1, a * y1),
            (x1 + weight * x2, y1 + weight * y2),
            (x1 + x2 + far * x3, y1 + y2 + far * y3),
            (x1 + x2 + x3, y1 + y2 + y3),
        )
        for step in steps:
            length = hypot(*step)
            if length > 0.0 and length >= DEGENERATE_LEG * size:
                return step
        return None


def start_view(segment: Segment) -> EndView:
    """Return a segment seen from s = 0."""
    a, b, c = segment.shape.leg_fractions
    (x0, y0), (x1, y1), (x2, y2), (x3, y3) = segment.points.tolist()
    legs = ((x1 - x0, y1 - y0), (x2 - x1, y2 - y1), (x3 - x2, y3 - y2))
    return EndView((x0, y0), legs, a, 1.0 - b, c)


def end_view(segment: Segment) -> EndView:
    """Return a segment seen from s = 1, walking backwards."""
    a, b, c = segment.shape.leg_fractions
    (x0, y0), (x1, y1), (x2, y2), (x3, y3) = segment.points.tolist()
    legs = ((x2 - x3, y2 - y3), (x1 - x2, y1 - y2), (x0 - x1, y0 - y1))
    return EndView((x3, y3), legs, c, b, a)


def stretched(view: EndView, factor: float) -> EndView:
    """Return an end of the same curve with every distance from the axis multiplied."""
    if factor == 1.0:
        return view
    first, second, third = ((factor * x, y) for x, y in view.legs)
    at = (factor * view.at[0], view.at[1])
    return EndView(at, (first, second, third), view.fraction, view.weight, view.far_fraction)


def measure_joint(profile: Profile, joint: int) -> JointReport:
    """Return what one joint of a profile truly is.

    Raises IndexError where the profile has no such joint.

    >>> bent = sgb.Profile.of([sgb.line((20, 0), (20, 30)), sgb.line((20, 30), (50, 60))])
    >>> joint = sgb.measure_joint(bent, 0)
    >>> str(joint.measured), round(joint.kink_deg, 6)
    ('G0', 45.0)
    """
    if joint not in profile.joints:
        raise IndexError(f"no joint {joint}; the profile has {len(profile.joints)}")
    return _measure(profile, joint, profile.size)


def measure_joints(
    profile: Profile, known: tuple[Profile, tuple[JointReport, ...]] | None = None
) -> tuple[JointReport, ...]:
    """Return what every joint of a profile truly is, in order.

    ``known`` is another profile with what its joints are: reports of joints between the very same
    two segments are taken over, so that an edit of one segment costs no more in a longer chain.

    >>> straight = sgb.Profile.of([sgb.line((20, 0), (20, 30)), sgb.line((20, 30), (20, 60))])
    >>> [str(joint.measured) for joint in sgb.measure_joints(straight)]
    ['G2']
    """
    size = profile.size
    if known is None or known[0].size != size or known[0].rules != profile.rules:
        return tuple(_measure(profile, joint, size) for joint in profile.joints)
    before, reports = known
    same = [now is then for now, then in zip(profile.segments, before.segments, strict=False)]
    if len(before) != len(profile):
        same = [False] * len(profile)
    found = []
    for joint in profile.joints:
        first, second = profile.neighbours(joint)
        kept = same[first] and same[second]
        found.append(reports[joint] if kept else _measure(profile, joint, size))
    return tuple(found)


def kink_degrees(before: EndView, after: EndView, size: float) -> float | None:
    """Return the angle in degrees between the true tangents of two ends that meet.

    Both are seen from the joint, so a smooth joint has opposite directions. None where one of
    the segments is a single point and has no tangent.
    """
    backward, forward = before.tangent(size), after.tangent(size)
    if backward is None or forward is None:
        return None
    # Scaled to about 1 first: products of two tiny legs could underflow.
    p, q = hypot(*backward), hypot(*forward)
    x1, y1 = -backward[0] / p, -backward[1] / p
    x2, y2 = forward[0] / q, forward[1] / q
    return degrees(atan2(abs(x1 * y2 - y1 * x2), x1 * x2 + y1 * y2))


def gap_at(profile: Profile, report: JointReport) -> Gap:
    """Return the finding that the ends at a joint, as measured, are apart."""
    return Gap(*profile.neighbours(report.joint), report.gap)


def unmet_rule(
    profile: Profile, report: JointReport, hindrance: Hindrance | None = None
) -> UnmetRule:
    """Return the finding that a joint, as measured, is less than its rule asks for."""
    joint, following = profile.neighbours(report.joint)
    return UnmetRule(
        joint, following, report.rule.value, report.measured.value, report.kink_deg, hindrance
    )


def _measure(profile: Profile, joint: int, size: float) -> JointReport:
    first, second = profile.neighbours(joint)
    before, after = end_view(profile.segments[first]), start_view(profile.segments[second])
    return measure_ends(before, after, joint, profile.rules[joint], size)


def measure_ends(
    before: EndView, after: EndView, joint: int, rule: JointRule, size: float
) -> JointReport:
    """Return what two ends that meet are as joint number ``joint``, both seen from it."""
    gap = hypot(after.at[0] - before.at[0], after.at[1] - before.at[1])
    flat1, flat2 = before.is_degenerate(size), after.is_degenerate(size)
    # The walk on the earlier segment is backwards: derivative and curvature change their sign.
    back, v2 = before.derivative(), after.derivative()
    v1 = (-back[0], -back[1])
    ratio = None if flat1 else 0.0 if flat2 else _finite(hypot(*v2) / hypot(*v1))
    k1, k2 = -before.curvature(), after.curvature()
    jump = None if flat1 or flat2 else _finite(k2 - k1)
    kink = None if gap > GAP * size else kink_degrees(before, after, size)

    if gap > GAP * size:
        measured = JointClass.GAP
    elif kink is None or kink >= KINK_DEG:
        measured = JointClass.G0
    elif jump is not None and abs(jump) <= EQUAL_CURVATURES * max(abs(k1), abs(k2), 1.0 / size):
        measured = JointClass.G2
    elif (flat1 and flat2) or _are_equal(v1, v2):
        # Two vanishing derivatives are equal, and G1 is already known: no kink is hidden.
        measured = JointClass.C1
    else:
        measured = JointClass.G1
    return JointReport(joint, rule, measured, kink, ratio, jump, gap, flat1 or flat2)


def _are_equal(v1: Vector, v2: Vector) -> bool:
    difference = hypot(v2[0] - v1[0], v2[1] - v1[1])
    return difference < EQUAL_DERIVATIVES * max(hypot(*v1), hypot(*v2))


def _finite(value: float) -> float | None:
    return value if isfinite(value) else None
