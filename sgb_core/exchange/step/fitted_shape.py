"""Patches as faces of the CAD kernel, sewn into shells and solids."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.step.curves import Spline
from sgb_core.exchange.step.faces import spline_curve
from sgb_core.exchange.step.fitted import Patch, PatchedPart, PatchedRing
from sgb_core.exchange.step.kernel import outward, together
from sgb_core.findings.exports import KernelFailure

# Edges this near, as a part of the size in mm and at least, are sewn: far below any fit.
_SEWN, _LEAST = 1e-7, 1e-6


def fitted_shape(parts: Sequence[PatchedPart], scale: float, closed: bool) -> Any:
    """Return the kernel's shape of parts, lengths times ``scale``; ``closed``: of a full turn.

    Raises ExportError where the kernel cannot build one, or what it built is not closed.
    """
    return together([_part_shape(part, scale, closed) for part in parts])


def _part_shape(part: PatchedPart, scale: float, closed: bool) -> Any:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.TopoDS import TopoDS

    reach = scale * max(float(np.abs(patch.poles).max()) for patch in part.patches)
    near = max(_LEAST, _SEWN * reach)
    if part.ends:
        # The edges of fits lie beside a helical end, as far as they are off.
        near = max(near, 2.0 * scale * max(part.deviations))
    rings = [[_face(p, scale) for row in ring.rows for p in row] for ring in part.rings]
    if not part.solid:
        return _sewn([face for ring in rings for face in ring], near)
    if not closed:
        ends = [_end(part, scale, at_end, near) for at_end in (False, True)]
        rings = [[face for ring in rings for face in ring] + ends]
    shells = [_shell(_sewn(ring, near)) for ring in rings]
    maker = BRepBuilderAPI_MakeSolid(outward(shells[0]))
    for inner in shells[1:]:
        maker.Add(TopoDS.Shell(outward(inner).Reversed()))
    solid = maker.Solid()
    if not BRepCheck_Analyzer(solid).IsValid():
        raise ExportError(KernelFailure.SHAPE)
    return solid


def _face(patch: Patch, scale: float) -> Any:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
    from OCP.collections import Array1_double, Array1_int, Array2_gp_Pnt
    from OCP.Geom import Geom_BSplineSurface
    from OCP.gp import gp_Pnt

    rows, columns = patch.poles.shape[:2]
    points = Array2_gp_Pnt(1, rows, 1, columns)
    for i, row in enumerate((scale * patch.poles).tolist(), start=1):
        for j, pole in enumerate(row, start=1):
            points.SetValue(i, j, gp_Pnt(*pole))
    arrays = []
    for vector in patch.knots:
        values, counts = np.unique(vector, return_counts=True)
        knots, multiplicities = Array1_double(1, len(values)), Array1_int(1, len(values))
        pairs = zip(values.tolist(), counts.tolist(), strict=True)
        for number, (value, count) in enumerate(pairs, start=1):
            knots.SetValue(number, value)
            multiplicities.SetValue(number, count)
        arrays.append((knots, multiplicities))
    (first, once), (second, twice) = arrays
    surface = Geom_BSplineSurface(points, first, second, once, twice, *patch.degrees)
    return BRepBuilderAPI_MakeFace(surface, _LEAST).Face()


def _sewn(faces: Sequence[Any], near: float) -> Any:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_Sewing

    sewing = BRepBuilderAPI_Sewing(near)
    for face in faces:
        sewing.Add(face)
    sewing.Perform()
    return sewing.SewedShape()


def _shell(shape: Any) -> Any:
    """Return the one closed shell that faces were sewn to."""
    from OCP.BRep import BRep_Tool
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopoDS import TopoDS

    if shape.ShapeType() != TopAbs_ShapeEnum.TopAbs_SHELL or not BRep_Tool.IsClosed_s(shape):
        raise ExportError(KernelFailure.SHAPE)
    return TopoDS.Shell(shape)


def _end(part: PatchedPart, scale: float, at_end: bool, near: float) -> Any:
    """Return the flat or helical face at the start or the end of a part turn."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
    from OCP.ShapeFix import ShapeFix_Face
    from OCP.TopoDS import TopoDS

    wires = [_wire(ring, scale, at_end) for ring in part.rings]
    if part.ends:
        surface = BRep_Tool.Surface_s(_face(part.ends[1 if at_end else 0], scale))
        maker = BRepBuilderAPI_MakeFace(surface, wires[0], True)
    else:
        maker = BRepBuilderAPI_MakeFace(wires[0], True)
    for wire in wires[1:]:
        maker.Add(TopoDS.Wire(wire.Reversed()))
    fixed = ShapeFix_Face(maker.Face())
    if part.ends:
        fixed.SetPrecision(near)
        # Edges learn where they run on the face.
        fixed.Perform()
    fixed.FixOrientation()
    return fixed.Face()


def _wire(ring: PatchedRing, scale: float, at_end: bool) -> Any:
    from OCP.BRepBuilderAPI import (
        BRepBuilderAPI_MakeEdge,
        BRepBuilderAPI_MakeWire,
    )
    from OCP.collections import List_TopoDS_Shape
    from OCP.gp import gp_Pnt

    edges = List_TopoDS_Shape()
    for row in ring.rows:
        patch = row[-1] if at_end else row[0]
        poles = patch.poles[:, -1 if at_end else 0]
        if float(np.ptp(poles, axis=0).max()) == 0.0:
            continue
        curve = Spline(poles[:, :2], patch.knots[0], patch.degrees[0])
        edges.Append(BRepBuilderAPI_MakeEdge(spline_curve(scale * poles, curve)).Edge())
    for first, last in (scale * ring.axis).tolist():
        edges.Append(BRepBuilderAPI_MakeEdge(gp_Pnt(*first), gp_Pnt(*last)).Edge())
    maker = BRepBuilderAPI_MakeWire()
    maker.Add(edges)
    return maker.Wire()
