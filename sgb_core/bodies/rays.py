"""Rays through a body's section: how far each runs before it meets an edge."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.curvature import cross

# So many rays at a time bound the memory, whatever the number of edges.
_CHUNK = 512
# An edge is this part of its length longer at both ends, so that no ray passes between two.
_SLACK = 1e-9
# A ray leaves by an edge whose outward normal is within 60° of it.
_FACING = 0.5


def first_meetings(
    origins: Floats, rays: Floats, starts: Floats, ends: Floats, outward: Floats | None = None
) -> Floats:
    """Return how far along its ray each origin meets the first edge, (k,); infinity for none.

    ``origins`` and unit ``rays`` have shape (k, 2); the edges run from ``starts`` to ``ends``,
    (m, 2). With their unit normals ``outward``, (m, 2), only edges that face along a ray count:
    those by which it leaves.
    """
    edges = ends - starts
    found = np.full(len(origins), np.inf)
    for part in np.array_split(np.arange(len(origins)), len(origins) // _CHUNK + 1):
        ray = rays[part][:, None]
        step = starts[None] - origins[part][:, None]
        det = cross(ray, edges[None])
        safe = np.where(det == 0.0, 1.0, det)
        along, share = cross(step, edges[None]) / safe, cross(step, ray) / safe
        hit = (det != 0.0) & (along > 0.0) & (share >= -_SLACK) & (share <= 1.0 + _SLACK)
        if outward is not None:
            hit &= (ray * outward[None]).sum(axis=-1) > _FACING
        found[part] = np.where(hit, along, np.inf).min(axis=1, initial=np.inf)
    return found
