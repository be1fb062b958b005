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
    between the nodes are ``exact`` on straight lines or arcs about ``centre`` (m, k, 2).
    """

    wall: Drawn
    distance: float
    nodes: Floats
    segment: np.ndarray
    s: Floats
    centre: Floats

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
                arc = _arc(wall, k - 1, corners[:, k - 1], distance)
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
        straight = np.full((rows, 1, 2), np.nan)
        return cls(
            wall,
            distance,
            np.concatenate([before, nodes, after], axis=1),
            np.concatenate([[-1], segment, [-1]]),
            np.concatenate([[0.0], *positions, [0.0]]),
            np.concatenate([straight, centre, straight], axis=1),
        )

    def at(self, z: Floats, row: np.ndarray) -> Floats:
        """Return the places at heights ``z`` at the angles of numbers ``row``, shape (k, 3).

        The three are the distances from the axis and along the turn, and by how many radians a
        twist turns their half-plane. Below and above the ends the end counts.
        """
        bracket = self._brackets(z, row)
        low, high = self.nodes[row, bracket], self.nodes[row, bracket + 1]
        rise = high[:, 2] - low[:, 2]
        share = np.clip((z - low[:, 2]) / np.where(rise > 0.0, rise, 1.0), 0.0, 1.0)
        found = (low + share[:, None] * (high - low))[:, _FLAT]
        centre = self.centre[row, bracket]
        on_arc = ~np.isnan(centre[:, 0]) & ~np.isnan(self.centre[row, bracket + 1, 0])
        if on_arc.any():
            away = np.clip(self.distance**2 - (z[on_arc] - centre[on_arc, 1]) ** 2, 0.0, None)
            found[on_arc, 0] = centre[on_arc, 0] - np.sign(self.distance) * np.sqrt(away)
        curved = (self.segment[bracket] >= 0) & (self.segment[bracket] == self.segment[bracket + 1])
        curved &= (share > 0.0) & (share < 1.0)
        if curved.any():
            found[curved] = self._refined(z[curved], row[curved], bracket[curved], share[curved])
        return np.asarray(found)

    def _brackets(self, z: Floats, row: np.ndarray) -> np.ndarray:
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
        """Return places at exact heights: the secant method on s, halving where it fails."""
        segment = self.segment[bracket]
        low, high = self.s[bracket], self.s[bracket + 1]
        width = high - low
        tolerance = 1e-9 * self.wall.size

        def miss(s: Floats, few: np.ndarray | slice = slice(None)) -> tuple[Floats, Floats]:
            place = self.wall.moved(row[few], segment[few], s, self.distance)
            return place[:, 2] - z[few], place

        before, s = low, low + share * width
        at_before = self.nodes[row, bracket, 2] - z
        off, place = miss(s)
        for _ in range(5):
            if (np.abs(off) <= tolerance).all():
                return place[:, _FLAT]
            change = off - at_before
            step = -off * (s - before) / np.where(change == 0.0, 1.0, change)
            before, at_before = s, off
            s = np.clip(s + step, low, high)
            off, place = miss(s)
        bad = np.flatnonzero(np.abs(off) > tolerance)
        if len(bad):
            below, above = low[bad], high[bad]
            for _ in range(50):
                middle = (below + above) / 2.0
                under = miss(middle, bad)[0] < 0.0
                below, above = np.where(under, middle, below), np.where(under, above, middle)
            place[bad] = miss((below + above) / 2.0, bad)[1]
        return place[:, _FLAT]


def _arc(wall: Drawn, joint: int, corner: Floats, distance: float) -> Floats | None:
    """Return nodes on the arcs about a corner, shape (m, k, 4); None where there is no corner."""
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
    nodes[..., 0] = corner[:, None, 0] - distance * np.cos(angle)
    nodes[..., 2] = corner[:, None, 1] - distance * np.sin(angle)
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
