"""Rays through a body's section: how far each runs before it meets an edge."""

from __future__ import annotations

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.surfaces.curvature import cross

# So many pairs of a ray and an edge at a time bound the memory.
_PAIRS = 2_000_000
# An edge is this part of its length longer at both ends, so that no ray passes between two.
_SLACK = 1e-9
# A ray leaves by an edge whose outward normal is within 60° of it.
_FACING = 0.5
# Rays are first looked at over this part of the whole extent, then over so many times as much.
_FIRST_REACH, _GROWTH = 1.0 / 256.0, 8.0


def first_meetings(
    origins: Floats,
    rays: Floats,
    starts: Floats,
    ends: Floats,
    outward: Floats | None = None,
    farthest: float = np.inf,
) -> Floats:
    """Return how far along its ray each origin meets the first edge, (k,); infinity for none.

    ``origins`` and unit ``rays`` have shape (k, 2); the edges run from ``starts`` to ``ends``,
    (m, 2). With their unit normals ``outward``, (m, 2), only edges that face along a ray count:
    those by which it leaves. Nothing is looked for beyond ``farthest``.
    """
    found = np.full(len(origins), np.inf)
    if not len(starts) or not len(origins):
        return found
    extent = float(np.hypot(*np.ptp(np.concatenate([origins, starts, ends]), axis=0)))
    most, reach = min(extent * (1.0 + _SLACK), farthest), extent * _FIRST_REACH
    tree = shapely.STRtree(shapely.linestrings(np.stack([starts, ends], axis=1)))
    edges, chunk = ends - starts, max(1, _PAIRS // len(starts))
    open_ = np.arange(len(origins))
    while len(open_):
        reach = min(reach, most)
        for low in range(0, len(open_), chunk):
            part = open_[low : low + chunk]
            origin, ray = origins[part], rays[part]
            # The box around a ray is a little larger, as the edges are.
            corner, slack = origin + reach * ray, _SLACK * extent
            lower, upper = np.minimum(origin, corner) - slack, np.maximum(origin, corner) + slack
            which, edge = tree.query(shapely.box(*lower.T, *upper.T))
            ray, along_edge, step = ray[which], edges[edge], starts[edge] - origin[which]
            det = cross(ray, along_edge)
            safe = np.where(det == 0.0, 1.0, det)
            along, share = cross(step, along_edge) / safe, cross(step, ray) / safe
            hit = (det != 0.0) & (along > 0.0) & (along <= reach)
            hit &= (share >= -_SLACK) & (share <= 1.0 + _SLACK)
            if outward is not None:
                hit &= (ray * outward[edge]).sum(axis=-1) > _FACING
            np.minimum.at(found, part[which[hit]], along[hit])
        if reach >= most:
            break
        open_, reach = open_[np.isinf(found[open_])], reach * _GROWTH
    return found
