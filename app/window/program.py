"""The program with a window: from its start to its end."""

from __future__ import annotations

from pathlib import Path

from app.settings import text_size
from app.state import preferences, stored
from app.theme import theme
from app.window.garbage_collector import GarbageCollector
from app.window.main_window import MainWindow, application


def run(path: Path | None = None) -> int:
    """Open the window, with the project at ``path`` if given, and run until it is closed."""
    app = application()
    app.setApplicationName("SGB Studio")
    app.setOrganizationName("SGB Studio")
    stored.check_store()
    GarbageCollector(app)
    theme.apply(app, stored.stored_theme())
    text_size.apply(app, preferences.current().text_percent)
    window = first_window(path)
    say_set_aside(window)
    return int(app.exec())


def first_window(path: Path | None) -> MainWindow:
    """Show the window of the start: with a project, or with what greets the user."""
    window = MainWindow()
    window.show()
    if path is not None:
        window.files.open_path(path)
        window.autosave.offer()
    else:
        window.welcome.at_start()
    return window


def say_set_aside(window: MainWindow) -> None:
    """Say once which settings made no sense and were set aside."""
    found = stored.faults()
    if found:
        words = ", ".join(found)
        window.presenter.notify(
            f"Settings that make no sense were set aside, their defaults hold: {words}.", "warning"
        )
