"""Relief: a surface moved along its normals by heights, between lines on which it stays.

Heights fade to nothing where the outer face of a body ends, at kinks and at the cuts of a part
turn, so that whatever meets it there still does. Rows and columns are placed where the heights
bend: between two of them the heights are nearly straight in both directions.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import ceil, log2
from typing import Protocol

import numpy as np

from sgb_core.arrays import Floats, Ints, distinct
from sgb_core.findings.errors import FindingError
from sgb_core.findings.surfaces import TooManyTriangles
from sgb_core.surfaces.uv import UVMap
from sgb_core.values import dataclass

# Samples over the width of an edge at least, along and around at most and at least so many, and in
# all at most so many.
_PER_EDGE = 3.0
MOST, LEAST = 4096, 64
_MOST_IN_ALL = 1 << 23
# Of 3t² − 2t³ a chord over a step h lies off by at most 6 h²/8.
_BEND = 0.75
# A diagonal of a cell bends up to four times as much as both of its sides.
_DIAGONAL = 0.25
# Rows of heights found at a time, which bounds the memory.
_STRIP = 128
# A row or column nearer to another than this part of the whole is not added.
NEAR = 1e-4
# A pole keeps its relief away by this part of the largest radius.
_POLE = 0.25

Run = tuple[float, float]


class Heights(Protocol):
    """What says how far a surface is raised; frozen and hashable."""

    def __hash__(self) -> int:
        """Return the hash of what decides the heights."""
        ...

    @property
    def reach(self) -> tuple[float, float]:
        """How far down and up heights may go, in the unit."""
        ...

    @property
    def edges(self) -> tuple[float, float]:
        """The narrowest and the widest edge, in the unit."""
        ...

    @property
    def varies_around(self) -> bool:
        """Whether heights differ from angle to angle."""
        ...

    def heights(self, uv_map: UVMap, sweep: float, u: Floats, v: Floats, least: float) -> Floats:
        """Return heights at shares of the sweep and of the length, shape (len(v), len(u))."""
        ...


def smooth(share: Floats) -> Floats:
    """Return 3t² − 2t³ of shares from 0 to 1: level at both ends."""
    return np.asarray(share * share * (3.0 - 2.0 * share))


@dataclass(frozen=True, slots=True, eq=False)
class ReliefField:
    """Heights over an outer face.

    ``faces`` are for each section of a body the runs of shares of the generatrix' length along
    which it is the outer face, without kinks; what one of them leaves out stays as it is.
    """

    source: Heights
    uv_map: UVMap
    sweep: float
    whole: bool
    faces: tuple[tuple[Run, ...], ...]

    @property
    def least(self) -> float:
        """The narrowest edge that there is, in the unit: a narrower one is as wide."""
        return _PER_EDGE * max(self.uv_map.width, self.uv_map.length) / MOST

    def counts(self, tolerance: float) -> tuple[int, int]:
        """Return into how many steps around and along the heights are taken apart.

        Raises FindingError where these would be too many.
        """
        low, high = self.source.reach
        edge = max(self.source.edges[0], self.least)
        per_edge = max(_PER_EDGE, (_BEND * (high - low) / tolerance) ** 0.5)
        around, along = (
            max(2 ** ceil(log2(max(per_edge * way / edge, 1.0))), LEAST)
            for way in (self.uv_map.width, self.uv_map.length)
        )
        if not self.source.varies_around:
            around = LEAST
        if around * along > _MOST_IN_ALL:
            raise FindingError(TooManyTriangles(2.0 * around * along, 2 * _MOST_IN_ALL))
        return around, along

    @property
    def fade(self) -> float:
        """How far from its ends the relief has its full depth, in the unit."""
        low, high = self.source.reach
        return max(self.source.edges[1], self.least, -low, high)

    def at(self, u: Floats, v: Floats) -> Floats:
        """Return the heights at columns and rows, shape (len(v), len(u))."""
        kept = self._kept(v)
        found = np.zeros((len(v), len(u)))
        inner = np.flatnonzero(kept)
        for begin in range(0, len(inner), _STRIP):
            rows = inner[begin : begin + _STRIP]
            heights = self.source.heights(self.uv_map, self.sweep, u, v[rows], self.least)
            heights *= kept[rows, None]
            if not self.whole:
                radius = np.interp(v[rows], self.uv_map.shares, np.abs(self.uv_map.points[:, 0]))
                way = np.minimum(u, 1.0 - u) * (self.sweep * radius)[:, None]
                heights *= smooth(np.clip(way / self.fade, 0.0, 1.0))
            found[rows] = heights
        return found

    def _kept(self, v: Floats) -> Floats:
        """Return which part of the heights is left at rows near the ends of faces, (len(v),)."""
        length = self.uv_map.length
        radius = np.abs(self.uv_map.points[:, 0])
        pole = max(self.fade, _POLE * float(radius.max()))
        least = np.ones_like(v)
        for face in self.faces:
            most = np.zeros_like(v)
            for ends in face:
                on_axis = np.interp(ends, self.uv_map.shares, radius) <= 1e-6 * radius.max()
                ways = [
                    np.clip(sign * (v - end) * length / (pole if polar else self.fade), 0.0, 1.0)
                    for sign, end, polar in zip((1.0, -1.0), ends, on_axis, strict=True)
                ]
                most = np.maximum(most, smooth(ways[0]) * smooth(ways[1]))
            least = np.minimum(least, most)
        return least

    def grid(self, tolerance: float) -> tuple[Floats, Floats]:
        """Return columns (shares of the sweep) and rows (of the length) that heights need.

        Between them heights stay within ``tolerance`` of what the corners' triangles give; columns
        and rows that they do not need are left out. 0 and 1 are among them.
        """
        limit = _DIAGONAL * tolerance
        around, along = self.counts(limit)
        u, v = np.linspace(0.0, 1.0, around + 1), np.linspace(0.0, 1.0, along + 1)
        heights = self.at(u, v).astype(np.float32)
        return u[bends(heights, limit)], v[bends(np.ascontiguousarray(heights.T), limit)]

    def parameters(self, v: Floats) -> Mapping[int, Floats]:
        """Return for each segment's number the s of the rows inside it."""
        per = self.uv_map.per_segment
        shares = self.uv_map.shares.reshape(-1, per + 1)
        even = np.linspace(0.0, 1.0, per + 1)
        found = {}
        for number, own in enumerate(shares):
            inside = v[(v > own[0]) & (v < own[-1])]
            found[number] = np.interp(inside, own, even)
        return found


