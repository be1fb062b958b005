"""A triangle mesh with two topologies: welded positions, and corners to draw them with."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints, frozen, frozen_ints
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """Triangles over welded positions and over render corners.

    ``positions`` (P, 3): no two are the same point of the surface; what is watertight, measured
    and exported. ``corner_positions`` (V,) maps each corner to its position; ``normals`` (V, 3)
    are unit and outward, ``uv`` (V, 2) in [0, 1]: a seam, a pole, a kink ring or a cap edge has
    several corners on one position. ``triangles`` (T, 3) index corners, counter-clockwise seen
    from outside. Arrays are copied and read-only. Raises ValueError where shapes disagree.
    """

    positions: Floats
    corner_positions: Ints
    normals: Floats
    uv: Floats
    triangles: Ints

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
        return self.corner_positions[self.triangles]

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
        faces, count = self.faces, len(self.positions)
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
        return self.positions.min(axis=0), self.positions.max(axis=0)


def _is_frozen(array: object, kind: type) -> bool:
    """Whether an array need not be copied: it owns its numbers, and nothing may change them."""
    return (
        isinstance(array, np.ndarray)
        and array.dtype == kind
        and array.flags.owndata
        and array.flags.c_contiguous
        and not array.flags.writeable
    )


def _given_away(array: NDArray[Any]) -> NDArray[Any]:
    """Return an array that was made for a mesh alone, read-only, so that it need not be copied."""
    owned = array if array.flags.owndata and array.flags.c_contiguous else array.copy(order="C")
    owned.flags.writeable = False
    return owned


def compact(
    positions: Floats, corner_positions: Ints, normals: Floats, uv: Floats, triangles: Ints
) -> Mesh:
    """Return the mesh without the triangles that repeat a position, nor what they alone used."""
    a, b, c = corner_positions[triangles].T
    kept = triangles[(a != b) & (b != c) & (c != a)]
    corners, kept = _renumbered(kept, len(corner_positions))
    used, corner_positions = _renumbered(corner_positions[corners], len(positions))
    parts = (positions[used], corner_positions, normals[corners], uv[corners], kept)
    return Mesh(*(_given_away(part) for part in parts))


def _renumbered(indices: Ints, count: int) -> tuple[NDArray[np.intp], Ints]:
    """Return which of ``count`` things are used, and the indices counted among those."""
    used = np.zeros(count, dtype=bool)
    used[indices] = True
    return np.flatnonzero(used), (np.cumsum(used) - 1)[indices]
