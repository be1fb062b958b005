"""A triangle mesh with two topologies: welded positions, and corners to draw them with."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints, Mask, box, frozen, frozen_ints
from sgb_core.values import dataclass

_Kind = TypeVar("_Kind", np.float64, np.int64)
# Rows looked at a time.
_BLOCK = 1 << 18


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """Triangles over welded positions and over render corners.

    ``positions`` (P, 3): no two are the same point of the surface; what is watertight, measured
    and exported. ``corner_positions`` (V,) maps each corner to its position; ``normals`` (V, 3)
    are unit and outward, ``uv`` (V, 2) in [0, 1]: a seam, a pole, a kink ring or a cap edge has
    several corners on one position. ``triangles`` (T, 3) index corners, counter-clockwise seen
    from outside. Arrays are copied and read-only. ``closed`` says whether the mesh is watertight
    where that is known from how it was made. Raises ValueError where shapes disagree.
    """

    positions: Floats
    corner_positions: Ints
    normals: Floats
    uv: Floats
    triangles: Ints
    closed: bool | None = None

    def __post_init__(self) -> None:
        for name in ("positions", "normals", "uv"):
            given = getattr(self, name)
            if not _is_frozen(given, np.float64):
                object.__setattr__(self, name, frozen(given))
        for name in ("corner_positions", "triangles"):
            given = getattr(self, name)
            if not _is_frozen(given, np.int64):
                object.__setattr__(self, name, frozen_ints(given))
        count = len(self.corner_positions)
        shapes = (self.positions.shape[1:], self.normals.shape, self.uv.shape)
        if shapes != ((3,), (count, 3), (count, 2)) or self.triangles.shape[1:] != (3,):
            raise ValueError("positions (P, 3), normals (V, 3), uv (V, 2), triangles (T, 3) needed")
        for indices, limit in (
            (self.corner_positions, len(self.positions)),
            (self.triangles, count),
        ):
            if indices.size and not 0 <= indices.min() <= indices.max() < limit:
                raise ValueError("an index points outside its array")

    @property
    def faces(self) -> Ints:
        """The triangles as indices of positions, shape (T, 3)."""
        return faces_of(self.triangles, self.corner_positions)

    @property
    def _directed_edges(self) -> tuple[Ints, Ints]:
        faces = self.faces
        start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
        count = len(self.positions)
        return start * count + end, end * count + start

    @property
    def is_oriented(self) -> bool:
        """Whether no two triangles run along the same edge in the same direction."""
        edges = np.sort(self._directed_edges[0])
        return not bool((edges[1:] == edges[:-1]).any())

    @property
    def is_watertight(self) -> bool:
        """Whether every edge has exactly two triangles, which run along it in opposite ways."""
        if self.closed is not None:
            return self.closed
        return are_closed(self.faces, len(self.positions))

    @property
    def triangle_normals(self) -> Floats:
        """Cross products of the triangles' edges, shape (T, 3): twice the area, outward."""
        a, b, c = np.moveaxis(self.positions[self.faces], 1, 0)
        return np.cross(b - a, c - a)

    @property
    def areas(self) -> Floats:
        """The triangles' areas, shape (T,)."""
        return np.asarray(np.linalg.norm(self.triangle_normals, axis=1) / 2.0)

    @property
    def area(self) -> float:
        """The sum of the triangles' areas."""
        return float(self.areas.sum())

    @property
    def volume(self) -> float:
        """The signed volume by the divergence theorem, positive when closed and outward.

        Summed about the middle of the bounds, so that a mesh far from the origin loses no digits;
        for an open mesh it is the volume of the cone over it from there.
        """
        if len(self.triangles) == 0:
            return 0.0
        low, high = self.bounds
        first = self.positions[self.faces[:, 0]] - (low + high) / 2.0
        return float(np.einsum("ij,ij->", first, self.triangle_normals) / 6.0)

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """The lower and upper corner of the box around all positions, each shape (3,).

        Raises ValueError for a mesh without positions.
        """
        return box(self.positions)


def _is_frozen(array: object, kind: type) -> bool:
    """Whether an array need not be copied: nothing may change its numbers, whoever owns them."""
    if not (isinstance(array, np.ndarray) and array.dtype == kind and array.flags.c_contiguous):
        return False
    owners = list(_owners(array))
    return owners[-1].flags.owndata and not any(owner.flags.writeable for owner in owners)


def _given_away(array: NDArray[Any]) -> NDArray[Any]:
    """Return an array that was made for a mesh alone, read-only, so that it need not be copied."""
    given = np.ascontiguousarray(array)
    for owner in _owners(given):
        owner.flags.writeable = False
    return given


