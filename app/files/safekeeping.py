"""Unsaved work is on the disk at each gesture's end; what a crash left behind is offered again."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress

from PySide6.QtCore import QObject, QSettings, Qt, Signal
from PySide6.QtWidgets import QWidget

from app.files.files import Files
from app.files.journal_writer import JournalWriter
from app.files.recovery_dialog import RecoveryDialog, title
from app.state import user_folders
from app.state.presenter import Presenter
from app.state.stored import stored_words
from app.state.unforeseen import guarded
from app.state.window_reader import why
from sgb_core.document.errors import FileError
from sgb_core.document.file import recovery
from sgb_core.document.file.journal import Journal
from sgb_core.document.file.recovery import Recoverable
from sgb_core.document.model import Document

# The names of the entries that could not be read and of which the user knows.
KEY = "entries_set_aside"


class Safekeeping(QObject):
    """The journal of one window, beside those of other windows and programs."""

    failed = Signal(object)

    def __init__(
        self,
        presenter: Presenter,
        files: Files,
        window: QWidget,
        another: Callable[[], Safekeeping],
    ) -> None:
        """``another`` opens a further window and returns its safekeeping."""
        super().__init__(files)
        self._presenter = presenter
        self._files = files
        self._window = window
        self._another = another
        self._told = False
        self._kept: Document | None = None
        self.dialog: RecoveryDialog | None = None
        self.journal = Journal(user_folders.recovery(), user_folders.locks())
        self.writer = JournalWriter(self.journal, self.failed.emit)
        self.failed.connect(self._tell, Qt.ConnectionType.QueuedConnection)
        self._unsubscribe = presenter.session.subscribe(guarded(lambda _old, _new: self._changed()))

    def _changed(self) -> None:
        session = self._presenter.session
        if not session.is_modified:
            if self._kept is not None:
                self._kept = None
                self.writer.clear()
            if not session.in_gesture:
                self.writer.prepare(session.document)
        # What a gesture shows is no work yet.
        elif not session.in_gesture and session.document is not self._kept:
            self._kept = session.document
            self.writer.put(session.document, self._files.path)

    def _tell(self, error: FileError) -> None:
        if not self._told:
            self._told = True
            self._presenter.notify(
                f"Unsaved work cannot be kept safe, save it: {why(error)}", "warning", stays=True
            )

    def flush(self) -> bool:
        """Have all work on the disk, an open gesture's too; returns whether it is."""
        self._presenter.session.commit()
        return self.writer.flush()

    def may_end(self) -> bool:
        """Ask about unsaved work at the end of a session; what is discarded is forgotten."""
        if not self._presenter.session.is_modified:
            return True
        may = self._files.may_discard()
        if may:
            self._kept = None
            self.writer.clear()
        return may

    def stop(self, *, keep: bool = False) -> None:
        """End with the window: the work was saved or thrown away on purpose, or is to be kept."""
        if keep:
            self._presenter.session.commit()
        self._unsubscribe()
        if not keep:
            self.writer.clear()
        self.writer.close()
        self._files.custody.release()
        if self.dialog is not None:
            self.dialog.close()

    # What a crash left behind.

    def offer(self) -> bool:
        """Offer all unsaved work that crashes left; returns whether there was any."""
        found = recovery.recoverable(user_folders.recovery(), user_folders.locks())
        if found:
            self.dialog = RecoveryDialog(found, self.restore, _throw_away, self._window)
            self.dialog.show()
        return bool(found)

    def restore(self, items: Sequence[Recoverable]) -> None:
        """Show unsaved work again, as unsaved: one here, where nothing would go, others aside."""
        for item in items:
            free = not self._presenter.session.is_modified and self._files.path is None
            place = self if free else self._another()
            place.take(item)

    def take(self, item: Recoverable) -> bool:
        """Show unsaved work again in this window; returns whether it is shown."""
        if not self.journal.adopt(item):
            self._presenter.notify("That work has been restored elsewhere.", "info")
            return False
        self._kept = item.document
        self._files.show_unsaved(item.document, item.target, item.seconds)
        self._presenter.notify(f"Restored “{title(item)}”; it is not saved yet.")
        return True


def _throw_away(items: Sequence[Recoverable]) -> None:
    for item in items:
        with suppress(OSError):
            item.entry.unlink()


def say_set_aside(presenter: Presenter) -> None:
    """Say once that entries could not be read, and where they lie."""
    found, settings = recovery.aside(user_folders.recovery()), QSettings()
    known = set(stored_words(KEY))
    names = [entry.name for entry in found]
    if not known.issuperset(names):
        presenter.notify(
            f"{len(found)} entries of unsaved work cannot be read; they lie in {found[0].parent}.",
            "warning",
            stays=True,
        )
    settings.setValue(KEY, names)
