"""Ctrl+C, SIGTERM, SIGHUP and the desktop's end of session: the work is kept, then all ends."""

from __future__ import annotations

import signal
import socket
from collections.abc import Callable, Iterable
from typing import Protocol

from PySide6.QtCore import QObject, QSocketNotifier, Qt
from PySide6.QtGui import QGuiApplication, QSessionManager

# Windows knows no hangup.
ENDING = tuple(
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
)
# What shells add to the number of the signal that ended a program.
BY_SIGNAL = 128


class Signals(QObject):
    """Hands the signals that end a program to the event loop, where windows can be closed."""

    def __init__(self, parent: QObject, end: Callable[[int], object]) -> None:
        """``end`` is called with the number of a signal."""
        super().__init__(parent)
        self._end = end
        self._read, self._written = socket.socketpair()
        for each in (self._read, self._written):
            each.setblocking(False)
        # While the event loop waits, Python's own handlers would wait with it.
        self._wakeup = signal.set_wakeup_fd(self._written.fileno(), warn_on_full_buffer=False)
        self._before = {each: signal.signal(each, _nothing) for each in ENDING}
        self._notifier = QSocketNotifier(self._read.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._arrived)

    def _arrived(self) -> None:
        for number in self._read.recv(64):
            if number in ENDING:
                self._end(number)

    def close(self) -> None:
        """Give the signals back to whoever had them."""
        self._notifier.setEnabled(False)
        for number, handler in self._before.items():
            signal.signal(number, handler)
        signal.set_wakeup_fd(self._wakeup)
        self._read.close()
        self._written.close()


def _nothing(*_: object) -> None:
    """Stand in for the handler that would end the program at once."""


class Asking(Protocol):
    """What a window answers at the end of a session."""

    def flush(self) -> bool:
        """Have all work on the disk."""
        ...

    def may_end(self) -> bool:
        """Ask about unsaved work; return whether the window may go."""
        ...


def follow_session(app: QGuiApplication, windows: Callable[[], Iterable[Asking]]) -> None:
    """Keep the work when the desktop's session ends, and ask where the platform lets one ask."""

    def commit(manager: QSessionManager) -> None:
        asked = list(windows())
        for window in asked:
            window.flush()
        if not manager.allowsInteraction():
            return
        if not all(window.may_end() for window in asked):
            manager.cancel()
        manager.release()

    # The answer is wanted before the signal returns.
    app.commitDataRequest.connect(commit, Qt.ConnectionType.DirectConnection)
