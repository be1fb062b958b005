"""A veil over a window, below what is laid over it: the eye goes to that, a click leaves it."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

_VEIL = QColor(0, 0, 0, 96)


class Scrim(QWidget):
    """Dims the whole window; ``clicked`` tells that somebody wants back to it."""

    clicked = Signal()

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self.setAccessibleName("Back to the window")
        self.setToolTip("Back to the window (Esc)")
        self.hide()

    def cover(self) -> None:
        """Lie over all of the window, whatever its size has become."""
        self.setGeometry(self._window.rect())

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), _VEIL)
        painter.end()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        event.accept()
        self.clicked.emit()
