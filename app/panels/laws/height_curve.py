"""The curve of a law's strength along the height: how far flutes reach, where a spout sets in."""

from __future__ import annotations

from math import hypot

from PySide6.QtCore import QEvent, QPointF, QSize, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.panels.laws.height_picture import Scale, paint_heights, strengths_of
from app.panels.laws.keys_in_hand import (
    NUDGES,
    REMOVALS,
    SNAP,
    START_DISTANCE,
    STEPS,
    KeyDrag,
    keeps,
)
from app.state.window_reader import why
from app.theme import theme
from app.theme.fonts import small_font
from app.widgets.step_burst import Burst
from sgb_core.document import edits
from sgb_core.document.edits import EditError
from sgb_core.surfaces.variation import Law

REACH = 9.0
ROUND_SHARE, ROUND_STRENGTH = 0.05, 0.25
NUDGE = 0.01
_HELP = (
    "How strong the law is along the height, from the foot on the left to the rim on the right.\n"
    "Double-click adds a key, drag moves it, Del removes it; arrows nudge it (Shift: ten times),\n"
    "Page Up and Page Down choose the one before or after, Insert adds one. Ctrl drags without\n"
    "snapping. Without keys the law is as strong at every height."
)


class HeightCurve(QWidget):
    """Shows k(u) of one law of the radius and lets its keys be moved; it changes nothing itself.

    A change is ``began`` with its name, one or more ``changed`` with a law, then ``ended`` or
    ``cancelled``; ``refused`` says why there is none.
    """

    began = Signal(str)
    changed = Signal(object)
    ended = Signal()
    cancelled = Signal()
    refused = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._law: Law | None = None
        self._selected: int | None = None
        self._over: int | None = None
        self._drag: KeyDrag | None = None
        self._burst = Burst(self)
        self._burst.ended.connect(self.ended)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName("Strength along the height")
        self.setToolTip(_HELP)
        theme.notifier().changed.connect(self._theme_changed)

    def _theme_changed(self, _palette: object) -> None:
        self.update()

    # What is shown.

    def show_law(self, law: Law) -> None:
        """Show a law of the radius."""
        if law == self._law:
            return
        self._law = law
        if self._selected is not None and self._selected >= len(law.along):
            self._selected = None
        self._over = None
        self._describe()
        self.update()

    @property
    def selected(self) -> int | None:
        """The number of the selected key."""
        return self._selected

    @property
    def scale(self) -> Scale:
        """Where shares of the height and strengths lie in this widget."""
        return Scale.of(float(self.width()), float(self.height()), self._keys)

    def place(self, u: float, k: float) -> QPointF:
        """Return where a share of the height and a strength lie, in pixels."""
        return self.scale.place(u, k)

    def sizeHint(self) -> QSize:
        return QSize(220, 92)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, 80)

    @property
    def _keys(self) -> tuple[tuple[float, float], ...]:
        return self._law.along if self._law is not None else ()

    def _key_at(self, at: QPointF) -> int | None:
        away = [self.place(*key) - at for key in self._keys]
        distances = [hypot(step.x(), step.y()) for step in away]
        best = min(range(len(distances)), key=distances.__getitem__, default=None)
        return best if best is not None and distances[best] <= REACH else None

    def _select(self, index: int | None) -> None:
        self._selected = index
        self._describe()
        self.update()

    def _describe(self) -> None:
        index, words = self._selected, ""
        if index is not None and index < len(self._keys):
            u, k = self._keys[index]
            words = f"Key {index + 1} of {len(self._keys)}: {u:.0%} of the height, {k:.0%} strong"
        self.setAccessibleDescription(words)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        marked = self._over if self._over is not None else self._selected
        font, focused = small_font(self.font()), self.hasFocus()
        paint_heights(painter, self.scale, self._keys, self._selected, marked, font, focused)
        painter.end()

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
        if drag is None:
            self._over = self._key_at(at)
            held = self._over is not None
            self.setCursor(Qt.CursorShape.SizeAllCursor if held else Qt.CursorShape.CrossCursor)
            self.update()
            return
        away = at - drag.press
        if not drag.moving and hypot(away.x(), away.y()) >= START_DISTANCE:
            drag = self._drag = KeyDrag(drag.index, drag.press, drag.law, moving=True)
            self.began.emit("Move key along the height")
        if drag.moving:
            u, k = self.scale.read(self.place(*drag.law.along[drag.index]) + away)
            if not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
                u, k = self._snapped(u, k)
            self._change(edits.with_strength_moved(drag.law, drag.index, u, self._within(k)))

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
        u, k = self._snapped(*self.scale.read(at))
        self._add(min(max(u, 0.0), 1.0), self._within(k))

    def leaveEvent(self, event: QEvent) -> None:
        self._over = None
        self.update()
        super().leaveEvent(event)

    def _within(self, k: float) -> float:
        return min(max(k, self.scale.low), self.scale.high)

    def _snapped(self, u: float, k: float) -> tuple[float, float]:
        box = self.scale.plot
        near = ROUND_SHARE * round(u / ROUND_SHARE)
        u = near if abs(near - u) * box.width <= SNAP else u
        mark = ROUND_STRENGTH * round(k / ROUND_STRENGTH)
        reach = self.scale.high - self.scale.low
        return round(u, 4), mark if abs(mark - k) / reach * box.height <= SNAP else round(k, 3)

    # The keyboard.

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            busy = self._drag is not None or self._burst.active
            if keeps(event, busy=busy):
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key, index, law = event.key(), self._selected, self._law
        if key == Qt.Key.Key_Escape:
            if not self._cancel():
                event.ignore()
        elif self._drag is not None and self._drag.moving:
            event.accept()
        elif key in REMOVALS and index is not None and law is not None:
            self._select(None)
            self._one_step("Remove key along the height", edits.without_strength(law, index))
        elif key in NUDGES and index is not None and law is not None:
            far = 10.0 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1.0
            if not self._burst.active:
                self.began.emit("Nudge key along the height")
            self._burst.touch()
            (u, k), (du, dk) = law.along[index], NUDGES[Qt.Key(key)]
            step = far * NUDGE
            k = self._within(round(k + step * dk, 9))
            self._change(edits.with_strength_moved(law, index, round(u + step * du, 9), k))
        elif key in STEPS and self._keys:
            self._burst.finish()
            start = 0 if index is None else index + STEPS[Qt.Key(key)]
            self._select(start % len(self._keys))
        elif key == Qt.Key.Key_Insert and law is not None:
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

    def finish(self) -> None:
        """End a run of key steps at once."""
        self._burst.finish()

    def _insert(self) -> None:
        """Add a key on the curve, halfway from the selected one to the next or to the rim."""
        shares = [u for u, _ in self._keys]
        here = shares[self._selected] if self._selected is not None else 0.0
        after = next((u for u in shares if u > here), 1.0)
        u = (here + after) / 2.0 if shares else 0.5
        self._add(u, float(strengths_of(self._keys, [u])[0]))

    def _add(self, u: float, k: float) -> None:
        law = self._law
        if law is None:
            return
        self._burst.finish()
        try:
            # The first key alone would change the strength at every height.
            whole = law if law.along else edits.with_strength(law, 1.0 if u < 0.5 else 0.0, 1.0)
            keyed = edits.with_strength(whole, u, k)
        except EditError as error:
            self.refused.emit(why(error))
            return
        self._one_step("Add key along the height", keyed)
        self._select(min(range(len(keyed.along)), key=lambda i: abs(keyed.along[i][0] - u)))

    def _cancel(self) -> bool:
        drag, self._drag = self._drag, None
        if self._burst.drop() or (drag is not None and drag.moving):
            self.cancelled.emit()
            return True
        return drag is not None

    def _change(self, law: Law) -> None:
        # Shown at once; where the edit is refused the panel shows the document's law again.
        self._law = law
        self._describe()
        self.update()
        self.changed.emit(law)

    def _one_step(self, label: str, law: Law) -> None:
        self._burst.finish()
        self.began.emit(label)
        self._change(law)
        self.ended.emit()
