"""STEP: the exact surface, each segment a quartic Bézier curve turned about the axis."""

from __future__ import annotations

import re
import tempfile
from itertools import pairwise
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.solid import BodyKind
from sgb_core.curves.crossings import axis_crossings, self_intersections
from sgb_core.curves.profile import GAP
from sgb_core.document.model import Document
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Format
from sgb_core.findings.exports import KernelFailure, NoExport, NoStep

# A quartic whose points lie within this part of the size of each other is a point.
_POINT = 1e-9
# Stands for the product's name until the kernel has written its file.
_PRODUCT = "sgb-product"


def write_step(document: Document, stream: BinaryIO) -> None:
    """Write the body as STEP AP242, in millimetres: a solid where it is closed, else a shell.

    Kind "filled" closes the ends to the axis. Raises ExportError for what has no exact form
    here (a wall, laws over the angle), for a profile that crosses the axis or itself, and where
    the optional CAD package is not installed.
    """
    _refuse_what_has_no_exact_form(document)
    scale = document.unit.millimetres
    chain = [q * scale for q in _without_points(document.profile.quartics)]
    if not chain:
        raise ExportError(NoExport.POINT)
    shape = _revolved(document, chain, scale)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "body.step"
        _write(shape, document.name, path)
        stream.write(_named(path.read_bytes(), _printable(document.name)))


def _refuse_what_has_no_exact_form(document: Document) -> None:
    profile = document.profile
    if document.solid.kind is BodyKind.VESSEL:
        raise ExportError(NoStep.VESSEL)
    if document.variation:
        raise ExportError(NoStep.LAWS)
    if axis_crossings(profile):
        raise ExportError(NoStep.CROSSES_AXIS)
    if not all(crossing.touches for crossing in self_intersections(profile)):
        raise ExportError(NoStep.CROSSES_ITSELF)
    ends = profile.control_points[:, [0, 3]]
    gaps = np.abs(ends[1:, 0] - ends[:-1, 1]).max(axis=-1, initial=0.0)
    if (gaps > GAP * profile.size).any():
        raise ExportError(NoStep.GAPS)


def _without_points(quartics: Floats) -> list[Floats]:
    size = float(np.hypot(*np.ptp(quartics.reshape(-1, 2), axis=0)))
    return [q for q in quartics if np.ptp(q, axis=0).max() > _POINT * size]


def _revolved(document: Document, chain: list[Floats], scale: float) -> Any:
    """Return the shape of the kernel: the chain, or the face it bounds, turned about the axis."""
    try:
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakeWire
        from OCP.BRepPrimAPI import BRepPrimAPI_MakeRevol
        from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt
    except ImportError as error:
        raise ExportError(KernelFailure.MISSING) from error
    surface = document.surface
    radial, _, axial = surface.directions(np.array([surface.start]))[0]
    origin = np.asarray(surface.placement.translation) * scale

    def place(points: Floats) -> Floats:
        placed: Floats = origin + points[..., :1] * radial + points[..., 1:] * axial
        return placed

    near_axis = _POINT * document.profile.size * scale
    chain = [_snapped(q, near_axis) for q in chain]
    first, last = chain[0][0], chain[-1][-1]
    ring = document.profile.closed
    on_axis = first[0] == 0.0 and last[0] == 0.0
    filled = document.solid.kind is BodyKind.FILLED and not ring
    solid = filled or ((ring or on_axis) and surface.is_full_turn)
    if not solid:
        # What lies on the axis sweeps nothing.
        chain = [q for q in chain if np.any(q[:, 0] != 0.0)]
    elif not ring:
        chain += _closing(first, last)
    maker = BRepBuilderAPI_MakeWire()
    for edge in _edges([place(q) for q in chain], ring or solid):
        maker.Add(edge)
    shape = BRepBuilderAPI_MakeFace(maker.Wire(), True).Face() if solid else maker.Wire()
    axis = gp_Ax1(gp_Pnt(*map(float, origin)), gp_Dir(*map(float, axial)))
    if surface.is_full_turn:
        return BRepPrimAPI_MakeRevol(shape, axis).Shape()
    return BRepPrimAPI_MakeRevol(shape, axis, float(surface.sweep)).Shape()


