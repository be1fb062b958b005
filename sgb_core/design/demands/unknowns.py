"""What may change of a chain: few unknowns y, from which all its numbers follow linearly."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.demands.chain import BLOCK, Chain
from sgb_core.values import dataclass

# A fraction so near an end of its range is at it.
_AT_END = 1e-15
# Inner points go no farther than this, in sizes of the profile, and legs keep this part of their
# length: beyond, an energy can fall for ever along ever larger loops.
_FARTHEST = 1.0
_LEAST_LEG = 0.02


@dataclass(frozen=True, slots=True)
class Unknowns:
    """Numbers = start + ``matrix`` y, with ``low`` ≤ y ≤ ``high``; y = 0 is the start.

    ``matrix`` has shape (11 n, m); its columns are square to each other.
    """

    start: Chain
    matrix: Floats
    low: Floats
    high: Floats

    def __len__(self) -> int:
        return int(self.matrix.shape[1])

    def chain(self, y: Floats) -> Chain:
        """Return the chain that y stands for."""
        flat = self.start.blocks.ravel() + self.matrix @ y
        blocks = flat.reshape(self.start.blocks.shape)
        fractions = blocks[:, :3]
        fractions[np.abs(fractions) <= _AT_END] = 0.0
        fractions[np.abs(fractions - 1.0) <= _AT_END] = 1.0
        return self.start.with_blocks(blocks)

    def nearest(self, chain: Chain) -> Floats:
        """Return the y within the bounds that comes nearest to a chain."""
        change = (chain.blocks - self.start.blocks).ravel()
        y = (self.matrix.T @ change) / (self.matrix**2).sum(axis=0)
        return np.asarray(np.clip(y, self.low, self.high))


def fraction_unknowns(start: Chain, low: Floats, high: Floats) -> Unknowns:
    """Return the leg fractions that have a range, of ``low`` and ``high`` (n, 3), as unknowns."""
    places = np.flatnonzero((low < high).ravel())
    rows = places // 3 * BLOCK + places % 3
    matrix = np.zeros((start.blocks.size, len(places)))
    matrix[rows, range(len(places))] = 1.0
    base = start.blocks.ravel()[rows]
    return Unknowns(start, matrix, low.ravel()[places] - base, high.ravel()[places] - base)


def with_inner_points(
    unknowns: Unknowns,
    segments: Collection[int],
    *,
    along_tangents: bool,
    fixed: Collection[tuple[int, int]] = (),
) -> Unknowns:
    """Return unknowns with P1 and P2 of some segments added, ``fixed`` (segment, point) left out.

    Each moves freely, or along its leg only. No point that lies on one side of the axis crosses
    it.
    """
    start = unknowns.start
    columns, low, high = [], [], []
    for k in sorted(segments):
        for end, leg in ((0, 1), (3, 2)):
            if (k, leg) in fixed:
                continue
            place = BLOCK * k + 3 + 2 * leg
            point, step = start.points[k, leg], start.points[k, leg] - start.points[k, end]
            length = float(np.hypot(step[0], step[1]))
            if along_tangents:
                if length > 0.0:
                    columns.append((place, step / length))
                    low.append((_LEAST_LEG - 1.0) * length)
                    high.append(_FARTHEST)
                continue
            for axis, unit in enumerate(np.eye(2)):
                columns.append((place, unit))
                at_axis = axis == 0 and point[0] >= 0.0
                low.append(-min(_FARTHEST, float(point[0])) if at_axis else -_FARTHEST)
                high.append(_FARTHEST)
    matrix = np.zeros((start.blocks.size, len(columns)))
    for column, (place, along) in enumerate(columns):
        matrix[place : place + 2, column] = along
    return Unknowns(
        start,
        np.concatenate([unknowns.matrix, matrix], axis=1),
        np.concatenate([unknowns.low, low]),
        np.concatenate([unknowns.high, high]),
    )
