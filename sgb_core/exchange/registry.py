"""From the suffix of a file to the writer of its format."""

from __future__ import annotations

import os
from functools import partial
from pathlib import PurePath
from typing import BinaryIO, cast

from sgb_core.document.file.atomic import write_whole
from sgb_core.document.model import Document
from sgb_core.exchange import csv_profile, dxf, glb, obj, ply, step, stl, svg, threemf
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Format, Request
from sgb_core.exchange.progress import (
    GUESS,
    CountingStream,
    Report,
    ReportedStream,
    rising,
    untold,
)
from sgb_core.findings.errors import FindingError
from sgb_core.findings.exports import NoFormat
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.mesh import Mesh

# By suffix, in the order to offer them. What is put in here, also by a script, is found by the
# window, the command line and :func:`write` alike.
FORMATS: dict[str, Format] = {
    module.FORMAT.suffix: module.FORMAT
    for module in (stl, obj, ply, glb, threemf, step, svg, dxf, csv_profile)
}


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
        raise ExportError(NoFormat(os.fspath(path), suffix, suffixes()))
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
    it has been made already. ``report`` is told which part, 0 to 1, is done, of writing about
    ``expected_bytes`` or of the work before; what it raises ends the writing and passes through,
    and the old file stays. Raises
    ExportError for what cannot be written and FileError where the system refuses.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.export(cylinder, "cylinder.stl", tolerance=0.1)
    >>> sgb.export(cylinder, "cylinder.xyz")
    Traceback (most recent call last):
        ...
    sgb_core.exchange.errors.ExportError: 'cylinder.xyz' has the suffix '.xyz', ...
    """
    found = format_for(path)
    tell = rising(report or untold)
    stem = PurePath(path).stem
    request = Request(document, _fineness(tolerance, samples), stem, mesh, tell)

    def write_to(stream: BinaryIO) -> None:
        tell(0.0)
        target = cast(BinaryIO, ReportedStream(stream, tell, expected_bytes)) if report else stream
        companions = found.write(request, target) or {}
        # While the old files still stand: who cancels now keeps them.
        tell(1.0)
        for name, data in companions.items():
            write_whole(PurePath(path).with_name(name), partial(_put, data))

    write_whole(path, write_to)


def _fineness(tolerance: float | None, samples: tuple[int, int] | None) -> Fineness:
    try:
        return Fineness(tolerance, samples)
    except FindingError as error:
        raise ExportError(error.finding) from error


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
    request = Request(document, _fineness(tolerance, samples), made=mesh)
    companions = format_for(f"file{suffix}").write(request, cast(BinaryIO, counter)) or {}
    return counter.size + sum(map(len, companions.values()))
