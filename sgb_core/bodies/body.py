"""Solid bodies: what the drawn surface means as an object, as a mesh and as a cross-section.

A body's section in the half-plane is a valid polygon, outlined by exact curves; turning it gives
a mesh that is always closed. :mod:`sgb_core.bodies.vessel` measures it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import acos, ceil, pi

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import CrossSection, SectionBuilder
from sgb_core.bodies.meridian import SolidError, check_simple, meridian_of, sample_grids
from sgb_core.bodies.outline import Arc, Piece, Role
from sgb_core.bodies.region import Outline, parameters
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.bodies.solid_mesh import Rows, ring_section, rows_of, sweep_rings
from sgb_core.bodies.varying_solid import sections_at, varying_rows
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sampling import (
    check_triangle_count,
    columns_for_radius,
    samples_for_tolerance,
)
from sgb_core.surfaces.section import AXIS
from sgb_core.surfaces.tessellation import DEFAULT_TOLERANCE, tessellate
from sgb_core.surfaces.turn import turn_of

__all__ = [
    "SectionPolygon",
    "SolidError",
    "body_mesh",
    "cross_section",
    "section_polygons",
]

# Part of the size to which curves are sampled to find the section's topology.
WORKING = 2e-4
# So many of the sections of a varying profile decide how finely all are sampled.
MOST_COMPARED = 12
LARGEST_ARC_STEP = pi / 6.0
# A section whose coarse samples cross is sampled twice as finely, at most so many times.
REFINEMENTS = 3


@dataclass(frozen=True, slots=True, eq=False)
class SectionPolygon:
    """One part of a body's section as a polygon with true normals.

    ``exterior`` (k, 2) runs counter-clockwise in (r, h) and repeats no point at its end; each of
    ``holes`` runs clockwise. ``roles`` names what each edge of the exterior, starting at the point
    of the same number, is: "drawn", "wall", "rim", "floor", "foot", "hole" or "axis". ``normals``
    (k, 2) are those at the starts of the edges.
    """

    exterior: Floats
    roles: tuple[Role, ...]
    normals: Floats
    holes: tuple[Floats, ...]


@lru_cache(maxsize=8)
def cross_section(surface: RevolutionSurface, solid: Solid) -> CrossSection:
    """Return the exact section of a filled body or a vessel, at the start angle where laws hold.

    Raises SolidError where there is none.
    """
    if not surface.laws:
        return section_at(surface, solid)
    held = surface.profile_at(surface.start)
    return cross_section(RevolutionSurface(held), solid)


def section_at(
    surface: RevolutionSurface, solid: Solid, quartics: Floats | None = None
) -> CrossSection:
    """Return the section of a body, where laws hold that of one angle's ``quartics``."""
    meridian = meridian_of(surface, quartics)
    offset = solid.wall if solid.side is WallSide.INSIDE else -solid.wall
    offsets = (0.0,) if solid.kind is BodyKind.FILLED else (0.0, offset)
    grids = sample_grids(meridian, offsets, _working(meridian.size, solid))
    check_simple(surface, meridian, grids)
    return SectionBuilder(meridian, solid, grids).build()


def _working(size: float, solid: Solid) -> float:
    thin = solid.wall / 16.0 if solid.kind is BodyKind.VESSEL else size
    return max(min(WORKING * size, thin), 1e-6 * size)


def working_tolerance(section: CrossSection, solid: Solid) -> float:
    """Return how closely the samples that decide a section's topology follow its curves."""
    return _working(section.meridian.size, solid)


