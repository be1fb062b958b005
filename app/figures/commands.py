"""The commands of the figure studio and of fitting, each with a window of its own."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Protocol

from PySide6.QtWidgets import QWidget

from app.commands.command import Command
from app.scene.camera import Pose
from app.state.jobs import Jobs
from app.state.presenter import Presenter


class Viewport(Protocol):
    """The 3-D view as the studio knows it."""

    pose: Pose | None


def fit_commands(presenter: Presenter, jobs: Jobs, window: QWidget) -> list[Command]:
    """Return what fits the profile to a curve, in a dialog beside ``window``."""

    def open_fit() -> None:
        from app.figures.fit_dialog import FitDialog

        dialog = window.findChild(FitDialog) or FitDialog(presenter, jobs, window)
        dialog.show()
        dialog.raise_()

    return [
        Command(
            "fit_ellipse",
            "Edit",
            "Fit to ellipse…",
            open_fit,
            "Ctrl+Alt+F",
            tip="Bring the profile as near as can be to a circle, an ellipse or a superellipse",
            separator=True,
        )
    ]


def figure_commands(
    presenter: Presenter,
    jobs: Jobs,
    viewport: Viewport,
    ask_path: Callable[[str, str], Path | None],
    window: QWidget,
) -> list[Command]:
    """Return what makes figures, in a studio beside ``window``.

    ``ask_path(title, suffix)`` asks where to write, None where the user thinks better of it.
    """

    def open_studio() -> None:
        from app.figures.studio import FigureStudio

        studio = window.findChild(FigureStudio) or FigureStudio(
            presenter, jobs, lambda: viewport.pose, ask_path, window
        )
        studio.show()
        studio.raise_()

    return [
        Command(
            "figure_studio",
            "Export",
            "Figure studio…",
            open_studio,
            "Ctrl+Alt+E",
            tip="Make a plate of panels for a paper: PDF, SVG or PNG",
            separator=True,
        )
    ]
