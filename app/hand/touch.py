"""Fingers and pens: touch and tablet events as the mouse's; two fingers as pan and pinch."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QInputDevice, QMouseEvent, QTabletEvent, QTouchEvent, QWheelEvent

from app.hand.coordinates import ScreenPoint
from sgb_core.values import dataclass

_PRESSES = {
    QEvent.Type.TabletPress: QEvent.Type.MouseButtonPress,
    QEvent.Type.TabletMove: QEvent.Type.MouseMove,
    QEvent.Type.TabletRelease: QEvent.Type.MouseButtonRelease,
}
# The events that a Touch takes.
TOUCHES = (
    *_PRESSES,
    QEvent.Type.TouchBegin,
    QEvent.Type.TouchUpdate,
    QEvent.Type.TouchEnd,
    QEvent.Type.TouchCancel,
)
# Fingers nearer to each other than this, in pixels, say nothing about a zoom.
LEAST_SPREAD = 8.0


@dataclass(frozen=True, slots=True)
class Pinch:
    """Where two fingers are: the middle between them, and how far they are apart."""

    centre: ScreenPoint
    spread: float

    @classmethod
    def of(cls, a: ScreenPoint, b: ScreenPoint) -> Pinch:
        """Return the pinch of two fingers."""
        return cls(ScreenPoint((a.x + b.x) / 2.0, (a.y + b.y) / 2.0), a.distance(b))

    def step(self, to: Pinch) -> PinchStep:
        """Return what the fingers did between this and another place of theirs."""
        near = min(self.spread, to.spread) < LEAST_SPREAD
        factor = 1.0 if near else to.spread / self.spread
        return PinchStep(
            to.centre, to.centre.x - self.centre.x, to.centre.y - self.centre.y, factor
        )


@dataclass(frozen=True, slots=True)
class PinchStep:
    """A step of two fingers: moved by (dx, dy) pixels and scaled by ``factor`` about ``at``."""

    at: ScreenPoint
    dx: float
    dy: float
    factor: float


class Touched(Protocol):
    """A view that fingers and pens work on."""

    def pointed(self, event: QMouseEvent) -> None:
        """Take what one finger, or a pen, does as if the mouse did it."""

    def pinched(self, step: PinchStep) -> None:
        """Take a step of two fingers."""

    def let_go(self) -> None:
        """Drop what one finger has begun: a second one has come."""


class Touch:
    """Feeds one view from touch and tablet events."""

    def __init__(self, view: Touched) -> None:
        self._view = view
        self._one: QPointF | None = None
        self._pinch: Pinch | None = None
        # After two fingers the last one that stays does nothing.
        self._spent = False

    def take(self, event: QEvent) -> bool:
        """Take an event; returns whether it was one of a pen's tip or of fingers."""
        if isinstance(event, QTabletEvent) and event.type() in _PRESSES:
            return self._pen(event)
        if isinstance(event, QTouchEvent):
            self._fingers(event)
            event.accept()
            return True
        return False

    def _pen(self, event: QTabletEvent) -> bool:
        left = Qt.MouseButton.LeftButton
        moves = event.type() == QEvent.Type.TabletMove
        if not moves and event.button() != left:
            return False
        self._send(_PRESSES[event.type()], event.position(), event.modifiers(), event.buttons())
        event.accept()
        return True

    def _fingers(self, event: QTouchEvent) -> None:
        points = [point.position() for point in event.points()]
        kind, ended = event.type(), event.type() in (QEvent.Type.TouchEnd, QEvent.Type.TouchCancel)
        if kind == QEvent.Type.TouchCancel or (len(points) > 1 and self._one is not None):
            if self._one is not None:
                self._view.let_go()
            self._one = None
        if ended:
            if self._one is not None:
                self._tell(QEvent.Type.MouseButtonRelease, points or [self._one], event)
            self._one = self._pinch = None
            self._spent = False
        elif len(points) > 1:
            now = Pinch.of(*(ScreenPoint(at.x(), at.y()) for at in points[:2]))
            if self._pinch is not None:
                self._view.pinched(self._pinch.step(now))
            self._pinch, self._spent = now, True
        elif points and not self._spent:
            begins = self._one is None
            kind = QEvent.Type.MouseButtonPress if begins else QEvent.Type.MouseMove
            self._tell(kind, points, event)
        if len(points) < 2:
            self._pinch = None

    def _tell(self, kind: QEvent.Type, points: Sequence[QPointF], event: QTouchEvent) -> None:
        self._one = points[0]
        held = kind != QEvent.Type.MouseButtonRelease
        buttons = Qt.MouseButton.LeftButton if held else Qt.MouseButton.NoButton
        self._send(kind, points[0], event.modifiers(), buttons)

    def _send(
        self,
        kind: QEvent.Type,
        at: QPointF,
        modifiers: Qt.KeyboardModifier,
        buttons: Qt.MouseButton,
    ) -> None:
        moves = kind == QEvent.Type.MouseMove
        button = Qt.MouseButton.NoButton if moves else Qt.MouseButton.LeftButton
        self._view.pointed(QMouseEvent(kind, at, at, button, buttons, modifiers))


def swipe(event: QWheelEvent) -> PinchStep | None:
    """Return the step of two fingers on a touchpad; None for a wheel, and where Ctrl zooms."""
    zooms = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
    if zooms or event.device().type() != QInputDevice.DeviceType.TouchPad:
        return None
    turned, moved = event.angleDelta(), event.pixelDelta()
    at = ScreenPoint(event.position().x(), event.position().y())
    # Some touchpads tell no pixels; a third of an eighth of a degree is about one.
    if moved.isNull():
        return PinchStep(at, turned.x() / 3.0, turned.y() / 3.0, 1.0)
    return PinchStep(at, moved.x(), moved.y(), 1.0)
