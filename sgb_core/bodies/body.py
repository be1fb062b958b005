"""Solid bodies: what the drawn surface means as an object, as a mesh and as a cross-section.

A body's section in the half-plane is a valid polygon, outlined by exact curves; turning it gives
a mesh that is always closed. A :class:`Body` answers for both what is asked of it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.body_mesh import body_mesh, sampler_of
from sgb_core.bodies.cross_section import cross_section, section_at
from sgb_core.bodies.hole_pattern import Pattern
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outline import Piece, Role
from sgb_core.bodies.region import Outline
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.bodies.solid_mesh import (
    rows_of,
)
from sgb_core.bodies.stability import Stand, stand
from sgb_core.bodies.vessel import VesselMeasures, capacity_to, vessel_measures
from sgb_core.bodies.worked import Worked, worked_body, worked_mesh
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.relief import Heights
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

__all__ = ["Body", "SectionPolygon", "SolidError", "body_mesh", "section_polygons"]


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
    patterns: tuple[Pattern, ...] = ()
    relief: Heights | None = None

    def __post_init__(self) -> None:
        for value, kind in ((self.surface, RevolutionSurface), (self.solid, Solid)):
            if not isinstance(value, kind):
                raise TypeError(f"{value!r} is no {kind.__name__}")

    @property
    def measures(self) -> VesselMeasures:
        """All that is measured, and what is doubtful about it.

        Of the material, what the cut-outs take and what a relief adds is measured from meshes with
        and without them; the wall is at least as thick as said. The other measures are those of
        the smooth, whole wall.
        """
        whole = vessel_measures(self.surface, self.solid)
        if not (self.patterns or self.relief):
            return whole
        worked = self.worked
        volume = whole.material_volume + worked.added - worked.removed
        return replace(whole, material_volume=volume, wall_min=worked.wall_min)

    @property
    def worked(self) -> Worked:
        """The mesh with relief and cut-outs, within 5e-4 of the size, and what became of them."""
        return worked_body(self.surface, self.solid, self.patterns, self.relief)

    @property
    def pierced(self) -> tuple[int, float]:
        """How many holes the cut-outs make, and the volume that they take, in unit³."""
        return (self.worked.count, self.worked.removed) if self.patterns else (0, 0.0)

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
        """Return its mesh, as fine as asked: see :func:`body_mesh`; with relief and cut-outs."""
        return worked_mesh(
            self.surface,
            self.solid,
            self.patterns,
            self.relief,
            tolerance=tolerance,
            samples=samples,
        ).mesh

    def section(
        self, *, theta: float | None = None, tolerance: float | None = None
    ) -> tuple[SectionPolygon, ...]:
        """Return its section at an absolute angle in radians: see :func:`section_polygons`."""
        return section_polygons(self.surface, self.solid, theta=theta, tolerance=tolerance)


def _held_at(surface: RevolutionSurface, turned: float) -> RevolutionSurface:
    if not surface.laws:
        return surface
    return RevolutionSurface(surface.profile_at(surface.start + turned))


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
    turned = 0.0 if theta is None else theta - surface.start
    section = (
        section_at(surface, solid, surface.sections(turned))
        if surface.fades
        else cross_section(_held_at(surface, turned), solid)
    )
    size = surface.profile.size
    limit = Fineness(tolerance).within(size)
    sampler = sampler_of([section], solid, limit, None, 1)
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
