"""What may change of a chain while locks hold, and at what cost.

Unknowns are leg fractions, ends (each carries its legs) and inner points beside their ends. Shape
parameters are cheap, points are dear, and what is in the hand is the dearest.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import ShapeParameters
from sgb_core.design.demands.chain import BLOCK, Chain
from sgb_core.design.demands.foot import standing
from sgb_core.values import dataclass

Flags = NDArray[np.bool_]
Numbers = NDArray[np.intp]
# A point that goes a fiftieth of the size costs as much as a leg fraction that changes by 1.
_POINT_COST = 50.0
# The ends of the fractions' range; an end fraction of 0 would let the tangent vanish.
_LEAST = (0.02, 0.0, 0.02)
_FARTHEST = 1.0
_SAME = 1e-12
_NONE = -1
# An end at a joint stands in two segments, and carries two legs.
_MOST_ROWS = 4


@dataclass(frozen=True, slots=True)
class Columns:
    """The unknowns of a chain: each adds itself to the numbers ``rows`` (m, 4).

    Where it adds itself to fewer, the others are 11 n, a number that is none.

    ``row`` is the number that an unknown is named after, ``beside`` that of its end where it tells
    how a point lies beside it; ``group`` is that of the point or fraction, ``carrier`` that of the
    end which carries the point; −1 is none.
    """

    rows: Numbers
    cost: Floats
    row: Numbers
    beside: Numbers
    group: Numbers
    carrier: Numbers
    fractions: Flags

    def spread(self, y: Floats, size: int) -> Floats:
        """Return what unknowns add to the ``size`` numbers of a chain."""
        found = np.bincount(self.rows.ravel(), np.repeat(y, self.rows.shape[1]), size + 1)
        return np.asarray(found[:size])

    def gathered(self, slope: Floats) -> Floats:
        """Return slopes by the unknowns, (k, m), for those by all numbers, (k, 11 n)."""
        padded = np.concatenate([slope, np.zeros((len(slope), 1))], axis=1)
        return np.asarray(padded[:, self.rows].sum(axis=2))

    @classmethod
    def of(
        cls, profile: Profile, fixed: Collection[tuple[int, int]], governed: Collection[int]
    ) -> Columns:
        """Return what may change of a profile but for ``fixed`` points.

        The shape of ``governed`` segments is not theirs to change; points on the axis stay on it,
        those of a flat bottom at its level.
        """
        return _Builder(profile, frozenset(fixed), frozenset(governed)).build()

    def held(self, start: Chain, edited: Chain) -> Flags:
        """Return which unknowns an edit has changed: those in the hand."""
        moved = (edited.blocks - start.blocks).ravel()
        own = moved[self.row] - np.where(self.beside >= 0, moved[self.beside], 0.0)
        groups = np.zeros(int(self.group.max(initial=0)) + 1, dtype=bool)
        groups[self.group[np.abs(own) > _SAME]] = True
        inner = (self.carrier >= 0) & groups[self.group]
        groups[self.carrier[inner]] = True
        return np.asarray(groups[self.group])

    def bounds(
        self, edited: Chain, held: Flags, shapes: list[ShapeParameters]
    ) -> tuple[Floats, Floats]:
        """Return how far the unknowns may go from an edited chain, each shape (m,).

        A segment one of whose parameters is in the hand keeps its ω.
        """
        values = edited.blocks.ravel()[self.row]
        low, high = np.full(len(values), -_FARTHEST), np.full(len(values), _FARTHEST)
        across = ~self.fractions & (self.row % BLOCK % 2 == 1) & (values > 0.0)
        low[across] = np.maximum(low[across], -values[across])
        segment, part = self.row // BLOCK, self.row % BLOCK
        omegas = np.ones(len(edited))
        for k in set(segment[self.fractions & held].tolist()):
            omegas[k] = shapes[k].omega
        least, most = _reach(omegas)
        chosen = self.fractions
        low[chosen] = np.minimum(least[segment[chosen], part[chosen]] - values[chosen], 0.0)
        high[chosen] = np.maximum(most[segment[chosen], part[chosen]] - values[chosen], 0.0)
        return low, high


def _reach(omegas: Floats) -> tuple[Floats, Floats]:
    """Return the least and the greatest leg fractions at some ω, each shape (n, 3)."""
    w = omegas
    least = np.stack([(3.0 - 3.0 * w) / 4.0, (3.0 - 3.0 * w) / 6.0, (3.0 - 3.0 * w) / 4.0], axis=1)
    most = np.stack([(3.0 + w) / 4.0, (3.0 + 3.0 * w) / 6.0, (3.0 + w) / 4.0], axis=1)
    return np.maximum(least, _LEAST), most


@dataclass(eq=False)
class _Builder:
    profile: Profile
    fixed: frozenset[tuple[int, int]]
    governed: frozenset[int]
    columns: list[tuple[list[int], float, int, int, int]] = field(default_factory=list)
    groups: int = 0

    def build(self) -> Columns:
        count = len(self.profile)
        for k in range(count):
            if k not in self.governed:
                for part in range(3):
                    self.columns.append(([BLOCK * k + part], 1.0, _NONE, self.groups, _NONE))
                    self.groups += 1
        fractions = len(self.columns)
        self.points = self.profile.control_points
        self.flat = standing(self.profile)
        for k in range(count):
            # Where a segment goes on from the one before, that one's end is its own.
            if not self._joined((k - 1) % count):
                self._end([(k, 0, 1)])
            following = (k + 1) % count
            if self._joined(k):
                self._end([(k, 3, 2), (following, 0, 1)])
            else:
                self._end([(k, 3, 2)])
        size = BLOCK * count
        return Columns(
            np.array(
                [rows + [size] * (_MOST_ROWS - len(rows)) for rows, *_ in self.columns],
                dtype=np.intp,
            ).reshape(-1, _MOST_ROWS),
            np.array([cost for _, cost, *_ in self.columns]),
            np.array([rows[0] for rows, *_ in self.columns], dtype=np.intp),
            np.array([beside for *_, beside, _, _ in self.columns], dtype=np.intp),
            np.array([group for *_, group, _ in self.columns], dtype=np.intp),
            np.array([carrier for *_, carrier in self.columns], dtype=np.intp),
            np.arange(len(self.columns)) < fractions,
        )

    def _joined(self, joint: int) -> bool:
        """Whether two segments' ends lie at one place after a joint's number."""
        following = (joint + 1) % len(self.profile)
        if following <= joint and not self.profile.closed:
            return False
        return bool(np.array_equal(self.points[joint, 3], self.points[following, 0]))

    def _end(self, sides: list[tuple[int, int, int]]) -> None:
        """Add an end that carries its legs, and the legs' points beside it."""
        if (
            len(sides) == 1
            and sides[0][1] == 0
            and self.profile.closed
            and self._joined(-1 % len(self.profile))
        ):
            # The last segment's end is this one.
            return
        carrier = _NONE
        if not any((k, end) in self.fixed for k, end, _ in sides):
            carrier, self.groups = self.groups, self.groups + 1
            for axis in range(2):
                if axis == 0 and self.points[sides[0][0], sides[0][1], 0] == 0.0:
                    continue
                if axis == 1 and any(k in self.flat for k, _, _ in sides):
                    continue
                rows = [_place(k, end, axis) for k, end, _ in sides]
                rows += [_place(k, leg, axis) for k, _, leg in sides if (k, leg) not in self.fixed]
                self.columns.append((rows, _POINT_COST, _NONE, carrier, _NONE))
        for k, end, leg in sides:
            if (k, leg) in self.fixed:
                continue
            for axis in range(2):
                if axis == 0 and self.points[k, leg, 0] == 0.0:
                    continue
                if axis == 1 and k in self.flat:
                    continue
                beside = _place(k, end, axis)
                self.columns.append(
                    ([_place(k, leg, axis)], _POINT_COST, beside, self.groups, carrier)
                )
            self.groups += 1


def _place(segment: int, point: int, axis: int) -> int:
    return BLOCK * segment + 3 + 2 * point + axis
