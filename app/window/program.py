"""The program with a window: from its start to its end."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from app.settings import text_size
from app.state import preferences, stored, user_folders
from app.state.log import Log, started
from app.theme import theme
from app.window.garbage_collector import GarbageCollector
from app.window.main_window import MainWindow, application
from app.window.trouble import Trouble, open_log

# So many settings are named; the others lie with them.
NAMED = 6


def run(path: Path | None = None) -> int:
    """Open the window, with the project at ``path`` if given, and run until it is closed."""
    app = application()
    app.setApplicationName(user_folders.PROGRAM)
    app.setOrganizationName(user_folders.PROGRAM)
    log = Log()
    log.write(started(user_folders.PROGRAM))
    trouble = Trouble(app, log, lambda: MainWindow.windows)
    stored.check_store()
    GarbageCollector(app)
    theme.apply(app, stored.stored_theme())
    text_size.apply(app, preferences.current().text_percent)
    window = MainWindow(furnished=False)
    window.show_frame()
    # What takes long to load is loaded behind the frame that is seen.
    from app.window.signals import Signals, follow_session

    clean_up()
    window.furnish()
    signals = Signals(app, end)
    follow_session(app, lambda: [each.safekeeping for each in MainWindow.windows])
    begin(window, path)
    say_crash(window, log)
    status = int(app.exec())
    signals.close()
    trouble.close()
    log.close()
    return status


def begin(window: MainWindow, path: Path | None) -> None:
    """Begin in the first window: with a project, or with what greets the user."""
    from app.files.safekeeping import say_set_aside
    from sgb_core.curves.parameter_fan import most_telling

    window.presenter.select(most_telling(window.presenter.document.profile))
    if path is not None:
        window.files.open_path(path)
        window.safekeeping.offer()
    else:
        window.welcome.at_start()
    say_set_aside(window.presenter)
    say_faults(window)
    # A panel reads its settings when it is first seen.
    window.presenter.refreshed.connect(lambda _frame: say_faults(window))


def say_faults(window: MainWindow) -> None:
    """Say which settings gave way to their defaults, beside what is being said already."""
    from app.state.presenter import Notice

    faults = stored.faults()
    if faults:
        text = f"Settings that make no sense were set aside, their defaults hold: {_some(faults)}."
        last = window.notice_bar.notice
        if last is None or not last.stays:
            last = Notice("")
        window.presenter.notify(
            f"{last.text} {text}".lstrip(), "warning", last.action, last.callback, stays=True
        )


def _some(names: Sequence[str]) -> str:
    """Return names in a line that can be read at a glance."""
    more = len(names) - NAMED
    return ", ".join(names[:NAMED]) + (f" and {more} more" if more > 0 else "")


def say_crash(window: MainWindow, log: Log) -> None:
    """Say that the program did not end as it should, unless there is more urgent news."""
    if log.crashes and window.notice_bar.notice is None:
        window.presenter.notify(
            "The program did not end as it should last time. What was saved or set aside is there.",
            "warning",
            "Open the log",
            lambda: open_log(log.path),
            stays=True,
        )


def end(number: int) -> None:
    """End by a signal: the work of all windows is kept for the next start."""
    from app.window.signals import BY_SIGNAL

    for window in list(MainWindow.windows):
        window.end()
    application().exit(BY_SIGNAL + number)


def clean_up() -> None:
    """Remove what killed programs left half written, wherever this one is used to write."""
    from app.files.files import RecentFiles
    from app.state import written_folders
    from sgb_core.document.file import hidden, recovery

    journals = user_folders.recovery()
    recovery.clean(journals, user_folders.locks())
    for folder in (
        *(user_folders.thumbnails(), user_folders.backups(), user_folders.printers()),
        *{path.parent for path in RecentFiles().paths()},
        *written_folders.paths(),
    ):
        hidden.clean(folder)
    hidden.clean()
