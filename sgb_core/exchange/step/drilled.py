"""Cut-outs in the CAD kernel: prisms with the holes' true outlines, taken from a solid."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.cut_outs import HoleShape
from sgb_core.bodies.hole import Hole, Prism
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.progress import Report
from sgb_core.findings.exports import KernelFailure
from sgb_core.interruption import checkpoint

# Holes cut at once: between one lot and the next it can be cancelled.
_AT_ONCE = 6


def drilled(shape: Any, holes: Sequence[Hole], scale: float, report: Report) -> Any:
    """Return the kernel's solid without its holes, straight prisms; lengths times ``scale``.

    Circles, ellipses and the ends of slots are true ones. ``report`` is told the part of the holes
    that are cut. Raises ExportError where the kernel
    fails, or what it leaves is not as many valid solids as before.
    """
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.collections import List_TopoDS_Shape

    left = shape
    for first in range(0, len(holes), _AT_ONCE):
        checkpoint()
        bodies, tools = List_TopoDS_Shape(), List_TopoDS_Shape()
        bodies.Append(left)
        for hole in holes[first : first + _AT_ONCE]:
            tools.Append(_prism(hole, scale))
        cut = BRepAlgoAPI_Cut()
        cut.SetArguments(bodies)
        cut.SetTools(tools)
        cut.Build()
        left = cut.Shape()
        report(min(first + _AT_ONCE, len(holes)) / len(holes))
    solids = list(_solids(left))
    if len(solids) != len(list(_solids(shape))) or not BRepCheck_Analyzer(left).IsValid():
        raise ExportError(KernelFailure.SHAPE)
    return solids[0] if len(solids) == 1 else left


def side_count(hole: Hole) -> int:
    """Return how many faces a hole has: one if it is round, four if a slot, else one a side."""
    if _is_round(hole):
        return 1
    return 4 if hole.shape is HoleShape.SLOT else len(hole.outline)


def _is_round(hole: Hole) -> bool:
    width, height = _half(hole)
    return hole.shape in (HoleShape.CIRCLE, HoleShape.ELLIPSE) or (
        hole.shape is HoleShape.SLOT and width == height
    )


def _half(hole: Hole) -> tuple[float, float]:
    """Return half the width and half the height of a hole."""
    width, height = hole.outline.max(axis=0).tolist()
    return width, height


def _solids(shape: Any) -> Iterator[Any]:
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer

    explorer = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_SOLID)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def _prism(hole: Hole, scale: float) -> Any:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakeWire
    from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
    from OCP.gp import gp_Vec

    wire = BRepBuilderAPI_MakeWire()
    for edge in _edges(hole, scale):
        wire.Add(edge)
    face = BRepBuilderAPI_MakeFace(wire.Wire()).Face()
    way = (scale * (hole.inner + hole.outer) * _frame(hole).out).tolist()
    return BRepPrimAPI_MakePrism(face, gp_Vec(*way)).Shape()


def _edges(hole: Hole, scale: float) -> Iterator[Any]:
    """Yield the edges of a hole's outline, head to tail, at the prism's inner end."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
    from OCP.gp import gp_Pnt

    if _is_round(hole):
        yield BRepBuilderAPI_MakeEdge(_ellipse(hole, scale, (0.0, 0.0), _half(hole))).Edge()
        return
    slot = hole.shape is HoleShape.SLOT
    corners = _slot_corners(hole) if slot else hole.outline
    placed = [gp_Pnt(*point) for point in _placed(hole, scale, corners).tolist()]
    for k, start in enumerate(placed):
        end = placed[(k + 1) % len(placed)]
        if slot and k % 2 == 0:
            middle = (corners[k] + corners[k + 1]) / 2.0
            radius = min(_half(hole))
            around = _ellipse(hole, scale, tuple(middle.tolist()), (radius, radius))
            yield BRepBuilderAPI_MakeEdge(around, start, end).Edge()
        else:
            yield BRepBuilderAPI_MakeEdge(start, end).Edge()


def _slot_corners(hole: Hole) -> Floats:
    """Return where the half circles of a slot begin and end, (4, 2), counter-clockwise."""
    width, height = _half(hole)
    radius, along = min(width, height), abs(height - width)
    upright = np.array([(radius, along), (-radius, along), (-radius, -along), (radius, -along)])
    return upright if height >= width else np.stack([-upright[:, 1], upright[:, 0]], axis=1)


def _placed(hole: Hole, scale: float, points: Floats) -> Floats:
    """Return points (k, 2) of the outline's plane in space, (k, 3), at the prism's inner end."""
    frame = _frame(hole)
    base = frame.centre - hole.inner * frame.out
    return np.asarray(scale * (base + points @ np.stack([frame.across, frame.up])))


def _frame(hole: Hole) -> Prism:
    prism = hole.prism
    assert prism is not None
    return prism


def _ellipse(hole: Hole, scale: float, middle: tuple[float, ...], half: tuple[float, float]) -> Any:
    """Return an ellipse about a point of the outline's plane, counter-clockwise in it."""
    from OCP.Geom import Geom_Circle, Geom_Ellipse
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt

    width, height = half
    (centre,) = _placed(hole, scale, np.array([middle]))
    prism = _frame(hole)
    normal = np.cross(prism.across, prism.up)
    longer = prism.across if width >= height else prism.up
    frame = gp_Ax2(gp_Pnt(*centre.tolist()), gp_Dir(*normal.tolist()), gp_Dir(*longer.tolist()))
    if width == height:
        return Geom_Circle(frame, scale * width)
    return Geom_Ellipse(frame, scale * max(half), scale * min(half))
