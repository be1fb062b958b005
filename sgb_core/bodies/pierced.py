"""A body's mesh with its cut-outs: closed and manifold, with the cut edges as they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from sgb_core.bodies.hole import Hole
from sgb_core.bodies.hole_cutter import cutter, hole_normals
from sgb_core.bodies.hole_layout import holes
from sgb_core.bodies.hole_pattern import Pattern
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import Solid
from sgb_core.findings.cut_outs import NoCutOuts
from sgb_core.interruption import checkpoint
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# Channels of a vertex beside its place: normal and texture coordinates.
_NORMAL, _UV = slice(3, 6), slice(6, 8)
# The part of its distance from the true body that a mesh may have at the outlines of its holes.
_OUTLINES = 0.3
# The part by which it may change to be rid of slivers, which single precision, as most files have
# it, would fold over.
_SIMPLER = 0.001


@dataclass(frozen=True, slots=True, eq=False)
class Pierced:
    """A mesh with ``count`` holes, and the ``removed`` volume that they took, in unit³."""

    mesh: Mesh
    count: int
    removed: float


def pierced(
    surface: RevolutionSurface,
    solid: Solid,
    patterns: Sequence[Pattern],
    mesh: Mesh,
    raised: float = 0.0,
    within: float = 0.0,
) -> Pierced:
    """Return a body's mesh with its holes cut, all of them through the wall and apart.

    Its outside may be ``raised`` by so much, and the mesh is ``within`` so much of the body.

    Raises SolidError for what :func:`~sgb_core.bodies.hole_layout.holes` refuses, and where the
    result is not the same body with that many holes more.
    """
    from manifold3d import Manifold, OpType

    asked = [
        replace(hole, inner=hole.inner + within, outer=hole.outer + raised + within)
        for hole in holes(surface, solid, patterns, _OUTLINES * within if within else None)
    ]
    body = _manifold(mesh)
    checkpoint()
    cutters = []
    for hole in asked:
        cutters.append(cutter(hole))
        checkpoint()
    numbers = {int(each.original_id()): k for k, each in enumerate(cutters)}
    result = Manifold.batch_boolean([body, *cutters], OpType.Subtract)
    checkpoint()
    parts = len(result.decompose())
    if parts != len(body.decompose()) or result.genus() != body.genus() + len(asked):
        raise SolidError(NoCutOuts.BROKEN)
    simpler = result.simplify(_SIMPLER * within)
    checkpoint()
    if simpler.genus() == result.genus() and len(simpler.decompose()) == parts:
        result = simpler
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
    inward = np.empty((len(cut), 3, 3))
    for number in np.unique(own[cut]).tolist():
        mine = np.flatnonzero(own[cut] == number)
        inward[mine] = hole_normals(asked[number], vertices[fresh[mine]])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.where(lengths > 0.0, normals / np.where(lengths > 0.0, lengths, 1.0), (0, 0, 1.0))
    return Mesh(
        positions,
        np.concatenate([corner_positions, corner_positions[fresh.ravel()]]),
        np.concatenate([normals, inward.reshape(-1, 3)]),
        np.clip(np.concatenate([uv, np.full((fresh.size, 2), 0.5)]), 0.0, 1.0),
        triangles,
    )
