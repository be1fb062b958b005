"""The drawn surface moved inwards by a fixed distance, found by height: what a bead follows.

Where the drawn wall climbs, the parallel at a distance inside it is the graph r(z) = min over the
points (f, h) of the wall of f − √(d² − (z − h)²), so loops that an offset has in tight curves and
corners are left out by taking the innermost branch (outside the outermost); about a corner of the
other kind that is an arc. Beyond its ends the curve goes on along its end tangents.
"""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.curvature import cross
from sgb_core.toolpaths.drawn import Drawn
from sgb_core.values import dataclass

# Intervals of a segment, and of an arc about a corner, between which a height is looked up.
_STEPS = 96
# Of the size: how near its height a place is found.
_WITHIN = 1e-8
_ARC_STEPS = 12
# Corners below this angle (radians) are rounding.
_SMOOTH = 1e-7
# What a place is at a known height: all but its distance along the axis.
_FLAT = [0, 1, 3]
# An end leaning more than this (the height's part of its direction) is carried on upright.
_LEVEL = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class MovedWall:
    """The surface moved by ``distance`` mm, positive towards the axis.

    ``nodes`` are looked-up places, shape (m, k, 4) as in :meth:`Drawn.moved`; ``segment`` and
    ``s``, shape (k,), say where each lies; −1 is on an arc or beyond an end, where the places
    between the nodes are ``exact`` on straight lines or arcs about ``centre`` (m, k, 2). Where all
    sections climb throughout ``keys`` (m·k,) are their heights, each section's above the last's.
    """

    wall: Drawn
    distance: float
    nodes: Floats
    segment: np.ndarray
    s: Floats
    centre: Floats
    keys: Floats | None = None

    @classmethod
    def of(cls, wall: Drawn, distance: float, reach: float) -> MovedWall:
        """Return the moved surface, carried on below its foot and above its rim by ``reach``."""
        rows, count = len(wall.sections), len(wall.numbers)
        steps = np.linspace(0.0, 1.0, _STEPS + 1)
        places, segments, positions, centres = [], [], [], []
        corners = wall.sections.ends[1]
        for k in range(count):
            s = wall.first + (1.0 - wall.first) * steps if k == 0 else steps
            row = np.repeat(np.arange(rows), len(s))
            at = np.tile(s, rows)
            moved = wall.moved(row, np.full(len(row), k), at, distance).reshape(rows, len(s), 4)
            if k and distance:
                every = np.arange(rows)
                joint = np.full(rows, k - 1)
                apart = distance - wall.heights(every, joint, np.ones(rows))
                arc = _arc(wall, k - 1, corners[:, k - 1], apart)
                if arc is not None:
                    places.append(arc)
                    segments.append(np.full(arc.shape[1], -1))
                    positions.append(np.zeros(arc.shape[1]))
                    centres.append(np.repeat(corners[:, k - 1, None], arc.shape[1], axis=1))
            places.append(moved)
            segments.append(np.full(len(s), k))
            positions.append(s)
            centres.append(np.full((rows, len(s), 2), np.nan))
        nodes = np.concatenate(places, axis=1)
        segment = np.concatenate(segments)
        centre = np.concatenate(centres, axis=1)
        before, after = _extensions(wall, nodes, reach)
        nodes = np.concatenate([before, nodes, after], axis=1)
        straight = np.full((rows, 1, 2), np.nan)
        return cls(
            wall,
            distance,
            nodes,
            np.concatenate([[-1], segment, [-1]]),
            np.concatenate([[0.0], *positions, [0.0]]),
            np.concatenate([straight, centre, straight], axis=1),
            _keys(nodes[..., 2]),
        )

    def at(self, z: Floats, row: np.ndarray, *, exact: bool = True) -> Floats:
        """Return the places at heights ``z`` at the angles of numbers ``row``, shape (k, 3).

        The three are the distances from the axis and along the turn, and by how many radians a
        twist turns their half-plane. Below and above the ends the end counts. Where not ``exact``
        a cubic through the looked-up places is enough, which is off by 1e-6 of the size or less;
        a relief is followed exactly all the same.
        """
        bracket = self._brackets(z, row)
        low, high = self.nodes[row, bracket], self.nodes[row, bracket + 1]
        rise = high[:, 2] - low[:, 2]
        share = np.clip((z - low[:, 2]) / np.where(rise > 0.0, rise, 1.0), 0.0, 1.0)
        found = (low + share[:, None] * (high - low))[:, _FLAT]
        centre = self.centre[row, bracket]
        # Under a relief corners are slight, if there are any, and chords are near enough.
        smooth = self.wall.raised is None
        on_arc = smooth & ~np.isnan(centre[:, 0]) & ~np.isnan(self.centre[row, bracket + 1, 0])
        if on_arc.any():
            away = np.clip(self.distance**2 - (z[on_arc] - centre[on_arc, 1]) ** 2, 0.0, None)
            found[on_arc, 0] = centre[on_arc, 0] - np.sign(self.distance) * np.sqrt(away)
        curved = (self.segment[bracket] >= 0) & (self.segment[bracket] == self.segment[bracket + 1])
        curved &= (share > 0.0) & (share < 1.0)
        if curved.any():
            where = (z[curved], row[curved], bracket[curved])
            x, near = self._on_cubic(*where, share[curved])
            found[curved] = self._refined(*where, x) if exact or not smooth else near
        return np.asarray(found)

    def _on_cubic(
        self, z: Floats, row: np.ndarray, bracket: np.ndarray, share: Floats
    ) -> tuple[Floats, Floats]:
        """Return how far beyond its node each height lies, 0 to 1, and the places there, (k, 3).

        Both by the cubic through four nodes of the segment, solved by Newton's method.
        """
        begins = np.concatenate([[0], np.flatnonzero(np.diff(self.segment)) + 1])
        start = begins[np.searchsorted(begins, bracket, side="right") - 1]
        first = np.clip(bracket - 1, start, start + _STEPS - 3)
        before = (bracket - first).astype(np.float64)
        flat = self.nodes.reshape(-1, self.nodes.shape[-1])
        number = row * self.nodes.shape[1] + first
        y = [flat[number + k].T for k in range(4)]
        # Newton's divided differences on even steps.
        one = [y[k + 1] - y[k] for k in range(3)]
        two = [one[k + 1] - one[k] for k in range(2)]
        parts = (y[0], one[0], two[0] / 2.0, (two[1] - two[0]) / 6.0)
        a, b, c, d = (part[2] for part in parts)
        x = before + share
        for _ in range(3):
            inner = c + (x - 2.0) * d
            off = a + x * (b + (x - 1.0) * inner) - z
            slope = b + (2.0 * x - 1.0) * inner + x * (x - 1.0) * d
            x = np.clip(x - off / np.where(slope > 0.0, slope, np.inf), before, before + 1.0)
        a, b, c, d = (part[_FLAT] for part in parts)
        return x - before, (a + x * (b + (x - 1.0) * (c + (x - 2.0) * d))).T

    def _brackets(self, z: Floats, row: np.ndarray) -> np.ndarray:
        if self.keys is not None:
            count = self.nodes.shape[1]
            low, high = self.nodes[:, 0, 2], self.nodes[:, -1, 2]
            wanted = np.clip(z, low[row], high[row]) + row * _apart(self.nodes[..., 2])
            place = np.searchsorted(self.keys, wanted, side="right") - 1 - row * count
            return np.asarray(np.clip(place, 0, count - 2))
        found = np.zeros(len(z), dtype=np.intp)
        order = np.argsort(row, kind="stable")
        first = np.searchsorted(row[order], np.arange(len(self.nodes) + 1))
        for k in range(len(self.nodes)):
            mine = order[first[k] : first[k + 1]]
            if len(mine):
                found[mine] = self._brackets_at(z[mine], self.nodes[k])
        return found

    def _brackets_at(self, z: Floats, nodes: Floats) -> np.ndarray:
        """Return the number of the node below each height on the innermost rising branch."""
        r, heights = nodes[:, 0], nodes[:, 2]
        last = len(heights) - 2
        falling = np.flatnonzero(np.diff(heights) < 0.0)
        if len(falling) == 0:
            return np.clip(np.searchsorted(heights, z, side="right") - 1, 0, last)
        side = 1.0 if self.distance >= 0.0 else -1.0
        best = np.full(len(z), np.inf)
        found = np.where(z < heights[0], 0, last)
        edges = np.concatenate([[0], falling + 1, [len(heights)]])
        for start, stop in zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True):
            if stop - start < 2:
                continue
            own = heights[start:stop]
            at = np.clip(np.searchsorted(own, z, side="right") - 1, 0, stop - start - 2) + start
            rise = heights[at + 1] - heights[at]
            share = (z - heights[at]) / np.where(rise > 0.0, rise, 1.0)
            reach = side * (r[at] + share * (r[at + 1] - r[at]))
            better = (z >= own[0]) & (z <= own[-1]) & (reach < best)
            found, best = np.where(better, at, found), np.where(better, reach, best)
        return np.asarray(found)

    def _refined(self, z: Floats, row: np.ndarray, bracket: np.ndarray, share: Floats) -> Floats:
        """Return places at exact heights: the secant method on s, halving where it fails.

        ``share`` is how far beyond its node each of them lies about.
        """
        segment = self.segment[bracket]
        low, high = self.s[bracket], self.s[bracket + 1]
        tolerance = _WITHIN * self.wall.size

        def miss(s: Floats, few: np.ndarray | slice = slice(None)) -> tuple[Floats, Floats]:
            place = self.wall.moved(row[few], segment[few], s, self.distance)
            return place[:, 2] - z[few], place

        s = low + share * (high - low)
        off, place = miss(s)
        bad = np.flatnonzero(np.abs(off) > tolerance)
        before, at_before = low[bad], self.nodes[row[bad], bracket[bad], 2] - z[bad]
        for _ in range(5):
            if len(bad) == 0:
                return place[:, _FLAT]
            change = off[bad] - at_before
            step = -off[bad] * (s[bad] - before) / np.where(change == 0.0, 1.0, change)
            before, at_before = s[bad], off[bad]
            s[bad] = np.clip(s[bad] + step, low[bad], high[bad])
            off[bad], place[bad] = miss(s[bad], bad)
            still = np.abs(off[bad]) > tolerance
            bad, before, at_before = bad[still], before[still], at_before[still]
        below, above = low[bad], high[bad]
        for _ in range(50 if len(bad) else 0):
            middle = (below + above) / 2.0
            under = miss(middle, bad)[0] < 0.0
            below, above = np.where(under, middle, below), np.where(under, above, middle)
        if len(bad):
            place[bad] = miss((below + above) / 2.0, bad)[1]
        return place[:, _FLAT]


