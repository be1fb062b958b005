"""Everything that the window says about a document's body, computed once and aside."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.reach import outline_reach
from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.stability import Stand, stand
from sgb_core.bodies.vessel import VesselMeasures, capacity_to, vessel_measures
from sgb_core.bodies.worked import Worked
from sgb_core.document.model import Document
from sgb_core.findings.finding import Finding
from sgb_core.surfaces.bounds import section_reach
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# Part of the size by which a mesh may stay inside the curves that it follows.
_MESHED = 2e-4


@dataclass(frozen=True, slots=True)
class BodyMeasures:
    """Measures of a filled solid or a vessel, in powers of the document's unit.

    ``filled`` is the volume up to the fill line, None without one. ``height`` and ``diameter`` are
    those of the body itself: a wall outside the drawn profile and a foot ring add to it, a round
    rim takes some away. ``holes`` are cut through its wall, None where they were not yet.
    """

    vessel: VesselMeasures
    filled: float | None
    stand: Stand
    height: float
    diameter: float
    holes: int | None = None


def body_measures(
    document: Document,
    surface: RevolutionSurface,
    mesh: Mesh,
    worked: Worked | Finding | None = None,
) -> BodyMeasures:
    """Return the measures of a body whose mesh is given, and of its relief and holes where known.

    Raises SolidError, a ValueError, where the body cannot be made.
    """
    solid, line = document.solid, document.fill_height
    filled = None
    if line is not None and solid.kind is BodyKind.VESSEL:
        filled = capacity_to(surface, solid, line)
    vessel = vessel_measures(surface, solid)
    if isinstance(worked, Worked):
        volume = vessel.material_volume + worked.added - worked.removed
        vessel = replace(vessel, material_volume=volume, wall_min=worked.wall_min)
    exact = not (surface.laws or isinstance(worked, Worked))
    height, diameter = _section_size(document, surface) if exact else _mesh_size(surface, mesh)
    return BodyMeasures(
        vessel,
        filled,
        stand(mesh, surface.directions(np.array(0.0))),
        height,
        diameter,
        worked.count if isinstance(worked, Worked) else None,
    )


def _section_size(document: Document, surface: RevolutionSurface) -> tuple[float, float]:
    """Return height and diameter of a body that has the same section all around."""
    section = cross_section(surface, document.solid)
    low, high, reach = outline_reach(section.outlines)
    return high - low, 2.0 * reach


def _mesh_size(surface: RevolutionSurface, mesh: Mesh) -> tuple[float, float]:
    """Return height and diameter of a mesh; those of the drawn surface where it has its size."""
    directions = surface.directions(np.array(0.0))
    local = (mesh.positions - np.asarray(surface.placement.translation)) @ directions.T
    made = float(np.ptp(local[:, 2])), 2.0 * float(np.hypot(local[:, 0], local[:, 1]).max())
    (inner, outer), (low, high) = section_reach(surface)
    drawn = high - low, 2.0 * max(abs(inner), abs(outer))
    slack = _MESHED * max(drawn)
    height, diameter = (
        whole if abs(whole - found) <= slack else found
        for whole, found in zip(drawn, made, strict=True)
    )
    return height, diameter


def mass_in_grams(document: Document, volume: float) -> float:
    """Return the mass of a volume (unit³) of the document's material, in grams."""
    return volume * document.unit.millilitres * document.manufacture.material.density
