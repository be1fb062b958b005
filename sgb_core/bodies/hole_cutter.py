"""The closed meshes that cut holes, and the normals of what they leave inside."""

from __future__ import annotations

from typing import Any

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.hole import Hole

# Channels of a vertex beside its place: that in the hole's chart, and the place on the outline,
# whose whole numbers are its corners; −1 on the ends, which nothing is left of.
_CHART, _ALONG = slice(3, 6), 6
_END = -1.0
# Sides of an outline that meet at less than this angle are one smooth curve.
_SMOOTH = np.cos(np.radians(30.0))


def cutter(hole: Hole) -> Any:
    """Return the body that a hole takes away, with an id of its own."""
    from manifold3d import Manifold, Mesh64

    flat = Manifold(_prism(hole))
    if hole.step > 0.0:
        flat = flat.refine_to_length(hole.step)
    given = flat.to_mesh64()
    values = np.array(given.vert_properties, order="C")
    triangles = np.asarray(given.tri_verts)
    values[:, :3] = hole.chart.placed(values[:, _CHART])
    a, b, c = (values[triangles[:, k], :3] for k in range(3))
    # A left-handed placement turns the prism inside out.
    if float(np.einsum("ij,ij->", a - values[0, :3], np.cross(b - a, c - a))) < 0.0:
        triangles = triangles[:, ::-1]
    return Manifold(
        Mesh64(
            vert_properties=values,
            tri_verts=np.array(triangles, dtype=np.uint64, order="C"),
            merge_from_vert=np.array(given.merge_from_vert, dtype=np.uint64),
            merge_to_vert=np.array(given.merge_to_vert, dtype=np.uint64),
        )
    ).as_original()


def _prism(hole: Hole) -> Any:
    """Return the prism in the hole's own chart: its ends, and each side with corners of its own."""
    from manifold3d import Mesh64, triangulate

    outline = hole.outline
    count = len(outline)
    k = np.arange(count)
    after = (k + 1) % count
    along = k.astype(np.float64)
    ends = np.asarray(triangulate([outline])).astype(np.int64)

    def row(points: Floats, depth: float, along: Floats) -> Floats:
        places = np.column_stack([points, np.full(count, depth)])
        return np.column_stack([places, places, along, np.zeros(count)])

    rows = [row(outline, depth, np.full(count, _END)) for depth in (-hole.inner, hole.outer)]
    for depth in (-hole.inner, hole.outer):
        rows += [row(outline, depth, along), row(outline[after], depth, along + 1.0)]
    first, second, third, fourth = (number * count + k for number in range(2, 6))
    sides = [np.stack([first, second, fourth], 1), np.stack([first, fourth, third], 1)]
    triangles = np.concatenate([ends[:, ::-1], ends + count, *sides])
    return Mesh64(
        vert_properties=np.ascontiguousarray(np.concatenate(rows)),
        tri_verts=np.ascontiguousarray(triangles.astype(np.uint64)),
        merge_from_vert=np.concatenate([first, second, third, fourth]).astype(np.uint64),
        merge_to_vert=np.concatenate([k, after, count + k, count + after]).astype(np.uint64),
    )


def hole_normals(hole: Hole, values: Floats) -> Floats:
    """Return the unit normals of triangles inside a hole, (n, 3, 3), into the hole.

    ``values`` (n, 3, 8) are the channels of their corners.
    """
    along = values[..., _ALONG]
    edge = np.floor(along.mean(axis=1)).astype(np.int64)
    share = np.clip(along - edge[:, None], 0.0, 1.0)
    steps = np.roll(hole.outline, -1, axis=0) - hole.outline
    own = np.stack([steps[:, 1], -steps[:, 0]], axis=1)
    own /= np.linalg.norm(own, axis=1, keepdims=True)
    edge = np.repeat(np.clip(edge, 0, len(own) - 1)[:, None], 3, axis=1)
    near = np.where(share < 0.5, edge - 1, (edge + 1) % len(own))
    smooth = np.einsum("ijk,ijk->ij", own[edge], own[near]) > _SMOOTH
    # Between the middles of sides that are one curve the normal turns evenly.
    turn = np.where(smooth, np.abs(share - 0.5), 0.0)[..., None]
    flat = (1.0 - turn) * own[edge] + turn * own[near]
    normals = hole.normals(values[..., _CHART].reshape(-1, 3), flat.reshape(-1, 2))
    return -normals.reshape(*along.shape, 3)
