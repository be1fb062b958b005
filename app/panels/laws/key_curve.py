"""A curve whose keys are moved by mouse and keyboard: what all such curves have in common."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import hypot
from types import MappingProxyType
from typing import ClassVar

from PySide6.QtCore import QEvent, QPointF, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QWidget

from app.panels.laws.key_sheet import Key, KeySheet
from app.state.window_reader import why
from app.widgets.step_burst import Burst
from sgb_core.document.edits import EditError
from sgb_core.surfaces.variation import Law
from sgb_core.values import dataclass

# A key moves once the pointer has gone so many pixels; within so many it snaps to round places,
# and to what else there is.
START_DISTANCE = 3.0
SNAP = 5.0
# Which way an arrow key moves a key, across and up.
NUDGES: Mapping[Qt.Key, Key] = MappingProxyType(
    {
        Qt.Key.Key_Left: (-1.0, 0.0),
        Qt.Key.Key_Right: (1.0, 0.0),
        Qt.Key.Key_Up: (0.0, 1.0),
        Qt.Key.Key_Down: (0.0, -1.0),
    }
)
STEPS: Mapping[Qt.Key, int] = MappingProxyType({Qt.Key.Key_PageUp: -1, Qt.Key.Key_PageDown: 1})
REMOVALS = (Qt.Key.Key_Delete, Qt.Key.Key_Backspace)
HELP = (
    "Double-click adds a key, drag moves it, Del removes it; arrows nudge it (Shift: ten times),\n"
    "Page Up and Page Down choose the one before or after, Insert adds one. Ctrl drags without\n"
    "snapping, Shift straight across or up."
)


@dataclass(frozen=True, slots=True)
class KeyDrag:
    """A key in the hand: where it was pressed, and the law as it was then."""

    index: int
    press: QPointF
    law: Law
    moving: bool = False


class KeyCurve(KeySheet):
    """Lets the keys of one curve of a law be moved; it changes nothing by itself.

    A change is ``began`` with its name, one or more ``changed`` with a law, then ``ended`` or
    ``cancelled``; ``refused`` says why there is none. A kind of curve says what makes a law with
    one key elsewhere, more, or gone.
    """

    began = Signal(str)
    changed = Signal(object)
    ended = Signal()
    cancelled = Signal()
    refused = Signal(str)

    # How far one arrow key moves a key, across and up.
    NUDGE: ClassVar[Key]

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._drag: KeyDrag | None = None
        self._burst = Burst(self)
        self._burst.ended.connect(self.ended)

    # What a kind of curve says.

    def _step_name(self, verb: str) -> str:
        """Return the name of a step that moves, adds or removes one of its keys."""
        raise NotImplementedError

    def _snapped(self, at: Key, levels: list[float]) -> Key:
        """Return the round values near a pair, or one of other keys' ``levels``."""
        raise NotImplementedError

    def _moved(self, law: Law, index: int, to: Key) -> Law:
        raise NotImplementedError

    def _without(self, law: Law, index: int) -> Law:
        raise NotImplementedError

    def _with(self, law: Law, key: Key) -> Law | None:
        """Return the law with one key more; None where something is to be asked first."""
        raise NotImplementedError

    def _between(self, law: Law, selected: int | None) -> Key:
        """Return a place on the curve for one key more, halfway from the selected one on."""
        raise NotImplementedError

    @property
    def _marked(self) -> int | None:
        return super()._marked if self._drag is None else self._drag.index

    def forget(self) -> None:
        """Let go of selection and gesture, as for another law."""
        self._burst.finish()
        self._drag = self._selected = self._over = None
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
        event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at, drag = event.position(), self._drag
        self._pointer = at
        if drag is None:
            self._over = self._key_at(at)
            held = self._over is not None
            self.setCursor(Qt.CursorShape.SizeAllCursor if held else Qt.CursorShape.CrossCursor)
        else:
            away = at - drag.press
            if not drag.moving and hypot(away.x(), away.y()) >= START_DISTANCE:
                drag = self._drag = replace(drag, moving=True)
                self.began.emit(self._step_name("Move"))
            if drag.moving:
                landing = self._landing(drag, away, event.modifiers())
                self._change(self._moved(drag.law, drag.index, landing))
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        drag, self._drag = self._drag, None
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
        key = self.read(at)
        if not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            key = self._snapped(key, [])
        self._add(key)

    def leaveEvent(self, event: QEvent) -> None:
        self._pointer = self._over = None
        self.update()
        super().leaveEvent(event)

    def _landing(self, drag: KeyDrag, away: QPointF, held: Qt.KeyboardModifier) -> Key:
        """Return where a dragged key lands; from its own place, so that a grab never jumps."""
        keys = self._keys_of(drag.law)
        old = keys[drag.index]
        x, y = self.read(self._places_of(old)[0] + away)
        if not held & Qt.KeyboardModifier.ControlModifier:
            levels = [key[1] for index, key in enumerate(keys) if index != drag.index]
            x, y = self._snapped((x, y), levels)
        if held & Qt.KeyboardModifier.ShiftModifier:
            return (x, old[1]) if abs(away.x()) >= abs(away.y()) else (old[0], y)
        return x, y

    # The keyboard.

    def event(self, event: QEvent) -> bool:
        if (
            event.type() == QEvent.Type.ShortcutOverride
            and isinstance(event, QKeyEvent)
            and self._keeps(event)
        ):
            event.accept()
            return True
        return super().event(event)

    def _keeps(self, event: QKeyEvent) -> bool:
        """Whether a key is kept from the window's shortcuts; Escape while there is a gesture."""
        if event.key() == Qt.Key.Key_Escape:
            return self._drag is not None or self._burst.active
        ours = event.key() in (*NUDGES, *STEPS, *REMOVALS, Qt.Key.Key_Insert)
        return ours and not event.modifiers() & Qt.KeyboardModifier.ControlModifier

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key, index, law = event.key(), self._selected, self._law
        if key == Qt.Key.Key_Escape:
            if not self._cancel():
                event.ignore()
        elif self._drag is not None and self._drag.moving:
            event.accept()
        elif law is None:
            event.ignore()
        elif key in REMOVALS and index is not None:
            self._remove(law, index)
        elif key in NUDGES and index is not None:
            far = 10.0 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
            self._nudge(law, index, far, NUDGES[Qt.Key(key)])
        elif key in STEPS and self._keys:
            self._step(STEPS[Qt.Key(key)])
        elif key == Qt.Key.Key_Insert:
            self._add(self._between(law, index))
        else:
            event.ignore()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._burst.finish()
        self.update()
        super().focusOutEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        self.update()
        super().focusInEvent(event)

    def _nudge(self, law: Law, index: int, far: float, way: Key) -> None:
        if not self._burst.active:
            self.began.emit(self._step_name("Nudge"))
        self._burst.touch()
        x, y = self._keys[index]
        upwards = 1.0 if self.place(x, 1.0).y() < self.place(x, 0.0).y() else -1.0
        x += far * self.NUDGE[0] * way[0]
        y += far * self.NUDGE[1] * way[1] * upwards
        self._change(self._moved(law, index, (round(x, 9), round(y, 9))))

    def _step(self, by: int) -> None:
        order = sorted(range(len(self._keys)), key=lambda k: self._column(self._keys[k]))
        place = order.index(self._selected) + by if self._selected is not None else 0
        self._burst.finish()
        self._select(order[place % len(order)])

    def _cancel(self) -> bool:
        drag, self._drag = self._drag, None
        if self._burst.drop() or (drag is not None and drag.moving):
            self.cancelled.emit()
            return True
        return drag is not None

    # Keys that come and go.

    def _add(self, key: Key) -> None:
        law = self._law
        if law is None:
            return
        self._burst.finish()
        try:
            keyed = self._with(law, key)
        except EditError as error:
            self.refused.emit(why(error))
            return
        if keyed is None:
            return
        self._one_step(self._step_name("Add"), keyed)
        column, keys = self._column(key), self._keys
        self._select(min(range(len(keys)), key=lambda k: abs(self._column(keys[k]) - column)))

    def _remove(self, law: Law, index: int) -> None:
        self._burst.finish()
        try:
            fewer = self._without(law, index)
        except EditError as error:
            self.refused.emit(why(error))
            return
        self._select(None)
        self._one_step(self._step_name("Remove"), fewer)

    def _change(self, law: Law) -> None:
        # Shown at once; where the edit is refused the panel shows the document's law again.
        self._law = law
        self._describe()
        self.update()
        self.changed.emit(law)

    def _one_step(self, label: str, law: Law) -> None:
        self.began.emit(label)
        self._change(law)
        self.ended.emit()
