"""The commands that concern the window itself: gallery, preferences, tour, states."""

from __future__ import annotations

from typing import TYPE_CHECKING

from app.commands.command import Command

if TYPE_CHECKING:
    from app.window.main_window import MainWindow


def gallery_commands(window: MainWindow) -> list[Command]:
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


def state_commands(window: MainWindow) -> list[Command]:
    """Return what can be done with named states without their panel."""

    def some(frame: object) -> bool:
        return bool(window.presenter.document.states)

    return [
        Command(
            "store_state",
            "Edit/States",
            "Store state",
            lambda: window.states_panel.store(),
            "Ctrl+B",
            tip="Keep the document as it is now as a state of its own, in the file",
        ),
        Command(
            "next_state",
            "Edit/States",
            "Show next state",
            lambda: window.states_panel.step(1),
            "Ctrl+Alt+PgDown",
            enabled=some,
        ),
        Command(
            "previous_state",
            "Edit/States",
            "Show previous state",
            lambda: window.states_panel.step(-1),
            "Ctrl+Alt+PgUp",
            enabled=some,
        ),
    ]


def preference_commands(window: MainWindow) -> list[Command]:
    """Return what the Edit menu ends with."""
    return [
        Command(
            "preferences",
            "Edit",
            "Preferences…",
            lambda: window.show_preferences(),
            "Ctrl+,",
            tip="Theme, text, navigation, units, keys",
            separator=True,
        )
    ]


def welcome_commands(window: MainWindow) -> list[Command]:
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
