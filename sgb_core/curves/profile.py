"""The generatrix: a chain of SG-Bézier segments with a rule at each joint."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.roots import extremes
from sgb_core.curves.segment import NO_EXTRA, Segment

# A joint whose ends are farther apart than this part of the size is a gap.
GAP = 1e-9


class JointRule(StrEnum):
    """What editing keeps at a joint; what the curve truly is there is measured apart."""

    FREE = "free"
    G0 = "G0"
    G1 = "G1"
    C1 = "C1"
    G2 = "G2"


@dataclass(frozen=True, slots=True)
class Profile:
    """A chain of n segments: n − 1 joints when open, n when closed.

    Joint k lies between segment k and segment (k + 1) mod n. ``rules`` defaults to G0
    everywhere. Raises ValueError with no segments or a wrong number of rules. Ends need not
    meet: :mod:`sgb_core.curves.continuity` says what a joint truly is.

    >>> foot, wall = sgb.line((0, 0), (20, 0)), sgb.line((20, 0), (25, 60))
    >>> profile = sgb.Profile.of([foot, wall])
    >>> [segment.point(1.0).tolist() for segment in profile]
    [[20.0, 0.0], [25.0, 60.0]]
    >>> profile[1] is wall, len(profile)
    (True, 2)
    """

    segments: tuple[Segment, ...]
    rules: tuple[JointRule, ...] = ()
    closed: bool = False
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "segments", tuple(self.segments))
        if not self.segments:
            raise ValueError("a profile has at least one segment")
        count = len(self.segments) if self.closed else len(self.segments) - 1
        rules = tuple(JointRule(rule) for rule in self.rules) or (JointRule.G0,) * count
        if len(rules) != count:
            raise ValueError(f"{len(self.segments)} segments have {count} joints, not {len(rules)}")
        object.__setattr__(self, "rules", rules)

    @classmethod
    def of(
        cls, segments: Iterable[Segment], rules: Iterable[str] = (), closed: bool = False
    ) -> Profile:
        """Return a profile of these segments with rules given by their names."""
        return cls(tuple(segments), tuple(JointRule(rule) for rule in rules), closed)

    def __len__(self) -> int:
        return len(self.segments)

    def __iter__(self) -> Iterator[Segment]:
        return iter(self.segments)

    def __getitem__(self, index: int) -> Segment:
        return self.segments[index]

    @property
    def joints(self) -> range:
        """The numbers of the joints."""
        return range(len(self.rules))

    def neighbours(self, joint: int) -> tuple[int, int]:
        """Return the numbers of the segments before and after a joint."""
        return joint, (joint + 1) % len(self.segments)

    @property
    def control_points(self) -> Floats:
        """All control points, shape (n, 4, 2)."""
        return np.stack([segment.points for segment in self.segments])

    @property
    def quartics(self) -> Floats:
        """The quartic Bézier points of all segments, shape (n, 5, 2)."""
        return np.stack([segment.quartic for segment in self.segments])

    @property
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
            raise ValueError("at least 2 points per segment")
        return basis.bernstein(4, np.linspace(0.0, 1.0, per_segment)) @ self.quartics

    def bounds(self) -> tuple[Floats, Floats]:
        """Return the exact lower and upper corner (r, h) of the curve's box, each shape (2,)."""
        reaches = [
            [extremes(coordinate) for coordinate in segment.quartic.T.tolist()]
            for segment in self.segments
        ]
        boxes = np.array(reaches)
        return boxes[:, :, 0].min(axis=0), boxes[:, :, 1].max(axis=0)

    def with_segment(self, index: int, segment: Segment) -> Profile:
        """Return this profile with one segment replaced."""
        segments = list(self.segments)
        segments[index] = segment
        return replace(self, segments=tuple(segments))

    def with_segments(self, segments: Iterable[Segment]) -> Profile:
        """Return this profile with the same number of other segments."""
        return replace(self, segments=tuple(segments))

    def reversed(self) -> Profile:
        """Return the same chain run from its end to its start."""
        segments = tuple(segment.reversed() for segment in reversed(self.segments))
        rules = self.rules[::-1]
        if self.closed:
            # The closing joint stays last: it still lies between the last segment and the first.
            rules = (*self.rules[:-1][::-1], self.rules[-1])
        return replace(self, segments=segments, rules=rules)
