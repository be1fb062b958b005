"""``figures``: writes the paper's figures, each as PNG, PDF and SVG with a JSON file beside it."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO

from app.cli import figure_record
from app.figures.drawing import draw
from app.figures.files import SUFFIXES, figure_bytes, plate_style
from app.figures.paper_figures import NUMBERS, figure
from app.figures.project_plate import plate_of
from sgb_core.document.file.atomic import write_whole
from sgb_core.document.model import Document
from sgb_core.findings.errors import FindingError
from sgb_core.findings.exports import NoFormat

BAR = 28


def write_figures(
    out: Path, only: int | None, dpi: int | None = None, again: Path | None = None
) -> None:
    """Write all figures, or one, into a folder, telling the progress on standard error.

    ``again`` is the JSON file beside a figure, which says the number and the resolution. Raises
    ValueError for a number that no figure has and for a file that is not of a figure, OSError
    where the system refuses.
    """
    if again is not None:
        only, dpi = figure_record.figure_of(again)
    numbers = list(NUMBERS) if only is None else [only]
    out.mkdir(parents=True, exist_ok=True)
    for place, number in enumerate(numbers):
        tell = _teller(number, place, len(numbers))
        tell(0.0)
        _write_figure(out / f"figure_{number:02d}", number, tell, dpi)
    _end_line()


def write_plate(
    document: Document,
    path: Path,
    told: Callable[[float], None] | None = None,
    dpi: int | None = None,
) -> None:
    """Write the plate that a document holds as its suffix says; ``told`` hears 0 to 1.

    Beside it stands OUT.json, from which it can be made again. Raises ValueError for another
    suffix, and where the document holds no plate or a faulty one.
    """
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise FindingError(NoFormat(str(path), suffix, tuple(SUFFIXES)))
    if dpi is not None and document.plate is not None:
        document = replace(document, plate=replace(document.plate, dpi=dpi))
    plate = plate_of(document)
    with plate_style():
        drawn = draw(plate, lambda part: told(0.8 * part) if told else None)
    _write(path, figure_bytes(drawn, suffix, plate.title or document.name))
    figure_record.write(
        path.with_name(f"{path.name}.json"), figure_record.of_plate(document, plate)
    )
    if told:
        told(1.0)


def _write_figure(stem: Path, number: int, tell: Callable[[float], None], dpi: int | None) -> None:
    made = figure(number)
    plate = made.plate if dpi is None else replace(made.plate, dpi=dpi)
    with plate_style():
        drawn = draw(plate, lambda part: tell(0.8 * part))
    title = f"Figure {number}: {made.record['title']}"
    for suffix in SUFFIXES:
        _write(stem.with_suffix(suffix), figure_bytes(drawn, suffix, title))
    figure_record.write(
        stem.with_suffix(".json"), figure_record.of_figure(number, made.record, plate)
    )
    tell(1.0)


def _write(path: Path, data: bytes) -> None:
    def writer(stream: BinaryIO) -> None:
        stream.write(data)

    write_whole(path, writer)


def _teller(number: int, place: int, count: int) -> Callable[[float], None]:
    """Return what draws the bar: on a terminal in one line, elsewhere a line for each figure."""

    def tell(part: float) -> None:
        whole = (place + part) / count
        bar = "#" * round(BAR * whole)
        if sys.stderr.isatty():
            line = f"\r[{bar:<{BAR}}] {whole:4.0%}  figure {number}"
            print(line, end="", file=sys.stderr, flush=True)
        elif part == 1.0:
            print(f"[{bar:<{BAR}}] {whole:4.0%}  figure {number}", file=sys.stderr, flush=True)

    return tell


def _end_line() -> None:
    if sys.stderr.isatty():
        print(file=sys.stderr)
