"""What the window as a whole can be told: files, gallery, states, themes, arrangement, help."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Protocol

from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QWidget

from app.commands.command import Command
from app.export.exporter import Exporting
from app.files.files import Files
from app.film.make_film import make_film
from app.intake.commands import Importer
from app.printing.print_path import print_path
from app.profile_editor.view import ProfileView
from app.start.welcome import Welcome
from app.state.jobs import Jobs
from app.state.presenter import Frame, Presenter
from app.theme import theme
from app.viewport.view import SurfaceView
from app.window.layout import WindowLayout
from app.window.panels import Panels

if TYPE_CHECKING:
    from app.panels.states import StatesPanel

Key = QKeySequence.StandardKey


class Window(Protocol):
    """The window as its commands know it: its parts, and what it does as a whole."""

    presenter: Presenter
    jobs: Jobs
    files: Files
    exporting: Exporting
    importer: Importer
    surface_view: SurfaceView
    panels: Panels
    arrangement: WindowLayout
    welcome: Welcome

    @property
    def profile_view(self) -> ProfileView:
        """The profile editor."""

    def window(self) -> QWidget:
        """Return what dialogs stand over."""

    def walked(self) -> list[QWidget]:
        """Return what the keyboard can walk through: the viewport and the panels."""

    def new_window(self) -> None:
        """Open another window."""

    def close(self) -> bool:
        """Close it, asking about unsaved work."""

    def quit(self) -> None:
        """Close every window."""

    def set_theme(self, choice: theme.Choice) -> None:
        """Choose a theme by its name."""

    def isFullScreen(self) -> bool:
        """Whether it fills the screen."""

    def toggle_full_screen(self) -> None:
        """Fill the screen, or stop doing so."""

    def show_preferences(self) -> None:
        """Show the preferences."""

    def show_palette(self) -> None:
        """Offer every action by its name."""

    def show_shortcuts(self) -> None:
        """Show the sheet of all keys."""

    def show_about(self) -> None:
        """Say what this program is."""


def gallery_commands(window: Window) -> list[Command]:
    """Return what the File menu begins with."""
    return [
        Command(
            "gallery",
            "File",
            "New…",
            lambda: window.welcome.show_gallery(),
            "Ctrl+N",
            "new",
            "Start from a shape of the gallery, a recent file or a blank sheet",
        ),
        Command(
            "new_blank",
            "File",
            "New blank",
            lambda: window.files.new_blank(),
            tip="Start from one plain segment",
        ),
    ]


def file_commands(window: Window) -> list[Command]:
    """Return what opens, saves and closes."""
    files = window.files
    return [
        Command("open", "File", "Open…", files.open, Key.Open, "open", "Open a project file"),
        Command("save", "File", "Save", files.save, Key.Save, "save", "Save the project"),
        Command("save_as", "File", "Save as…", files.save_as, Key.SaveAs),
        Command("new_window", "File", "New window", window.new_window, "Ctrl+Shift+N"),
        Command("close", "File", "Close window", window.close, Key.Close, separator=True),
        Command("quit", "File", "Quit", window.quit, Key.Quit),
    ]


def state_commands(presenter: Presenter, panels: Panels) -> list[Command]:
    """Return what can be done with named states without looking at their panel."""

    def some(_frame: object) -> bool:
        return bool(presenter.document.states)

    def panel() -> StatesPanel:
        from app.panels.states import StatesPanel

        return panels.of("states", StatesPanel)

    return [
        Command(
            "store_state",
            "Edit/States",
            "Store state",
            lambda: panel().store(),
            "Ctrl+B",
            tip="Keep the document as it is now as a state of its own, in the file",
        ),
        Command(
            "next_state",
            "Edit/States",
            "Show next state",
            lambda: panel().step(1),
            "Ctrl+Alt+PgDown",
            enabled=some,
        ),
        Command(
            "previous_state",
            "Edit/States",
            "Show previous state",
            lambda: panel().step(-1),
            "Ctrl+Alt+PgUp",
            enabled=some,
        ),
    ]


def look_commands(window: Window) -> list[Command]:
    """Return what is done to the look without looking for its panel."""

    def lay_picture() -> None:
        from app.panels.look.panel import LookPanel

        window.arrangement.go_to(window.panels.docks["look"])
        window.panels.of("look", LookPanel).texture.ask_for_picture()

    return [
        Command(
            "picture_around",
            "View",
            "Picture around the surface…",
            lay_picture,
            tip="Lay a photo or drawing around the object, or around the segment that the panel "
            "Look names",
        ),
    ]


def preference_commands(window: Window) -> list[Command]:
    """Return what the Edit menu ends with."""
    return [
        Command(
            "preferences",
            "Edit",
            "Preferences…",
            window.show_preferences,
            "Ctrl+,",
            tip="Theme, text, navigation, units, keys",
            separator=True,
        )
    ]


def theme_commands(window: Window) -> list[Command]:
    """Return the choice of a theme."""

    def has_theme(choice: theme.Choice, _frame: Frame) -> bool:
        return theme.choice() == choice

    return [
        Command(
            f"theme_{choice}",
            "View/Theme",
            text,
            partial(window.set_theme, choice),
            state=partial(has_theme, choice),
        )
        for choice, text in theme.CHOICES.items()
    ]


def layout_commands(window: Window) -> list[Command]:
    """Return what changes which parts of the window are seen."""
    return [
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


def export_commands(window: Window) -> list[Command]:
    """Return what the Export menu begins with."""
    exporting = window.exporting
    return [
        Command(
            "export_mesh",
            "Export",
            "Export…",
            exporting.export,
            "Ctrl+E",
            "export",
            "Write a mesh or the profile for another program",
        ),
        Command(
            "film",
            "Export",
            "Film…",
            lambda: make_film(exporting, window.presenter, window.window()),
            tip="The object turning, or a parameter changing, as GIF, MP4 or pictures",
        ),
        Command(
            "print_path",
            "Export",
            "Print path…",
            lambda: print_path(exporting, window.presenter, window.window()),
            tip="G-code for clay and plastic straight from the exact surface, as one helix",
        ),
        Command(
            "screenshot",
            "Export",
            "Picture…",
            exporting.picture,
            "Ctrl+Shift+S" if QKeySequence(Key.SaveAs).isEmpty() else "Ctrl+Alt+S",
            "screenshot",
            "Save a picture of the viewport as PNG",
        ),
        Command(
            "copy_picture",
            "Export",
            "Copy picture",
            exporting.copy_picture,
            "Ctrl+Shift+C",
            tip="Put a picture of the viewport on the clipboard",
        ),
    ]


def welcome_commands(window: Window) -> list[Command]:
    """Return what the Help menu begins with."""
    return [
        Command(
            "tour",
            "Help",
            "Guided tour",
            lambda: window.welcome.start_tour(),
            tip="See what λ1, λ2, λ3 and ω do, by moving them",
        ),
        Command(
            "hints",
            "Help",
            "Show hints",
            lambda: window.welcome.show_hints(),
            tip="Show the three hints of the first start again",
        ),
    ]


def help_commands(window: Window) -> list[Command]:
    """Return what the Help menu ends with."""
    return [
        Command("palette", "Help", "Command palette…", window.show_palette, "Ctrl+Shift+P"),
        Command("shortcuts", "Help", "Shortcuts", window.show_shortcuts, "F1"),
        Command("about", "Help", "About SGB Studio", window.show_about),
    ]
