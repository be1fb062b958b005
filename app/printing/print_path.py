"""Asks how to print, then writes the G-code aside, with progress, to be cancelled."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog, QWidget

from app.export.exporter import Exporting
from app.state.presenter import Presenter


def print_path(exporting: Exporting, presenter: Presenter, parent: QWidget) -> None:
    """Ask for a printer and settings and where to write to, then write the path aside."""
    # Imported when it is first wanted, not while the window starts.
    from app.printing.dialog import PrintDialog
    from sgb_core.toolpaths.gcode import write_gcode
    from sgb_core.toolpaths.preview import preview

    document = presenter.document
    dialog = PrintDialog(document, parent)
    accepted = dialog.exec() == QDialog.DialogCode.Accepted
    path = dialog.path
    dialog.deleteLater()
    if not accepted or path is None:
        return
    target = exporting.ask_path("Print path", ".gcode")
    if target is not None:
        exporting.write(
            target,
            lambda report: write_gcode(
                path, target, document.name, picture=preview(path), report=report
            ),
        )
