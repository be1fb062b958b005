"""Turns mouse, wheel and keys over the viewport into movements of the camera."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum, auto
from math import radians
from typing import Protocol

from PySide6.QtCore import QEvent, QObject, QPointF, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent, QNativeGestureEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from app.scene_camera import Pose

# How far the object turns for a pixel of the hand, and nears for a step of the wheel.
TURN_PER_PIXEL = radians(0.42)
ZOOM_PER_STEP = 0.87
OPPOSITE = {"front": "back", "right": "left", "top": "bottom"}
VIEW_KEYS = {Qt.Key.Key_1: "front", Qt.Key.Key_3: "right", Qt.Key.Key_7: "top"}


class Hand(Enum):
    """What the pressed mouse does."""

    IDLE = auto()
    ORBIT = auto()
    PAN = auto()


class Viewport(Protocol):
    """What the navigation moves."""

    pose: Pose | None

    def move_camera(self, pose: Pose) -> None:
        """See from ``pose``, drawing plainly until the hand rests."""

    def hand_rested(self) -> None:
        """Draw in full again."""

    def set_pivot(self, x: float, y: float) -> None:
        """Turn about what is seen at (x, y), in logical pixels from the top left."""

    def set_view_direction(self, name: str) -> None:
        """See from a standard direction."""

    def fit(self) -> None:
        """See all of the object."""

    def toggle_projection(self) -> None:
        """Change between perspective and parallel."""


class Navigator(QObject):
    """An event filter on the drawing widget: it takes the events before VTK sees them."""

    def __init__(self, target: QWidget, viewport: Viewport) -> None:
        super().__init__(target)
        self._target = target
        self._viewport = viewport
        self._hand = Hand.IDLE
        self._last = QPointF()
        self._handlers: dict[QEvent.Type, Callable[..., bool]] = {
            QEvent.Type.MouseButtonPress: self._press,
            QEvent.Type.MouseMove: self._move,
            QEvent.Type.MouseButtonRelease: self._release,
            QEvent.Type.MouseButtonDblClick: self._double_click,
            QEvent.Type.Wheel: self._wheel,
            QEvent.Type.NativeGesture: self._gesture,
            QEvent.Type.KeyPress: self._key,
            QEvent.Type.KeyRelease: lambda _event: True,
            # VTK would answer these with its own interaction.
            QEvent.Type.Enter: lambda _event: True,
            QEvent.Type.Leave: lambda _event: True,
        }
        target.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        handler = self._handlers.get(event.type())
        return handler is not None and handler(event)

    def _press(self, event: QMouseEvent) -> bool:
        self._target.setFocus(Qt.FocusReason.MouseFocusReason)
        button = event.button()
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if button == Qt.MouseButton.LeftButton:
            self._hand = Hand.PAN if shift else Hand.ORBIT
        elif button == Qt.MouseButton.MiddleButton:
            self._hand = Hand.PAN
        else:
            # The right button belongs to the context menu of whoever holds the viewport.
            return False
        self._last = event.position()
        self._target.setCursor(Qt.CursorShape.ClosedHandCursor)
        return True

    def _move(self, event: QMouseEvent) -> bool:
        pose = self._viewport.pose
        if self._hand is Hand.IDLE or pose is None:
            return True
        step = event.position() - self._last
        self._last = event.position()
        if self._hand is Hand.ORBIT:
            turned = pose.orbited(-step.x() * TURN_PER_PIXEL, step.y() * TURN_PER_PIXEL)
            self._viewport.move_camera(turned)
        else:
            half = self._target.height() / 2.0
            self._viewport.move_camera(pose.panned(step.x() / half, -step.y() / half))
        return True

    def _release(self, _event: QMouseEvent) -> bool:
        if self._hand is not Hand.IDLE:
            self._hand = Hand.IDLE
            self._target.unsetCursor()
            self._viewport.hand_rested()
        return True

    def _double_click(self, event: QMouseEvent) -> bool:
        if event.button() == Qt.MouseButton.LeftButton:
            self._viewport.set_pivot(event.position().x(), event.position().y())
        return True

    def _wheel(self, event: QWheelEvent) -> bool:
        steps = event.angleDelta().y() / 120.0
        self._zoom(ZOOM_PER_STEP**steps, event.position())
        return True

    def _gesture(self, event: QNativeGestureEvent) -> bool:
        if event.gestureType() != Qt.NativeGestureType.ZoomNativeGesture:
            return False
        self._zoom(1.0 / max(0.2, 1.0 + event.value()), event.position())
        return True

    def _zoom(self, factor: float, at: QPointF) -> None:
        pose = self._viewport.pose
        if pose is None or factor == 1.0:
            return
        half = self._target.height() / 2.0
        x, y = (at.x() - self._target.width() / 2.0) / half, 1.0 - at.y() / half
        self._viewport.move_camera(pose.zoomed(factor, x, y))
        self._viewport.hand_rested()

    def _key(self, event: QKeyEvent) -> bool:
        key = Qt.Key(event.key())
        if key in VIEW_KEYS:
            name = VIEW_KEYS[key]
            opposite = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
            self._viewport.set_view_direction(OPPOSITE[name] if opposite else name)
        elif event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier:
            event.ignore()
        elif key == Qt.Key.Key_P:
            self._viewport.toggle_projection()
        elif key == Qt.Key.Key_F:
            self._viewport.fit()
        else:
            event.ignore()
        # Taken from VTK in any case; an event that is ignored goes on to the parent widget.
        return event.isAccepted()
