"""How much material lies behind each point of the drawn surface, along its normal."""

from __future__ import annotations

import numpy as np
import shapely

from sgb_core.arrays import Floats, between
from sgb_core.bodies.cross_section import (
    CrossSection,
    cross_section,
    section_at,
    working_tolerance,
)
from sgb_core.bodies.outline import Role
from sgb_core.bodies.rays import first_meetings
from sgb_core.bodies.region import parameters
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.bodies.varying_solid import sections_at
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sections import Sections

# Rays do not start at the very ends of segments, where they could pass between two edges.
_END = 1e-4
# Sections made where laws hold; between them the depth is interpolated.
SECTIONS = 24


def wall_depths(surface: RevolutionSurface, solid: Solid, s: Floats, columns: int) -> Floats:
    """Return the way through the material, shape (n * len(s), 1), or (…, columns + 1) with laws.

    In the half-plane of the angle, from each point at ``s`` of each segment along the normal to
    where the body ends; through a filled body to its other side. Not a number where the drawn
    surface bounds no material, everywhere for a bare surface. Raises SolidError where the body
    cannot be made.
    """
    if solid.kind is BodyKind.SURFACE:
        return np.full((len(surface.profile) * len(s), 1), np.nan)
    inner = np.clip(s, _END, 1.0 - _END)
    if not surface.laws:
        depths = _depths(solid, cross_section(surface, solid), surface.section, inner)
        return depths.reshape(-1, 1)
    turned = np.linspace(0.0, surface.sweep, SECTIONS + 1)
    sections = sections_at(surface, solid, turned, section_at)
    drawn = surface.sections(turned)
    known = np.stack(
        [_depths(solid, section, drawn[k], inner) for k, section in enumerate(sections)]
    )
    known = known.reshape(SECTIONS + 1, -1)
    low, beyond = between(np.linspace(0.0, SECTIONS, columns + 1), SECTIONS + 1)
    part = beyond[:, None]
    return np.asarray((known[low] * (1.0 - part) + known[low + 1] * part).T)


def _depths(solid: Solid, section: CrossSection, drawn: Sections, s: Floats) -> Floats:
    size = section.meridian.size
    # Start deeper than the samples that stand for the curve may lie beside it.
    inside = 2.0 * working_tolerance(section, solid)
    points = drawn.on(s)
    tangents = drawn.tangents_on(s, size).reshape(-1, 2)
    origin = points.reshape(-1, 2) * (-1.0 if section.meridian.mirrored else 1.0, 1.0)
    normals = np.stack([-tangents[:, 1], tangents[:, 0]], axis=-1)
    if section.meridian.mirrored:
        normals[:, 0] *= -1.0
    starts, ends, material = _edges(section)
    depths = np.full(len(origin), np.nan)
    for way in (1.0, -1.0):
        rays = way * normals
        within = origin + inside * rays
        held = shapely.contains_xy(material, within[:, 0], within[:, 1])
        depths[held] = first_meetings(within[held], rays[held], starts, ends) + inside
    depths[np.isinf(depths)] = np.nan
    if solid.kind is BodyKind.VESSEL:
        # Less than the samples' own error is none.
        depths[np.abs(depths - solid.wall) < 1.5 * inside] = solid.wall
    return depths


def _edges(section: CrossSection) -> tuple[Floats, Floats, shapely.Geometry]:
    """Return the edges that bound the material on both sides of the axis, and the material."""
    grids = section.grids
    starts, ends, parts = [], [], []
    for outline in section.outlines:
        rings = []
        for ring in outline.rings:
            loop = []
            for piece in ring:
                points = piece.points(parameters(piece, grids))
                loop.append(points[:-1])
                if piece.role is not Role.AXIS:
                    starts.append(points[:-1])
                    ends.append(points[1:])
            rings.append(np.concatenate(loop))
        parts.append(shapely.Polygon(rings[0], rings[1:]))
    first, last = np.concatenate(starts), np.concatenate(ends)
    starts_of_both = np.concatenate([first, first * (-1.0, 1.0)])
    ends_of_both = np.concatenate([last, last * (-1.0, 1.0)])
    return starts_of_both, ends_of_both, shapely.MultiPolygon(parts)


def wall_depth_at(surface: RevolutionSurface, solid: Solid, segment: int, s: float) -> float | None:
    """Return the way through the material at one place of the section at θ = 0.

    None where the drawn surface bounds no material there. Raises SolidError where the body cannot
    be made.
    """
    if solid.kind is BodyKind.SURFACE:
        return None
    inner = np.clip([s], _END, 1.0 - _END)
    depths = _depths(solid, cross_section(surface, solid), surface.section, inner)
    depth = float(depths.reshape(-1)[segment])
    return depth if np.isfinite(depth) else None
