"""Everything that the window says about a document's body, computed once and aside."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.stability import Stand, stand
from sgb_core.bodies.vessel import VesselMeasures, capacity_to, vessel_measures
from sgb_core.bodies.worked import Worked
from sgb_core.document.model import Document
from sgb_core.findings.finding import Finding
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class BodyMeasures:
    """Measures of a filled solid or a vessel, in powers of the document's unit.

    ``filled`` is the volume up to the fill line, None without one. ``height`` and ``diameter`` are
    those of the body itself, its wall outside the drawn profile included. ``holes`` are cut through
    its wall, None where they were not yet.
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
    directions = surface.directions(np.array(0.0))
    local = (mesh.positions - np.asarray(surface.placement.translation)) @ directions.T
    return BodyMeasures(
        vessel,
        filled,
        stand(mesh, directions[[0, 1, 2]]),
        float(np.ptp(local[:, 2])),
        2.0 * float(np.hypot(local[:, 0], local[:, 1]).max()),
        worked.count if isinstance(worked, Worked) else None,
    )


def mass_in_grams(document: Document, volume: float) -> float:
    """Return the mass of a volume (unit³) of the document's material, in grams."""
    return volume * document.unit.millilitres * document.manufacture.material.density
