"""Where a half-plane through the axis cuts a closed mesh: the faces of a body with relief or holes.

A corner exactly in the plane counts as lying before it, so that every crossing is one point of an
edge and the lines always close.
"""

from __future__ import annotations

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface

# Of the size: how far inside the body the ends of a part turn are looked at.
_INSIDE = 1e-6
# Of the size: a corner this near lies in the plane.
_ROUNDING = 1e-10
_GRID = 1e-7

Rings = tuple[Floats, ...]


def mesh_section(mesh: Mesh, surface: RevolutionSurface, angle: float) -> tuple[Rings, ...]:
    """Return the section of a surface's closed mesh at an absolute angle in radians.

    Each part is its outline and what it leaves out, (k, 2) each in (r, h) of the half-plane at the
    angle, r ≥ 0, no point repeated.
    """
    size = surface.profile.size
    across, aside, along = surface.directions(np.array(angle))
    local = mesh.positions - np.asarray(surface.placement.translation)
    away = local @ aside
    if not surface.is_full_turn:
        turned = (angle - surface.start) / surface.sweep
        away += (-_INSIDE if turned < 0.5 else _INSIDE) * size
    away[np.abs(away) < _ROUNDING * size] = 0.0
    lines = _crossings(mesh, np.stack([local @ across, local @ along], axis=1), away)
    half = shapely.box(0.0, -1e9 * size, 1e9 * size, 1e9 * size)
    # Slivers in the plane cross each other by rounding: noded on a fine grid they do not.
    noded = shapely.union_all(shapely.linestrings(lines), grid_size=_GRID * size)
    area = shapely.intersection(shapely.build_area(noded), half)
    return tuple(
        tuple(shapely.get_coordinates(ring)[:-1] for ring in (part.exterior, *part.interiors))
        for part in shapely.get_parts(area)
        if isinstance(part, shapely.Polygon) and part.area > 0.0
    )


def _crossings(mesh: Mesh, flat: Floats, away: Floats) -> Floats:
    """Return the lines (k, 2, 2) along which faces cross the plane that corners are ``away`` of."""
    before = away >= 0.0
    faces = mesh.faces
    ahead = before[faces].sum(axis=1)
    crossed = faces[(ahead > 0) & (ahead < 3)]
    edges = crossed[:, [[0, 1], [1, 2], [2, 0]]]
    cut = before[edges[..., 0]] != before[edges[..., 1]]
    # From the smaller number to the larger: both faces of an edge find the same point.
    first, last = np.sort(edges[cut], axis=1).T
    share = away[first] / (away[first] - away[last])
    points = flat[first] + share[:, None] * (flat[last] - flat[first])
    lines = points.reshape(-1, 2, 2)
    return np.asarray(lines[(lines[:, 0] != lines[:, 1]).any(axis=1)])