def _snapped(quartic: Floats, near_axis: float) -> Floats:
    """Return the points with radii that are zero up to rounding set to zero."""
    snapped = quartic.copy()
    snapped[np.abs(snapped[:, 0]) <= near_axis, 0] = 0.0
    return snapped


def _closing(first: Floats, last: Floats) -> list[Floats]:
    """Return the straight edges from the end of the chain by way of the axis to its start."""
    corners = [last, np.array([0.0, last[1]]), np.array([0.0, first[1]]), first]
    return [np.stack([start, end]) for start, end in pairwise(corners) if np.any(start != end)]


def _edges(curves: list[Floats], closed: bool) -> list[Any]:
    """Return Bézier edges that share their vertices, as a wire needs them."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeVertex
    from OCP.collections import Array1_gp_Pnt
    from OCP.Geom import Geom_BezierCurve
    from OCP.gp import gp_Pnt

    starts = [curve[0] for curve in curves] + ([] if closed else [curves[-1][-1]])
    vertices = [BRepBuilderAPI_MakeVertex(gp_Pnt(*map(float, p))).Vertex() for p in starts]
    if closed:
        vertices.append(vertices[0])
    edges = []
    for k, curve in enumerate(curves):
        poles = Array1_gp_Pnt(1, len(curve))
        for number, point in enumerate(curve, start=1):
            poles.SetValue(number, gp_Pnt(*map(float, point)))
        bezier = Geom_BezierCurve(poles)
        maker = BRepBuilderAPI_MakeEdge(bezier, vertices[k], vertices[k + 1], 0.0, 1.0)
        if not maker.IsDone():
            raise ExportError(KernelFailure.EDGE)
        edges.append(maker.Edge())
    return edges


def _write(shape: Any, name: str, path: Path) -> None:
    from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.Interface import Interface_Static
    from OCP.Message import Message
    from OCP.STEPControl import (
        STEPControl_Controller,
        STEPControl_StepModelType,
        STEPControl_Writer,
    )
    from OCP.TCollection import TCollection_HAsciiString

    # The kernel would report each transfer on standard output.
    Message.DefaultMessenger_s().ChangePrinters().Clear()
    # Without this the first file of a process would be AP214, whatever the next line says.
    STEPControl_Controller.Init_s()
    Interface_Static.SetCVal_s("write.step.schema", "AP242DIS")
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    Interface_Static.SetCVal_s("write.step.product.name", _PRODUCT)
    writer = STEPControl_Writer()
    writer.Transfer(shape, STEPControl_StepModelType.STEPControl_AsIs)
    header = APIHeaderSection_MakeHeader(writer.Model())
    header.SetName(TCollection_HAsciiString(_printable(name)))
    # The same document gives the same file: no date but a fixed one.
    header.SetTimeStamp(TCollection_HAsciiString("1970-01-01T00:00:00"))
    if writer.Write(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise ExportError(KernelFailure.FILE)


def _printable(text: str) -> str:
    """Return text as the kernel's strings can hold it."""
    return "".join(c if " " <= c <= "~" else "?" for c in text)


def _named(data: bytes, name: str) -> bytes:
    """Name the product: the kernel would add how many files this process has written."""
    quoted = name.replace("'", "''").replace("\\", "\\\\").encode("ascii")
    product = b"PRODUCT('" + quoted + b"','" + quoted + b"'"
    pattern = rb"PRODUCT\('%b \d+','%b \d+'" % (_PRODUCT.encode(), _PRODUCT.encode())
    return re.sub(pattern, lambda _: product, data, count=1)


FORMAT = Format(
    ".step",
    "STEP, the exact surface",
    lambda request, stream: write_step(request.document, stream),
    lambda _document: "The exact surface, no mesh",
    meshed=False,
)
