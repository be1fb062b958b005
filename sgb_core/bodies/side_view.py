"""A body of revolution seen from the side: which stretches of its outline show, and which edges.

Seen level, at each height the place farthest from the axis hides all others. What shows are the
stretches of the outline that are outermost at their height, and circles as level lines from the
axis: corners that show, and folds, below or above which the body is narrower at once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import acos, degrees

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.outline import Line, Piece, Ring, Role
from sgb_core.values import dataclass

# Points in all along the outline, and at least along each piece, that say what hides what.
_POINTS, _LEAST = 2000, 8
_AT_ONCE = 256
# Parts of the size: what is nearer than this is not hidden; how far above and below a fold is
# looked, and by how much the body is narrower there at once.
_NEAR, _BESIDE, _JUMP = 1e-5, 1e-7, 1e-3
# What rises by less than this part of the size is level.
_LEVEL = 1e-9
# A smaller turn, in degrees, is no edge that is seen.
EDGE_DEG = 1.0
_HALVINGS = 40


@dataclass(frozen=True, slots=True, eq=False)
class SideView:
    """What shows of one half: stretches of the outline, and circles as (radius, height)."""

    stretches: tuple[Piece, ...]
    edges: tuple[tuple[float, float], ...]


class _Profile:
    """The outlines as edges of a polyline, which answer how far out the body is at a height."""

    def __init__(self, rings: Sequence[Ring], size: float) -> None:
        pieces = [piece for ring in rings for piece in ring if piece.role is not Role.AXIS]
        per_piece = max(_LEAST, _POINTS // max(1, len(pieces)))
        self.size = size
        self.samples = {id(piece): _grid(piece, per_piece, size) for piece in pieces}
        lines = [piece.points(self.samples[id(piece)]) for piece in pieces]
        starts = np.concatenate([line[:-1] for line in lines])
        ends = np.concatenate([line[1:] for line in lines])
        self._low = np.minimum(starts[:, 1], ends[:, 1])
        self._high = np.maximum(starts[:, 1], ends[:, 1])
        self._starts = starts
        rise = ends[:, 1] - starts[:, 1]
        # A level line hides nothing, whatever rounding makes of its heights.
        rise[np.abs(rise) <= _LEVEL * size] = 0.0
        self._high = np.where(rise == 0.0, self._low, self._high)
        lean = np.zeros(len(rise))
        np.divide(ends[:, 0] - starts[:, 0], rise, out=lean, where=rise != 0.0)
        self._lean = lean

    def reach(self, heights: Floats) -> Floats:
        """Return how far from the axis the body is at heights; −∞ above and below it."""
        found = np.full(len(heights), -np.inf)
        for first in range(0, len(heights), _AT_ONCE):
            h = heights[first : first + _AT_ONCE, None]
            within = (self._low <= h) & (h < self._high)
            radii = self._starts[:, 0] + (h - self._starts[:, 1]) * self._lean
            found[first : first + _AT_ONCE] = np.where(within, radii, -np.inf).max(axis=1)
        return found

    def shows(self, points: Floats) -> Floats:
        """Return whether places of the outline are hidden by none, shape (k,)."""
        return np.asarray(self.reach(points[:, 1]) <= points[:, 0] + _NEAR * self.size)

    def is_fold(self, point: Floats) -> bool:
        """Whether right above or below a place of the outline the body is narrower, or ends."""
        beside = self.reach(point[1] + np.array([-1.0, 1.0]) * (_BESIDE * self.size))
        return bool((beside < point[0] - _JUMP * self.size).any())


def _grid(piece: Piece, count: int, size: float) -> Floats:
    """Return parameters along the travel, those of the highest and lowest places among them."""
    if isinstance(piece, Line):
        return np.array([piece.start, piece.end])
    u = np.linspace(piece.start, piece.end, count)
    rates = piece.velocity(u)[:, 1]
    rates[np.abs(rates) <= _LEVEL * size] = 0.0
    turning = np.flatnonzero(rates[:-1] * rates[1:] < 0.0)
    low, high = u[turning], u[turning + 1]
    side = np.sign(rates[turning])
    for _ in range(_HALVINGS if len(turning) else 0):
        middle = 0.5 * (low + high)
        before = np.sign(piece.velocity(middle)[:, 1]) == side
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    extremes = 0.5 * (low + high)
    return np.insert(u, turning + 1, extremes)


def side_view(rings: Sequence[Ring], size: float) -> SideView:
    """Return what shows of bodies between outlines in the half-plane, material to their left.

    A run of pieces that is not closed, such as a bare profile, counts as a ring of its own.
    """
    profile = _Profile(rings, size)
    stretches: list[Piece] = []
    edges: list[tuple[float, float]] = []
    for ring in rings:
        for number, piece in enumerate(ring):
            if piece.role is Role.AXIS:
                continue
            parts = _showing(profile, piece)
            stretches += [part for part in parts if not _is_level(part, size)]
            for part in parts:
                edges += [
                    (float(end[0]), float(end[1])) for end in part.ends if profile.is_fold(end)
                ]
            following = ring[(number + 1) % len(ring)]
            corner = piece.ends[1]
            if _turns(piece, following, size) and bool(profile.shows(corner[None])[0]):
                edges.append((float(corner[0]), float(corner[1])))
    return SideView(tuple(stretches), _distinct(edges, size))


def circles_of(rings: Sequence[Ring], size: float) -> tuple[tuple[float, float], ...]:
    """Return all corners and places that are highest or lowest around, as (radius, height)."""
    found: list[tuple[float, float]] = []
    for ring in rings:
        for number, piece in enumerate(ring):
            if piece.role is Role.AXIS:
                continue
            u = _grid(piece, _LEAST, size)
            points = piece.points(u)
            rise = np.diff(points[:, 1])
            rise[np.abs(rise) <= _LEVEL * size] = 0.0
            turning = np.flatnonzero(rise[:-1] * rise[1:] < 0.0) + 1
            found += [(float(r), float(h)) for r, h in points[turning]]
            for other, place in ((ring[(number + 1) % len(ring)], 1), (ring[number - 1], 0)):
                corner = piece.ends[place]
                apart = other.ends[1 - place] - corner
                pair = (piece, other) if place else (other, piece)
                if float(np.hypot(*apart)) > _NEAR * size or _turns(*pair, size):
                    found.append((float(corner[0]), float(corner[1])))
    return tuple(circle for circle in found if circle[0] > _NEAR * size)


def _showing(profile: _Profile, piece: Piece) -> list[Piece]:
    """Return the stretches of a piece that nothing hides, led to where they end."""
    u = profile.samples[id(piece)]
    middles = 0.5 * (u[:-1] + u[1:])
    seen = profile.shows(piece.points(middles))
    parts: list[Piece] = []
    start: float | None = None
    for number, shown in enumerate(seen.tolist()):
        if shown and start is None:
            start = float(u[0]) if number == 0 else _border(profile, piece, middles, number)
        elif not shown and start is not None:
            parts.append(replace(piece, start=start, end=_border(profile, piece, middles, number)))
            start = None
    if start is not None:
        parts.append(replace(piece, start=start, end=float(u[-1])))
    return parts


def _border(profile: _Profile, piece: Piece, middles: Floats, number: int) -> float:
    """Return where, between two places of which one is hidden, what shows begins or ends."""
    sample = float(profile.samples[id(piece)][number])
    rates = piece.velocity(np.array([middles[number - 1], middles[number]]))[:, 1]
    if rates[0] * rates[1] < 0.0:
        # It turns back there: at a fold one side hides the other.
        return sample
    first, last = float(middles[number - 1]), float(middles[number])
    shown = bool(profile.shows(piece.points(np.array([first])))[0])
    for _ in range(_HALVINGS):
        middle = 0.5 * (first + last)
        if bool(profile.shows(piece.points(np.array([middle])))[0]) == shown:
            first = middle
        else:
            last = middle
    return first if shown else last


def _is_level(piece: Piece, size: float) -> bool:
    """Whether a piece is a level line, which the circles at its ends show already."""
    heights = piece.points(np.linspace(piece.start, piece.end, _LEAST))[:, 1]
    return float(np.ptp(heights)) <= _LEVEL * size


def _turns(piece: Piece, following: Piece, size: float) -> bool:
    """Whether two pieces meet at a corner that is seen as an edge."""
    corner, start = piece.ends[1], following.ends[0]
    if Role.AXIS in (piece.role, following.role) or corner[0] <= _NEAR * size:
        return False
    if float(np.hypot(*(start - corner))) > _NEAR * size:
        return False
    before, after = _direction(piece, piece.end), _direction(following, following.start)
    return degrees(acos(min(1.0, max(-1.0, float(before @ after))))) > EDGE_DEG


def _direction(piece: Piece, u: float) -> Floats:
    tangent = piece.tangents(np.array([u]))[0]
    return np.asarray(tangent if piece.end >= piece.start else -tangent)


def _distinct(edges: list[tuple[float, float]], size: float) -> tuple[tuple[float, float], ...]:
    """Return one circle for each height, the widest, from the lowest to the highest."""
    found: list[tuple[float, float]] = []
    for r, h in sorted(edges, key=lambda edge: (edge[1], edge[0])):
        if r <= _NEAR * size:
            continue
        if found and h - found[-1][1] <= 10.0 * _NEAR * size:
            found[-1] = (max(r, found[-1][0]), found[-1][1])
        else:
            found.append((r, h))
    return tuple(found)
