"""The profile editor under pen, fingers and touchpad, and the right button that is held."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import (
    QContextMenuEvent,
    QMouseEvent,
    QNativeGestureEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QWidget

from app.commands import context_menu
from app.hand.coordinates import ScreenPoint
from app.hand.right_hold import RightHold
from app.hand.touch import PinchStep, Touch, swipe
from app.profile_editor.tool_sheet import ToolSheet
from app.state.presenter import Presenter
from app.widgets.radial_menu import RadialMenu

RIGHT = Qt.MouseButton.RightButton


class TouchSheet(ToolSheet):
    """A pen and one finger do what the mouse does; two fingers pan and zoom the paper.

    The right button opens the context menu when it is let go at once, and a ring of the same
    choices when it is held still.
    """

    # Qt sends events while the widget is still being made.
    _touch: Touch | None = None

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(presenter, parent)
        self.setAttribute(Qt.WidgetAttribute.WA_AcceptTouchEvents)
        self._hold = RightHold(self, self._open_ring)
        self._touch = Touch(self)

    def event(self, event: QEvent) -> bool:
        made = self._touch
        if made is None:
            return super().event(event)
        if made.take(event) or self._right(event) or self._touchpad(event):
            return True
        return super().event(event)

    # Pen and fingers.

    def pointed(self, event: QMouseEvent) -> None:
        """Take what one finger, or a pen, does as if the mouse did it."""
        if event.type() == QEvent.Type.MouseButtonPress:
            self.mousePressEvent(event)
        elif event.type() == QEvent.Type.MouseMove:
            self.mouseMoveEvent(event)
        else:
            self.mouseReleaseEvent(event)

    def pinched(self, step: PinchStep) -> None:
        """Pan and zoom the paper by a step of two fingers."""
        self._transform = self._transform.panned(step.dx, step.dy)
        self.zoom(step.factor, step.at)

    def let_go(self) -> None:
        """Drop what one finger has begun."""
        self._hand.cancel()
        if self._tool is not None and self._tool.held:
            self._tool.escape()
        self.update()

    def _touchpad(self, event: QEvent) -> bool:
        """Pan by two fingers on a touchpad, zoom by a pinch there."""
        if isinstance(event, QNativeGestureEvent):
            at = ScreenPoint(event.position().x(), event.position().y())
            if event.gestureType() == Qt.NativeGestureType.ZoomNativeGesture:
                self.zoom(max(0.2, 1.0 + event.value()), at)
                return True
            if event.gestureType() == Qt.NativeGestureType.PanNativeGesture:
                self.pinched(PinchStep(at, event.delta().x(), event.delta().y(), 1.0))
                return True
            return False
        step = swipe(event) if isinstance(event, QWheelEvent) else None
        if step is not None:
            self.pinched(step)
            event.accept()
        return step is not None

    # The right button.

    def _right(self, event: QEvent) -> bool:
        kind = event.type()
        if isinstance(event, QContextMenuEvent):
            # The menu of a press that is watched comes when the button is let go.
            mouse = event.reason() == QContextMenuEvent.Reason.Mouse
            return mouse and self._hold.watches
        if not isinstance(event, QMouseEvent):
            return False
        if kind == QEvent.Type.MouseButtonPress and event.button() == RIGHT:
            self._hold.press(event.position())
        elif kind == QEvent.Type.MouseMove:
            self._hold.move(event.position())
        elif kind == QEvent.Type.MouseButtonRelease and event.button() == RIGHT:
            self._released(event.position().toPoint())
        return False

    def _released(self, at: QPoint) -> None:
        if self._hold.release():
            reason = QContextMenuEvent.Reason.Other
            self.contextMenuEvent(QContextMenuEvent(reason, at, self.mapToGlobal(at)))

    def _open_ring(self, at: QPointF) -> None:
        """Open a ring of what can be done with the thing under a place."""
        if self._hand.gesture.edits or (self._tool is not None and self._tool.held):
            return
        handle = self._pick(ScreenPoint(at.x(), at.y()), framed=False)
        if handle is not None:
            self._hand.click(handle, shift=False)
        menu = context_menu.build(self, self._presenter, handle, self.fit_action)
        RadialMenu(menu, self).open_at(self.mapToGlobal(at.toPoint()))
