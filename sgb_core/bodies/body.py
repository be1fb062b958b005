"""Solid bodies: what the drawn surface means as an object, as a mesh and as a cross-section.

A body's section in the half-plane is a valid polygon, outlined by exact curves; turning it gives
a mesh that is always closed. A :class:`Body` answers for both what is asked of it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from math import acos, ceil, pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import CrossSection, cross_section, section_at
from sgb_core.bodies.cut_outs import CutOut
from sgb_core.bodies.meridian import SolidError, sample_grids
from sgb_core.bodies.outline import Arc, Piece, Role
from sgb_core.bodies.pierced import Pierced, pierced
from sgb_core.bodies.region import Outline, parameters
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.bodies.solid_mesh import (
    are_simple,
    loop_of,
    ring_section,
    rows_of,
    sweep_rings,
    thick_parts,
    widest,
)
from sgb_core.bodies.stability import Stand, stand
from sgb_core.bodies.varying_solid import sections_at, varying_rows
from sgb_core.bodies.vessel import VesselMeasures, capacity_to, vessel_measures
from sgb_core.findings.bodies import NoBodyFor
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.helix import UNTWISTED, helix_limits
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sampling import (
    check_triangle_count,
    columns_for_radius,
    samples_for_tolerance,
)
from sgb_core.surfaces.section import MERGE
from sgb_core.surfaces.tessellation import tessellate
from sgb_core.surfaces.turn import closed_up, turn_of
from sgb_core.surfaces.twist import Twist

__all__ = ["Body", "SectionPolygon", "SolidError", "body_mesh", "section_polygons"]

# So many of the sections of a varying profile decide how finely all are sampled.
MOST_COMPARED = 12
LARGEST_ARC_STEP = pi / 6.0
# What is shown with its holes, and what they take, is of a mesh within this part of the size.
PIERCED_WITHIN = 5e-4
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


@dataclass(frozen=True, slots=True)
class Body:
    """What a surface and its ``solid`` make: a bare surface, a filled solid or a vessel.

    It is made when something is asked of it: whatever that is raises SolidError, a ValueError,
    where no such body can be. A bare surface has a mesh; its measures raise ValueError. Lengths
    are in the surface's unit.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    >>> cup = sgb.edits.set_solid(tube, kind="vessel", wall=3, base=4)
    >>> body = cup.body()
    >>> round(body.capacity / math.pi, 6), round(body.material_volume / math.pi, 6), body.wall_min
    (16184.0, 7816.0, 3.0)
    >>> body.mesh(tolerance=0.1).is_watertight
    True
    >>> body.stand.stands
    True
    """

    surface: RevolutionSurface
    solid: Solid
    cut_outs: tuple[CutOut, ...] = ()

    def __post_init__(self) -> None:
        for value, kind in ((self.surface, RevolutionSurface), (self.solid, Solid)):
            if not isinstance(value, kind):
                raise TypeError(f"{value!r} is no {kind.__name__}")

    @property
    def measures(self) -> VesselMeasures:
        """All that is measured, and what is doubtful about it.

        Of the material, what the cut-outs take is measured from the meshes with and without them;
        the other measures are those of the whole wall.
        """
        whole = vessel_measures(self.surface, self.solid)
        if not self.cut_outs:
            return whole
        return replace(whole, material_volume=whole.material_volume - self.pierced[1])

    @property
    def pierced(self) -> tuple[int, float]:
        """How many holes the cut-outs make, and the volume that they take, in unit³."""
        if not self.cut_outs:
            return 0, 0.0
        found = pierced_body(self.surface, self.solid, self.cut_outs)
        return found.count, found.removed

    @property
    def capacity(self) -> float | None:
        """What it holds to the brim, in unit³, a drain hole ignored; None without a rim."""
        return self.measures.capacity

    @property
    def material_volume(self) -> float:
        """The volume of wall and floor, or of the filled solid, in unit³."""
        return self.measures.material_volume

    @property
    def wall_min(self) -> float | None:
        """The smallest thickness of the wall, rim and floor left out; None for filled solids."""
        return self.measures.wall_min

    @property
    def stand(self) -> Stand:
        """How it stands on level ground."""
        return stand(self.mesh(), self.surface.directions(np.array(0.0)))

    def capacity_to(self, height: float) -> float | None:
        """Return what it holds up to a height of the profile, in unit³; None without a rim."""
        return capacity_to(self.surface, self.solid, height)

    def mesh(
        self, *, tolerance: float | None = None, samples: tuple[int, int] | None = None
    ) -> Mesh:
        """Return its mesh, as fine as asked: see :func:`body_mesh`; with its cut-outs."""
        mesh = body_mesh(self.surface, self.solid, tolerance=tolerance, samples=samples)
        if not self.cut_outs:
            return mesh
        return pierced(self.surface, self.solid, self.cut_outs, mesh).mesh

    def section(
        self, *, theta: float | None = None, tolerance: float | None = None
    ) -> tuple[SectionPolygon, ...]:
        """Return its section at an absolute angle in radians: see :func:`section_polygons`."""
        return section_polygons(self.surface, self.solid, theta=theta, tolerance=tolerance)


@lru_cache(maxsize=4)
def pierced_body(surface: RevolutionSurface, solid: Solid, cut_outs: tuple[CutOut, ...]) -> Pierced:
    """Return a body with its cut-outs as it is shown and measured, within 5e-4 of the size.

    Errors as for :func:`~sgb_core.bodies.pierced.pierced`.
    """
    mesh = body_mesh(surface, solid, tolerance=PIERCED_WITHIN * surface.profile.size)
    return pierced(surface, solid, cut_outs, mesh)


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
    size = surface.profile.size
    limit = Fineness(tolerance, samples).within(size)
    section = cross_section(surface, solid)
    reach = widest(section)
    if surface.sweep * reach < MERGE * size:
        raise SolidError(NoBodyFor.TOO_NARROW)
    surface = closed_up(surface, reach, MERGE * size)
    columns = _columns(surface, section, limit, samples)
    turn = turn_of(surface, columns)
    held = [section]
    if surface.laws:
        untwisted = replace(surface, twist=Twist())
        held = list(_held(untwisted, solid, turn.angles.tobytes()))
    for attempt in range(REFINEMENTS + 1):
        sampler = _sampler(held, solid, 0.45 * limit, samples, 2**attempt)
        if surface.twisting is not None:
            sampler = _along_helices(sampler, surface, columns, limit)
        if surface.laws:
            parts = varying_rows(surface, held, turn, sampler)
        else:
            parts = [
                [rows_of(ring, size, sampler) for ring in outline.rings]
                for outline in section.outlines
            ]
        rings = [ring for part in parts for ring in part]
        check_triangle_count(sum(rows.points.shape[1] for ring in rings for rows in ring), columns)
        # Where laws hold the sections at both ends and at the middle stand for all.
        probes = {0, len(turn.angles) // 2, -1} if surface.laws else {0}
        if all(
            are_simple([loop_of(ring, k, size) for ring in part]) for part in parts for k in probes
        ):
            break
    # A hole of two samples is none.
    sections = [
        tuple(ring_section(ring, size) for ring in part if len(loop_of(ring, 0, size)) > 2)
        for part in thick_parts(parts, probes, size)
    ]
    return sweep_rings(sections, turn, surface, section.meridian.mirrored)


@lru_cache(maxsize=4)
def _held(surface: RevolutionSurface, solid: Solid, angles: bytes) -> tuple[CrossSection, ...]:
    """Return the sections at angles; a twist drags on the same ones."""
    return tuple(sections_at(surface, solid, np.frombuffer(angles), section_at))


def _along_helices(
    sampler: Callable[[Piece], Floats], surface: RevolutionSurface, columns: int, limit: float
) -> Callable[[Piece], Floats]:
    """Return the sampling with what a twist needs between: lines, too, are curves then."""
    limits, twisting = helix_limits(surface, columns, limit), surface.twisting
    assert twisting is not None

    def sampled(piece: Piece) -> Floats:
        u = sampler(piece)
        return limits.refined(u, piece.points(u), twisting)

    return sampled


def _columns(
    surface: RevolutionSurface,
    section: CrossSection,
    limit: float,
    samples: tuple[int, int] | None,
) -> int:
    if samples is not None:
        return samples[1]
    share = limit if surface.twisting is None else UNTWISTED * limit
    columns = columns_for_radius(surface, widest(section), 0.45 * share)
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
    limit = Fineness(tolerance).within(size)
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