def _owners(array: NDArray[Any]) -> Iterator[NDArray[Any]]:
    """Yield an array, and what it is a view of."""
    owner: object = array
    while isinstance(owner, np.ndarray):
        yield owner
        owner = owner.base


def faces_of(triangles: Ints, corner_positions: Ints) -> Ints:
    """Return triangles of corners as indices of positions, shape (T, 3)."""
    # Indices are known to be good; looking them over again takes longer than the rest.
    return np.take(corner_positions, triangles, mode="clip")


def are_closed(faces: Ints, count: int) -> bool:
    """Return whether triangles (T, 3) of ``count`` positions have each edge twice, both ways."""
    if len(faces) == 0 or len(faces) % 2:
        return False
    # Each edge as one number whichever way it is run along, the way as its lowest bit: sorted,
    # the two ways of one edge stand beside each other, and no two pairs are alike.
    edges = np.empty((3, len(faces)), np.int64)
    for k, row in enumerate(edges):
        start, end = faces[:, k], faces[:, (k + 1) % 3]
        np.multiply(np.minimum(start, end), count, out=row)
        row += np.maximum(start, end)
        row *= 2
        row += start > end
    ways = edges.reshape(-1)
    ways.sort()
    paired = bool((ways[0::2] % 2 == 0).all() and (ways[1::2] - ways[0::2] == 1).all())
    return paired and bool((ways[2::2] != ways[0:-2:2]).all())


@dataclass(frozen=True, slots=True)
class Topology:
    """What is known of triangles before they are looked at: nothing, by default.

    ``closed``: whether they are watertight, those left out that repeat a position. ``whole``: that
    none does, and each corner and each position has triangles.
    """

    closed: bool | None = None
    whole: bool = False


UNKNOWN = Topology()


def topology(triangles: Ints, corner_positions: Ints, count: int) -> Topology:
    """Return what is to be known of triangles of ``count`` positions."""
    distinct = _distinct(triangles, corner_positions)
    kept = triangles if distinct is None else triangles[distinct]
    faces = faces_of(kept, corner_positions)
    whole = distinct is None and _used(triangles, len(corner_positions)) is None
    return Topology(are_closed(faces, count), whole and _used(faces, count) is None)


def _distinct(triangles: Ints, corner_positions: Ints) -> Mask | None:
    """Return which triangles repeat no position, None where all do not."""
    kept = np.empty(len(triangles), dtype=np.bool_)
    for start in range(0, len(triangles), _BLOCK):
        block = slice(start, start + _BLOCK)
        a, b, c = faces_of(triangles[block], corner_positions).T
        kept[block] = (a != b) & (b != c) & (c != a)
    return None if kept.all() else kept


def compact(
    positions: Floats,
    corner_positions: Ints,
    normals: Floats,
    uv: Floats,
    triangles: Ints,
    known: Topology = UNKNOWN,
) -> Mesh:
    """Return the mesh without the triangles that repeat a position, nor what they alone used.

    The arrays, which it may change, are the mesh's from now on.
    """
    if not known.whole:
        triangles = _squeezed(triangles, _distinct(triangles, corner_positions))
        corners = _used(triangles, len(corner_positions))
        _renumber(triangles, corners)
        corner_positions = _squeezed(corner_positions, corners)
        normals, uv = _squeezed(normals, corners), _squeezed(uv, corners)
        places = _used(corner_positions, len(positions))
        _renumber(corner_positions, places)
        positions = _squeezed(positions, places)
    return Mesh(
        _given_away(positions),
        _given_away(corner_positions),
        _given_away(normals),
        _given_away(uv),
        _given_away(triangles),
        known.closed,
    )


def _used(indices: Ints, count: int) -> Mask | None:
    """Return which of ``count`` things are used, None where all are."""
    used = np.zeros(count, dtype=np.bool_)
    used[indices] = True
    return None if used.all() else used


def _renumber(indices: Ints, used: Mask | None) -> None:
    """Count indices among what is used, in place."""
    if used is None:
        return
    numbers = np.cumsum(used) - 1
    for start in range(0, len(indices), _BLOCK):
        block = indices[start : start + _BLOCK]
        block[:] = numbers.take(block, mode="clip")


def _squeezed(array: NDArray[_Kind], kept: Mask | None) -> NDArray[_Kind]:
    """Return the rows that are kept, moved together in place: a long mesh is not there twice."""
    if kept is None:
        return array
    count = 0
    for start in range(0, len(array), _BLOCK):
        rows = array[start : start + _BLOCK][kept[start : start + _BLOCK]]
        array[count : count + len(rows)] = rows
        count += len(rows)
    return array[:count]