def _keys(heights: Floats) -> Floats | None:
    if (np.diff(heights, axis=1) < 0.0).any():
        return None
    rows = np.arange(len(heights))[:, None]
    return np.asarray((heights + rows * _apart(heights)).ravel())


def _apart(heights: Floats) -> float:
    """Return by how much the heights of sections are moved apart so that none overlap."""
    return 2.0 * float(heights[:, -1].max() - heights[:, 0].min())


def _arc(wall: Drawn, joint: int, corner: Floats, distance: Floats) -> Floats | None:
    """Return nodes on the arcs about a corner, shape (m, k, 4); None where there is no corner.

    ``distance`` (m,) are their radii, negative away from the axis.
    """
    rows = len(wall.sections)
    row = np.arange(rows)
    before = wall.tangents(row, joint, np.ones(rows))
    after = wall.tangents(row, joint + 1, np.zeros(rows))
    turn = np.arctan2(cross(before, after), (before * after).sum(axis=-1))
    if (np.abs(turn) < _SMOOTH).all():
        return None
    angle = np.arctan2(-before[:, 0], before[:, 1])[:, None] + turn[:, None] * np.linspace(
        0.0, 1.0, _ARC_STEPS + 1
    )
    nodes = np.zeros((rows, _ARC_STEPS + 1, 4))
    nodes[..., 0] = corner[:, None, 0] - distance[:, None] * np.cos(angle)
    nodes[..., 2] = corner[:, None, 1] - distance[:, None] * np.sin(angle)
    nodes[..., 3] = wall.turned(corner[:, 1])[:, None]
    return nodes


def _extensions(wall: Drawn, nodes: Floats, reach: float) -> tuple[Floats, Floats]:
    """Return one node below the foot and one above the rim of each section, (m, 1, 4) each."""
    rows = len(nodes)
    row = np.arange(rows)
    foot = wall.tangents(row, 0, np.full(rows, wall.first))
    rim = wall.tangents(row, -1, np.ones(rows))
    found = []
    for end, tangent, way in ((nodes[:, 0], foot, -1.0), (nodes[:, -1], rim, 1.0)):
        steep = tangent[:, 1] > _LEVEL
        lean = np.where(steep, tangent[:, 0] / np.where(steep, tangent[:, 1], 1.0), 0.0)
        beyond = end.copy()
        beyond[:, 0] += way * reach * lean
        beyond[:, 2] += way * reach
        found.append(beyond[:, None])
    return found[0], found[1]
