"""The commands of drawings on paper, in the Export menu."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QDialog, QWidget

from app.commands.command import Command
from app.drawings.sort import Sort
from app.export.exporter import Exporting
from app.state.presenter import Presenter

PER_SEGMENT = 33


def drawing_commands(exporting: Exporting, presenter: Presenter, parent: QWidget) -> list[Command]:
    """Return what draws on paper and what copies the profile for other programs."""

    def drawing(sort: Sort) -> Callable[[], None]:
        return lambda: draw_on_paper(exporting, presenter, parent, sort)

    return [
        Command(
            "drawing",
            "Export",
            "Drawing on paper…",
            drawing(Sort.SECTION),
            "Ctrl+Shift+D",
            tip="A dimensioned section, a plate of vessels or a template at true size: PDF, SVG, "
            "DXF, PNG",
            separator=True,
        ),
        Command(
            "compare_curves",
            "Export",
            "Comparison of curves…",
            drawing(Sort.CURVES),
            "Ctrl+Alt+J",
            tip="The plain cubic, the quartic and the nearest rational cubic on the same points, "
            "and the fairest between the same joints: energies and deviations, and a plate",
        ),
        Command(
            "curvature_figure",
            "Export",
            "Curvature along the profile…",
            drawing(Sort.CURVATURE),
            tip="Curvature and the distance from the plain cubic over the arc length, as a figure",
        ),
        *_copying(presenter),
    ]


def _copying(presenter: Presenter) -> list[Command]:
    def copy_profile() -> None:
        from app.drawings import clipboard

        clipboard.copy_profile(presenter.document)
        presenter.notify("Copied the profile as SVG to the clipboard.")

    def copy_table() -> None:
        from app.drawings import clipboard

        count = clipboard.copy_table(presenter.document, PER_SEGMENT)
        presenter.notify(f"Copied {count} points of the profile to the clipboard.")

    def copy_curvature() -> None:
        from app.drawings import clipboard

        count = clipboard.copy_table(presenter.document, PER_SEGMENT, curvature=True)
        presenter.notify(f"Copied the curvature at {count} points to the clipboard.")

    return [
        Command(
            "copy_profile",
            "Export",
            "Copy profile as SVG",
            copy_profile,
            tip="Put the profile on the clipboard for Inkscape and Illustrator",
        ),
        Command(
            "copy_table",
            "Export",
            "Copy points as table",
            copy_table,
            tip=f"Put {PER_SEGMENT} points of each segment on the clipboard for a spreadsheet",
        ),
        Command(
            "copy_curvature",
            "Export",
            "Copy curvature as table",
            copy_curvature,
            tip="The same points with arc length, curvature and distance from the plain cubic",
        ),
    ]


def draw_on_paper(
    exporting: Exporting, presenter: Presenter, parent: QWidget, sort: Sort = Sort.SECTION
) -> None:
    """Ask what to draw, beginning with a sort, and where to write to, then write it aside."""
    from app.drawings.dialog import DrawingDialog
    from app.drawings.picture import writers
    from sgb_core.drawings.drawing import write_drawing

    dialog = DrawingDialog(presenter.document, parent, sort)
    accepted = dialog.exec() == QDialog.DialogCode.Accepted
    drawing, suffix, dpi = dialog.drawing, dialog.suffix, dialog.dpi.value
    dialog.deleteLater()
    if not accepted or drawing is None:
        return
    target = exporting.ask_path("Drawing on paper", suffix)
    if target is not None:
        exporting.write(target, lambda _: write_drawing(drawing, target, writers(dpi)))
