"""The right button: let go at once it opens a menu, held still it opens a ring of choices."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QPointF, QTimer

from app.hand.coordinates import ScreenPoint
from app.hand.drag import START_DISTANCE

HOLD = 250


class RightHold(QObject):
    """Times one press of the right button; ``held(at)`` is called where it was held still."""

    def __init__(self, parent: QObject, held: Callable[[QPointF], object]) -> None:
        super().__init__(parent)
        self._held = held
        self._at: QPointF | None = None
        # Whether the menu of this press is this object's affair.
        self.watches = False
        self._timer = QTimer(self, singleShot=True, interval=HOLD)
        self._timer.timeout.connect(self._fire)

    def press(self, at: QPointF) -> None:
        """Begin to wait."""
        self._at, self.watches = at, True
        self._timer.start()

    def move(self, at: QPointF) -> None:
        """Wait no longer once the hand has moved."""
        if self._at is not None:
            begun = ScreenPoint(self._at.x(), self._at.y())
            if begun.distance(ScreenPoint(at.x(), at.y())) >= START_DISTANCE:
                self.stop()

    def release(self) -> bool:
        """Let go; returns whether it was a short click, neither held nor moved."""
        short = self._at is not None
        self.stop()
        return short

    def stop(self) -> None:
        """Wait no longer."""
        self._at = None
        self._timer.stop()

    def _fire(self) -> None:
        at, self._at = self._at, None
        if at is not None:
            self._held(at)
