"""Asks for a film and has it drawn aside, with progress, to be cancelled."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog, QWidget

from app.export.exporter import Exporting
from app.state.child_command import run_aside
from app.state.presenter import Presenter


def make_film(exporting: Exporting, presenter: Presenter, parent: QWidget) -> None:
    """Ask for a film and where to write it, then make it aside."""
    # Imported when a film is wanted: the window starts without.
    from app.film.dialog import FilmDialog
    from app.film.film import check_target

    document = presenter.document
    dialog = FilmDialog(document, presenter.view.segment, parent)
    if dialog.exec() != QDialog.DialogCode.Accepted:
        return
    path = exporting.ask_path("Film", dialog.suffix)
    if path is None:
        return
    try:
        check_target(path)
    except ValueError as error:
        presenter.notify(str(error), "warning")
        return
    arguments = ["--progress", *dialog.arguments]
    exporting.write(path, lambda report: run_aside("animate", document, path, report, arguments))
