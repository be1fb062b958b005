"""Turns mouse, wheel and keys over the viewport into movements of the camera or of handles."""

from __future__ import annotations

from collections.abc import Callable
from math import radians
from typing import Protocol

from PySide6.QtCore import QEvent, QObject, QPointF, Qt
from PySide6.QtGui import QCursor, QKeyEvent, QMouseEvent, QNativeGestureEvent, QWheelEvent
from PySide6.QtWidgets import QApplication, QWidget

from app.hand.coordinates import ScreenPoint
from app.hand.keys import modifier_of
from app.hand.preferences import wheel_turn
from app.hand.right_hold import RightHold
from app.hand.touch import TOUCHES, PinchStep, Touch, swipe
from app.scene.camera import Pose
from app.scene.standard_views import STANDARD_VIEWS
from app.viewport import view_menu
from app.viewport.hand import SurfaceHand
from app.viewport.mouse_styles import STYLES, Hand, Style, remembered
from app.widgets.radial_menu import RadialMenu

# How far the object turns for a pixel of the hand, and nears for a step of the wheel.
TURN_PER_PIXEL = radians(0.42)
ZOOM_PER_STEP = 0.87
ZOOM_PER_PIXEL = 0.992
# What an arrow key turns by; Shift turns it into a pan by this part of half the height.
TURN_PER_KEY = radians(15.0)
PAN_PER_KEY = 0.1
VIEW_KEYS = {Qt.Key(ord(view.key)): view for view in STANDARD_VIEWS.values() if view.key}
ARROWS = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, 1),
    Qt.Key.Key_Down: (0, -1),
}
ZOOM_KEYS = {Qt.Key.Key_Plus: 1, Qt.Key.Key_Equal: 1, Qt.Key.Key_Minus: -1}
# What a key alone does, and what the sheet of keys says of it.
LETTERS = {"P": ("projection", "perspective or parallel"), "F": ("fit", "fit")}
KEYS = {Qt.Key(ord(letter)): action for letter, (action, _) in LETTERS.items()}


