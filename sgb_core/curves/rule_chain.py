"""A profile in the middle of an edit, whose joints' rules are restored one after the other."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterable
from typing import Literal

import numpy as np

from sgb_core.curves.continuity import JointReport, measure_joint, unmet_rule
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.rules import Yielded, match_curvature, turn_leg, view_from
from sgb_core.curves.segment import Segment
from sgb_core.findings.joints import Hindrance, UnmetRule

# Which side of a joint moves where both could.
Yielding = Literal["earlier", "later"]

# No point moves farther than this many times its leg's length when a rule is restored.
FARTHEST = 10.0


class RuleChain:
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

    def copy(self) -> RuleChain:
        """Return a chain that goes on from here by itself."""
        copied = RuleChain(self.start, "later" if self.by_default_later else "earlier")
        copied.segments = list(self.segments)
        copied.touched, copied.pinned = set(self.touched), set(self.pinned)
        copied.sides, copied.hindrances = dict(self.sides), dict(self.hindrances)
        return copied

    def put(self, number: int, segment: Segment) -> None:
        """Replace a segment and remember that it was touched."""
        if segment is not self.segments[number]:
            self.segments[number] = segment
            self.touched.add(number)

    def pin(self, segments: Iterable[int]) -> None:
        """Keep the shape parameters of some segments as they are."""
        self.pinned.update(segments)

    def later_yields(self, joint: int) -> bool:
        """Return whether the later side yields where both could: unless that end holds."""
        first, second = self.start.neighbours(joint)
        held = (self.start.segments[first].holds_end, self.start.segments[second].holds_start)
        later = self.by_default_later
        own, other = held[::-1] if later else held
        return not later if own and not other else later

    def joints_of(self, segments: Iterable[int]) -> list[int]:
        """Return the joints at either end of some segments, ascending."""
        count, joints = len(self.start), self.start.joints
        near = {(segment + step) % count for segment in segments for step in (-1, 0)}
        return [joint for joint in sorted(near) if joint in joints]

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

    def settle(self, joints: Iterable[int] = (), *, shared: bool = False) -> None:
        """Restore the curvature at every G2 joint of a touched segment, and beyond.

        Joints between two touched segments come first, then the effect spreads outwards: only
        where λ2 had to change does the next joint follow. With ``shared`` the other side of a
        joint adds what the yielding one misses at the ends of its ranges, unless it holds: so both
        follow a drag steadily. Each joint is visited at most twice, so a ring that cannot be
        satisfied comes to rest.
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
            own = self.start.neighbours(joint)[1 if later else 0]
            if own in self.pinned:
                self.hindrances[joint] = Hindrance.BOTH_SET
                continue
            sides = [later]
            if shared and self.may_help(joint, not later):
                sides.append(not later)
            for side in sides:
                yielded = self.match(joint, side)
                if yielded.middle_changed:
                    changed = self.start.neighbours(joint)[1 if side else 0]
                    queue.extend(
                        j
                        for j in self.joints_of({changed})
                        if j != joint and rules[j] == JointRule.G2
                    )
                if yielded.hindrance is None:
                    break

    def match(self, joint: int, later: bool, *, middle_is_free: bool = True) -> Yielded:
        """Let the shape parameters of one side of a joint follow the other side's curvature."""
        first, second = self.start.neighbours(joint)
        own, other = (second, first) if later else (first, second)
        yielded = match_curvature(
            view_from(self.segments[other], not later),
            self.segments[own],
            later,
            size=self.size,
            # λ2 of the only segment of a ring would change both sides of its joint.
            middle_is_free=middle_is_free and own != other,
        )
        self.take(joint, own, yielded)
        return yielded

    def may_help(self, joint: int, later: bool) -> bool:
        """Return whether a side of a joint may add what the yielding one misses."""
        first, second = self.start.neighbours(joint)
        number = second if later else first
        segment = self.start.segments[number]
        holds = segment.holds_start if later else segment.holds_end
        return first != second and not holds and number not in self.pinned

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

    def unmet(self, profile: Profile) -> tuple[UnmetRule, ...]:
        """Return the rules that the edited profile, as it is by now, truly does not keep."""
        unmet = []
        for joint in sorted(set(self.joints_of(self.touched)) | set(self.hindrances)):
            truth = measure_joint(profile, joint)
            if not truth.holds:
                hindrance = self.hindrances.get(joint) or _untried(truth)
                unmet.append(unmet_rule(profile, truth, hindrance))
        return tuple(unmet)


def _untried(truth: JointReport) -> Hindrance:
    """Return why a rule that nothing tried to restore does not hold."""
    return Hindrance.UNTRIED_STILL_END if truth.degenerate else Hindrance.UNMET_BEFORE
