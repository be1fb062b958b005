"""The Edit menu's beginning: back and forth, snapping, and what changes the whole profile."""

from __future__ import annotations

from PySide6.QtGui import QKeySequence

from app.commands.command import Command
from app.state.presenter import Presenter
from app.state.window_reader import WINDOW
from sgb_core.document import edits

Key = QKeySequence.StandardKey


def edit_commands(presenter: Presenter) -> list[Command]:
    """Return what the Edit menu begins with, in its order."""
    return [*_history(presenter), _snap(presenter), *_whole(presenter)]


def _history(presenter: Presenter) -> list[Command]:
    session = presenter.session
    return [
        Command(
            "undo",
            "Edit",
            "Undo",
            presenter.undo,
            Key.Undo,
            "undo",
            enabled=lambda _: session.undo_label is not None,
            label=lambda _: f"Undo {session.undo_label}" if session.undo_label else "Undo",
        ),
        Command(
            "redo",
            "Edit",
            "Redo",
            presenter.redo,
            # Both habits: Ctrl+Shift+Z here, Ctrl+Y added by the window.
            "Ctrl+Shift+Z",
            "redo",
            enabled=lambda _: session.redo_label is not None,
            label=lambda _: f"Redo {session.redo_label}" if session.redo_label else "Redo",
        ),
    ]


def _snap(presenter: Presenter) -> Command:
    return Command(
        "snap",
        "Edit",
        "Snap to grid",
        lambda: presenter.set_view(snap=not presenter.view.snap),
        "Ctrl+G",
        separator=True,
        tip="Snap dragged points to the grid",
        state=lambda frame: frame.view.snap,
    )


def _whole(presenter: Presenter) -> list[Command]:
    return [
        Command(
            "reset_shape",
            "Edit",
            "Reset shape parameters of segment",
            lambda: _reset_shape(presenter),
            "Ctrl+R",
            "reset",
            tip="Set λ = 1, 3, 1 and ω = 0: the plain cubic",
        ),
        Command(
            "reset_all_shapes",
            "Edit",
            "Reset shape parameters of all segments",
            lambda: presenter.do("Reset all shapes", lambda d: edits.reset_shape(d, None, None)),
            "Ctrl+Shift+R",
        ),
        Command(
            "reverse_profile",
            "Edit",
            "Reverse profile",
            lambda: presenter.do("Reverse profile", edits.reverse_profile),
            tip="Run the whole profile from its end to its start",
            separator=True,
        ),
        Command(
            "mirror",
            "Edit",
            "Mirror upside down",
            lambda: presenter.do("Mirror upside down", edits.mirror_height),
        ),
    ]


def _reset_shape(presenter: Presenter) -> None:
    segment = presenter.view.segment
    presenter.do(
        f"Reset shape of {WINDOW.segment(segment)}", lambda d: edits.reset_shape(d, segment, None)
    )
