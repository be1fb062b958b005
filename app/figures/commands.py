"""The commands of the figure studio and of fitting, each with a window of its own."""

from __future__ import annotations

from typing import TYPE_CHECKING

from app.commands.command import Command

if TYPE_CHECKING:
    from app.window.main_window import MainWindow


def fit_commands(window: MainWindow) -> list[Command]:
    """Return what fits the profile to a curve."""
    return [
        Command(
            "fit_ellipse",
            "Edit",
            "Fit to ellipse…",
            lambda: open_fit(window),
            "Ctrl+Alt+F",
            tip="Bring the profile as near as can be to a circle, an ellipse or a superellipse",
            separator=True,
        )
    ]


def figure_commands(window: MainWindow) -> list[Command]:
    """Return what makes figures."""
    return [
        Command(
            "figure_studio",
            "Export",
            "Figure studio…",
            lambda: open_studio(window),
            "Ctrl+Alt+E",
            tip="Make a plate of panels for a paper: PDF, SVG or PNG",
            separator=True,
        )
    ]


def open_fit(window: MainWindow) -> None:
    """Show the fit dialog of a window, made on first use."""
    from app.figures.fit_dialog import FitDialog

    dialog = window.findChild(FitDialog) or FitDialog(window.presenter, window.jobs, window)
    dialog.show()
    dialog.raise_()


def open_studio(window: MainWindow) -> None:
    """Show the figure studio of a window, made on first use."""
    from app.figures.studio import FigureStudio

    studio = window.findChild(FigureStudio) or FigureStudio(
        window.presenter,
        window.jobs,
        lambda: window.surface_view.pose,
        window.exporting.ask_path,
        window,
    )
    studio.show()
    studio.raise_()