def body_mesh(
    surface: RevolutionSurface,
    solid: Solid,
    *,
    tolerance: float | None = None,
    samples: tuple[int, int] | None = None,
) -> Mesh:
    """Return the mesh of a body: for kind "surface" the surface's own, else always watertight.

    ``tolerance`` (in unit, default 1e-3 of the profile's size) bounds the distance to the true
    body; ``samples`` = (NS, NT) fixes the intervals per segment and around instead. Raises
    SolidError where the body cannot be made, ValueError as :func:`tessellate` does.
    """
    if solid.kind is BodyKind.SURFACE:
        return tessellate(surface, tolerance=tolerance, samples=samples)
    if tolerance is not None and samples is not None:
        raise ValueError("give either a tolerance or the samples, not both")
    size = surface.profile.size
    limit = DEFAULT_TOLERANCE * size if tolerance is None else tolerance
    if not (np.isfinite(limit) and limit > 0.0):
        raise ValueError(f"tolerance is {tolerance!r}; allowed is any length above 0")
    if samples is not None and samples[0] < 1:
        raise ValueError("at least one interval for each segment is needed")
    section = cross_section(surface, solid)
    columns = _columns(surface, section, limit, samples)
    turn = turn_of(surface, columns)
    held = [section]
    if surface.laws:
        held = sections_at(surface, solid, turn.angles, section_at)
    for attempt in range(REFINEMENTS + 1):
        sampler = _sampler(held, solid, 0.45 * limit, samples, 2**attempt)
        if surface.laws:
            parts = varying_rows(surface, held, turn, sampler)
        else:
            parts = [
                [rows_of(ring, size, sampler) for ring in outline.rings]
                for outline in section.outlines
            ]
        rows = sum(each.points.shape[1] for part in parts for ring in part for each in ring)
        check_triangle_count(rows, columns)
        # Where laws hold the sections at both ends and at the middle stand for all.
        probes = {0, len(turn.angles) // 2, -1} if surface.laws else {0}
        if all(
            _is_simple([_loop(ring, k, size) for ring in part]) for part in parts for k in probes
        ):
            break
    # A hole of two samples is none.
    sections = [
        tuple(ring_section(ring, size) for ring in part if len(_loop(ring, 0, size)) > 2)
        for part in parts
    ]
    return sweep_rings(sections, turn, surface, section.meridian.mirrored)


def _columns(
    surface: RevolutionSurface,
    section: CrossSection,
    limit: float,
    samples: tuple[int, int] | None,
) -> int:
    if samples is not None:
        return samples[1]
    columns = columns_for_radius(surface, widest(section), 0.45 * limit)
    if not surface.laws:
        return columns
    varying = samples_for_tolerance(surface, limit)[1]
    return varying * ceil(columns / varying)


def _sampler(
    sections: Sequence[CrossSection],
    solid: Solid,
    limit: float,
    samples: tuple[int, int] | None,
    finer: int,
) -> Callable[[Piece], Floats]:
    """Return the function that gives the parameters at which a mesh samples a piece."""
    meridian = sections[0].meridian
    if samples is None:
        offset = solid.wall if solid.side is WallSide.INSIDE else -solid.wall
        offsets = (0.0,) if solid.kind is BodyKind.FILLED else (0.0, offset)
        grids = sample_grids(meridian, offsets, limit / finer**2, least=1)
        different = list({id(section): section for section in sections}.values())
        for other in different[1 :: max(1, len(different) // MOST_COMPARED)]:
            for number, s in sample_grids(
                other.meridian, offsets, limit / finer**2, least=1
            ).items():
                grids[number] = _merged(grids[number], s)
    else:
        even = np.linspace(0.0, 1.0, samples[0] * finer + 1)
        grids = dict.fromkeys(meridian.numbers, even)

    def sampled(piece: Piece) -> Floats:
        step = LARGEST_ARC_STEP / finer
        if samples is not None:
            step = min(step, pi / samples[0])
        elif isinstance(piece, Arc):
            step = min(step, 2.0 * acos(max(1.0 - limit / piece.radius, 0.0)) / finer)
        return parameters(piece, grids, max(step, 1e-3))

    return sampled


def _merged(first: Floats, second: Floats) -> Floats:
    # Extremes differ a little from angle to angle: of such a group one is enough.
    near = np.abs(second[:, None] - first).min(axis=1)
    return np.union1d(first, second[near > 2e-3])


def widest(section: CrossSection) -> float:
    """Return the largest distance of the body from the axis, in unit."""
    return max(
        float(np.abs(piece.points(parameters(piece, section.builder.register.grids))[:, 0]).max())
        for outline in section.outlines
        for piece in outline.exterior
    )


def _loop(rows: Sequence[Rows], version: int, size: float) -> Floats:
    """Return a ring's points in one version, each corner once."""
    points = np.concatenate([piece.points[version, :-1] for piece in rows])
    steps = points - np.roll(points, 1, axis=0)
    return np.asarray(points[np.hypot(steps[:, 0], steps[:, 1]) > AXIS * size])


def _is_simple(loops: Sequence[Floats]) -> bool:
    if min(map(len, loops)) < 3:
        return False
    return bool(shapely.Polygon(loops[0], list(loops[1:])).is_valid)


def section_polygons(
    surface: RevolutionSurface,
    solid: Solid,
    *,
    theta: float | None = None,
    tolerance: float | None = None,
) -> tuple[SectionPolygon, ...]:
    """Return the body's section at an absolute angle (default the start angle) as polygons.

    Empty for kind "surface". Points are (r, h) in the surface's own half-plane, not placed;
    ``tolerance`` as for :func:`body_mesh`. Raises SolidError where there is no body.
    """
    if solid.kind is BodyKind.SURFACE:
        return ()
    held = surface
    if surface.laws:
        held = RevolutionSurface(surface.profile_at(surface.start if theta is None else theta))
    section = cross_section(held, solid)
    size = surface.profile.size
    limit = DEFAULT_TOLERANCE * size if tolerance is None else tolerance
    sampler = _sampler([section], solid, limit, None, 1)
    side = -1.0 if section.meridian.mirrored else 1.0
    return tuple(_polygon(outline, size, sampler, side) for outline in section.outlines)


def _polygon(
    outline: Outline, size: float, sampler: Callable[[Piece], Floats], side: float
) -> SectionPolygon:
    rings = [rows_of(ring, size, sampler) for ring in outline.rings]
    loops = [
        np.concatenate([piece.points[0, :-1] for piece in ring]) * (side, 1.0) for ring in rings
    ]
    roles = [piece.role for piece in rings[0] for _ in range(piece.points.shape[1] - 1)]
    normals = np.concatenate([piece.normals[0, :-1, ::2] for piece in rings[0]]) * (side, 1.0)
    if side < 0.0:
        loops = [loop[::-1] for loop in loops]
        roles = [*roles[-2::-1], roles[-1]]
        normals = normals[::-1]
    return SectionPolygon(loops[0], tuple(roles), normals, tuple(loops[1:]))
