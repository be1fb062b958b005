"""What each menu entry does; the tables that :mod:`app.commands.command` turns into actions."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtGui import QKeySequence

from app.commands.analysis import analysis_commands
from app.commands.clipboard import clipboard_commands
from app.commands.command import Command
from app.commands.cut_away import body_commands
from app.commands.focus_walk import walk_commands
from app.commands.scale_dialog import selection_commands
from app.commands.segment import segment_commands
from app.commands.segment_kinds import more_segment_commands
from app.figures.commands import figure_commands, fit_commands
from app.film.make_film import make_film
from app.state.presenter import Frame, Presenter
from app.state.view_state import Overlay
from app.theme import theme
from app.window.commands import (
    gallery_commands,
    preference_commands,
    state_commands,
    welcome_commands,
)
from sgb_core.document import edits

if TYPE_CHECKING:
    from app.window.main_window import MainWindow

Key = QKeySequence.StandardKey

OVERLAYS: tuple[tuple[Overlay, str, str], ...] = (
    ("surface", "Surface", "Alt+1"),
    ("generatrix", "Generatrix", "Alt+2"),
    ("polygon", "Control polygon", "Alt+3"),
    ("circles", "Circles of P1 (*) and P2 (o)", "Alt+4"),
    ("mesh", "Mesh lines", "Alt+5"),
    ("axes", "Axes", "Alt+6"),
    ("quartic", "Quartic points Q", "Alt+7"),
    ("ghost", "Mirrored silhouette", "Alt+8"),
    ("comb", "Curvature comb", "Alt+9"),
    ("liquid", "Liquid up to the fill line", "Alt+0"),
)

VIEWS = (
    ("front", "Front", "Ctrl+Alt+1"),
    ("back", "Back", "Ctrl+Alt+2"),
    ("right", "Right", "Ctrl+Alt+3"),
    ("left", "Left", "Ctrl+Alt+4"),
    ("top", "Top", "Ctrl+Alt+7"),
    ("bottom", "Bottom", "Ctrl+Alt+8"),
    ("iso", "Three-quarter", "Ctrl+Alt+0"),
)


def all_commands(window: MainWindow) -> list[Command]:
    """Return every command of a window, in the order of the menus."""
    return [
        *gallery_commands(window),
        *_file_commands(window),
        *_edit_commands(window.presenter),
        *clipboard_commands(window.presenter),
        *selection_commands(window.presenter, window),
        *state_commands(window),
        *fit_commands(window),
        *preference_commands(window),
        *segment_commands(window.presenter),
        *more_segment_commands(window.presenter),
        *_view_commands(window),
        *walk_commands(window),
        *analysis_commands(window),
        *_export_commands(window),
        *figure_commands(window),
        *welcome_commands(window),
        *_help_commands(window),
    ]


def _file_commands(window: MainWindow) -> list[Command]:
    files = window.files
    return [
        Command("open", "File", "Open…", files.open, Key.Open, "open", "Open a project file"),
        Command("save", "File", "Save", files.save, Key.Save, "save", "Save the project"),
        Command("save_as", "File", "Save as…", files.save_as, Key.SaveAs),
        Command("new_window", "File", "New window", window.new_window, "Ctrl+Shift+N"),
        Command("close", "File", "Close window", window.close, Key.Close, separator=True),
        Command("quit", "File", "Quit", window.quit, Key.Quit),
    ]


def _edit_commands(presenter: Presenter) -> list[Command]:
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
        Command(
            "snap",
            "Edit",
            "Snap to grid",
            lambda: presenter.set_view(snap=not presenter.view.snap),
            "Ctrl+G",
            separator=True,
            tip="Snap dragged points to the grid",
            state=lambda frame: frame.view.snap,
        ),
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
        f"Reset shape of segment {segment + 1}", lambda d: edits.reset_shape(d, segment, None)
    )


def _view_commands(window: MainWindow) -> list[Command]:
    presenter = window.presenter

    def toggle(overlay: Overlay) -> None:
        presenter.set_view(show=presenter.view.show ^ {overlay})

    def has_theme(choice: theme.Choice, _frame: Frame) -> bool:
        return window.theme_choice == choice

    def toggle_projection() -> None:
        other = "parallel" if presenter.view.projection == "perspective" else "perspective"
        presenter.set_view(projection=other)

    shows = [
        Command(
            f"show_{overlay}",
            "View/Show",
            text,
            partial(toggle, overlay),
            keys,
            state=partial(_shows, overlay),
        )
        for overlay, text, keys in OVERLAYS
    ]
    views = [
        Command(
            f"view_{name}",
            "View/Standard views",
            text,
            partial(window.surface_view.set_view_direction, name),
            keys,
        )
        for name, text, keys in VIEWS
    ]
    themes = [
        Command(
            f"theme_{choice}",
            "View/Theme",
            text,
            partial(window.set_theme, choice),
            state=partial(has_theme, choice),
        )
        for choice, text in theme.CHOICES.items()
    ]
    return [
        *shows,
        *body_commands(window),
        *views,
        Command(
            "fit",
            "View",
            "Fit surface",
            window.surface_view.fit,
            "Ctrl+F",
            "fit",
            "Show the whole surface in the viewport",
            separator=True,
        ),
        Command(
            "fit_profile",
            "View",
            "Fit profile",
            window.profile_view.fit,
            "Ctrl+Shift+F",
            tip="Show the whole profile in the editor",
        ),
        Command(
            "parallel",
            "View",
            "Parallel projection",
            toggle_projection,
            "Ctrl+P",
            "perspective",
            state=lambda frame: frame.view.projection == "parallel",
        ),
        *themes,
        Command(
            "viewport_alone",
            "View",
            "Viewport alone",
            lambda: window.arrangement.toggle_alone("viewport"),
            "F11",
            separator=True,
            tip="Let the viewport fill the screen; Esc brings everything back",
            state=lambda _: window.arrangement.alone == "viewport",
        ),
        Command(
            "editor_alone",
            "View",
            "Profile editor alone",
            lambda: window.arrangement.toggle_alone("editor"),
            "Shift+F11",
            tip="Let the profile editor fill the screen; Esc brings everything back",
            state=lambda _: window.arrangement.alone == "editor",
        ),
        Command(
            "full_screen",
            "View",
            "Full screen",
            window.toggle_full_screen,
            "Ctrl+F11",
            tip="Use the whole screen, with all panels",
            state=lambda _: window.isFullScreen(),
        ),
        Command("reset_layout", "View", "Reset layout", lambda: window.arrangement.reset()),
    ]


def _export_commands(window: MainWindow) -> list[Command]:
    return [
        Command(
            "export_mesh",
            "Export",
            "Export…",
            window.exporting.export,
            "Ctrl+E",
            "export",
            "Write a mesh or the profile for another program",
        ),
        Command(
            "film",
            "Export",
            "Film…",
            lambda: make_film(window.exporting, window.presenter, window),
            tip="The object turning, or a parameter changing, as GIF, MP4 or pictures",
        ),
        Command(
            "screenshot",
            "Export",
            "Picture…",
            window.exporting.picture,
            "Ctrl+Shift+S" if QKeySequence(Key.SaveAs).isEmpty() else "Ctrl+Alt+S",
            "screenshot",
            "Save a picture of the viewport as PNG",
        ),
        Command(
            "copy_picture",
            "Export",
            "Copy picture",
            window.exporting.copy_picture,
            "Ctrl+Shift+C",
            tip="Put a picture of the viewport on the clipboard",
        ),
    ]


def _help_commands(window: MainWindow) -> list[Command]:
    return [
        Command("palette", "Help", "Command palette…", window.show_palette, "Ctrl+Shift+P"),
        Command("shortcuts", "Help", "Shortcuts", window.show_shortcuts, "F1"),
        Command("about", "Help", "About SGB Studio", window.show_about),
    ]


def _shows(overlay: Overlay, frame: Frame) -> bool:
    return overlay in frame.view.show
