"""The angle-curve editor: how a shape parameter runs around the turn, with keys to drag."""

from __future__ import annotations

from math import hypot

from PySide6.QtCore import QEvent, QPointF, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QWidget

from app.panels.laws.keys_in_hand import (
    NUDGES,
    REMOVALS,
    SNAP,
    START_DISTANCE,
    STEPS,
    KeyDrag,
    keeps,
)
from app.panels.laws.plot import value_at
from app.panels.laws.sheet import AngleSheet
from app.state.window_reader import why
from app.widgets.step_burst import Burst
from sgb_core.document import edits
from sgb_core.document.edits import EditError
from sgb_core.surfaces.variation import Law

ROUND_DEGREES, ROUND_VALUE = 15.0, 0.25
# One arrow key; with Shift ten times as far.
NUDGE_DEGREES, NUDGE_VALUE = 1.0, 0.01
_HELP = (
    "How the parameter runs around the turn, from the start angle on.\n"
    "Double-click adds a key, drag moves it, Del removes it; arrows nudge it (Shift: ten times),\n"
    "Page Up and Page Down choose the one before or after. Ctrl drags without snapping,\n"
    "Shift keeps to the angle or the value. The curve stays between neighbouring keys."
)


class AngleCurve(AngleSheet):
    """Shows f(θ) of one law and lets its keys be moved; it changes nothing by itself.

    A change is ``began`` with its name, one or more ``changed`` with a law, then ``ended`` or
    ``cancelled``. ``hovered`` gives the angle under the pointer in degrees, or None.
    ``keys_wanted`` asks whether a law of several waves is to become so many keys first.
    """

    began = Signal(str)
    changed = Signal(object)
    ended = Signal()
    cancelled = Signal()
    hovered = Signal(object)
    refused = Signal(str)
    keys_wanted = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._drag: KeyDrag | None = None
        self._burst = Burst(self)
        self._burst.ended.connect(self.ended)
        self.setAccessibleName("Angle curve")
        self.setToolTip(_HELP)

    def forget(self) -> None:
        """Let go of selection and gesture, as for another law."""
        self._burst.finish()
        self._drag = self._held = self._selected = self._over = None
        self.update()

    def finish(self) -> None:
        """End a run of key steps at once."""
        self._burst.finish()

    # The mouse.

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton or self._law is None:
            event.ignore()
            return
        self._burst.finish()
        index = self._key_at(event.position())
        self._select(index)
        if index is not None:
            self._drag = KeyDrag(index, event.position(), self._law)
            self._held = index
        event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        self._pointer = at
        drag = self._drag
        if drag is None:
            self._over = self._key_at(at)
            held = self._over is not None
            self.setCursor(Qt.CursorShape.SizeAllCursor if held else Qt.CursorShape.CrossCursor)
        else:
            away = at - drag.press
            if not drag.moving and hypot(away.x(), away.y()) >= START_DISTANCE:
                drag = self._drag = KeyDrag(drag.index, drag.press, drag.law, moving=True)
                self.began.emit(f"Move key of {self._name}")
            if drag.moving:
                degrees, value = self._landing(drag, at, event.modifiers())
                self._change(edits.with_key_moved(drag.law, drag.index, degrees, value))
        inside = self.plot.box.contains(at)
        self.hovered.emit(min(max(self.plot.read(at)[0], 0.0), 360.0) if inside else None)
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        drag, self._drag, self._held = self._drag, None, None
        if drag is not None and drag.moving:
            self.ended.emit()
        self.update()
        event.accept()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if event.button() != Qt.MouseButton.LeftButton or self._law is None:
            return
        if self._key_at(at) is not None:
            self.mousePressEvent(event)
            return
        degrees, value = self.plot.read(at)
        free = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        if not free:
            degrees, value = self._snapped(degrees, value, ())
        self._add(degrees, min(max(value, 0.0), 1.0))

    def leaveEvent(self, event: QEvent) -> None:
        self._pointer = self._over = None
        self.hovered.emit(None)
        self.update()
        super().leaveEvent(event)

    def _landing(
        self, drag: KeyDrag, at: QPointF, keys: Qt.KeyboardModifier
    ) -> tuple[float, float]:
        """Return where a dragged key lands; from its own place, so that a grab never jumps."""
        plot, (old_degrees, old_value) = self.plot, drag.law.keyframes[drag.index]
        away = at - drag.press
        degrees = old_degrees + 360.0 * away.x() / plot.width
        value = old_value - away.y() / plot.height
        if not keys & Qt.KeyboardModifier.ControlModifier:
            others = [key[1] for k, key in enumerate(drag.law.keyframes) if k != drag.index]
            degrees, value = self._snapped(degrees, value, others)
        if keys & Qt.KeyboardModifier.ShiftModifier:
            if abs(away.x()) >= abs(away.y()):
                value = old_value
            else:
                degrees = old_degrees
        return degrees, value

    def _snapped(
        self, degrees: float, value: float, heights: list[float] | tuple[float, ...]
    ) -> tuple[float, float]:
        plot = self.plot
        nearest = ROUND_DEGREES * round(degrees / ROUND_DEGREES)
        close = abs(nearest - degrees) * plot.width / 360.0 <= SNAP
        degrees = nearest if close else round(degrees, 1)
        marks = [ROUND_VALUE * round(value / ROUND_VALUE), *heights]
        mark = min(marks, key=lambda each: abs(each - value))
        close = abs(mark - value) * plot.height <= SNAP
        return degrees, mark if close else round(value, 3)

    # The keyboard.

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            busy = self._drag is not None or self._burst.active
            if keeps(event, busy=busy):
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = event.key()
        if key == Qt.Key.Key_Escape:
            if not self._cancel():
                event.ignore()
        elif self._drag is not None and self._drag.moving:
            event.accept()
        elif key in REMOVALS and self._selected is not None:
            self._remove(self._selected)
        elif key in NUDGES and self._selected is not None:
            far = 10.0 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
            x, y = NUDGES[Qt.Key(key)]
            self._nudge(far * NUDGE_DEGREES * x, far * NUDGE_VALUE * y)
        elif key in STEPS and self._keys:
            self._step(STEPS[Qt.Key(key)])
        elif key == Qt.Key.Key_Insert and self._law is not None:
            self._insert()
        else:
            event.ignore()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._burst.finish()
        self.update()
        super().focusOutEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        self.update()
        super().focusInEvent(event)

    def _nudge(self, degrees: float, value: float) -> None:
        law, index = self._law, self._selected
        if law is None or index is None:
            return
        if not self._burst.active:
            self.began.emit(f"Nudge key of {self._name}")
        self._burst.touch()
        old = law.keyframes[index]
        moved = edits.with_key_moved(
            law, index, round(old[0] + degrees, 9), round(old[1] + value, 9)
        )
        self._change(moved)

    def _step(self, by: int) -> None:
        order = sorted(range(len(self._keys)), key=lambda k: self._keys[k][0] % 360.0)
        place = order.index(self._selected) + by if self._selected is not None else 0
        self._burst.finish()
        self._select(order[place % len(order)])

    def _insert(self) -> None:
        """Add a key on the curve, halfway from the selected one to the next."""
        turns = sorted(key[0] % 360.0 for key in self._keys)
        if self._selected is None or not turns:
            degrees = (turns[0] + 45.0) % 360.0 if turns else 90.0
        else:
            here = self._keys[self._selected][0] % 360.0
            after = next((turn for turn in turns if turn > here), turns[0] + 360.0)
            degrees = ((here + after) / 2.0) % 360.0
        law = self._law
        if law is not None:
            span = law.end - law.start
            self._add(degrees, (value_at(law, degrees) - law.start) / span if span else 0.5)

    def _cancel(self) -> bool:
        drag, self._drag, self._held = self._drag, None, None
        if self._burst.drop():
            self.cancelled.emit()
            return True
        if drag is not None and drag.moving:
            self.cancelled.emit()
            return True
        return drag is not None

    # Keys that come and go.

    def _add(self, degrees: float, value: float) -> None:
        law = self._law
        if law is None:
            return
        self._burst.finish()
        try:
            keys = edits.as_keyframes(law)
            if keys is not law and (law.waves or 1) > 1:
                # One key is what was asked for, not the dozens that all the waves need.
                self.keys_wanted.emit(len(keys.keyframes))
                return
            keyed = edits.with_key(keys, degrees, value)
        except EditError as error:
            self.refused.emit(why(error))
            return
        self._one_step(f"Add key to {self._name}", keyed)
        turn = degrees % 360.0
        self._select(next((k for k, key in enumerate(self._keys) if key[0] == turn), None))

    def _remove(self, index: int) -> None:
        law = self._law
        if law is None:
            return
        self._burst.finish()
        try:
            fewer = edits.without_key(law, index)
        except EditError as error:
            self.refused.emit(why(error))
            return
        self._select(None)
        self._one_step(f"Remove key of {self._name}", fewer)

    def _change(self, law: Law) -> None:
        # Shown at once; where the edit is refused the panel shows the document's law again.
        self._law = law
        self.update()
        self.changed.emit(law)

    def _one_step(self, label: str, law: Law) -> None:
        self.began.emit(label)
        self._change(law)
        self.ended.emit()
