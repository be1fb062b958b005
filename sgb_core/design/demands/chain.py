"""A chain as numbers: leg fractions and control points in one block of eleven for each segment.

A block is [a, b, c, P0r, P0h, P1r, P1h, P2r, P2h, P3r, P3h]. Lengths are in units of the profile's
size, heights count from its middle: nothing depends on the unit, or on how far away a profile is.
"""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.values import dataclass

BLOCK = 11
# Between which control points Q1, Q2 and Q3 lie, from the end at the fraction 0.
_NEAR, _FAR = np.array([(0, 1), (2, 1), (3, 2)]).T
# Fractions closer than this are the same.
_SAME = 1e-14


@dataclass(frozen=True, slots=True)
class Chain:
    """A profile's blocks (n, 11), and the ``size`` and ``middle`` height that they are told in."""

    blocks: Floats
    size: float
    middle: float

    @classmethod
    def of(cls, profile: Profile) -> Chain:
        """Return a profile as numbers."""
        points = profile.control_points
        size = profile.size or 1.0
        heights = points[..., 1]
        middle = float(heights.min() + (heights.max() - heights.min()) / 2.0)
        blocks = np.empty((len(points), BLOCK))
        blocks[:, :3] = [segment.shape.leg_fractions for segment in profile.segments]
        blocks[:, 3:] = ((points - (0.0, middle)) / size).reshape(-1, 8)
        return cls(blocks, size, middle)

    def told(self, profile: Profile) -> Chain:
        """Return a profile's numbers in the size and from the middle of this chain."""
        blocks = Chain.of(profile).blocks
        points = (profile.control_points - (0.0, self.middle)) / self.size
        blocks[:, 3:] = points.reshape(-1, 8)
        return self.with_blocks(blocks)

    def __len__(self) -> int:
        return len(self.blocks)

    def with_blocks(self, blocks: Floats) -> Chain:
        """Return the chain with other numbers, told in the same size."""
        return Chain(blocks, self.size, self.middle)

    @property
    def fractions(self) -> Floats:
        """The leg fractions, shape (n, 3)."""
        return self.blocks[:, :3]

    @property
    def points(self) -> Floats:
        """The control points, shape (n, 4, 2)."""
        return self.blocks[:, 3:].reshape(-1, 4, 2)

    @property
    def quartics(self) -> Floats:
        """The quartic points, shape (n, 5, 2)."""
        p, found = self.points, np.empty((len(self.blocks), 5, 2))
        found[:, ::4] = p[:, ::3]
        near = p[:, _NEAR]
        found[:, 1:4] = near + self.fractions[:, :, None] * (p[:, _FAR] - near)
        return found

    def slopes(self) -> Floats:
        """Return how the quartic points, flat, move with each number: shape (n, 10, 11)."""
        p, count = self.points, len(self.blocks)
        moves = np.zeros((count, 5, 2, BLOCK))
        # Q1 lies between P0 and P1, Q2 between P2 and P1, Q3 between P3 and P2.
        for which, (near, far) in enumerate(((0, 1), (2, 1), (3, 2))):
            part = self.blocks[:, which]
            moves[:, which + 1, :, which] = p[:, far] - p[:, near]
            for k in range(2):
                moves[:, which + 1, k, 3 + 2 * near + k] = 1.0 - part
                moves[:, which + 1, k, 3 + 2 * far + k] = part
        for k in range(2):
            moves[:, 0, k, 3 + k] = moves[:, 4, k, 9 + k] = 1.0
        return moves.reshape(count, 10, BLOCK)

    def bends(self, gradient: Floats) -> Floats:
        """Return Σ gradient · ∂²Q, (n, 11, 11), for a gradient (n, 10) by the quartic points."""
        result = np.zeros((len(self.blocks), BLOCK, BLOCK))
        for which, (near, far) in enumerate(((0, 1), (2, 1), (3, 2))):
            for k in range(2):
                pull = gradient[:, 2 * (which + 1) + k]
                result[:, which, 3 + 2 * near + k] -= pull
                result[:, which, 3 + 2 * far + k] += pull
        return result + np.swapaxes(result, 1, 2)

    def profile(self, profile: Profile, start: Chain) -> Profile:
        """Return the profile with what differs from ``start``, its own numbers, taken over.

        What is the same stays bit for bit.
        """
        segments = []
        for segment, before, after in zip(profile.segments, start.blocks, self.blocks, strict=True):
            segments.append(self._segment(segment, before, after))
        return profile.with_segments(segments)

    def _segment(self, segment: Segment, before: Floats, after: Floats) -> Segment:
        changed = segment
        if (after[3:] != before[3:]).any():
            old = np.array(segment.points)
            moved = (after[3:] != before[3:]).reshape(4, 2)
            new = after[3:].reshape(4, 2) * self.size + (0.0, self.middle)
            changed = changed.with_points(np.where(moved, new, old))
        if np.abs(after[:3] - before[:3]).max() > _SAME:
            changed = changed.with_shape(shape_of(after[:3], before[:3], segment.shape))
        return changed


def shape_of(fractions: Floats, before: Floats, shape: ShapeParameters) -> ShapeParameters:
    """Return shape parameters with these leg fractions, as near to the present ones as can be.

    ω stays where the fractions are in its reach, so that only the λ of what changed move; else
    all are written at ω = 1, which reaches every fraction.
    """
    a, b, c = (float(min(max(value, 0.0), 1.0)) for value in fractions)
    omega = shape.omega
    if omega > 0.0:
        # The leg fractions of the key fact, solved for λ.
        wanted = (
            1.0 + (3.0 - 4.0 * a) / omega,
            3.0 + (6.0 * b - 3.0) / omega,
            1.0 + (3.0 - 4.0 * c) / omega,
        )
        present = (shape.lambda1, shape.lambda2, shape.lambda3)
        same = np.abs(fractions - before) <= _SAME
        values = [
            old if kept else new for new, old, kept in zip(wanted, present, same, strict=True)
        ]
        limits = (4.0, 6.0, 4.0)
        if all(-1e-12 <= value <= high + 1e-12 for value, high in zip(values, limits, strict=True)):
            first, second, third = (
                min(max(value, 0.0), high) for value, high in zip(values, limits, strict=True)
            )
            return ShapeParameters(first, second, third, omega)
    return ShapeParameters.from_leg_fractions(a, b, c)
