"""A body's mesh with its cut-outs: closed and manifold, with the cut edges as they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.bodies.hole_layout import Hole, holes
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import Solid
from sgb_core.findings.cut_outs import NoCutOuts
from sgb_core.interruption import checkpoint
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# Channels of a vertex beside its place: normal and texture coordinates.
_NORMAL, _UV = slice(3, 6), slice(6, 8)


@dataclass(frozen=True, slots=True, eq=False)
class Pierced:
    """A mesh with ``count`` holes, and the ``removed`` volume that they took, in unit³."""

    mesh: Mesh
    count: int
    removed: float


def pierced(
    surface: RevolutionSurface,
    solid: Solid,
    cut_outs: Sequence[CutOut],
    mesh: Mesh,
    raised: float = 0.0,
) -> Pierced:
    """Return a body's mesh with its holes cut, all of them through the wall and apart.

    Its outside may be ``raised`` by so much.

    Raises SolidError for what :func:`~sgb_core.bodies.hole_layout.holes` refuses, and where the
    result is not the same body with that many holes more.
    """
    from manifold3d import Manifold, OpType

    asked = holes(surface, solid, cut_outs)
    body = _manifold(mesh)
    checkpoint()
    cutters = [_cutter(replace(hole, outer=hole.outer + raised)) for hole in asked]
    numbers = {int(cutter.original_id()): k for k, cutter in enumerate(cutters)}
    result = Manifold.batch_boolean([body, *cutters], OpType.Subtract)
    checkpoint()
    parts = len(result.decompose())
    if parts != len(body.decompose()) or result.genus() != body.genus() + len(asked):
        raise SolidError(NoCutOuts.BROKEN)
    found = _mesh(result, numbers, asked)
    return Pierced(found, len(asked), mesh.volume - found.volume)


def _manifold(mesh: Mesh) -> Any:
    from manifold3d import Manifold, Mesh64

    corners = mesh.corner_positions
    properties = np.concatenate([mesh.positions[corners], mesh.normals, mesh.uv], axis=1)
    first = np.zeros(len(mesh.positions), dtype=np.uint64)
    first[corners[::-1]] = np.arange(len(corners), dtype=np.uint64)[::-1]
    stands = first[corners]
    others = np.flatnonzero(stands != np.arange(len(corners)))
    return Manifold(
        Mesh64(
            vert_properties=np.ascontiguousarray(properties),
            tri_verts=np.ascontiguousarray(mesh.triangles.astype(np.uint64)),
            merge_from_vert=others.astype(np.uint64),
            merge_to_vert=np.ascontiguousarray(stands[others]),
        )
    )


def _cutter(hole: Hole) -> Any:
    """Return the prism of a hole."""
    from manifold3d import Manifold, Mesh64

    count = len(hole.outline)
    flat = hole.centre + hole.outline @ np.stack([hole.across, hole.up])
    ends = [flat - hole.inner * hole.out, flat + hole.outer * hole.out]
    k = np.arange(count)
    after = (k + 1) % count
    fan = np.stack([np.zeros(count - 2, int), k[1:-1], k[2:]], axis=1)
    sides = [np.stack([k, after, after + count], 1), np.stack([k, after + count, k + count], 1)]
    triangles = np.concatenate([fan[:, ::-1], fan + count, *sides])
    if np.linalg.det(np.stack([hole.across, hole.up, hole.out])) < 0.0:
        triangles = triangles[:, ::-1]
    return Manifold(
        Mesh64(
            vert_properties=np.ascontiguousarray(np.concatenate(ends)),
            tri_verts=np.ascontiguousarray(triangles.astype(np.uint64)),
        )
    ).as_original()


def _mesh(result: Any, numbers: dict[int, int], asked: Sequence[Hole]) -> Mesh:
    """Return the mesh of what was cut: drawn faces as they were, with the holes' own inside."""
    given = result.to_mesh64()
    vertices = np.asarray(given.vert_properties)
    triangles = np.asarray(given.tri_verts).astype(np.int64)
    welded = np.arange(len(vertices))
    welded[np.asarray(given.merge_from_vert, dtype=np.int64)] = np.asarray(
        given.merge_to_vert, dtype=np.int64
    )
    used, numbered = np.unique(welded, return_inverse=True)
    positions, corner_positions = vertices[used, :3], numbered.astype(np.int64)
    normals, uv = vertices[:, _NORMAL].copy(), vertices[:, _UV].copy()
    runs = np.asarray(given.run_index, dtype=np.int64) // 3
    own = np.full(len(triangles), -1)
    for run, original in enumerate(np.asarray(given.run_original_id).tolist()):
        own[runs[run] : runs[run + 1]] = numbers.get(int(original), -1)
    cut = np.flatnonzero(own >= 0)
    # Each triangle of a hole has corners of its own, with the hole's normals.
    fresh = triangles[cut]
    triangles[cut] = len(vertices) + np.arange(fresh.size).reshape(-1, 3)
    places = vertices[fresh][..., :3]
    inward, around = _hole_normals(places, own[cut], asked)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.where(lengths > 0.0, normals / np.where(lengths > 0.0, lengths, 1.0), (0, 0, 1.0))
    return Mesh(
        positions,
        np.concatenate([corner_positions, corner_positions[fresh.ravel()]]),
        np.concatenate([normals, inward.reshape(-1, 3)]),
        np.clip(np.concatenate([uv, around.reshape(-1, 2)]), 0.0, 1.0),
        triangles,
    )


def _hole_normals(places: Floats, own: Ints, asked: Sequence[Hole]) -> tuple[Floats, Floats]:
    """Return normals (k, 3, 3) and texture coordinates (k, 3, 2) of triangles inside holes."""
    normals, uv = np.empty_like(places), np.full((*places.shape[:2], 2), 0.5)
    for number in np.unique(own).tolist():
        hole, mine = asked[number], np.flatnonzero(own == number)
        frame = np.stack([hole.across, hole.up])
        flat = (places[mine] - hole.centre) @ frame.T
        if hole.shape is HoleShape.HEXAGON:
            flat = np.broadcast_to(flat.mean(axis=1, keepdims=True), flat.shape)
        normals[mine] = -_outward(hole, flat.reshape(-1, 2)).reshape(flat.shape) @ frame
    return normals, uv


def _outward(hole: Hole, points: Floats) -> Floats:
    """Return unit normals (k, 2) of a hole's outline near points of it."""
    starts = hole.outline
    steps = np.roll(starts, -1, axis=0) - starts
    ahead = points[:, None] - starts
    share = np.clip((ahead * steps).sum(2) / (steps**2).sum(1), 0.0, 1.0)
    away = np.linalg.norm(ahead - share[..., None] * steps, axis=2)
    edge = np.argmin(away, axis=1)
    normals = np.stack([steps[:, 1], -steps[:, 0]], axis=1)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    if hole.shape is HoleShape.HEXAGON:
        return np.asarray(normals[edge])
    # Round outlines are smooth: between the middles of sides the normal turns evenly.
    part = share[np.arange(len(points)), edge]
    near = np.where(part < 0.5, edge - 1, (edge + 1) % len(starts))
    turn = np.abs(part - 0.5)[:, None]
    mixed = (1.0 - turn) * normals[edge] + turn * normals[near]
    return np.asarray(mixed / np.linalg.norm(mixed, axis=1, keepdims=True))
