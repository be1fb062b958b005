"""Edits of a profile that keep the rules of its joints.

Pure functions from the profile at the start of a gesture to the one after it, so that rounding
never adds up over a drag. Segments and joints count from 0.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import hypot
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.curves.continuity import JointReport, measure_joint, unmet_rule
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.rules import Yielded, match_curvature, turn_leg, view_from
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.findings.joints import Hindrance, UnmetRule

# Which side of a joint moves where both could.
Yielding = Literal["earlier", "later"]

# A control point: (segment, index 0..3).
PointKey = tuple[int, int]

# No point moves farther than this many times its leg's length when a rule is restored.
FARTHEST = 10.0

_SMOOTH = (JointRule.G1, JointRule.C1, JointRule.G2)


@dataclass(frozen=True, slots=True)
class Enforced:
    """A profile after an edit, and each rule that could not be kept, with what hindered it."""

    profile: Profile
    unmet: tuple[UnmetRule, ...] = ()


def enforce(profile: Profile, joint: int, yielding: Yielding = "later") -> Enforced:
    """Return the profile with the rule of one joint restored as well as it can be.

    G0: the yielding segment's end moves to the joint and carries its leg. G1, C1, G2: see
    :mod:`sgb_core.curves.rules`; a G2 joint that needs λ2 passes on to the next G2 joint.
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
    chain = _Chain(profile, yielding)
    chain.close_gap(joint)
    if rule in _SMOOTH:
        chain.align(joint, chain.later_yields(joint))
    chain.settle({joint})
    return chain.result()


def set_shapes(
    profile: Profile, shapes: Mapping[int, ShapeParameters], yielding: Yielding = "later"
) -> Enforced:
    """Return the profile with other shape parameters of some segments, the joints' rules kept.

    One edit. At a C1 joint a leg scales, on the side that ``yielding`` says; at a G2 joint the
    neighbour's parameters follow. G1 needs nothing (Theorem 1), but is unmet where an end
    derivative vanishes and a kink appears.
    """
    chain = _Chain(profile, yielding)
    for segment, shape in shapes.items():
        chain.put(segment, profile.segments[segment].with_shape(shape))
    chain.pinned.update(shapes)
    for joint in chain.joints_of(shapes):
        if profile.rules[joint] == JointRule.C1:
            chain.align(joint, chain.later_yields(joint))
    chain.settle()
    return chain.result()


def move_control_points(
    profile: Profile,
    targets: Mapping[PointKey, ArrayLike],
    keep_rules: bool = True,
    yielding: Yielding = "later",
) -> Enforced:
    """Return the profile with control points moved to new places (r, h), as one edit.

    Ends that meet stay together under any rule but "free". With ``keep_rules`` a moved joint
    carries its legs, P2 before it and P1 after it, and where one leg of a G1, C1 or G2 joint
    moves the other side follows; without, legs stay where they are and joints may kink.
    """
    chain = _Chain(profile, yielding)
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
            if profile.rules[joint] in _SMOOTH:
                first, second = profile.neighbours(joint)
                legs = ((first, 2) in targets, (second, 1) in targets)
                if any(legs):
                    later = chain.later_yields(joint) if all(legs) else legs[0]
                    chain.align(joint, later, reach)
        chain.settle()
    return chain.result() if keep_rules else Enforced(chain.profile)


def earlier_yields(profile: Profile, joint: int) -> bool:
    """Return whether the earlier side of a joint yields where both could: the later one holds."""
    first, second = profile.neighbours(joint)
    return profile.segments[second].holds_start and not profile.segments[first].holds_end


