"""STEP: the exact surface, each segment a quartic Bézier curve turned about the axis."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path
from typing import Any, BinaryIO

from sgb_core.document.model import Document
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Format
from sgb_core.exchange.step_kernel import Turning, kernel_errors, kernel_shape
from sgb_core.exchange.step_parts import step_parts
from sgb_core.findings.exports import KernelFailure

# Stands for the product's name until the kernel has written its file.
_PRODUCT = "sgb-product"


def write_step(document: Document, stream: BinaryIO) -> None:
    """Write the body as STEP AP242, in millimetres: solids where it is closed, else a shell.

    Kind "filled" closes the ends to the axis. Raises ExportError for what has no exact form
    here (a wall, laws over the angle), for a profile that crosses the axis or itself, where the
    kernel fails, and where the optional CAD package is not installed.
    """
    parts = step_parts(document)
    with tempfile.TemporaryDirectory() as folder, kernel_errors():
        path = Path(folder) / "body.step"
        shape = kernel_shape(parts, Turning(document.surface, document.unit.millimetres))
        _write(shape, document.name, path)
        stream.write(_named(path.read_bytes(), _printable(document.name)))


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


def _contents(document: Document) -> str:
    """Return in words what the file holds; raises ExportError where it cannot hold the body."""
    parts = step_parts(document)
    faces = sum(len(part.curves) for part in parts)
    solids = sum(part.solid for part in parts)
    if solids == len(parts) and not document.surface.is_full_turn:
        faces += 2 * solids
    what = "An open surface" if not solids else "One solid" if solids == 1 else f"{solids} solids"
    if solids > 1:
        what += " that meet on the axis"
    if 0 < solids < len(parts):
        what += " and an open surface"
    return f"{what}, exact: {faces} {'face' if faces == 1 else 'faces'}, no mesh"


FORMAT = Format(
    ".step",
    "STEP, the exact surface",
    lambda request, stream: write_step(request.document, stream),
    _contents,
    meshed=False,
)
