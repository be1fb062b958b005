"""Edits of a profile that keep the rules of its joints.

Pure functions from the profile at the start of a gesture to the one after it, so that rounding
never adds up over a drag. Segments and joints count from 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import hypot

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.curves.continuity import measure_joint, measure_joints
from sgb_core.curves.profile import SMOOTH_RULES, JointRule, Profile
from sgb_core.curves.rule_chain import RuleChain, Yielding
from sgb_core.curves.segment import ShapeParameters
from sgb_core.findings.joints import Hindrance, UnmetRule
from sgb_core.values import dataclass

# A control point: (segment, index 0..3).
PointKey = tuple[int, int]


@dataclass(frozen=True, slots=True)
class Enforced:
    """A profile after an edit, and each rule that could not be kept, with what hindered it."""

    profile: Profile
    unmet: tuple[UnmetRule, ...] = ()


def enforce(profile: Profile, joint: int, yielding: Yielding = "later") -> Enforced:
    """Return the profile with the rule of one joint restored as well as it can be.

    G0: the yielding segment's end moves to the joint and carries its leg. G1, C1, G2: see
    :mod:`sgb_core.curves.rules`; a G2 joint that needs λ2 passes on to the next G2 joint. Where
    the yielding segment alone cannot meet the curvature, the other one does, unless it holds.
    Raises IndexError where the profile has no such joint.

    >>> legs = [sgb.line((20, 0), (20, 30)), sgb.line((20, 30), (50, 60))]
    >>> smooth = sgb.enforce(sgb.Profile.of(legs, ["G1"]), 0).profile
    >>> str(sgb.measure_joint(smooth, 0).measured)
    'G1'
    """
    if joint not in profile.joints:
        raise IndexError(f"no joint {joint}; the profile has {len(profile.joints)}")
    rule = profile.rules[joint]
    if rule == JointRule.FREE:
        return Enforced(profile)
    chain = RuleChain(profile, yielding)
    chain.close_gap(joint)
    if rule in SMOOTH_RULES:
        chain.align(joint, chain.later_yields(joint))
    if rule == JointRule.G2:
        solved = _curvature_solved(chain, joint)
        if solved is not None:
            return solved
    chain.settle({joint})
    return _result(chain)


def keep_rule(profile: Profile, joint: int, yielding: Yielding = "later") -> Enforced:
    """Return the profile with the rule of one joint restored, or with nothing moved for it.

    As :func:`enforce`, but a rule that cannot be met leaves all as it was, save for a gap, which
    no rule but "free" allows. Raises IndexError where the profile has no such joint.
    """
    best = enforce(profile, joint, yielding)
    if measure_joint(best.profile, joint).holds:
        return best
    chain = RuleChain(profile, yielding)
    chain.close_gap(joint)
    kept = tuple(
        replace(each, hindrance=Hindrance.NONE_IN_RANGE)
        if each.hindrance is Hindrance.OUT_OF_RANGE
        else each
        for each in best.unmet
        if each.joint == joint
    )
    return Enforced(chain.profile, kept)


def _curvature_solved(aligned: RuleChain, joint: int) -> Enforced | None:
    """Return the first way to equal curvatures at an aligned joint; None where there is none.

    The yielding segment's λ1 (λ3 where it lies before the joint) is tried first, then its λ2 for
    what is still missing, then the same of the other segment. A way that breaks no other rule goes
    before one that does.
    """
    start = aligned.start
    first, second = start.neighbours(joint)
    later = aligned.later_yields(joint)
    held = start.segments[first].holds_end if later else start.segments[second].holds_start
    broken = {report.joint for report in measure_joints(start) if not report.holds}
    found: Enforced | None = None
    for side in (later,) if held else (later, not later):
        for middle in (False, True):
            chain = aligned.copy()
            if chain.match(joint, side, middle_is_free=middle).hindrance:
                continue
            chain.settle()
            result = _result(chain)
            if not measure_joint(result.profile, joint).holds:
                continue
            if broken.issuperset(unmet.joint for unmet in result.unmet):
                return result
            found = found or result
    return found


def set_shapes(
    profile: Profile, shapes: Mapping[int, ShapeParameters], yielding: Yielding = "later"
) -> Enforced:
    """Return the profile with other shape parameters of some segments, the joints' rules kept.

    One edit. At a C1 joint a leg scales, on the side that ``yielding`` says; at a G2 joint the
    neighbour's parameters follow. G1 needs nothing (Theorem 1), but is unmet where an end
    derivative vanishes and a kink appears.
    """
    chain = RuleChain(profile, yielding)
    for segment, shape in shapes.items():
        chain.put(segment, profile.segments[segment].with_shape(shape))
    chain.pin(shapes)
    for joint in chain.joints_of(shapes):
        if profile.rules[joint] == JointRule.C1:
            chain.align(joint, chain.later_yields(joint))
    chain.settle(shared=True)
    return _result(chain)


def move_control_points(
    profile: Profile,
    targets: Mapping[PointKey, ArrayLike],
    keep_rules: bool = True,
    yielding: Yielding = "later",
) -> Enforced:
    """Return the profile with control points moved to new places (r, h), as one edit.

    Ends that meet stay together under any rule but "free". With ``keep_rules`` a moved joint
    carries its legs, P2 before it and P1 after it, and where one leg of a G1, C1 or G2 joint
    moves the other side follows; at a G2 joint the shape parameters of both sides do, where one
    side's alone do not reach. Without, legs stay where they are and joints may kink.
    """
    chain = RuleChain(profile, yielding)
    old = profile.control_points
    moved = {key: np.asarray(target, dtype=np.float64) for key, target in targets.items()}
    for joint in profile.joints:
        if profile.rules[joint] == JointRule.FREE:
            continue
        first, second = profile.neighbours(joint)
        before, after = (first, 3), (second, 0)
        if before not in moved and after not in moved:
            continue
        place = moved[before] if before in moved else moved[after]
        shift = place - old[before if before in moved else after]
        moved[before] = moved[after] = place
        if keep_rules:
            for leg in ((first, 2), (second, 1)):
                if leg not in targets:
                    moved[leg] = old[leg] + shift
    points = old.copy()
    for key, place in moved.items():
        points[key] = place
    for segment in {key[0] for key in moved}:
        chain.put(segment, profile.segments[segment].with_points(points[segment]))
    if keep_rules:
        reach = max((float(hypot(*(moved[key] - old[key]))) for key in targets), default=0.0)
        for joint in profile.joints:
            if profile.rules[joint] in SMOOTH_RULES:
                first, second = profile.neighbours(joint)
                legs = ((first, 2) in targets, (second, 1) in targets)
                if any(legs):
                    later = chain.later_yields(joint) if all(legs) else legs[0]
                    chain.align(joint, later, reach)
        chain.settle(shared=True)
    return _result(chain) if keep_rules else Enforced(chain.profile)


def earlier_yields(profile: Profile, joint: int) -> bool:
    """Return whether the earlier side of a joint yields where both could: the later one holds."""
    first, second = profile.neighbours(joint)
    return profile.segments[second].holds_start and not profile.segments[first].holds_end


def _result(chain: RuleChain) -> Enforced:
    profile = chain.profile
    return Enforced(profile, chain.unmet(profile))
