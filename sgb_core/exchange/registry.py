"""From the suffix of a file to the writer of its format."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from math import isfinite
from pathlib import PurePath
from types import MappingProxyType
from typing import BinaryIO, TypeAlias, cast

from sgb_core.document.file.atomic import write_whole
from sgb_core.document.model import Document
from sgb_core.exchange.body import exported_mesh
from sgb_core.exchange.csv_profile import write_csv
from sgb_core.exchange.dxf import write_dxf
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.glb import write_glb
from sgb_core.exchange.mtl import mtl_text
from sgb_core.exchange.obj import write_obj
from sgb_core.exchange.ply import write_ply
from sgb_core.exchange.progress import GUESS, CountingStream, Report, ReportedStream
from sgb_core.exchange.skin import Skin, skin_of
from sgb_core.exchange.step import write_step
from sgb_core.exchange.stl import write_stl
from sgb_core.exchange.svg import write_svg
from sgb_core.exchange.threemf import write_threemf
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.tessellation import samples_for_tolerance

# Points per segment of a generatrix where nobody asks for another number.
PER_SEGMENT = 65


@dataclass(frozen=True, slots=True)
class Fineness:
    """How finely to sample: a tolerance, or intervals per segment and around, or neither.

    ``mesh`` is the document's mesh where it has been made as finely already. Raises ExportError
    for both at once, a tolerance that is not finite and above 0, or samples below 1.
    """

    tolerance: float | None = None
    samples: tuple[int, int] | None = None
    mesh: Mesh | None = None

    def __post_init__(self) -> None:
        if self.tolerance is not None:
            if self.samples is not None:
                raise ExportError("tolerance and samples exclude each other")
            if not (isfinite(self.tolerance) and self.tolerance > 0.0):
                raise ExportError(
                    f"the tolerance is {self.tolerance!r}; allowed is a finite number above 0"
                )
        elif self.samples is not None:
            along, around = self.samples
            if min(self.samples) < 1:
                raise ExportError(f"the samples are {along} {around}; allowed are 1 or more each")


Writer: TypeAlias = Callable[[Document, Fineness, BinaryIO], None]


@dataclass(frozen=True, slots=True)
class Format:
    """A file format: its name for people, what writes it, whether it holds a mesh and its look."""

    title: str
    write: Writer
    meshed: bool = True
    looks: bool = False


def _mesh(document: Document, fineness: Fineness) -> Mesh:
    if fineness.mesh is not None:
        return fineness.mesh
    return exported_mesh(document, tolerance=fineness.tolerance, samples=fineness.samples)


def _stl(document: Document, fineness: Fineness, stream: BinaryIO) -> None:
    write_stl(_mesh(document, fineness), stream)


def _obj(document: Document, fineness: Fineness, stream: BinaryIO) -> None:
    write_obj(_mesh(document, fineness), stream)


def _textured_obj(skin: Skin, library: str) -> Writer:
    def write(document: Document, fineness: Fineness, stream: BinaryIO) -> None:
        mesh = _mesh(document, fineness)
        write_obj(mesh, stream, uv=skin.coordinates(mesh), library=library)

    return write


def _ply(document: Document, fineness: Fineness, stream: BinaryIO) -> None:
    mesh, skin = _mesh(document, fineness), skin_of(document)
    write_ply(mesh, stream, None if skin is None else skin.position_colors(mesh))


def _glb(document: Document, fineness: Fineness, stream: BinaryIO) -> None:
    mesh, skin = _mesh(document, fineness), skin_of(document)
    write_glb(mesh, stream, unit=document.unit, name=document.name, skin=skin)


def _threemf(document: Document, fineness: Fineness, stream: BinaryIO) -> None:
    write_threemf(_mesh(document, fineness), stream, unit=document.unit, name=document.name)


def _csv(document: Document, fineness: Fineness, stream: BinaryIO) -> None:
    """Write the generatrix at the same steps of s as the mesh would have."""
    per_segment: int | list[int] = PER_SEGMENT
    if fineness.samples is not None:
        per_segment = fineness.samples[0] + 1
    elif fineness.tolerance is not None:
        along, _ = samples_for_tolerance(document.surface, fineness.tolerance)
        per_segment = [intervals + 1 for intervals in along]
    write_csv(document.surface.profile_at(document.surface.start), stream, per_segment)


def _step(document: Document, fineness: Fineness, stream: BinaryIO) -> None:
    write_step(document, stream)


def _svg(document: Document, fineness: Fineness, stream: BinaryIO) -> None:
    write_svg(document, stream, fineness.tolerance)


def _dxf(document: Document, fineness: Fineness, stream: BinaryIO) -> None:
    write_dxf(document, stream)


FORMATS: Mapping[str, Format] = MappingProxyType(
    {
        ".stl": Format("STL, binary", _stl),
        ".obj": Format("Wavefront OBJ", _obj, looks=True),
        ".ply": Format("PLY, binary", _ply, looks=True),
        ".glb": Format("glTF, binary", _glb, looks=True),
        ".3mf": Format("3D Manufacturing Format", _threemf),
        ".step": Format("STEP, the exact surface", _step, meshed=False),
        ".svg": Format("Generatrix as SVG", _svg, meshed=False),
        ".dxf": Format("Generatrix as DXF", _dxf, meshed=False),
        ".csv": Format("Generatrix as CSV", _csv, meshed=False),
    }
)


def suffixes() -> tuple[str, ...]:
    """Return the suffixes that can be written, such as ".stl", in the order to offer them."""
    return tuple(FORMATS)


def format_for(path: str | os.PathLike[str]) -> Format:
    """Return the format that the suffix of a path names, in any case of its letters.

    Raises ExportError that names the suffixes there are.
    """
    suffix = PurePath(path).suffix
    found = FORMATS.get(suffix.lower())
    if found is None:
        has = f"has the suffix {suffix!r}" if suffix else "has no suffix"
        raise ExportError(
            f"{os.fspath(path)!r} {has}, which names no format; allowed are {' '.join(FORMATS)}"
        )
    return found


def write(
    document: Document,
    path: str | os.PathLike[str],
    *,
    tolerance: float | None = None,
    samples: tuple[int, int] | None = None,
    mesh: Mesh | None = None,
    report: Report | None = None,
    expected_bytes: int = GUESS,
) -> None:
    """Write a document's body to a file whose suffix names the format, whole or not at all.

    ``tolerance`` is the largest distance from the true surface, in the document's unit;
    ``samples`` the intervals per segment and around; they exclude each other, and the default
    is a tolerance of 1e-3 of the size. ``mesh`` is what :func:`exported_mesh` gave for them, where
    it has been made already. ``report`` is told which part, 0 to 1, of about ``expected_bytes`` is
    written; what it raises ends the writing and passes through, and the old file stays. Raises
    ExportError for what cannot be written and FileError where the system refuses.
    """
    writer, companions = _writer(document, path)
    fineness = Fineness(tolerance, samples, mesh)

    def write_to(stream: BinaryIO) -> None:
        if report is None:
            writer(document, fineness, stream)
        else:
            report(0.0)
            reported = cast(BinaryIO, ReportedStream(stream, report, expected_bytes))
            writer(document, fineness, reported)
            # While the old files still stand: who cancels now keeps them.
            report(1.0)
        for name, data in companions.items():
            write_whole(PurePath(path).with_name(name), partial(_put, data))

    write_whole(path, write_to)


def _writer(document: Document, path: str | os.PathLike[str]) -> tuple[Writer, dict[str, bytes]]:
    """Return what writes the file, and the files that go with it by their names."""
    found = format_for(path)
    skin = skin_of(document) if found is FORMATS[".obj"] else None
    if skin is None:
        return found.write, {}
    stem = PurePath(path).stem
    companions = {f"{stem}.png": skin.png} if skin.png else {}
    companions[f"{stem}.mtl"] = mtl_text(skin, f"{stem}.png").encode()
    return _textured_obj(skin, f"{stem}.mtl"), companions


def _put(data: bytes, stream: BinaryIO) -> None:
    stream.write(data)


def file_size(
    document: Document,
    suffix: str,
    *,
    tolerance: float | None = None,
    samples: tuple[int, int] | None = None,
    mesh: Mesh | None = None,
) -> int:
    """Return how many bytes :func:`write` would write in all, by writing them nowhere."""
    counter = CountingStream()
    writer, companions = _writer(document, f"file{suffix}")
    writer(document, Fineness(tolerance, samples, mesh), cast(BinaryIO, counter))
    return counter.size + sum(map(len, companions.values()))
