"""The pen: draws the profile from nothing, or on from an end, one stroke a step of undo."""

from __future__ import annotations

from decimal import Decimal

from PySide6.QtCore import Qt

from app.hand.canvas import Canvas
from app.hand.coordinates import DesignPoint, GridSteps, ScreenPoint
from app.hand.keys import NUDGES, keys_of
from app.hand.snapping import DragKeys
from app.profile_editor.tools import pen_picture
from app.profile_editor.tools.pen_strokes import NO_KEYS, PenStrokes

_PLACES = (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter)
_ENDS = (Qt.Key.Key_Return, Qt.Key.Key_Enter)


class PenTool(PenStrokes):
    """Click for a corner, drag for a smooth point.

    On an untouched blank document the first segment replaces the one that is there; else the pen
    goes on from the end that it takes up. Each stroke is one undo entry, and undo gives the pen
    back what it had before.
    """

    # The mouse.

    def press(self, at: ScreenPoint, keys: DragKeys) -> None:
        """Do what a press means here; a drag goes on with it."""
        self._cursor = None
        self._press_at(at, keys)

    def move(self, at: ScreenPoint | None, keys: DragKeys) -> None:
        """Show what a press would do, or draw out the handles of what was placed."""
        self._keys = keys
        if at is None:
            if not self.held:
                self._pointer = self._aim = None
            return
        self._pointer, self._cursor, self._refused = at, None, False
        if self.held:
            self._drag(at, keys)
        else:
            self._aim = self._aimed(at, keys)

    def modified(self, keys: DragKeys) -> None:
        """Aim, or draw out, again with other keys held."""
        self._keys = keys
        at = self._at
        if at is None:
            return
        if self.held:
            self._drag(at, keys)
        else:
            self._aim = self._aimed(at, keys)

    # The keyboard.

    def wants(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Want the arrows, what places a point or ends the run, and Backspace in a run."""
        held = modifiers & ~(
            Qt.KeyboardModifier.ShiftModifier
            | Qt.KeyboardModifier.KeypadModifier
            | Qt.KeyboardModifier.AltModifier
        )
        if held:
            return False
        if key in NUDGES or key == Qt.Key.Key_Space:
            return True
        if key in _ENDS:
            return self.busy or self._cursor is not None
        return key in (Qt.Key.Key_Backspace, Qt.Key.Key_Delete) and self.busy

    def key(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Move the pen's own cursor, place a point there, end the run or take a stroke back."""
        keys = keys_of(modifiers)
        if key in NUDGES:
            self._step(NUDGES[key], large=bool(modifiers & Qt.KeyboardModifier.ShiftModifier))
        elif key == Qt.Key.Key_Space and self.held and self._cursor is None:
            self._carries = True
        elif key in _PLACES and self._cursor is not None:
            if not self.held:
                self._press_at(self._screen(self._cursor.pair), keys)
            if key in _ENDS:
                self._put_down()
        elif key in _ENDS:
            self._end_run()
        elif key in (Qt.Key.Key_Backspace, Qt.Key.Key_Delete):
            self.take_back()
        elif key == Qt.Key.Key_Space:
            return False
        return True

    def key_released(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Let go of what the space bar holds."""
        if key != Qt.Key.Key_Space:
            return False
        self._carries = False
        if self.held and self._cursor is not None:
            self._put_down()
        return True

    def _put_down(self) -> None:
        """End a stroke of the keyboard; the cursor stays on what was placed."""
        cursor = self._cursor
        if cursor is None or not self.held:
            return
        self.release(self._screen(cursor.pair), NO_KEYS)
        if self._run is None:
            self._cursor = None
        elif cursor.pair != self._run.path.last.place:
            self._cursor = DesignPoint(*self._run.path.last.place)
        else:
            # A second press of the key that placed it ends the run.
            self._cursor = None
        self._aim_again()

    def _step(self, way: tuple[int, int], *, large: bool) -> None:
        """Move the keyboard's cursor by a step of the grid, five with Shift."""
        transform = self._sheet.transform
        if self._cursor is None:
            area = self._sheet.area
            if self._run is not None:
                self._cursor = DesignPoint(*self._run.path.last.place)
            else:
                x, y = (area.left + area.right) / 2.0, (area.top + area.bottom) / 2.0
                self._cursor = transform.to_design(ScreenPoint(x, y))
        steps = GridSteps.at(transform.scale)
        step = Decimal(repr(steps.minor)) * (5 if large else 1)
        r, h = (
            float(Decimal(repr(steps.snapped(value))) + sign * step)
            for value, sign in zip(self._cursor.pair, way, strict=True)
        )
        self._cursor = DesignPoint(r, h)
        at = self._screen(self._cursor.pair)
        self._sheet.bring_in(at)
        at = self._screen(self._cursor.pair)
        if self.held:
            self._drag(at, NO_KEYS)
        else:
            self._aim = self._aimed(at, NO_KEYS)

    # The picture.

    def draw(self, canvas: Canvas) -> None:
        """Draw the run's handles, the coming segment, guides, and what a press would do."""
        pen_picture.draw(canvas, self._state())

    def told(self) -> tuple[ScreenPoint, list[str]] | None:
        """Say what a press does here, where, and how far from the last point."""
        return pen_picture.told(self._state(), self._sheet.transform.scale)

    def _state(self) -> pen_picture.PenState:
        document = self._presenter.document
        return pen_picture.PenState(
            document.profile,
            str(document.unit),
            self._run,
            self._aim,
            self.held,
            self._pull,
            self._at,
            self._cursor is not None,
            self._refused,
        )
