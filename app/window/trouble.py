"""What nobody foresaw: an exception anywhere in the window is caught, told, and gone on from."""

from __future__ import annotations

import sys
import threading
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Protocol

from PySide6.QtCore import QObject, Qt, QUrl, Signal
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QPlainTextEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.state.log import Log
from app.window.panels import PANELS
from sgb_core.values import dataclass

if TYPE_CHECKING:
    from app.state.presenter import Presenter

# Rooms, and what they are called; panels have titles of their own.
PLACES = {
    "viewport": "the viewport",
    "scene": "the viewport",
    "profile_editor": "the profile editor",
    "hand": "a drag",
    "export": "the export",
    "figures": "the figure studio",
    "film": "the film",
    "files": "opening or saving",
    "start": "the welcome",
    "settings": "the preferences",
}
APP = Path(__file__).resolve().parents[1]
NOTICES = APP / "window" / "notice_bar.py"
JOURNAL = {APP / "files" / name for name in ("journal_writer.py", "safekeeping.py")}


@dataclass(frozen=True, slots=True)
class Failure:
    """One exception: in plain words what failed, and for the log all that is known.

    One that is ``mute`` has failed in what the window says things with; after one that is
    ``unsafe`` the journal may lack a gesture.
    """

    place: str
    words: str
    details: str
    mute: bool = False
    unsafe: bool = False

    @classmethod
    def of(cls, error: BaseException) -> Failure:
        """Return the failure that an exception is."""
        frames = traceback.extract_tb(error.__traceback__)
        places = [found for frame in frames if (found := _called(Path(frame.filename)))]
        place = places[-1] if places else "the program"
        # Of one piece of code, however often it fails.
        last = frames[-1] if frames else None
        where = f"{last.filename}:{last.lineno}" if last else ""
        name = type(error).__name__
        files = {Path(frame.filename) for frame in frames}
        return cls(
            where,
            f"{place} ({name})",
            "".join(traceback.format_exception(error)),
            mute=NOTICES in files,
            unsafe=not files.isdisjoint(JOURNAL),
        )

    @property
    def comfort(self) -> str:
        """What it means for the work, in a sentence."""
        if self.unsafe:
            return "The last gestures may not be on the disk: save your work."
        return "Your work is safe, you can go on."


def _called(file: Path) -> str:
    """Return what the user calls the part of the window that a module belongs to, "" for none."""
    if not file.is_relative_to(APP):
        return ""
    room, *rest = file.relative_to(APP).with_suffix("").parts
    if room != "panels" or not rest:
        return PLACES.get(room, "")
    kinds = (kind for kind in PANELS if (kind.module or kind.key) == rest[0])
    return next((f"the {kind.title} panel" for kind in kinds), "")


class Troubled(Protocol):
    """A window that can tell of a failure."""

    presenter: Presenter

    def save_copy(self) -> bool:
        """Ask for a file, and save a copy there."""
        ...

    def window(self) -> QWidget:
        """Return what dialogs stand over."""
        ...


class Trouble(QObject):
    """Takes over what Python does with an exception that nobody caught, on all threads."""

    happened = Signal(object)

    def __init__(
        self, parent: QObject, log: Log, windows: Callable[[], Sequence[Troubled]]
    ) -> None:
        super().__init__(parent)
        self._log = log
        self._windows = windows
        self._told: set[str] = set()
        self._before = sys.excepthook, threading.excepthook
        sys.excepthook = self._caught
        threading.excepthook = self._caught_aside
        # Told between two events, and on the GUI thread wherever it happened.
        self.happened.connect(self._tell, Qt.ConnectionType.QueuedConnection)

    def close(self) -> None:
        """Give exceptions back to whoever had them."""
        sys.excepthook, threading.excepthook = self._before

    def _caught(
        self, kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        if not issubclass(kind, Exception):
            return
        if not self._windows():
            # Nobody can be told but whoever started the program.
            sys.__excepthook__(kind, error, trace)
        failure = Failure.of(error)
        # Python keeps the last exception, and with it a painter that would let nobody else paint.
        traceback.clear_frames(trace)
        # What fails at each refresh is told and written once.
        if failure.place not in self._told:
            self._told.add(failure.place)
            self._log.write(failure.details)
            self.happened.emit(failure)

    def _caught_aside(self, caught: threading.ExceptHookArgs) -> None:
        if caught.exc_value is not None:
            self._caught(caught.exc_type, caught.exc_value, caught.exc_traceback)

    def _tell(self, failure: Failure) -> None:
        windows = self._windows()
        if not windows:
            return
        window = next((w for w in windows if w.window().isActiveWindow()), windows[-1])
        if failure.mute:
            TroubleDialog(failure, window, self._log.path).show()
            return
        window.presenter.notify(
            f"Something failed in {failure.words}. {failure.comfort}",
            "error",
            "More…",
            lambda: TroubleDialog(failure, window, self._log.path).show(),
            stays=True,
        )


class TroubleDialog(QDialog):
    """What failed, and what one can do: save a copy, look at the log, or just go on."""

    def __init__(self, failure: Failure, window: Troubled, log: Path) -> None:
        super().__init__(window.window())
        self.setWindowTitle("Something failed")
        self.setModal(False)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        words = QLabel(
            f"Something failed in {failure.words}. {failure.comfort} The other parts of the window "
            "go on. To be sure, save a copy and start the program again.",
            self,
        )
        words.setWordWrap(True)
        details = QPlainTextEdit(failure.details, self)
        details.setReadOnly(True)
        details.setAccessibleName("Details for whoever mends it")
        row = QHBoxLayout()
        self.copy_button = _button(
            self, "Save a copy…", "Save the document under another name", window.save_copy
        )
        self.log_button = _button(self, "Open the log", f"Show {log}", lambda: open_log(log))
        self.go_on_button = _button(self, "Go on", "Close this (Esc)", self.close)
        self.go_on_button.setDefault(True)
        for button in (self.copy_button, self.log_button, self.go_on_button):
            row.addWidget(button)
        layout = QVBoxLayout(self)
        layout.addWidget(words)
        layout.addWidget(details, 1)
        layout.addLayout(row)
        self.resize(560, 320)


def open_log(log: Path) -> bool:
    """Show the log with what the system shows texts with."""
    return QDesktopServices.openUrl(QUrl.fromLocalFile(str(log)))


def _button(dialog: QDialog, text: str, tip: str, action: Callable[[], object]) -> QPushButton:
    button = QPushButton(text, dialog)
    button.setToolTip(tip)
    button.setAutoDefault(False)
    button.clicked.connect(lambda: action())
    return button
