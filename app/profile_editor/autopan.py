"""Moves the paper while a point is dragged against, or beyond, the edge of the editor."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

from app.hand.coordinates import Area, ScreenPoint

# Within this many pixels of the edge the paper begins to move, the faster the farther out.
RIM = 4.0
_PART = 0.12
_FASTEST = 14.0
_MILLISECONDS = 16


class EdgePan(QObject):
    """Calls ``pan(dx, dy)`` again and again while the pointer stays at the edge."""

    def __init__(self, parent: QObject, pan: Callable[[float, float], object]) -> None:
        super().__init__(parent)
        self._pan = pan
        self._step = (0.0, 0.0)
        self._timer = QTimer(self, interval=_MILLISECONDS)
        self._timer.timeout.connect(lambda: self._pan(*self._step))

    def follow(self, at: ScreenPoint, area: Area, *, dragging: bool) -> None:
        """Take note of the pointer; without ``dragging`` the paper rests."""
        inner = area.grown(-RIM)
        beyond = (
            min(0.0, at.x - inner.left) + max(0.0, at.x - inner.right),
            min(0.0, at.y - inner.top) + max(0.0, at.y - inner.bottom),
        )
        if not dragging or beyond == (0.0, 0.0):
            self._timer.stop()
            return
        dx, dy = (max(-_FASTEST, min(_FASTEST, -_PART * far)) for far in beyond)
        self._step = (dx, dy)
        if not self._timer.isActive():
            self._timer.start()
