"""STEP files: written by the kernel, named after the document, and told in a line beforehand."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, BinaryIO

from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.hole import Hole
from sgb_core.bodies.hole_layout import holes
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.file.hidden import new_folder
from sgb_core.document.model import Document
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Format, Request
from sgb_core.exchange.progress import Report, untold
from sgb_core.exchange.step.drawn import drawn_parts
from sgb_core.exchange.step.drilled import drilled, side_count
from sgb_core.exchange.step.faces import Turning
from sgb_core.exchange.step.fitted import PatchedPart, patched_parts
from sgb_core.exchange.step.fitted_shape import fitted_shape
from sgb_core.exchange.step.kernel import kernel_errors, kernel_shape
from sgb_core.exchange.step.parts import StepPart
from sgb_core.exchange.step.walls import section_parts
from sgb_core.findings.exports import KernelFailure, NoStep
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.revolution import RevolutionSurface

# What is fitted stays this part of the size near, unless asked otherwise.
FIT = 1e-4
# And nearer than this part of a wall.
THIN = 0.02
# And nearer than this part of the size where the ends of a part turn are twisted.
HELICAL = 1e-5
# The parts of the work that are done before holes are cut, and after.
_BEFORE_HOLES, _AFTER_HOLES = 0.1, 0.9
# Stands for the product's name until the kernel has written its file.
_PRODUCT = "sgb-product"


def write_step(
    document: Document,
    stream: BinaryIO,
    tolerance: float | None = None,
    report: Report = untold,
) -> None:
    """Write the body as STEP AP242, in millimetres: solids where it is closed, else a shell.

    Drawn curves are exact; what has no exact form stays within ``tolerance``, in the document's
    unit (default 1e-4 of the size). ``report`` is told the part done. Raises ExportError for what
    no solid can be made of, where the kernel fails, and where the optional CAD package is not
    installed.
    """
    scale = document.unit.millimetres
    patched = _patched(document, tolerance)
    parts = () if patched else step_parts(document, tolerance)
    asked = _holes(document)
    with new_folder() as folder, kernel_errors():
        path = folder / "body.step"
        shape = (
            fitted_shape(patched, scale, document.surface.is_full_turn)
            if patched
            else kernel_shape(parts, Turning(document.surface, scale))
        )
        if asked:
            # Each hole takes longer than all the rest.
            report(_BEFORE_HOLES)
            rest = _AFTER_HOLES - _BEFORE_HOLES
            shape = drilled(shape, asked, scale, lambda part: report(_BEFORE_HOLES + rest * part))
        report(_AFTER_HOLES)
        _write(shape, document.name, path)
        stream.write(_named(path.read_bytes(), _printable(document.name)))


def step_parts(document: Document, tolerance: float | None = None) -> tuple[StepPart, ...]:
    """Return the solids or the surface of one section that a document's file holds.

    Arguments as for writing. Raises ExportError for what there are none of.
    """
    wanted = _within(document, tolerance)
    if document.solid.kind is not BodyKind.VESSEL:
        return drawn_parts(document)
    return _vessel_parts(document.surface, document.solid, wanted)


def _within(document: Document, tolerance: float | None) -> float:
    """Return how near fits have to be; raises ExportError for bodies of which there are none."""
    if relief_of(document.appearance) is not None:
        raise ExportError(NoStep.RELIEF)
    size = document.profile.size or 1.0
    wanted = Fineness(tolerance if tolerance is not None else FIT * size).within(size)
    if document.solid.kind is not BodyKind.VESSEL:
        return wanted
    # A fit that strays farther than a part of the wall could leave it.
    return min(wanted, document.solid.wall * THIN)


def _patched(document: Document, tolerance: float | None) -> tuple[PatchedPart, ...]:
    """Return the fitted parts of a body whose section changes, or that a part turn twists."""
    surface = document.surface
    turned = surface.twisting is not None and not surface.is_full_turn
    if not (document.variation or turned):
        return ()
    within = _within(document, tolerance)
    # The edges of helical ends lie beside them, as far as the fits are off.
    within = min(within, HELICAL * document.profile.size) if turned else within
    return patched_parts(surface, document.solid, within)


def _holes(document: Document) -> tuple[Hole, ...]:
    """Return the holes of the cut-outs; raises ExportError where there can be none."""
    try:
        found = holes(document.surface, document.solid, document.patterns)
    except SolidError as error:
        raise ExportError(error.finding) from error
    if any(hole.prism is None for hole in found):
        raise ExportError(NoStep.BENT_HOLES)
    return found


# What a file will hold is told before, or after, it is written: fitted once for both.
@lru_cache(maxsize=1)
def _vessel_parts(
    surface: RevolutionSurface, solid: Solid, tolerance: float
) -> tuple[StepPart, ...]:
    try:
        section = cross_section(surface, solid)
    except SolidError as error:
        raise ExportError(error.finding) from error
    return section_parts(section, tolerance)


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


def _contents(request: Request) -> str:
    """Return in words what the file holds; raises ExportError where it cannot hold the body."""
    document = request.document
    parts: Sequence[StepPart | PatchedPart] = _patched(document, request.fineness.tolerance)
    parts = parts or step_parts(document, request.fineness.tolerance)
    off = [distance for part in parts for distance in part.deviations]
    asked = _holes(document)
    faces = len(off) + sum(map(side_count, asked))
    solids = sum(part.solid for part in parts)
    flat = not document.surface.is_full_turn and document.surface.twisting is None
    if solids == len(parts) and flat:
        faces += 2 * solids
    what = "An open surface" if not solids else "One solid" if solids == 1 else f"{solids} solids"
    if solids > 1:
        what += " that meet on the axis"
    if 0 < solids < len(parts):
        what += " and an open surface"
    if asked:
        what += f" with {len(asked)} {'hole' if len(asked) == 1 else 'holes'}"
    fits = [distance for distance in off if distance > 0.0]
    if not fits:
        return f"{what}, exact: {_counted(faces)}, no mesh"
    exact = f"{_counted(faces - len(fits))} exact, " if len(fits) < faces else ""
    within = f"{len(fits)} fitted within {max(fits):.2g} {document.unit}"
    return f"{what}: {exact}{within}, no mesh"


def _counted(faces: int) -> str:
    return f"{faces} {'face' if faces == 1 else 'faces'}"


def _write_request(request: Request, stream: BinaryIO) -> None:
    write_step(request.document, stream, request.fineness.tolerance, request.report)


FORMAT = Format(
    ".step",
    "STEP, exact surfaces",
    _write_request,
    _contents,
    meshed=False,
    tolerance=FIT,
    holds_up=True,
)
