"""The geometry of SGB Studio, usable without the window: ``import sgb_core as sgb``.

The names here are what a script needs; everything else is reached by its module. All values are
frozen: each function of ``edits`` returns a new document. What is asked of a thing is a property
or a method of it; the examples in docstrings take ``import math`` and the import above as done.

>>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
>>> cup = sgb.edits.set_solid(tube, kind="vessel", wall=3, base=4)
>>> f"{cup.body().capacity / 1000:.1f} ml in a cup {cup.height:.0f} mm high"
'50.8 ml in a cup 60 mm high'
"""

from sgb_core.bodies.body import Body
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.curves.comb import Comb, comb
from sgb_core.curves.constraints import Enforced, enforce
from sgb_core.curves.continuity import JointClass, JointReport, measure_joint, measure_joints
from sgb_core.curves.crossings import (
    BeyondAxis,
    Certificates,
    Crossing,
    axis_crossings,
    certificates,
    self_intersections,
)
from sgb_core.curves.nearest import Nearest, arc_length, nearest
from sgb_core.curves.primitives import arc, cubic, line
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.curves.subdivision import Split, merge, split
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.tracing import Trace, TraceError

# Not in __all__: a star import would hide the standard module of that name.
from sgb_core.design.tracing import trace as trace
from sgb_core.document import edits
from sgb_core.document.errors import EditError, FileError
from sgb_core.document.file.project_file import dumps, load, loads, save
from sgb_core.document.findings import check
from sgb_core.document.model import Document, Revolution, Unit
from sgb_core.exchange import ExportError
from sgb_core.exchange import write as export
from sgb_core.findings.refusal import RefusalError
from sgb_core.findings.words import say
from sgb_core.surfaces.deviation import deviation
from sgb_core.surfaces.grid import SweepGrid
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.laws.shape import LawShape
from sgb_core.surfaces.laws.shapes import add_shape as add_law_shape
from sgb_core.surfaces.measures import (
    area,
    bending_energy,
    bounds,
    centroid,
    generatrix_length,
    height,
    largest_diameter,
    surface_bending_energy,
    volume,
)
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.rational import RationalPatch, rational_patches
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.sampling import samples_for_tolerance
from sgb_core.surfaces.tessellation import tessellate

__all__ = [
    "Axis",
    "BeyondAxis",
    "Body",
    "BodyKind",
    "Certificates",
    "Comb",
    "Crossing",
    "Dimension",
    "DimensionKind",
    "Document",
    "EditError",
    "Enforced",
    "ExportError",
    "FileError",
    "JointClass",
    "JointReport",
    "JointRule",
    "Law",
    "LawShape",
    "Mesh",
    "Nearest",
    "Placement",
    "Profile",
    "RationalPatch",
    "RefusalError",
    "Revolution",
    "RevolutionSurface",
    "Rim",
    "Segment",
    "ShapeParameters",
    "Solid",
    "SolidError",
    "Split",
    "SweepGrid",
    "Trace",
    "TraceError",
    "Unit",
    "WallSide",
    "add_law_shape",
    "arc",
    "arc_length",
    "area",
    "axis_crossings",
    "bending_energy",
    "bounds",
    "centroid",
    "certificates",
    "check",
    "comb",
    "cubic",
    "deviation",
    "dumps",
    "edits",
    "enforce",
    "export",
    "generatrix_length",
    "height",
    "largest_diameter",
    "line",
    "load",
    "loads",
    "measure_joint",
    "measure_joints",
    "merge",
    "nearest",
    "rational_patches",
    "samples_for_tolerance",
    "save",
    "say",
    "self_intersections",
    "split",
    "surface_bending_energy",
    "tessellate",
    "volume",
]
