"""Import: the command of the File menu, what is dropped on the window, what is pasted."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QIODevice, QMimeData
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QFileDialog, QWidget

from app.commands.command import Command
from app.state.presenter import Presenter

if TYPE_CHECKING:
    from app.intake.sheet import ImportSheet

# A pasted table has so many points at least: two numbers alone are no profile.
_LEAST = 3
_PASTED_PICTURE, _PASTED_POINTS = "Pasted picture.png", "Pasted points.csv"


class Importer:
    """Opens the sheet of one window, which is imported and made when it is first wanted."""

    def __init__(
        self, presenter: Presenter, window: QWidget, fit: Callable[[], object] = lambda: None
    ) -> None:
        """Stand over ``window``; ``fit`` shows the whole of a profile that has been replaced."""
        self._presenter, self._window, self._fit = presenter, window, fit

    @property
    def sheet(self) -> ImportSheet:
        """The sheet, shown."""
        from app.intake.sheet import ImportSheet

        sheet = self._window.findChild(ImportSheet)
        sheet = sheet or ImportSheet(self._presenter, self._window, self._fit)
        sheet.show()
        sheet.raise_()
        sheet.activateWindow()
        return sheet

    def ask(self) -> None:
        """Ask for a file and open the sheet over it."""
        from sgb_core.sources import SOURCES

        patterns = " ".join(f"*{suffix}" for suffix in SOURCES)
        name, _ = QFileDialog.getOpenFileName(
            self._window, "Import", "", f"Drawings, points, meshes, pictures ({patterns})"
        )
        if name:
            self.sheet.open_path(Path(name))

    def place(self) -> None:
        """Show what lies behind the profile beside the window."""
        from app.intake.reference_dialog import ReferenceDialog

        window = self._window
        dialog = window.findChild(ReferenceDialog)
        dialog = dialog or ReferenceDialog(self._presenter, self._retrace, window)
        dialog.show()
        dialog.raise_()

    def _retrace(self) -> None:
        source = self._presenter.document.reference
        if source is not None and source.picture is not None:
            self.sheet.open_data(source.picture.data, Path(source.name).stem + ".png")

    def takes(self, data: QMimeData) -> bool:
        """Whether something dropped can be opened."""
        return dropped_source(data) is not None or data.hasImage()

    def drop(self, data: QMimeData) -> bool:
        """Open what was dropped; returns whether it was something that can be."""
        path = dropped_source(data)
        if path is not None:
            self.sheet.open_path(path)
            return True
        return self._take_picture(data)

    def paste(self, data: QMimeData) -> bool:
        """Open a picture or a table of points from the clipboard; returns whether it holds one."""
        if self.drop(data):
            return True
        from sgb_core.sources import SourceError
        from sgb_core.sources.points import parse_points

        text = data.text().encode()
        try:
            count = len(parse_points(text)) if text else 0
        except SourceError:
            return False
        if count < _LEAST:
            return False
        self.sheet.open_data(text, _PASTED_POINTS)
        return True

    def _take_picture(self, data: QMimeData) -> bool:
        picture = data.imageData() if data.hasImage() else None
        if not isinstance(picture, QImage) or picture.isNull():
            return False
        buffer = QBuffer()
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        picture.save(buffer, "PNG")  # type: ignore[call-overload]
        self.sheet.open_data(bytes(buffer.data().data()), _PASTED_PICTURE)
        return True


def dropped_source(data: QMimeData) -> Path | None:
    """Return the first file among what is dropped that a profile can come from."""
    from sgb_core.sources import SOURCES

    for url in data.urls():
        path = Path(url.toLocalFile())
        if url.isLocalFile() and path.suffix.lower() in SOURCES:
            return path
    return None


def import_commands(importer: Importer) -> list[Command]:
    """Return what the File menu takes sources in with."""
    return [
        Command(
            "import",
            "File",
            "Import…",
            importer.ask,
            "Ctrl+Shift+O",
            "import",
            "Trace a drawing, points, a mesh or a picture into a few segments",
        )
    ]


def picture_commands(importer: Importer) -> list[Command]:
    """Return what the View menu does with the picture behind the profile."""
    return [
        Command(
            "picture_behind",
            "View",
            "Picture behind…",
            importer.place,
            tip="Show, fade, lock, scale or remove the picture that lies behind the profile",
        ),
    ]