class Viewport(Protocol):
    """What the navigation moves."""

    pose: Pose | None

    def interrupt(self) -> None:
        """Stop a view change that is under way where it is."""

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
    """An event filter on the drawing widget: it takes the events before VTK sees them.

    What the hand can grab it gets; the rest moves the camera in the chosen style.
    """

    def __init__(self, target: QWidget, viewport: Viewport, grips: SurfaceHand) -> None:
        super().__init__(target)
        self._target = target
        self._viewport = viewport
        self._grips = grips
        self._hand = Hand.IDLE
        self._pressed = Qt.MouseButton.NoButton
        self._press_at = self._last = QPointF()
        self._style = STYLES[remembered()]
        self._touch = Touch(self)
        self._hold = RightHold(self, self._open_ring)
        target.setAttribute(Qt.WidgetAttribute.WA_AcceptTouchEvents)
        self._handlers: dict[QEvent.Type, Callable[..., bool]] = {
            QEvent.Type.MouseButtonPress: self._press,
            QEvent.Type.MouseMove: self._move,
            QEvent.Type.MouseButtonRelease: self._release,
            QEvent.Type.MouseButtonDblClick: self._double_click,
            QEvent.Type.Wheel: self._wheel,
            QEvent.Type.NativeGesture: self._gesture,
            **dict.fromkeys(TOUCHES, self._touch.take),
            QEvent.Type.ShortcutOverride: self._claim,
            QEvent.Type.KeyPress: self._key,
            QEvent.Type.KeyRelease: self._key_released,
            # VTK would answer these with its own interaction.
            QEvent.Type.Enter: lambda _event: True,
            QEvent.Type.Leave: self._leave,
        }
        target.installEventFilter(self)

    def take_style(self, style: Style) -> None:
        """Let the mouse do from now on what it does in ``style``."""
        self._style = style

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        handler = self._handlers.get(event.type())
        if handler is None:
            return False
        taken = handler(event)
        if self._hand is Hand.IDLE:
            self._show_cursor()
        return taken

    def _show_cursor(self) -> None:
        shape = self._grips.cursor
        if shape is None:
            self._target.unsetCursor()
        elif self._target.cursor().shape() != shape:
            self._target.setCursor(shape)

    # The mouse.

    def _press(self, event: QMouseEvent) -> bool:
        self._target.setFocus(Qt.FocusReason.MouseFocusReason)
        self._viewport.interrupt()
        button = event.button()
        if button == Qt.MouseButton.RightButton:
            self._hold.press(event.position())
        hand = self._style.hand_for(button, event.modifiers())
        if button == Qt.MouseButton.LeftButton and self._grips.press(
            _place(event), event.modifiers()
        ):
            return True
        if self._grips.busy:
            return True
        if hand is Hand.IDLE:
            # The right button belongs to the context menu of whoever holds the viewport.
            return button != Qt.MouseButton.RightButton
        self._hand, self._pressed = hand, button
        self._last = self._press_at = event.position()
        self._grips.rest()
        self._target.setCursor(Qt.CursorShape.ClosedHandCursor)
        return True

    def _move(self, event: QMouseEvent) -> bool:
        pose = self._viewport.pose
        self._hold.move(event.position())
        if self._hand is Hand.IDLE or pose is None:
            self._grips.move(_place(event), event.modifiers())
            return True
        step = event.position() - self._last
        self._last = event.position()
        if self._hand is Hand.ORBIT:
            self._viewport.move_camera(orbited(pose, step.x(), step.y()))
        elif self._hand is Hand.PAN:
            half = self._target.height() / 2.0
            self._viewport.move_camera(pose.panned(step.x() / half, -step.y() / half))
        else:
            self._zoom(ZOOM_PER_PIXEL ** -step.y(), self._press_at)
        return True

    def _release(self, event: QMouseEvent) -> bool:
        self._hold.release()
        if event.button() == Qt.MouseButton.LeftButton:
            self._grips.release(_place(event), event.modifiers())
        if self._hand is not Hand.IDLE and event.button() == self._pressed:
            self._hand = Hand.IDLE
            self._viewport.hand_rested()
            self._grips.move(_place(event), event.modifiers())
        return True

    def _double_click(self, event: QMouseEvent) -> bool:
        if event.button() == Qt.MouseButton.LeftButton:
            self._viewport.set_pivot(event.position().x(), event.position().y())
        elif event.button() == self._style.fits_on:
            self._viewport.fit()
        return True

    def _wheel(self, event: QWheelEvent) -> bool:
        step = swipe(event)
        if step is not None:
            self.pinched(step)
            return True
        self._viewport.interrupt()
        steps = wheel_turn(event.angleDelta().y()) / 120.0
        self._zoom(ZOOM_PER_STEP**steps, event.position())
        return True

    # Pen and fingers.

    def pointed(self, event: QMouseEvent) -> None:
        """Take what one finger, or a pen, does as if the mouse did it."""
        if event.type() == QEvent.Type.MouseButtonPress:
            self._press(event)
        elif event.type() == QEvent.Type.MouseMove:
            self._move(event)
        else:
            self._release(event)
        self._show_cursor()

    def pinched(self, step: PinchStep) -> None:
        """Orbit and zoom by a step of two fingers."""
        pose = self._viewport.pose
        if pose is not None:
            self._viewport.interrupt()
            self._viewport.move_camera(orbited(pose, step.dx, step.dy))
            self._zoom(1.0 / step.factor, QPointF(step.at.x, step.at.y))
            self._viewport.hand_rested()

    def let_go(self) -> None:
        """Drop what one finger has begun."""
        self._grips.cancel()
        self._hand = Hand.IDLE

    def _open_ring(self, at: QPointF) -> None:
        """Open a ring of what can be done with the thing under a place, else with the view."""
        self._hand = Hand.IDLE
        place = ScreenPoint(at.x(), at.y())
        menu = self._grips.menu(place, self._target)
        if menu is None:
            menu = view_menu.build(self._target, self._viewport, place)
        ring = RadialMenu(menu, self._target)
        ring.open_at(self._target.mapToGlobal(at.toPoint()))

    def _gesture(self, event: QNativeGestureEvent) -> bool:
        if event.gestureType() == Qt.NativeGestureType.PanNativeGesture:
            at = ScreenPoint(event.position().x(), event.position().y())
            self.pinched(PinchStep(at, event.delta().x(), event.delta().y(), 1.0))
            return True
        if event.gestureType() != Qt.NativeGestureType.ZoomNativeGesture:
            return False
        self._viewport.interrupt()
        self._zoom(1.0 / max(0.2, 1.0 + event.value()), event.position())
        return True

    def _leave(self, _event: QEvent) -> bool:
        # Events of a pointer that has meanwhile come back are of no interest.
        if QApplication.widgetAt(QCursor.pos()) is not self._target:
            self._grips.leave()
        return True

    def _zoom(self, factor: float, at: QPointF) -> None:
        pose = self._viewport.pose
        if pose is None or factor == 1.0:
            return
        half = self._target.height() / 2.0
        x, y = (at.x() - self._target.width() / 2.0) / half, 1.0 - at.y() / half
        self._viewport.move_camera(pose.zoomed(factor, x, y))
        self._viewport.hand_rested()

    # The keyboard.

    def _claim(self, event: QKeyEvent) -> bool:
        """Keep from the window's shortcuts what is meant for the hand, or is the style's own."""
        plain = event.modifiers() == Qt.KeyboardModifier.NoModifier
        cancels = self._grips.busy and event.key() in (Qt.Key.Key_Escape, Qt.Key.Key_H)
        claimed = cancels or self._types(event) or (plain and event.key() in self._style.keys)
        event.setAccepted(claimed)
        return claimed

    def _key(self, event: QKeyEvent) -> bool:
        key = Qt.Key(event.key())
        if self._types(event):
            self._grips.type(event.key(), event.text())
            return True
        if key in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
            # Without a number the widget moves the focus; ignored here, its parent would once more.
            return self._grips.type_next(forward=key == Qt.Key.Key_Tab)
        event.setAccepted(self._take_key(key, event.modifiers()))
        # Taken from VTK in any case; an event that is ignored goes on to the parent widget.
        return event.isAccepted()

    def _types(self, event: QKeyEvent) -> bool:
        """Return whether a key is typed as a number of what is in the hand."""
        held = event.modifiers() & (
            Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
        )
        return not held and self._grips.would_type(event.key(), event.text())

    def _take_key(self, key: Qt.Key, modifiers: Qt.KeyboardModifier) -> bool:
        held = modifiers & ~Qt.KeyboardModifier.KeypadModifier
        if self._grips.busy:
            if key == Qt.Key.Key_Escape:
                return self._grips.cancel()
            self._grips.key(modifiers | modifier_of(key), key)
            return True
        if key in ARROWS and held in (
            Qt.KeyboardModifier.NoModifier,
            Qt.KeyboardModifier.ShiftModifier,
        ):
            self._step(*ARROWS[key], pan=bool(held))
            return True
        if key in ZOOM_KEYS and held in (
            Qt.KeyboardModifier.NoModifier,
            Qt.KeyboardModifier.ShiftModifier,
        ):
            middle = QPointF(self._target.width() / 2.0, self._target.height() / 2.0)
            self._zoom(ZOOM_PER_STEP ** ZOOM_KEYS[key], middle)
            return True
        return self.look(key, held)

    def look(self, key: Qt.Key, held: Qt.KeyboardModifier) -> bool:
        """Take a key of a standard view, of the projection or of fitting; also from elsewhere."""
        if key in VIEW_KEYS:
            view = VIEW_KEYS[key]
            opposite = bool(held & Qt.KeyboardModifier.ControlModifier)
            self._viewport.set_view_direction(view.opposite if opposite else view.name)
            return True
        action = self._style.keys.get(key) or KEYS.get(key)
        if held != Qt.KeyboardModifier.NoModifier or action is None:
            return False
        if action == "fit":
            self._viewport.fit()
        else:
            self._viewport.toggle_projection()
        return True

    def _step(self, right: int, up: int, *, pan: bool) -> None:
        pose = self._viewport.pose
        if pose is None:
            return
        if pan:
            moved = pose.panned(right * PAN_PER_KEY, up * PAN_PER_KEY)
        else:
            moved = pose.orbited(right * TURN_PER_KEY, up * TURN_PER_KEY)
        self._viewport.move_camera(moved)
        self._viewport.hand_rested()

    def _key_released(self, event: QKeyEvent) -> bool:
        self._grips.key(event.modifiers() & ~modifier_of(event.key()))
        return True


def orbited(pose: Pose, dx: float, dy: float) -> Pose:
    """Return the pose after the hand has turned the object by a step in pixels."""
    return pose.orbited(-dx * TURN_PER_PIXEL, dy * TURN_PER_PIXEL)


def _place(event: QMouseEvent) -> ScreenPoint:
    return ScreenPoint(event.position().x(), event.position().y())
