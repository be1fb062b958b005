"""STEP files written and read back by the kernel: what it finds in them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

import pytest

from sgb_core.document.model import Document
from sgb_core.exchange.step import write_step


@dataclass(frozen=True, slots=True)
class Read:
    """A valid shape of a file: how many solids and faces it has, its volume and area in mm."""

    shape: Any
    solids: int
    faces: int
    volume: float
    area: float
    centre: tuple[float, float, float]


def read_step(data: bytes, folder: Path) -> Read:
    """Return what the kernel reads, which it must find valid."""
    pytest.importorskip("OCP")
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer

    path = folder / "body.step"
    path.write_bytes(data)
    reader = STEPControl_Reader()
    reader.ReadFile(str(path))
    reader.TransferRoots()
    shape = reader.OneShape()
    assert BRepCheck_Analyzer(shape).IsValid()

    def count(kind: Any) -> int:
        explorer, found = TopExp_Explorer(shape, kind), 0
        while explorer.More():
            found += 1
            explorer.Next()
        return found

    def integrated(integrate: Callable[..., float], *how: float) -> Any:
        measured = GProp_GProps()
        integrate(shape, measured, *how)
        return measured

    # Gauss and Kronrod's rule goes by its error, where the plain one takes few points of a face.
    volume = integrated(BRepGProp.VolumePropertiesGK_s, 1e-9)
    middle = integrated(BRepGProp.VolumeProperties_s).CentreOfMass()
    return Read(
        shape,
        count(TopAbs_ShapeEnum.TopAbs_SOLID),
        count(TopAbs_ShapeEnum.TopAbs_FACE),
        volume.Mass(),
        integrated(BRepGProp.SurfaceProperties_s).Mass(),
        (middle.X(), middle.Y(), middle.Z()),
    )


def stepped(document: Document, folder: Path, tolerance: float | None = None) -> Read:
    """Return what the kernel reads in the STEP file of a document."""
    pytest.importorskip("OCP")
    stream = BytesIO()
    write_step(document, stream, tolerance)
    return read_step(stream.getvalue(), folder)
