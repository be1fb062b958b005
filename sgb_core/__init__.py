"""The geometry of SGB Studio, usable without the window: ``import sgb_core as sgb``.

The names here are what a script needs; everything else is reached by its module. All values are
frozen: each function of ``edits`` returns a new document. What is asked of a thing is a property
or a method of it; the examples in docstrings take ``import math`` and the import above as done.

>>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
>>> cup = sgb.edits.set_solid(tube, kind="vessel", wall=3, base=4)
>>> f"{cup.body().capacity / 1000:.1f} ml in a cup {cup.height:.0f} mm high"
'50.8 ml in a cup 60 mm high'
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
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

# The module of each name: what a script does not ask for is not imported.
_HOMES = {
    "Body": ("sgb_core.bodies.body", "Body"),
    "SolidError": ("sgb_core.bodies.meridian", "SolidError"),
    "BodyKind": ("sgb_core.bodies.solid", "BodyKind"),
    "Rim": ("sgb_core.bodies.solid", "Rim"),
    "Solid": ("sgb_core.bodies.solid", "Solid"),
    "WallSide": ("sgb_core.bodies.solid", "WallSide"),
    "Comb": ("sgb_core.curves.comb", "Comb"),
    "comb": ("sgb_core.curves.comb", "comb"),
    "Enforced": ("sgb_core.curves.constraints", "Enforced"),
    "enforce": ("sgb_core.curves.constraints", "enforce"),
    "JointClass": ("sgb_core.curves.continuity", "JointClass"),
    "JointReport": ("sgb_core.curves.continuity", "JointReport"),
    "measure_joint": ("sgb_core.curves.continuity", "measure_joint"),
    "measure_joints": ("sgb_core.curves.continuity", "measure_joints"),
    "BeyondAxis": ("sgb_core.curves.crossings", "BeyondAxis"),
    "Certificates": ("sgb_core.curves.crossings", "Certificates"),
    "Crossing": ("sgb_core.curves.crossings", "Crossing"),
    "axis_crossings": ("sgb_core.curves.crossings", "axis_crossings"),
    "certificates": ("sgb_core.curves.crossings", "certificates"),
    "self_intersections": ("sgb_core.curves.crossings", "self_intersections"),
    "Nearest": ("sgb_core.curves.nearest", "Nearest"),
    "arc_length": ("sgb_core.curves.nearest", "arc_length"),
    "nearest": ("sgb_core.curves.nearest", "nearest"),
    "arc": ("sgb_core.curves.primitives", "arc"),
    "cubic": ("sgb_core.curves.primitives", "cubic"),
    "line": ("sgb_core.curves.primitives", "line"),
    "JointRule": ("sgb_core.curves.profile", "JointRule"),
    "Profile": ("sgb_core.curves.profile", "Profile"),
    "Segment": ("sgb_core.curves.segment", "Segment"),
    "ShapeParameters": ("sgb_core.curves.segment", "ShapeParameters"),
    "Split": ("sgb_core.curves.subdivision", "Split"),
    "merge": ("sgb_core.curves.subdivision", "merge"),
    "split": ("sgb_core.curves.subdivision", "split"),
    "Dimension": ("sgb_core.design.locks.dimension", "Dimension"),
    "DimensionKind": ("sgb_core.design.locks.dimension", "DimensionKind"),
    "Trace": ("sgb_core.design.tracing", "Trace"),
    "TraceError": ("sgb_core.design.tracing", "TraceError"),
    "trace": ("sgb_core.design.tracing", "trace"),
    "EditError": ("sgb_core.document.errors", "EditError"),
    "FileError": ("sgb_core.document.errors", "FileError"),
    "dumps": ("sgb_core.document.file.project_file", "dumps"),
    "load": ("sgb_core.document.file.project_file", "load"),
    "loads": ("sgb_core.document.file.project_file", "loads"),
    "save": ("sgb_core.document.file.project_file", "save"),
    "check": ("sgb_core.document.findings", "check"),
    "Document": ("sgb_core.document.model", "Document"),
    "Revolution": ("sgb_core.document.model", "Revolution"),
    "Unit": ("sgb_core.document.model", "Unit"),
    "ExportError": ("sgb_core.exchange", "ExportError"),
    "export": ("sgb_core.exchange", "write"),
    "RefusalError": ("sgb_core.findings.refusal", "RefusalError"),
    "say": ("sgb_core.findings.words", "say"),
    "deviation": ("sgb_core.surfaces.deviation", "deviation"),
    "SweepGrid": ("sgb_core.surfaces.grid", "SweepGrid"),
    "Law": ("sgb_core.surfaces.laws.law", "Law"),
    "LawShape": ("sgb_core.surfaces.laws.shape", "LawShape"),
    "add_law_shape": ("sgb_core.surfaces.laws.shapes", "add_shape"),
    "area": ("sgb_core.surfaces.measures", "area"),
    "bending_energy": ("sgb_core.surfaces.measures", "bending_energy"),
    "bounds": ("sgb_core.surfaces.measures", "bounds"),
    "centroid": ("sgb_core.surfaces.measures", "centroid"),
    "generatrix_length": ("sgb_core.surfaces.measures", "generatrix_length"),
    "height": ("sgb_core.surfaces.measures", "height"),
    "largest_diameter": ("sgb_core.surfaces.measures", "largest_diameter"),
    "surface_bending_energy": ("sgb_core.surfaces.measures", "surface_bending_energy"),
    "volume": ("sgb_core.surfaces.measures", "volume"),
    "Mesh": ("sgb_core.surfaces.mesh", "Mesh"),
    "Placement": ("sgb_core.surfaces.placement", "Placement"),
    "RationalPatch": ("sgb_core.surfaces.rational", "RationalPatch"),
    "rational_patches": ("sgb_core.surfaces.rational", "rational_patches"),
    "Axis": ("sgb_core.surfaces.revolution", "Axis"),
    "RevolutionSurface": ("sgb_core.surfaces.revolution", "RevolutionSurface"),
    "samples_for_tolerance": ("sgb_core.surfaces.sampling", "samples_for_tolerance"),
    "tessellate": ("sgb_core.surfaces.tessellation", "tessellate"),
}
# What is reached as a module of its own.
_MODULES = {"edits": "sgb_core.document.edits"}
_ROOMS = (
    "bodies",
    "curves",
    "design",
    "document",
    "drawings",
    "exchange",
    "findings",
    "sources",
    "surfaces",
    "toolpaths",
)


def __getattr__(name: str) -> object:
    if name in _HOMES:
        module, known = _HOMES[name]
        found: object = getattr(import_module(module), known)
    elif name in _MODULES or name in _ROOMS:
        found = import_module(_MODULES.get(name, f"{__name__}.{name}"))
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__, *_MODULES})
