"""The CAD kernel: exact faces, sewn into shells and solids. Loaded when a STEP file is written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.step_parts import StepPart
from sgb_core.findings.exports import KernelFailure
from sgb_core.surfaces.revolution import RevolutionSurface

# Edges this near, in mm, are one: what the kernel itself takes for one point, and no less than
# rounding leaves of large coordinates.
_SAME, _SAME_PART = 1e-7, 1e-12


@contextmanager
def kernel_errors() -> Iterator[None]:
    """Turn whatever the kernel raises, and its absence, into an ExportError."""
    try:
        yield
    except ImportError as error:
        raise ExportError(KernelFailure.MISSING) from error
    except Exception as error:
        # The kernel's exceptions have no base of their own.
        if not type(error).__module__.startswith("OCP"):
            raise
        raise ExportError(KernelFailure.SHAPE) from error


@dataclass(frozen=True, slots=True)
class Turning:
    """Where the profile's half-plane stands: a surface's frame, with lengths times ``scale``."""

    surface: RevolutionSurface
    scale: float

    def place(self, points: Floats, angle: float) -> Floats:
        """Return points (k, 2) in space, turned by ``angle`` from the start, shape (k, 3)."""
        radial, _, axial = self.surface.directions(np.array(self.surface.start + angle))
        placed = points[:, :1] * radial + points[:, 1:] * axial
        return np.asarray((placed + np.asarray(self.surface.placement.translation)) * self.scale)

    @property
    def same(self) -> float:
        """The distance within which edges are one."""
        points = self.surface.profile.control_points
        far = np.abs(self.surface.placement.translation).max() + np.abs(points).max()
        return max(_SAME, _SAME_PART * float(far) * self.scale)


def kernel_shape(parts: Sequence[StepPart], turning: Turning) -> Any:
    """Return the kernel's shape: a solid or shell for each part, a compound where several.

    Raises ExportError where the kernel cannot build one, or what it built is not closed.
    """
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Compound

    shapes = [_part_shape(part, turning) for part in parts]
    if len(shapes) == 1:
        return shapes[0]
    builder, compound = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(compound)
    for shape in shapes:
        builder.Add(compound, shape)
    return compound


def _part_shape(part: StepPart, turning: Turning) -> Any:
    from OCP.BRep import BRep_Builder
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid, BRepBuilderAPI_Sewing
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepLib import BRepLib
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS_Shell

    sewing = BRepBuilderAPI_Sewing(turning.same)
    for curve in part.curves:
        sewing.Add(_turned(curve, turning))
    if part.solid and not turning.surface.is_full_turn:
        for angle in (0.0, turning.surface.sweep):
            sewing.Add(_end_face(part.curves, turning, angle))
    sewing.Perform()
    builder, shell = BRep_Builder(), TopoDS_Shell()
    builder.MakeShell(shell)
    faces = TopExp_Explorer(sewing.SewedShape(), TopAbs_ShapeEnum.TopAbs_FACE)
    while faces.More():
        builder.Add(shell, faces.Current())
        faces.Next()
    if not part.solid:
        return shell
    if sewing.NbFreeEdges() or sewing.NbMultipleEdges():
        raise ExportError(KernelFailure.SHAPE)
    shell.Closed(True)
    solid = BRepBuilderAPI_MakeSolid(shell).Solid()
    BRepLib.OrientClosedSolid_s(solid)
    if not BRepCheck_Analyzer(solid).IsValid():
        raise ExportError(KernelFailure.SHAPE)
    return solid


def _bezier(points: Floats) -> Any:
    from OCP.collections import Array1_gp_Pnt
    from OCP.Geom import Geom_BezierCurve
    from OCP.gp import gp_Pnt

    poles = Array1_gp_Pnt(1, len(points))
    for number, point in enumerate(points.tolist(), start=1):
        poles.SetValue(number, gp_Pnt(*point))
    return Geom_BezierCurve(poles)


def _turned(curve: Floats, turning: Turning) -> Any:
    """Return the face that a curve sweeps.

    It is made of its surface, not by sweeping an edge: that fails where the curve ends on the
    axis with a derivative of zero.
    """
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
    from OCP.Geom import Geom_SurfaceOfRevolution
    from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt

    foot = turning.place(np.zeros((1, 2)), 0.0)[0]
    up = turning.surface.directions(np.array(0.0))[2]
    axis = gp_Ax1(gp_Pnt(*foot.tolist()), gp_Dir(*up.tolist()))
    surface = Geom_SurfaceOfRevolution(_bezier(turning.place(curve, 0.0)), axis)
    sweep = float(turning.surface.sweep)
    return BRepBuilderAPI_MakeFace(surface, 0.0, sweep, 0.0, 1.0, turning.same).Face()


def _end_face(curves: Sequence[Floats], turning: Turning, angle: float) -> Any:
    """Return the flat face that the curves, and the axis where they end on it, bound."""
    from OCP.BRepBuilderAPI import (
        BRepBuilderAPI_MakeEdge,
        BRepBuilderAPI_MakeFace,
        BRepBuilderAPI_MakeVertex,
        BRepBuilderAPI_MakeWire,
    )
    from OCP.gp import gp_Pnt

    ends = np.array([curves[-1][-1], curves[0][0]])
    loop = list(curves)
    if not ends[:, 0].any() and ends[0, 1] != ends[1, 1]:
        loop.append(ends)
    placed = [turning.place(curve, angle) for curve in loop]
    corners = [BRepBuilderAPI_MakeVertex(gp_Pnt(*curve[0].tolist())).Vertex() for curve in placed]
    maker = BRepBuilderAPI_MakeWire()
    for k, curve in enumerate(placed):
        after = corners[(k + 1) % len(corners)]
        maker.Add(BRepBuilderAPI_MakeEdge(_bezier(curve), corners[k], after, 0.0, 1.0).Edge())
    return BRepBuilderAPI_MakeFace(maker.Wire(), True).Face()
