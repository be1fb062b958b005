"""Cyclic garbage is collected on the GUI thread, between two events, and nowhere else."""

from __future__ import annotations

import gc

from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtGui import QGuiApplication

INTERVAL_MILLISECONDS = 1000
# By then Qt has let go of a window that was closed.
CLOSED_MILLISECONDS = 100


class GarbageCollector(QObject):
    """Takes the place of Python's automatic collection while it lives.

    Automatic collection runs wherever an allocation happens to be: on a worker thread, or in
    the middle of setting up a viewport. If it then frees what is left of a closed window, Qt
    widgets and graphics contexts are destroyed on the wrong thread or while another context is
    in use, which crashes. Nothing is collected while a mouse button is down, so that no drag
    stutters.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        gc.disable()
        self._timer = QTimer(self, interval=INTERVAL_MILLISECONDS)
        self._timer.timeout.connect(self._look)
        self._timer.start()

    def stop(self) -> None:
        """Give collection back to Python."""
        self._timer.stop()
        gc.enable()

    def _look(self) -> None:
        if QGuiApplication.mouseButtons() == Qt.MouseButton.NoButton:
            collect_due()


def collect_due() -> None:
    """Collect the oldest generation that Python itself would collect by now, if any."""
    for generation in (2, 1, 0):
        if gc.get_count()[generation] > gc.get_threshold()[generation]:
            gc.collect(generation)
            return


def collect_closed() -> None:
    """Free the cycles of a window that is being closed, once Qt has let it go.

    A wrapper of its viewport's surface that outlived it would be taken for whatever Qt makes
    next at its address.
    """
    QTimer.singleShot(CLOSED_MILLISECONDS, lambda: gc.collect())
