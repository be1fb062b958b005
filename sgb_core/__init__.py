"""The geometry of SGB Studio, usable without the window: ``import sgb_core as sgb``."""

from sgb_core.surfaces.body import Body, BodyKind, Rim, WallSide
from sgb_core.surfaces.deviation import deviation
from sgb_core.surfaces.grid import SweepGrid
from sgb_core.surfaces.measures import (
    area,
    bending_energy,
    bounds,
    centroid,
    generatrix_length,
    height,
    largest_diameter,
    volume,
)
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.rational import RationalPatch, rational_patches
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.sampling import samples_for_tolerance
from sgb_core.surfaces.tessellation import tessellate
from sgb_core.surfaces.variation import Law, LawKind

__all__ = [
    "Axis",
    "Body",
    "BodyKind",
    "Law",
    "LawKind",
    "Mesh",
    "Placement",
    "RationalPatch",
    "RevolutionSurface",
    "Rim",
    "SweepGrid",
    "WallSide",
    "area",
    "bending_energy",
    "bounds",
    "centroid",
    "deviation",
    "generatrix_length",
    "height",
    "largest_diameter",
    "rational_patches",
    "samples_for_tolerance",
    "tessellate",
    "volume",
]
