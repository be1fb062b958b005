"""The View menu's beginning: what is shown, what is cut away, and from where it is seen."""

from __future__ import annotations

from functools import partial
from typing import Protocol

from app.commands.command import Command
from app.commands.cut_away import cut_commands
from app.scene.standard_views import STANDARD_VIEWS
from app.state.overlays import Overlay
from app.state.presenter import Frame, Presenter


class Viewport(Protocol):
    """The 3-D view as these commands know it."""

    def fit(self) -> None:
        """See all of the object."""

    def set_view_direction(self, name: str) -> None:
        """See from one of the standard views."""


class Editor(Protocol):
    """The profile editor as these commands know it."""

    def fit(self) -> None:
        """Show the whole profile."""


def view_commands(presenter: Presenter, viewport: Viewport, editor: Editor) -> list[Command]:
    """Return what the View menu begins with, in its order."""
    return [
        *_shows(presenter),
        *cut_commands(presenter, viewport),
        *_standard_views(viewport),
        Command(
            "fit",
            "View",
            "Fit surface",
            viewport.fit,
            "Ctrl+F",
            "fit",
            "Show the whole surface in the viewport",
            separator=True,
        ),
        Command(
            "fit_profile",
            "View",
            "Fit profile",
            editor.fit,
            "Ctrl+Shift+F",
            tip="Show the whole profile in the editor",
        ),
        Command(
            "parallel",
            "View",
            "Parallel projection",
            presenter.toggle_projection,
            "Ctrl+P",
            "perspective",
            state=lambda frame: frame.view.projection == "parallel",
        ),
    ]


def _shows(presenter: Presenter) -> list[Command]:
    return [
        Command(
            f"show_{overlay}",
            "View/Show",
            overlay.words,
            partial(presenter.toggle_overlay, overlay),
            overlay.keys,
            tip=overlay.tip,
            state=partial(_shown, overlay),
        )
        for overlay in Overlay
    ] + [_dimensions(presenter)]


def _dimensions(presenter: Presenter) -> Command:
    return Command(
        "show_dimensions",
        "View/Show",
        "Dimensions in the viewport",
        lambda: presenter.set_view(dimensions_in_space=not presenter.view.dimensions_in_space),
        "Ctrl+Alt+D",
        tip="The dimension lines of the Locks panel over the 3-D view too, where they are "
        "dragged as in the profile editor",
        state=lambda frame: frame.view.dimensions_in_space,
    )


def _shown(overlay: Overlay, frame: Frame) -> bool:
    return frame.view.shows(overlay)


def _standard_views(viewport: Viewport) -> list[Command]:
    return [
        Command(
            f"view_{name}",
            "View/Standard views",
            view.words,
            partial(viewport.set_view_direction, name),
            view.keys,
        )
        for name, view in STANDARD_VIEWS.items()
    ]
