"""What is dropped on a window: projects are opened, sources brought in."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtGui import QDropEvent

from app.files.files import SUFFIX, Files
from app.intake.commands import Importer


def enter(event: QDropEvent, importer: Importer) -> None:
    """Accept what can be dropped."""
    if _project(event) is not None or importer.takes(event.mimeData()):
        event.acceptProposedAction()


def drop(event: QDropEvent, files: Files, importer: Importer) -> None:
    """Open or bring in what was dropped."""
    path = _project(event)
    if path is not None:
        event.acceptProposedAction()
        files.open_path(path)
    elif importer.drop(event.mimeData()):
        event.acceptProposedAction()


def _project(event: QDropEvent) -> Path | None:
    for url in event.mimeData().urls():
        path = Path(url.toLocalFile())
        if url.isLocalFile() and path.suffix.lower() == SUFFIX:
            return path
    return None
