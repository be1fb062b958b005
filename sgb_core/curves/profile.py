"""The generatrix: a chain of SG-Bézier segments with a rule at each joint."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field, replace
from enum import StrEnum
from functools import cached_property
from math import hypot

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats, frozen
from sgb_core.curves import basis
from sgb_core.curves.roots import extremes_of_all
from sgb_core.curves.segment import Segment
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import Choice, Flag, Said
from sgb_core.fields.lists import Several
from sgb_core.fields.record import Part, Record, check, says
from sgb_core.findings.errors import FindingError
from sgb_core.findings.refusal import Apart, Argument, OpenRing
from sgb_core.values import dataclass

# A joint whose ends are farther apart than this part of the size is a gap.
GAP = 1e-9
# Far beyond any real project; what keeps reading a hostile one within seconds.
MAX_SEGMENTS = 2_000


class JointRule(StrEnum):
    """What editing keeps at a joint; what the curve truly is there is measured apart."""

    FREE = "free"
    G0 = "G0"
    G1 = "G1"
    C1 = "C1"
    G2 = "G2"


# From what asks for nothing to what asks for most.
STRICTNESS = tuple(JointRule)
# Those that ask for more than ends that meet.
SMOOTH_RULES = (JointRule.G1, JointRule.C1, JointRule.G2)


@dataclass(frozen=True)
class Profile:
    """A chain of n segments: n − 1 joints when open, n when closed.

    Joint k lies between segment k and segment (k + 1) mod n. ``rules`` defaults to G0
    everywhere. Raises RefusalError, a ValueError, with no segments, too many or a wrong number
    of rules. Ends need not meet: :mod:`sgb_core.curves.continuity` says what a joint truly is,
    and a document holds ends together where their rule does.

    >>> foot, wall = sgb.line((0, 0), (20, 0)), sgb.line((20, 0), (25, 60))
    >>> profile = sgb.Profile.of([foot, wall])
    >>> [segment.point(1.0).tolist() for segment in profile]
    [[20.0, 0.0], [25.0, 60.0]]
    >>> profile[1] is wall, len(profile)
    (True, 2)
    """

    RECORD = Record("profile", "The generatrix.", first=("closed",))

    segments: tuple[Segment, ...] = field(
        metadata=says(Several(Part(Segment), "segments", MAX_SEGMENTS, 1))
    )
    rules: tuple[JointRule, ...] = field(
        default=(),
        metadata=says(
            Several(Choice(JointRule), "rules", MAX_SEGMENTS),
            key="joints",
            tip="The rule kept at each joint while editing; G0 where the list is not given.",
        ),
    )
    closed: bool = field(default=False, metadata=says(Flag()))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        count = _joint_count(len(self.segments), self.closed)
        if not self.rules:
            object.__setattr__(self, "rules", (JointRule.G0,) * count)
        elif len(self.rules) != count:
            allowed = rule_for_each_joint(len(self.segments), self.closed)
            raise allowed.refusal(self.rules, ("profile", "joints"))

    @classmethod
    def of(
        cls, segments: Iterable[Segment], rules: Iterable[str] = (), closed: bool = False
    ) -> Profile:
        """Return a profile of these segments with rules given by their names.

        Ends may be apart here whatever their rule, as in a drawing on its way; a document takes
        such a profile only where the rule is "free". Raises RefusalError, a ValueError, for none
        or too many segments and for other rules than there are joints.
        """
        return cls(tuple(segments), tuple(rules), closed)  # type: ignore[arg-type]

    def __len__(self) -> int:
        return len(self.segments)

    def __iter__(self) -> Iterator[Segment]:
        return iter(self.segments)

    def __getitem__(self, index: int) -> Segment:
        return self.segments[index]

    @cached_property
    def gaps(self) -> tuple[float, ...]:
        """The distance between the ends at each joint."""
        points, count = self.control_points, len(self.rules)
        starts = points[1:, 0] if count < len(points) else np.roll(points[:, 0], -1, axis=0)
        away = points[:count, 3] - starts
        found = [0.0] * count
        for joint in np.flatnonzero(away.any(axis=1)).tolist():
            found[joint] = hypot(*away[joint].tolist())
        return tuple(found)

    @cached_property
    def joined(self) -> tuple[bool, ...]:
        """Whether the two ends at each joint are one point."""
        return tuple(gap <= GAP * self.size for gap in self.gaps)

    @property
    def fault(self) -> Apart | OpenRing | None:
        """The first ends that do not meet though a rule, or the ring, says so; None for none."""
        gaps = self.gaps
        if not any(gaps):
            return None
        size = self.size
        for joint, (rule, gap) in enumerate(zip(self.rules, gaps, strict=True)):
            if gap <= GAP * size:
                continue
            if self.closed and joint == len(self) - 1:
                return OpenRing(("profile", "closed"), gap)
            if rule is not JointRule.FREE:
                place = ("profile", "joints", joint)
                return Apart(place, str(rule), self.neighbours(joint), gap)
        return None

    @property
    def joints(self) -> range:
        """The numbers of the joints."""
        return range(len(self.rules))

    def neighbours(self, joint: int) -> tuple[int, int]:
        """Return the numbers of the segments before and after a joint."""
        return joint, (joint + 1) % len(self.segments)

    # Asked for many times at each tick of a slider, so each is computed once.

    @cached_property
    def control_points(self) -> Floats:
        """All control points, read-only, shape (n, 4, 2)."""
        return frozen([segment.points for segment in self.segments])

    @cached_property
    def shape_values(self) -> Floats:
        """λ1, λ2, λ3 and ω of all segments, read-only, shape (n, 4)."""
        return frozen([_shape_values(segment) for segment in self.segments])

    @cached_property
    def quartics(self) -> Floats:
        """The quartic Bézier points of all segments, read-only, shape (n, 5, 2)."""
        return frozen([segment.quartic for segment in self.segments])

    @cached_property
    def size(self) -> float:
        """The diagonal of the box around all control points."""
        points = self.control_points.reshape(-1, 2)
        extent = points.max(axis=0) - points.min(axis=0)
        return float(np.hypot(extent[0], extent[1]))

    def point(self, segment: int, s: ArrayLike) -> Floats:
        """Return where one segment is at ``s``, shape (*s.shape, 2)."""
        return self.segments[segment].point(s)

    def sample(self, per_segment: int) -> Floats:
        """Return ``per_segment`` ≥ 2 points of each segment at equal steps of s, ends included.

        Shape (n, per_segment, 2).
        """
        if per_segment < 2:
            raise FindingError(Argument("the number of points", per_segment, Said("2 or more")))
        return basis.bernstein(4, np.linspace(0.0, 1.0, per_segment)) @ self.quartics

    def bounds(self) -> tuple[Floats, Floats]:
        """Return the exact lower and upper corner (r, h) of the curve's box, each shape (2,)."""
        reach = [extremes_of_all(self.quartics[:, :, axis]) for axis in range(2)]
        lower, upper = np.array(reach).T
        return lower, upper

    def with_segment(self, index: int, segment: Segment) -> Profile:
        """Return this profile with one segment replaced."""
        segments = list(self.segments)
        segments[index] = segment
        return self.with_segments(segments)

    def with_segments(self, segments: Iterable[Segment]) -> Profile:
        """Return this profile with the same number of other segments."""
        made = replace(self, segments=tuple(segments))
        made._take_over(self)
        return made

    def _take_over(self, other: Profile) -> None:
        """Make the joined arrays from another profile's where most segments are the same ones.

        Of a long chain a slider changes few rows at each tick.
        """
        pairs = enumerate(zip(self.segments, other.segments, strict=True))
        changed = [k for k, (own, before) in pairs if own is not before]
        if 2 * len(changed) > len(self.segments):
            return
        for name, row in _ROWS.items():
            known = other.__dict__.get(name)
            if known is not None:
                joined = known.copy()
                for k in changed:
                    joined[k] = row(self.segments[k])
                joined.flags.writeable = False
                self.__dict__[name] = joined

    def reversed(self) -> Profile:
        """Return the same chain run from its end to its start."""
        segments = tuple(segment.reversed() for segment in reversed(self.segments))
        rules = self.rules[::-1]
        if self.closed:
            # The closing joint stays last: it still lies between the last segment and the first.
            rules = (*self.rules[:-1][::-1], self.rules[-1])
        return replace(self, segments=segments, rules=rules)


def _shape_values(segment: Segment) -> tuple[float, float, float, float]:
    shape = segment.shape
    return shape.lambda1, shape.lambda2, shape.lambda3, shape.omega


# The joined arrays, and what each has of a segment.
_ROWS: Mapping[str, Callable[[Segment], ArrayLike]] = {
    "control_points": lambda segment: segment.points,
    "quartics": lambda segment: segment.quartic,
    "shape_values": _shape_values,
}


def _joint_count(segments: int, closed: bool) -> int:
    return segments if closed else segments - 1


def rule_for_each_joint(segments: int, closed: bool) -> Said:
    """Return how many rules a profile has, in words."""
    many = f"a list of {_joint_count(segments, closed)}: one rule for each joint of "
    return Said(f"{many}{segments} segments{' in a ring' if closed else ''}")
