"""The profile editor: the control points in the profile half-plane, under the hand."""

from __future__ import annotations

from decimal import Decimal

from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import (
    QContextMenuEvent,
    QFocusEvent,
    QHelpEvent,
    QHideEvent,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QApplication, QToolTip, QWidget

from app.commands import context_menu
from app.commands.segment import split
from app.hand.coordinates import Area, GridSteps, ScreenPoint
from app.hand.drag import State
from app.hand.handle_field import type_into
from app.hand.hit_test import Handle, Target, canonical, distinct_points, points_in
from app.hand.keys import NUDGES, keys_of, modifier_of
from app.hand.preferences import wheel_turn
from app.hand.quartic_light import QuarticLight
from app.hand.readout import lines_for
from app.profile_editor.autopan import EdgePan
from app.profile_editor.guide_sheet import GuideSheet
from app.profile_editor.tools.table import BY_KEY, SELECT
from app.state.presenter import Presenter
from app.state.view_state import ViewChanges

_ZOOMS: dict[int, float] = {
    Qt.Key.Key_Plus: 1.25,
    Qt.Key.Key_Equal: 1.25,
    Qt.Key.Key_Minus: 0.8,
}
_OWN_KEYS = (
    *NUDGES,
    *_ZOOMS,
    Qt.Key.Key_Delete,
    Qt.Key.Key_Backspace,
    Qt.Key.Key_Space,
    Qt.Key.Key_F,
)


class ProfileView(GuideSheet):
    """Shows the profile and lets every point of it be dragged, by mouse and by keyboard."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(presenter, parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self._edge_pan = EdgePan(self, self._pan_on)
        self._light = QuarticLight(presenter)
        self.setAccessibleName("Profile editor")
        self.setWhatsThis(_HELP)

    # The mouse.

    def mousePressEvent(self, event: QMouseEvent) -> None:
        at = _place(event.position())
        self._pointer = at
        middle = event.button() == Qt.MouseButton.MiddleButton
        if middle or (self._pan_ready and event.button() == Qt.MouseButton.LeftButton):
            self._hand.pan(at)
        elif event.button() == Qt.MouseButton.LeftButton and self._tool is not None:
            self._tool.press(at, keys_of(event.modifiers()))
        elif event.button() == Qt.MouseButton.LeftButton:
            self._active = self._pick(at)
            self._hand.press(at, self._active, self._profile)
        self._show_cursor()
        self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at, gesture = _place(event.position()), self._hand.gesture
        before, self._pointer = self._pointer, at
        if self._tool is not None and gesture.state is State.IDLE:
            self._tool.move(at, keys_of(event.modifiers()))
        elif gesture.state is State.IDLE or gesture.state is State.NUDGING:
            self._active = self._pick(at)
            self._light.show(self._active)
        elif gesture.state is State.PANNING and before is not None:
            self._transform = self._transform.panned(at.x - before.x, at.y - before.y)
            self._follows_size = False
        elif self._hand.pull(at, self._transform.to_design(gesture.press)):
            self._light.forget()
        self._drag(event.modifiers())
        moving = self._hand.gesture.state is State.MOVING or self._drawing
        self._edge_pan.follow(at, self.area, dragging=moving)
        self._show_cursor()
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() not in (Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton):
            return
        gesture, at = self._hand.gesture, _place(event.position())
        if gesture.state is State.BOXING:
            self._select_box(gesture.press, at, event.modifiers())
        self._hand.release(bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier))
        if self._tool is None:
            type_into(self._presenter, gesture, at, self)
            self._active = self._pick(at)
            self._light.show(self._active)
        elif event.button() == Qt.MouseButton.LeftButton:
            self._tool.release(at, keys_of(event.modifiers()))
        self._show_cursor()
        self.update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        if self._tool is not None:
            self.mousePressEvent(event)
            return
        # Quartic points often lie close to the curve; a double click means the curve.
        handle = self._pick(_place(event.position()), quartics=False)
        if handle is not None and handle.target is Target.CURVE:
            self._hand.end()
            split(self._presenter, handle.segment, handle.s)
        else:
            self.mousePressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        turned = wheel_turn(event.angleDelta().y() or event.angleDelta().x())
        self.zoom(1.0015**turned, _place(event.position()))
        self._drag(event.modifiers())
        self._tool_again(event.modifiers())
        event.accept()

    def leaveEvent(self, event: QEvent) -> None:
        self._forget_pointer()
        super().leaveEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:
        self._forget_pointer()
        super().hideEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        if self._hand.gesture.edits or (self._tool is not None and self._tool.held):
            return
        if event.reason() == QContextMenuEvent.Reason.Keyboard:
            handle, at = self._active, self.mapToGlobal(self.rect().center())
        else:
            handle, at = self._pick(_place(QPointF(event.pos())), framed=False), event.globalPos()
        if handle is not None:
            self._hand.click(handle, shift=False)
        menu = context_menu.build(self, self._presenter, handle, self.fit_action)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.popup(at)

    # The keyboard.

    def event(self, event: QEvent) -> bool:
        if (
            isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.ShortcutOverride
            and self._wants(event)
        ):
            # While the editor has the focus, these keys are its own, whatever the menus bind.
            event.accept()
            return True
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            QToolTip.showText(event.globalPos(), self._tip(_place(QPointF(event.pos()))), self)
            return True
        return super().event(event)

    def _wants(self, event: QKeyEvent) -> bool:
        if event.key() == Qt.Key.Key_Escape:
            busy = self._hand.gesture.state is not State.IDLE or self._tool is not None
            return busy or bool(self._frame.view.points)
        taken = self._tool is not None and self._tool.wants(event.key(), event.modifiers())
        if taken or self._types(event):
            return True
        if event.matches(QKeySequence.StandardKey.SelectAll):
            return True
        if event.key() == Qt.Key.Key_H and self._hand.gesture.state is State.MOVING:
            return True
        held = event.modifiers() & ~(
            Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.KeypadModifier
        )
        return (
            event.key() in _OWN_KEYS or event.key() in BY_KEY
        ) and held == Qt.KeyboardModifier.NoModifier

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key, gesture = event.key(), self._hand.gesture
        if key == Qt.Key.Key_Escape and self._wants(event):
            self._cancel()
        elif self._type(event) or self._tool_key(event):
            event.accept()
        elif key in BY_KEY and event.modifiers() == Qt.KeyboardModifier.NoModifier:
            self.take(BY_KEY[key].name)
        elif key == Qt.Key.Key_Space:
            self._pan_ready = True
        elif key == Qt.Key.Key_F:
            self.fit()
        elif key in _ZOOMS:
            centre = self.rect().center()
            self.zoom(_ZOOMS[key], ScreenPoint(centre.x(), centre.y()))
        elif event.matches(QKeySequence.StandardKey.SelectAll):
            self._presenter.set_view(points=frozenset(distinct_points(self._profile)))
        elif key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace) and gesture.state is State.IDLE:
            self._remove()
        elif key in NUDGES and gesture.state in (State.IDLE, State.NUDGING):
            self._nudge(event)
        elif gesture.steered:
            if key == Qt.Key.Key_H and not event.isAutoRepeat():
                self._hand.switch_legs()
            self._drag(event.modifiers() | modifier_of(key))
        else:
            super().keyPressEvent(event)
        self._show_cursor()
        self.update()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if event.isAutoRepeat():
            return
        if self._tool is not None:
            self._tool.key_released(event.key(), event.modifiers())
            if modifier_of(event.key()) != Qt.KeyboardModifier.NoModifier:
                self._tool.modified(keys_of(event.modifiers() & ~modifier_of(event.key())))
        if event.key() == Qt.Key.Key_Space:
            self._pan_ready = False
        elif event.key() in NUDGES and self._hand.gesture.state is State.NUDGING:
            self._hand.end()
        elif self._hand.gesture.steered:
            self._drag(event.modifiers() & ~modifier_of(event.key()))
        self._show_cursor()
        super().keyReleaseEvent(event)

    def focusNextPrevChild(self, forward: bool) -> bool:
        if not self.isVisible() or self._hand.gesture.edits:
            # Asked by Qt, for whom the focus may not stay in what is being hidden: no step.
            return super().focusNextPrevChild(forward)
        points = distinct_points(self._profile)
        chosen = canonical(self._profile, self._frame.view.points)
        edge = -1 if forward else len(points)
        there = (points.index(chosen[-1]) if chosen else edge) + (1 if forward else -1)
        if not 0 <= there < len(points):
            return super().focusNextPrevChild(forward)
        segment, index = points[there]
        self._active = Handle(Target.POINT, segment, index)
        self._pointer = None
        self._presenter.select(segment, index)
        lines = lines_for(
            self._profile,
            self._frame.evaluation.joints,
            self._active,
            self._transform.scale,
            self._unit,
        )
        self.setAccessibleDescription(", ".join(lines))
        return True

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._pan_ready = False
        if self._hand.gesture.state is State.NUDGING:
            self._hand.end()
        super().focusOutEvent(event)

    # What the events lead to.

    def _forget_pointer(self) -> None:
        if self._tool is not None:
            self._tool.move(None, keys_of(Qt.KeyboardModifier.NoModifier))
        if self._hand.gesture.state is State.IDLE:
            self._pointer = self._active = None
            self._light.show(None)
        self.update()

    def _pan_on(self, dx: float, dy: float) -> None:
        idle = self._hand.gesture.state is not State.MOVING and not self._drawing
        if idle or self._pointer is None:
            self._edge_pan.follow(ScreenPoint(0.0, 0.0), self.area, dragging=False)
            return
        self._transform = self._transform.panned(dx, dy)
        self._follows_size = False
        self._drag(QApplication.keyboardModifiers())
        self._tool_again(QApplication.keyboardModifiers())
        self.update()

    def _drag(self, modifiers: Qt.KeyboardModifier) -> None:
        if self._pointer is not None:
            self._hand.drag(self._pointer, self._transform, keys_of(modifiers))

    def _select_box(self, a: ScreenPoint, b: ScreenPoint, modifiers: Qt.KeyboardModifier) -> None:
        box = Area(min(a.x, b.x), min(a.y, b.y), max(a.x, b.x), max(a.y, b.y))
        found = points_in(self._profile, self._transform, box)
        if modifiers & Qt.KeyboardModifier.ShiftModifier:
            found |= self._frame.view.points
        changes: ViewChanges = {"points": found}
        segments = {segment for segment, _ in found}
        if segments and self._frame.view.segment not in segments:
            changes["segment"] = min(segments)
        self._presenter.set_view(**changes)

    def _cancel(self) -> None:
        if self._tool is not None and self._hand.gesture.state is State.IDLE:
            if self._tool.busy:
                self._tool.escape()
            else:
                self.take(SELECT)
            return
        if self._hand.gesture.state is State.IDLE:
            self._presenter.set_view(points=frozenset())
        self._hand.cancel()
        self._pick_again()

    def _remove(self) -> None:
        chosen = sorted(self._frame.view.points)
        context_menu.remove(self._presenter, chosen[-1][0] if chosen else self._frame.view.segment)

    def _nudge(self, event: QKeyEvent) -> None:
        points = tuple(canonical(self._profile, self._frame.view.points))
        if not points:
            return
        step = Decimal(repr(GridSteps.at(self._transform.scale).minor))
        if not event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            step /= 10
        dr, dh = NUDGES[event.key()]
        self._active = Handle(Target.POINT, *points[0])
        self._hand.nudge(points, self._profile, (dr * step, dh * step))


def _place(position: QPointF) -> ScreenPoint:
    return ScreenPoint(position.x(), position.y())


_HELP = (
    "Drag points and the dots on their legs. Arrows nudge, Shift tenfold. While dragging: a number "
    "sets it exactly, Ctrl does not snap, Shift holds, Alt breaks the joint's rule, Esc cancels. "
    "Around several selected points a frame scales them, with Shift in proportion, with Alt "
    "about the centre. Double-click the curve to split it, Del removes a segment, wheel zooms, "
    "Space and drag pans, plus and minus zoom, F fits, Tab walks through points, Ctrl+A takes all."
)