class _Chain:
    """A profile being edited: what was touched, and why rules could not be kept.

    A side of a joint is a truth value: true for the later segment, seen from its start, false
    for the earlier one, seen from its end.
    """

    def __init__(self, profile: Profile, yielding: Yielding) -> None:
        self.start = profile
        self.segments = list(profile.segments)
        self.size = profile.size
        self.by_default_later = yielding == "later"
        self.touched: set[int] = set()
        self.pinned: set[int] = set()
        self.sides: dict[int, bool] = {}
        self.hindrances: dict[int, Hindrance | None] = {}

    def put(self, number: int, segment: Segment) -> None:
        """Replace a segment and remember that it was touched."""
        if segment is not self.segments[number]:
            self.segments[number] = segment
            self.touched.add(number)

    def later_yields(self, joint: int) -> bool:
        """Return whether the later side yields where both could: unless that end holds."""
        first, second = self.start.neighbours(joint)
        held = (self.start.segments[first].holds_end, self.start.segments[second].holds_start)
        later = self.by_default_later
        own, other = held[::-1] if later else held
        return not later if own and not other else later

    def joints_of(self, segments: Iterable[int]) -> list[int]:
        """Return the joints at either end of some segments, ascending."""
        chosen = set(segments)
        return [j for j in self.start.joints if chosen & set(self.start.neighbours(j))]

    def close_gap(self, joint: int) -> None:
        """Move the yielding end, with its leg, to where the other end is."""
        first, second = self.start.neighbours(joint)
        later = self.later_yields(joint)
        place = self.segments[first].points[3] if later else self.segments[second].points[0]
        number, end, leg = (second, 0, 1) if later else (first, 3, 2)
        points = np.array(self.segments[number].points)
        shift = place - points[end]
        if shift.any():
            points[leg] += shift
            points[end] = place
            self.put(number, self.segments[number].with_points(points))

    def align(self, joint: int, later: bool, reach: float = 0.0) -> None:
        """Bring the leg on one side of a joint in line with the other, after a hand's reach."""
        first, second = self.start.neighbours(joint)
        own, other = (second, first) if later else (first, second)
        length = view_from(self.start.segments[own], later).leg_length
        yielded = turn_leg(
            view_from(self.segments[other], not later),
            self.segments[own],
            later,
            size=self.size,
            equal_speed=self.start.rules[joint] == JointRule.C1,
            limit=FARTHEST * max(length, reach),
        )
        self.sides[joint] = later
        self.take(joint, own, yielded)

    def take(self, joint: int, number: int, yielded: Yielded) -> None:
        """Take over what a segment became at a joint."""
        self.put(number, yielded.segment)
        self.hindrances[joint] = yielded.hindrance

    def settle(self, joints: Iterable[int] = ()) -> None:
        """Restore the curvature at every G2 joint of a touched segment, and beyond.

        Joints between two touched segments come first, then the effect spreads outwards: only
        where λ2 had to change does the next joint follow. Each joint is visited at most twice,
        so a ring that cannot be satisfied comes to rest.
        """
        rules = self.start.rules
        affected = sorted(set(self.joints_of(self.touched)) | set(joints))
        inner = [j for j in affected if self.touched.issuperset(self.start.neighbours(j))]
        outer = [j for j in affected if j not in inner]
        queue = deque(j for j in inner + outer if rules[j] == JointRule.G2)
        visits: Counter[int] = Counter()
        while queue:
            joint = queue.popleft()
            if visits[joint] == 2:
                continue
            visits[joint] += 1
            later = self.yielding_side(joint)
            first, second = self.start.neighbours(joint)
            own, other = (second, first) if later else (first, second)
            if own in self.pinned:
                self.hindrances[joint] = Hindrance.BOTH_SET
                continue
            yielded = match_curvature(
                view_from(self.segments[other], not later),
                self.segments[own],
                later,
                size=self.size,
                # λ2 of the only segment of a ring would change both sides of its joint.
                middle_is_free=own != other,
            )
            self.take(joint, own, yielded)
            if yielded.middle_changed:
                queue.extend(
                    j for j in self.joints_of({own}) if j != joint and rules[j] == JointRule.G2
                )

    def yielding_side(self, joint: int) -> bool:
        """Return which side of a joint follows: never the one whose parameters are being set."""
        first, second = self.start.neighbours(joint)
        if first in self.pinned or second in self.pinned:
            return first in self.pinned
        if joint in self.sides:
            return self.sides[joint]
        if (first in self.touched) != (second in self.touched):
            return first in self.touched
        return self.later_yields(joint)

    @property
    def profile(self) -> Profile:
        """The profile as it is by now."""
        return self.start.with_segments(self.segments)

    def result(self) -> Enforced:
        """Return the edited profile with the rules that it truly does not keep."""
        profile = self.profile
        unmet = []
        for joint in sorted(set(self.joints_of(self.touched)) | set(self.hindrances)):
            truth = measure_joint(profile, joint)
            if not truth.holds:
                hindrance = self.hindrances.get(joint) or _untried(truth)
                unmet.append(unmet_rule(profile, truth, hindrance))
        return Enforced(profile, tuple(unmet))


def _untried(truth: JointReport) -> Hindrance:
    """Return why a rule that nothing tried to restore does not hold."""
    return Hindrance.UNTRIED_STILL_END if truth.degenerate else Hindrance.UNMET_BEFORE
