"""Regions of the half-plane: topology by GEOS on dense samples, exact outlines read back from it.

Loops of exact pieces are sampled and handed to shapely, which finds crossings, unites and cuts.
Every edge that comes back is known to be part of one piece, so the result is again an outline of
exact pieces, whose corners are then found by Newton's method to rounding.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from itertools import pairwise
from math import ceil, pi
from typing import TypeAlias

import numpy as np
import shapely
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints
from sgb_core.bodies.corners import joined, straightened
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outline import Arc, Line, Piece, Ring, Role, Trace
from sgb_core.bodies.traces import points_of
from sgb_core.findings.bodies import NoBodyFor
from sgb_core.values import dataclass

Complexes: TypeAlias = NDArray[np.complex128]
ARC_STEP = pi / 24.0
# A curve and a distance from it.
Near: TypeAlias = tuple[shapely.Geometry, float]
# So many points at a time bound the memory, whatever the number of edges.
_AT_ONCE = 128
# What lies on an edge is nearer to it than this part of the size.
_NEAR = 1e-9
# Parts of a region smaller than this share of size² are rounding.
SLIVER = 1e-11
# Roles of lines that may lie on others without being what the body has there.
_CLOSING = (Role.FLOOR, Role.LEVEL)


@dataclass(frozen=True, slots=True)
class Outline:
    """One connected part of a cross-section: its outer ring and those of its holes.

    Rings have the material to their left: the outer runs counter-clockwise in (r, h).
    """

    exterior: Ring
    holes: tuple[Ring, ...] = ()

    @property
    def rings(self) -> tuple[Ring, ...]:
        """The outer ring, then the holes."""
        return (self.exterior, *self.holes)


@dataclass(slots=True, eq=False)
class Register:
    """Samples of loops and which piece each of their edges belongs to.

    ``grids`` gives the parameters at which each segment's traces are sampled.
    """

    grids: Mapping[int, Floats]
    size: float
    pieces: dict[int, Piece] = field(default_factory=dict)
    _starts: dict[complex, list[int]] = field(default_factory=dict)
    _stops: dict[complex, list[int]] = field(default_factory=dict)
    _edges: list[tuple[complex, complex, int, float, float]] = field(default_factory=list)
    _known: dict[tuple[int, float], list[float]] = field(default_factory=dict)
    _table: tuple[Complexes, Complexes, shapely.STRtree] | None = None

    def polygon(self, loop: Sequence[Piece], near: Near | None = None) -> shapely.Geometry:
        """Return the region that a closed loop winds around counter-clockwise, as polygons.

        The pieces follow each other; where ends do not meet, a straight edge joins them. ``near``
        as for :func:`positive_region`.
        """
        loop = [piece for piece in loop if self._is_long(piece)]
        samples = [parameters(piece, self.grids) for piece in loop]
        # Without each piece's last point, with which the next begins.
        ring = self._points(loop, [u[:-1] for u in samples])
        keys = _keys(ring)
        position = 0
        for piece, u in zip(loop, samples, strict=True):
            self.pieces.setdefault(piece.source, piece)
            for low, high in zip(u[:-1].tolist(), u[1:].tolist(), strict=True):
                first, last = keys[position], keys[(position + 1) % len(keys)]
                position += 1
                if first != last:
                    self._starts.setdefault(first, []).append(len(self._edges))
                    self._stops.setdefault(last, []).append(len(self._edges))
                    self._edges.append((first, last, piece.source, low, high))
        self._table = None
        return positive_region(ring, self.size, near)

    def _points(self, pieces: Sequence[Piece], samples: Sequence[Floats]) -> Floats:
        """Return samples that are the same to the last bit in every loop of a piece, one by one."""
        sources = [piece.source for piece in pieces]
        keys = [
            (source, u)
            for source, places in zip(sources, samples, strict=True)
            for u in places.tolist()
        ]
        of = np.repeat(np.arange(len(pieces)), [len(u) for u in samples])
        fresh = np.array([key not in self._known for key in keys], dtype=bool)
        if fresh.any():
            u = np.concatenate(samples)[fresh]
            new = (key for key, is_new in zip(keys, fresh.tolist(), strict=True) if is_new)
            points = points_of(pieces, u, of[fresh]).tolist()
            self._known.update(zip(new, points, strict=True))
        return np.array([self._known[key] for key in keys]).reshape(-1, 2)

    def samples(self, pieces: Sequence[Piece]) -> Floats:
        """Return the points at which loops hold pieces, one piece after the other, (k, 2)."""
        return self._points(pieces, [parameters(piece, self.grids) for piece in pieces])

    def _is_long(self, piece: Piece) -> bool:
        if not isinstance(piece, Line):
            return True
        step = np.diff(piece.ends, axis=0)[0]
        return bool(np.hypot(*step) > 1e-12 * self.size)

    def outlines(self, geometry: shapely.Geometry) -> tuple[Outline, ...]:
        """Return the exact outlines of polygons made from registered loops, largest first."""
        parts = [
            part
            for part in shapely.get_parts(geometry)
            if isinstance(part, shapely.Polygon) and part.area > SLIVER * self.size**2
        ]
        parts.sort(key=lambda part: -part.area)
        found = []
        for part in parts:
            oriented = shapely.orient_polygons(part)
            holes = [
                hole
                for hole in oriented.interiors
                if shapely.Polygon(hole).area > SLIVER * self.size**2
            ]
            found.append(
                Outline(self._ring(oriented.exterior), tuple(self._ring(hole) for hole in holes))
            )
        return tuple(found)

    def _ring(self, ring: shapely.LinearRing) -> Ring:
        keys = _keys(shapely.get_coordinates(ring))
        stretches: list[list[float]] = []
        for first, last in pairwise(keys):
            if first == last:
                continue
            before = int(stretches[-1][0]) if stretches else -1
            source, start, end = self._part(first, last, before)
            if stretches and stretches[-1][0] == source and _goes_on(stretches[-1], start, end):
                stretches[-1][2] = end
            else:
                stretches.append([source, start, end])
        if len(stretches) > 1 and stretches[0][0] == stretches[-1][0]:
            last_one = stretches[-1]
            if _goes_on(last_one, stretches[0][1], stretches[0][2]):
                stretches[0][1] = last_one[1]
                stretches.pop()
        pieces = [
            replace(self.pieces[int(source)], start=start, end=end)
            for source, start, end in stretches
            if start != end
        ]
        return joined(straightened(pieces), self.size)

    def _part(self, first: complex, last: complex, before: int) -> tuple[int, float, float]:
        """Return (source, u at first, u at last) of the piece that an edge lies on."""
        found: list[tuple[int, float, float]] = []
        for number in self._starts.get(first, ()):
            _, stop, source, low, high = self._edges[number]
            if stop == last:
                found.append((source, low, high))
        for number in self._stops.get(first, ()):
            start, _, source, low, high = self._edges[number]
            if start == last:
                found.append((source, high, low))
        if found:
            return min(found, key=lambda part: self._rank(part[0], before))
        return self._partial(first, last, before)

    def _rank(self, source: int, before: int) -> tuple[bool, bool, int]:
        """Order the pieces that share an edge, in the same way at every angle of a turn.

        What only closes a region, such as the lid of the cavity, comes after the body's own.
        """
        return self.pieces[source].role in _CLOSING, source != before, source

    def _partial(self, first: complex, last: complex, before: int) -> tuple[int, float, float]:
        origin, step, tree = self._edge_table()
        # An edge that holds both ends reaches into the box around one of them.
        reach = _NEAR * self.size
        x, y = first.real, first.imag
        near = np.sort(tree.query(shapely.box(x - reach, y - reach, x + reach, y + reach)))
        away, shares = _distances(origin[near], step[near], first, last)
        if away.min(initial=np.inf) > reach / 2.0:
            near = np.arange(len(origin))
            away, shares = _distances(origin, step, first, last)
        best = int(np.argmin(away))
        close = np.flatnonzero(away <= away[best] + 1e-12 * self.size).tolist()
        best = min(close, key=lambda place: self._rank(self._edges[near[place]][2], before))
        _, _, source, low, high = self._edges[near[best]]
        start, end = (low + (high - low) * float(share[best]) for share in shares)
        return source, start, end

    def _edge_table(self) -> tuple[Complexes, Complexes, shapely.STRtree]:
        if self._table is None:
            edges = np.array([(a, b) for a, b, *_ in self._edges])
            lines = shapely.linestrings(np.stack([edges.real, edges.imag], axis=-1))
            self._table = edges[:, 0], edges[:, 1] - edges[:, 0], shapely.STRtree(lines)
        return self._table


def _distances(
    origin: Complexes, step: Complexes, first: complex, last: complex
) -> tuple[Floats, tuple[Floats, Floats]]:
    """Return how far the farther of two points is from each edge, and their shares of it."""
    square = np.abs(step) ** 2
    share_first, share_last = (
        np.clip(((end - origin) * step.conj()).real / square, 0.0, 1.0) for end in (first, last)
    )
    away = np.maximum(
        np.abs(first - origin - share_first * step), np.abs(last - origin - share_last * step)
    )
    return away, (share_first, share_last)


def parameters(piece: Piece, grids: Mapping[int, Floats], step: float = ARC_STEP) -> Floats:
    """Return the u at which a piece is sampled, from its start to its end, ends included."""
    if isinstance(piece, Line):
        return np.array([piece.start, piece.end])
    low, high = min(piece.start, piece.end), max(piece.start, piece.end)
    if isinstance(piece, Trace):
        grid = grids[piece.segment]
    else:
        assert isinstance(piece, Arc)
        grid = np.linspace(0.0, 1.0, max(1, ceil(abs(piece.high - piece.low) / step)) + 1)
    slack = 1e-9 * (1.0 if high > low else 0.0)
    inner = grid[(grid > low + slack) & (grid < high - slack)]
    u = np.concatenate([[low], inner, [high]])
    return u if piece.end >= piece.start else u[::-1]


def positive_region(ring: Floats, size: float, near: Near | None = None) -> shapely.Geometry:
    """Return where the winding number of a closed polyline, shape (k, 2), is above 0.

    With ``near`` = (curve, distance) faces nearer to the curve than that are part of it as well:
    at cusps of moved curves, chords cut off faces that wind the wrong way. Raises SolidError where
    the polyline cannot be taken apart.
    """
    if len(ring) < 3:
        return shapely.Polygon()
    polygon = shapely.Polygon(ring)
    if polygon.is_valid:
        return polygon if polygon.exterior.is_ccw else shapely.Polygon()
    closed = np.concatenate([ring, ring[:1]])
    try:
        noded = shapely.node(shapely.LineString(closed))
    except shapely.errors.GEOSException:
        # It gives up on a line that nearly coincides with itself all along.
        raise SolidError(NoBodyFor.NOT_RESOLVED) from None
    faces = shapely.get_parts(shapely.polygonize([noded]))
    faces = faces[shapely.area(faces) > 1e-4 * SLIVER * size**2]
    if len(faces) == 0:
        return shapely.Polygon()
    inside = shapely.get_coordinates(shapely.point_on_surface(faces))
    kept = _windings(inside, closed) > 0
    if near is not None:
        shapely.prepare(near[0])
        # GEOS leaves the processor's flags of a division by zero behind, which is none of ours.
        with np.errstate(all="ignore"):
            kept |= shapely.dwithin(near[0], shapely.points(inside), near[1])
    return shapely.union_all(faces[kept])


def _windings(points: Floats, closed: Floats) -> Ints:
    """Return the winding numbers of a closed polyline (k + 1, 2) about points (m, 2)."""
    lines = shapely.linestrings(np.stack([closed[:-1], closed[1:]], axis=1))
    tree, far = shapely.STRtree(lines), float(closed[:, 0].max()) + 1.0
    found = np.zeros(len(points), dtype=np.int64)
    for low in range(0, len(points), _AT_ONCE):
        x, y = points[low : low + _AT_ONCE].T
        # Only edges that a ray to the right may meet count.
        which, edge = tree.query(shapely.box(x, y, np.maximum(x, far), y))
        (x0, y0), (x1, y1) = closed[edge].T, closed[edge + 1].T
        side = (x1 - x0) * (y[which] - y0) - (x[which] - x0) * (y1 - y0)
        up = (y0 <= y[which]) & (y1 > y[which]) & (side > 0.0)
        down = (y0 > y[which]) & (y1 <= y[which]) & (side < 0.0)
        np.add.at(found, low + which, up.astype(np.int64) - down)
    return found


def _keys(points: Floats) -> list[complex]:
    # Adding 0 makes −0 and 0 one key.
    keys: list[complex] = ((points[:, 0] + 0.0) + 1j * (points[:, 1] + 0.0)).tolist()
    return keys


def _goes_on(stretch: list[float], start: float, end: float) -> bool:
    """Whether a part continues a stretch of its source; out and back the same way does, too.

    GEOS leaves such spikes where a vertex misses by rounding the edge that it was put on.
    """
    return abs(stretch[2] - start) < 1e-9
