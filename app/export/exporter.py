"""Taking things away: meshes and tables to files, pictures to files and the clipboard."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Protocol

from PySide6.QtCore import QObject, QUrl
from PySide6.QtGui import QDesktopServices, QGuiApplication, QImage
from PySide6.QtWidgets import QDialog, QFileDialog, QWidget

from app.files.files import Files
from app.state import written_folders
from app.state.child_command import run_aside
from app.state.jobs import Job, Jobs, Report
from app.state.presenter import Presenter
from app.state.window_reader import why
from sgb_core.document.file import atomic
from sgb_core.document.file.hidden import new_folder

if TYPE_CHECKING:
    from app.export.plan import Examined, ExportPlan


def _write_aside(path: Path, plan: ExportPlan, report: Report) -> None:
    """Have another process write the file, then put it in its place."""
    tolerance = plan.exported_tolerance
    fineness = [] if tolerance is None else ["--tolerance", repr(tolerance)]
    with new_folder() as folder:
        made = folder / f"made{plan.suffix}"
        run_aside("export", plan.exported, made, report, ["--progress", *fineness])
        atomic.write_whole(path, lambda file: file.write(made.read_bytes()))


def show_in_folder(path: Path) -> bool:
    """Open the folder of a file in the system's file manager; returns whether there is one."""
    return QDesktopServices.openUrl(QUrl.fromLocalFile(str(path.parent)))


def file_type(suffix: str) -> str:
    """Return how a file dialog names the files of a suffix."""
    from sgb_core import exchange

    known = exchange.FORMATS.get(suffix)
    title = known.title if known is not None else _TITLES.get(suffix, "")
    return f"{title} (*{suffix})" if title else f"*{suffix}"


# What is no format of a document.
_TITLES = MappingProxyType(
    {
        ".png": "Picture",
        ".pdf": "PDF document",
        ".gif": "Film",
        ".mp4": "Film",
        ".gcode": "G-code",
    }
)


class PictureSource(Protocol):
    """What can draw the viewport as a picture."""

    def size_in_pixels(self) -> tuple[int, int]:
        """Return the viewport's own (width, height)."""
        ...

    def picture(self, size: tuple[int, int], transparent: bool) -> bytes:
        """Return a PNG of the present view."""
        ...


class Exporting(QObject):
    """The Export menu of one window."""

    def __init__(
        self, presenter: Presenter, files: Files, jobs: Jobs, source: PictureSource, window: QWidget
    ) -> None:
        super().__init__(window)
        self._presenter = presenter
        self._files = files
        self._jobs = jobs
        self._source = source
        self._window = window

    def export(self) -> None:
        """Ask what and where to, then write it aside."""
        from app.export.dialog import ExportDialog
        from sgb_core import exchange

        document = self._presenter.document
        dialog = ExportDialog(document, exchange.suffixes(), self._window)
        if dialog.exec() != QDialog.DialogCode.Accepted:
            return
        path = self.ask_path("Export", dialog.suffix)
        if path is not None:
            self.write_plan(path, dialog.plan, dialog.result_shown)

    def write_plan(self, path: Path, plan: ExportPlan, examined: Examined | None = None) -> None:
        """Write what was asked for to ``path`` aside, with progress, to be cancelled."""
        from sgb_core import exchange
        from sgb_core.exchange.progress import GUESS

        size = GUESS if examined is None else examined.size

        def work(report: Report) -> None:
            wanted = plan.resolved() if examined is None else examined.plan
            if wanted.format.holds_up:
                _write_aside(path, wanted, report)
                return
            exchange.write(
                wanted.exported,
                path,
                tolerance=wanted.exported_tolerance,
                samples=wanted.samples if wanted.meshed else None,
                mesh=None if examined is None else examined.mesh,
                report=report,
                expected_bytes=size,
            )

        self.write(path, work)

    def write(self, path: Path, work: Callable[[Report], object]) -> None:
        """Run ``work``, which writes ``path``, as a job and say how it went."""
        written_folders.note(path)
        self._jobs.start(
            Job(
                f"Writing {path.name}",
                work,
                lambda _: self.tell_written(path),
                lambda error: self._presenter.notify(
                    f"Could not write {path.name}: {why(error)}",
                    "error",
                    "Try again…",
                    self.export,
                    stays=True,
                ),
                lambda: self._presenter.notify(f"Did not write {path.name}: cancelled."),
            )
        )

    def tell_written(self, path: Path) -> None:
        """Say that a file was written, and offer to show where."""
        self._presenter.notify(
            f"Wrote {path.name}.", "info", "Show in folder", lambda: self._show_in_folder(path)
        )

    def _show_in_folder(self, path: Path) -> None:
        if show_in_folder(path):
            return
        self._presenter.notify(
            f"No file manager answers here. The file is {path}.",
            "info",
            "Copy the path",
            lambda: QGuiApplication.clipboard().setText(str(path)),
            stays=True,
        )

    def picture(self) -> None:
        """Ask for a size, then save or copy a picture of the viewport."""
        from app.export.picture_dialog import PictureDialog

        dialog = PictureDialog(self._source.size_in_pixels(), self._window)
        if dialog.exec() != QDialog.DialogCode.Accepted:
            return
        size, transparent = dialog.size_in_pixels, dialog.transparent
        if dialog.to_clipboard:
            self.copy_picture(size, transparent)
            return
        path = self.ask_path("Save picture", ".png")
        if path is not None:
            # VTK draws on the GUI thread only; just the writing goes aside.
            png = self._source.picture(size, transparent)
            self.write(path, lambda _: atomic.write_whole(path, lambda file: file.write(png)))

    def copy_picture(self, size: tuple[int, int] | None = None, transparent: bool = False) -> None:
        """Put a picture of the viewport, by default as on screen, on the clipboard."""
        png = self._source.picture(size or self._source.size_in_pixels(), transparent)
        QGuiApplication.clipboard().setImage(QImage.fromData(png))
        self._presenter.notify("Copied the picture to the clipboard.")

    def ask_path(self, title: str, suffix: str) -> Path | None:
        """Ask where to write to; None where the user thinks better of it."""
        folder = self._files.path.parent if self._files.path else Path.home()
        start = folder / f"{self._files.title}{suffix}"
        name, _ = QFileDialog.getSaveFileName(self._window, title, str(start), file_type(suffix))
        if not name:
            return None
        path = Path(name)
        return path if path.suffix else path.with_suffix(suffix)
