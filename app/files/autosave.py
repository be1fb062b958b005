"""Unsaved work is set aside every few seconds; what a crash left behind is offered again."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtCore import QObject, QTimer

from app.files.files import Files
from app.state import preferences, user_folders
from app.state.presenter import Presenter
from app.state.window_reader import why
from sgb_core.document.errors import FileError
from sgb_core.document.file import recovery
from sgb_core.document.file.recovery import Journal, Recoverable


class Autosave(QObject):
    """The journal of one window, beside those of other windows and programs."""

    def __init__(self, presenter: Presenter, files: Files) -> None:
        super().__init__(files)
        self._presenter = presenter
        self._files = files
        self._told = False
        self.journal = Journal(user_folders.recovery())
        self._timer = QTimer(self)
        self._timer.timeout.connect(self.write)
        self._take_preferences(preferences.current())
        preferences.notifier().changed.connect(self._take_preferences)
        self._unsubscribe = presenter.session.subscribe(lambda _old, _new: self._clear_if_saved())

    def write(self) -> bool:
        """Set unsaved work aside, unless the hand is moving; returns whether it was written."""
        session = self._presenter.session
        if not session.is_modified or session.in_gesture:
            return False
        try:
            return self.journal.write(session.document, self._files.path)
        except FileError as error:
            if not self._told:
                self._told = True
                self._presenter.notify(f"Unsaved work cannot be set aside: {why(error)}", "warning")
            return False

    def stop(self) -> None:
        """Forget the work, which was saved or thrown away on purpose; for closing the window."""
        self._timer.stop()
        self._unsubscribe()
        self.journal.clear()

    def offer(self) -> bool:
        """Offer the newest unsaved work that a crash left; returns whether there was any."""
        found = recovery.recoverable(user_folders.recovery())
        if not found:
            return False
        item = found[0]
        when = datetime.fromtimestamp(item.seconds).strftime("%d %b, %H:%M")
        more = f" ({len(found) - 1} more)" if len(found) > 1 else ""
        self._presenter.notify(
            f"“{_title(item)}” was not saved when the program last ended, {when}{more}.",
            "warning",
            "Restore",
            lambda: self.restore(item),
        )
        return True

    def restore(self, item: Recoverable) -> bool:
        """Show unsaved work again, as unsaved; returns whether it is shown."""
        if not self._files.may_discard():
            return False
        if not self.journal.adopt(item):
            self._presenter.notify("That work has been restored elsewhere.", "info")
            return False
        self._files.show_unsaved(item.document, item.target)
        if not self.offer():
            self._presenter.notify(f"Restored “{_title(item)}”; it is not saved yet.")
        return True

    def _clear_if_saved(self) -> None:
        if not self._presenter.session.is_modified:
            self.journal.clear()

    def _take_preferences(self, wanted: preferences.Preferences) -> None:
        if wanted.autosave_seconds:
            self._timer.start(1000 * wanted.autosave_seconds)
        else:
            self._timer.stop()
            self.journal.clear()


def _title(item: Recoverable) -> str:
    return item.target.stem if item.target else item.document.name
