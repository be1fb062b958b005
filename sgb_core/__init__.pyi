"""The names of the library and where each stands; read when one is first asked for."""

from sgb_core import (
    bodies as bodies,
    curves as curves,
    design as design,
    document as document,
    drawings as drawings,
    exchange as exchange,
    findings as findings,
    sources as sources,
    surfaces as surfaces,
    toolpaths as toolpaths,
)
from sgb_core.bodies.body import Body as Body
from sgb_core.bodies.meridian import SolidError as SolidError
from sgb_core.bodies.cut_outs import (
    CutOut as CutOut,
)
from sgb_core.bodies.cut_outs import (
    HoleShape as HoleShape,
)
from sgb_core.bodies.solid import (
    BodyKind as BodyKind,
    Rim as Rim,
    Solid as Solid,
    WallSide as WallSide,
)
from sgb_core.curves.comb import Comb as Comb, comb as comb
from sgb_core.curves.constraints import Enforced as Enforced, enforce as enforce
from sgb_core.curves.continuity import (
    JointClass as JointClass,
    JointReport as JointReport,
    measure_joint as measure_joint,
    measure_joints as measure_joints,
)
from sgb_core.curves.crossings import (
    BeyondAxis as BeyondAxis,
    Certificates as Certificates,
    Crossing as Crossing,
    axis_crossings as axis_crossings,
    certificates as certificates,
    self_intersections as self_intersections,
)
from sgb_core.curves.nearest import Nearest as Nearest, arc_length as arc_length, nearest as nearest
from sgb_core.curves.primitives import arc as arc, cubic as cubic, line as line
from sgb_core.curves.profile import JointRule as JointRule, Profile as Profile
from sgb_core.curves.segment import Segment as Segment, ShapeParameters as ShapeParameters
from sgb_core.curves.subdivision import Split as Split, merge as merge, split as split
from sgb_core.design.locks.dimension import Dimension as Dimension, DimensionKind as DimensionKind
from sgb_core.design.tracing import Trace as Trace, TraceError as TraceError, trace as trace
from sgb_core.document import edits as edits
from sgb_core.document.errors import EditError as EditError, FileError as FileError
from sgb_core.document.file.project_file import (
    dumps as dumps,
    load as load,
    loads as loads,
    save as save,
)
from sgb_core.document.findings import check as check
from sgb_core.document.guides import Guide as Guide
from sgb_core.document.model import Document as Document, Revolution as Revolution, Unit as Unit
from sgb_core.exchange import ExportError as ExportError, write
from sgb_core.findings.refusal import RefusalError as RefusalError
from sgb_core.findings.words import say as say
from sgb_core.surfaces.deviation import deviation as deviation
from sgb_core.surfaces.grid import SweepGrid as SweepGrid
from sgb_core.surfaces.laws.law import Law as Law
from sgb_core.surfaces.laws.shape import LawShape as LawShape
from sgb_core.surfaces.laws.shapes import add_shape
from sgb_core.surfaces.measures import (
    area as area,
    bending_energy as bending_energy,
    bounds as bounds,
    centroid as centroid,
    generatrix_length as generatrix_length,
    height as height,
    largest_diameter as largest_diameter,
    surface_bending_energy as surface_bending_energy,
    volume as volume,
)
from sgb_core.surfaces.mesh import Mesh as Mesh
from sgb_core.surfaces.placement import Placement as Placement
from sgb_core.surfaces.rational import (
    RationalPatch as RationalPatch,
    rational_patches as rational_patches,
)
from sgb_core.surfaces.revolution import Axis as Axis, RevolutionSurface as RevolutionSurface
from sgb_core.surfaces.sampling import samples_for_tolerance as samples_for_tolerance
from sgb_core.surfaces.tessellation import tessellate as tessellate
from sgb_core.surfaces.twist import Ease as Ease, Twist as Twist

export = write
add_law_shape = add_shape
