"""Drawings on paper as files of a command: their formats, pictures too, and what stands beside."""

from __future__ import annotations

from pathlib import Path, PurePath
from types import MappingProxyType
from typing import TYPE_CHECKING

from app.cli import figure_record, preflight
from sgb_core.document.model import Document
from sgb_core.drawings.drawing import WRITERS, Writers, write_drawing, writer_for
from sgb_core.drawings.page import Drawing

if TYPE_CHECKING:
    from collections.abc import Callable

PICTURE = ".png"


def is_drawn(path: str) -> bool:
    """Return whether a file's suffix is that of a drawing."""
    return PurePath(path).suffix.lower() in {*WRITERS, PICTURE}


def check_suffix(path: str) -> None:
    """Raise DrawingError for a suffix that is no drawing's: the cheap question first."""
    writer_for(path, _writers(None))


def write(drawing: Drawing, path: str, dpi: int | None = None) -> None:
    """Write a drawing as its suffix says; raises ValueError for what cannot be written so."""
    write_drawing(drawing, path, _writers(dpi))


def write_figure(
    document: Document, drawing: Drawing, path: str, command: list[str], dpi: int | None = None
) -> None:
    """Write a figure of a document, and OUT.json beside it, from which it is made again."""
    write(drawing, path, dpi)
    fine = ["--dpi", str(dpi)] if dpi is not None else []
    record = figure_record.of_drawing(document, drawing, [*command, *fine])
    figure_record.write(Path(f"{path}.json"), record)


def _writers(dpi: int | None) -> Writers:
    return MappingProxyType({**WRITERS, PICTURE: _picture(dpi)})


def _picture(dpi: int | None) -> Callable[[Drawing], bytes]:
    def make(drawing: Drawing) -> bytes:
        preflight.check_drawing()
        # Imported late: only a picture needs Qt.
        from PySide6.QtGui import QGuiApplication

        from app.drawings.picture import DPI, png_bytes

        # Letters come from an application; this one needs no screen.
        running = QGuiApplication.instance() or QGuiApplication(["", "-platform", "offscreen"])
        assert isinstance(running, QGuiApplication)
        return png_bytes(drawing, DPI if dpi is None else dpi)

    return make
