"""What turns a stream of small steps into gestures, one undo entry each."""

from __future__ import annotations

from time import monotonic

from PySide6.QtCore import QObject, QPoint, Qt, QTimer, Signal

# Steps of the wheel or of a repeated key that follow within this time are one gesture.
BURST_MILLISECONDS = 500
# A wheel that has been scrolling a panel goes on doing so over a slider that slides under it.
SCROLL_SECONDS = 0.4

FINER, COARSER = 0.1, 10.0


def step_scale(modifiers: Qt.KeyboardModifier) -> float:
    """Return by what Shift (finer) or Ctrl (coarser) multiplies a step."""
    if modifiers & Qt.KeyboardModifier.ShiftModifier:
        return FINER
    return COARSER if modifiers & Qt.KeyboardModifier.ControlModifier else 1.0


class Burst(QObject):
    """A run of steps: ``began`` before the first, ``ended`` a moment after the last."""

    began = Signal()
    ended = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(BURST_MILLISECONDS)
        self._timer.timeout.connect(self.ended)

    @property
    def active(self) -> bool:
        """Whether a run is under way."""
        return self._timer.isActive()

    def touch(self) -> None:
        """Note a step, which begins a run or goes on with it."""
        if not self.active:
            self.began.emit()
        self._timer.start()

    def finish(self) -> None:
        """End the run at once; nothing happens where none is under way."""
        if self.active:
            self._timer.stop()
            self.ended.emit()

    def drop(self) -> bool:
        """End the run without a word, for who cancels it; return whether there was one."""
        was_active = self.active
        self._timer.stop()
        return was_active


class WheelSteps:
    """Gathers a wheel's turning, which may come in small parts, into whole steps."""

    def __init__(self) -> None:
        self._rest = 0

    def take(self, delta: QPoint) -> int:
        """Return the whole steps that have come together with this turn, up positive."""
        # Some platforms turn a wheel with a modifier held into a horizontal one.
        self._rest += delta.y() or delta.x()
        steps = int(self._rest / 120)
        self._rest -= steps * 120
        return steps


class ScrollGuard:
    """Remembers when a panel was last scrolled, so that sliders leave that wheel alone."""

    _last = -SCROLL_SECONDS

    @classmethod
    def scrolled(cls) -> None:
        """Note that a panel has just been scrolled with the wheel."""
        cls._last = monotonic()

    @classmethod
    def scrolling(cls) -> bool:
        """Whether a wheel that turns now belongs to the panel, not to what lies under it."""
        return monotonic() - cls._last < SCROLL_SECONDS