def bends(values: np.ndarray[tuple[int, int], np.dtype[np.float32]], limit: float) -> Ints:
    """Return which columns of values (R, 2^k + 1) are needed, increasing.

    Between two of them every row stays within ``limit`` of its chord: intervals are halved until
    they do.
    """
    count = values.shape[1] - 1
    kept = np.zeros(count + 1, dtype=bool)
    kept[[0, -1]] = True
    open_: Ints = np.zeros(1, dtype=np.int64)
    width = count
    while width > 1 and len(open_):
        share = (np.arange(1, width) / width).astype(np.float32)
        bent = np.zeros(len(open_), dtype=bool)
        for number, first in enumerate(open_.tolist()):
            low, high = values[:, first], values[:, first + width]
            off = values[:, first + 1 : first + width] - low[:, None]
            off -= (high - low)[:, None] * share
            bent[number] = max(float(off.max()), -float(off.min())) > limit
        split = open_[bent]
        kept[split + width // 2] = True
        open_ = np.sort(np.concatenate([split, split + width // 2]))
        width //= 2
    return np.flatnonzero(kept).astype(np.int64)


def refined(given: Floats, wanted: Floats, near: float) -> Floats:
    """Return increasing values with others among them that are not ``near`` one of the given."""
    if len(wanted) == 0:
        return given
    place = np.clip(np.searchsorted(given, wanted), 1, len(given) - 1)
    apart = np.minimum(np.abs(wanted - given[place - 1]), np.abs(given[place] - wanted))
    return distinct(given, wanted[apart > near])
