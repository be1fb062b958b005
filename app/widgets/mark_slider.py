"""A slider for a real number, with a mark at its neutral value."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QSlider, QWidget

from app.theme import theme
from app.widgets.step_burst import FINER, Burst, ScrollGuard, WheelSteps, step_scale

_RADIUS = 6.5
_PAD = _RADIUS + 2.0
# The whole numbers that assistive technology reads and sets, per unit.
_TICKS = 1000
# What a number may begin with.
NUMBER_BEGINS = "0123456789.,-("
# Drags land on multiples of this: a thousand steps for ω, four to six thousand for the λ.
GRAIN = 1e-3


class MarkSlider(QSlider):
    """Slides from ``minimum`` to ``maximum``; the groove is filled from the neutral mark on.

    Signals as in a number field: ``began``, any number of ``changed``, then ``ended`` or
    ``cancelled``. Held Shift makes a drag ten times finer. The ends are reached exactly.
    ``focused`` tells that the keyboard has come to the slider or gone. A number begun while the
    mouse holds the handle is ``typed``, its first sign given: the drag is taken back, and where the
    mouse lets go the number is ``let_go`` of.
    """

    began = Signal()
    changed = Signal(float)
    ended = Signal()
    cancelled = Signal()
    focused = Signal(bool)
    typed = Signal(str)
    let_go = Signal()

    def __init__(
        self,
        low: float,
        high: float,
        neutral: float,
        step: float,
        parent: QWidget | None = None,
        *,
        grain: float = GRAIN,
    ) -> None:
        """Make a slider; steps are of ``step``, drags land on multiples of ``grain``."""
        super().__init__(Qt.Orientation.Horizontal, parent)
        self._grain = grain
        self._low, self._high, self._neutral, self._step = low, high, neutral, step
        self._value = neutral
        self._before = neutral
        self._effective = True
        self._anchor: tuple[float, float, bool] | None = None
        self._is_typed = False
        self._wheel = WheelSteps()
        self._burst = Burst(self)
        self._burst.began.connect(self.began)
        self._burst.ended.connect(self.ended)
        self.setRange(round(low * _TICKS), round(high * _TICKS))
        self.setSingleStep(round(step * _TICKS))
        self.setPageStep(round(10 * step * _TICKS))
        self._sync()
        self.valueChanged.connect(self._ticks_set)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)

    # The value.

    @property
    def number(self) -> float:
        """The value in full precision."""
        return self._value

    def set_number(self, value: float) -> None:
        """Show ``value``; emits nothing."""
        if value != self._value:
            self._value = value
            self._sync()

    @property
    def limits(self) -> tuple[float, float]:
        """From where to where it slides."""
        return self._low, self._high

    def set_limits(self, low: float, high: float, step: float, grain: float) -> None:
        """Slide from ``low`` to ``high`` from now on; the value stays, even outside."""
        self._low, self._high, self._step, self._grain = low, high, step, grain
        blocked = self.blockSignals(True)
        self.setRange(round(low * _TICKS), round(high * _TICKS))
        self.setSingleStep(max(1, round(step * _TICKS)))
        self.setPageStep(max(1, round(10 * step * _TICKS)))
        self.blockSignals(blocked)
        self._sync()

    def set_effective(self, effective: bool) -> None:
        """Draw the slider faintly where moving it would change nothing."""
        if effective != self._effective:
            self._effective = effective
            self.update()

    @property
    def dragging(self) -> bool:
        """Whether the mouse holds the handle."""
        return self._anchor is not None

    def handle_centre(self, value: float | None = None) -> QPointF:
        """Return where the handle's centre is at ``value`` (default: now), in pixels."""
        shown = self._value if value is None else value
        part = min(max((shown - self._low) / self._range, 0.0), 1.0)
        return QPointF(_PAD + part * self._span, self.height() / 2.0)

    def finish(self) -> None:
        """End a run of steps at once."""
        self._burst.finish()

    @property
    def _span(self) -> float:
        return max(self.width() - 2.0 * _PAD, 1.0)

    def _sync(self) -> None:
        blocked = self.blockSignals(True)
        self.setValue(round(self._value * _TICKS))
        self.blockSignals(blocked)
        self.update()

    def _ticks_set(self, ticks: int) -> None:
        self._step_to(ticks / _TICKS)

    def _move_to(self, value: float) -> None:
        value = min(max(value, self._low), self._high)
        if value != self._value:
            self._value = value
            self._sync()
            self.changed.emit(value)

    def _step_to(self, value: float) -> None:
        value = min(max(round(value, 10), self._low), self._high)
        if value == self._value:
            return
        if not self._burst.active:
            self._before = self._value
        self._burst.touch()
        self._move_to(value)

    # Mouse.

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            event.ignore()
            return
        self._burst.finish()
        self._before = self._value
        x = event.position().x()
        self.began.emit()
        fine = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if abs(x - self.handle_centre().x()) > _RADIUS + 2.0:
            # A press beside the handle brings it under the pointer.
            self._move_to(self._rounded(self._low + (x - _PAD) / self._span * self._range, fine))
        self._anchor = (x, self._value, fine)
        self.update()
        event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._anchor is None:
            event.ignore()
            return
        x = event.position().x()
        fine = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        start, value, was_fine = self._anchor
        if fine != was_fine:
            # From here on at the other speed, without a jump.
            start, value = x, self._value
            self._anchor = (start, value, fine)
        scale = FINER if fine else 1.0
        moved = scale * (x - start) / self._span * self._range
        if moved != 0.0 or self._value != value:
            self._move_to(self._rounded(value + moved, fine))
        event.accept()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._is_typed:
            self._is_typed = False
            self.let_go.emit()
        if event.button() == Qt.MouseButton.LeftButton and self._anchor is not None:
            self._anchor = None
            self.ended.emit()
            self.update()
        event.accept()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self.mousePressEvent(event)

    @property
    def _range(self) -> float:
        return self._high - self._low

    def _rounded(self, value: float, fine: bool) -> float:
        grain = self._grain * FINER if fine else self._grain
        return round(round(value / grain) * grain, 10)

    # Wheel and keys.

    def wheelEvent(self, event: QWheelEvent) -> None:
        if not self.isEnabled() or ScrollGuard.scrolling():
            event.ignore()
            return
        steps = self._wheel.take(event.angleDelta())
        if steps and not self.dragging:
            self._step_to(self._value + steps * self._step * step_scale(event.modifiers()))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = event.key()
        if key == Qt.Key.Key_Escape:
            if not self._cancel():
                event.ignore()
        elif self.dragging:
            event.accept()
            if event.text() and event.text() in NUMBER_BEGINS:
                self._is_typed = self._cancel()
                self.typed.emit(event.text())
        elif key in _DIRECTIONS:
            step = _DIRECTIONS[key] * self._step * step_scale(event.modifiers())
            self._step_to(self._value + step)
        elif key == Qt.Key.Key_Home:
            self._step_to(self._low)
        elif key == Qt.Key.Key_End:
            self._step_to(self._high)
        else:
            event.ignore()

    def _cancel(self) -> bool:
        was_dragging = self.dragging
        self._anchor = None
        if not (self._burst.drop() or was_dragging):
            return False
        self._value = self._before
        self._sync()
        self.cancelled.emit()
        return True

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            busy = self.dragging or self._burst.active
            typed = self.dragging and event.text() and event.text() in NUMBER_BEGINS
            if event.key() in _OWN_KEYS or typed or (busy and event.key() == Qt.Key.Key_Escape):
                event.accept()
                return True
        return super().event(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.focused.emit(True)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._burst.finish()
        self.focused.emit(False)
        super().focusOutEvent(event)

    # Drawing.

    def sizeHint(self) -> QSize:
        return QSize(110, max(22, self.fontMetrics().height() + 4))

    def minimumSizeHint(self) -> QSize:
        return QSize(60, self.sizeHint().height())

    def paintEvent(self, _event: QPaintEvent) -> None:
        palette = theme.current()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        live = self.isEnabled() and self._effective
        middle = self.height() / 2.0
        at, mark = self.handle_centre().x(), self.handle_centre(self._neutral).x()

        painter.setBrush(QColor(palette.groove))
        painter.drawRoundedRect(
            QRectF(_PAD - 2, middle - 2, self._span + 4, 4), 2, 2, Qt.SizeMode.AbsoluteSize
        )
        painter.setBrush(QColor(palette.accent if live else palette.axis))
        painter.drawRect(QRectF(min(at, mark), middle - 2, abs(at - mark), 4))
        # The neutral mark reaches above and below the groove, clear of the handle.
        painter.setBrush(QColor(palette.axis))
        painter.drawRect(QRectF(mark - 0.75, middle - 9.0, 1.5, 4.0))
        painter.drawRect(QRectF(mark - 0.75, middle + 5.0, 1.5, 4.0))

        active = self.dragging or self.underMouse() or self.hasFocus()
        edge = palette.accent if live or active else palette.axis
        painter.setPen(QPen(QColor(edge), 2.0))
        painter.setBrush(QColor(palette.accent if self.dragging else palette.field))
        painter.drawEllipse(QPointF(at, middle), _RADIUS - 1.0, _RADIUS - 1.0)
        if self.hasFocus():
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(QColor(palette.accent), 1.0))
            painter.drawEllipse(QPointF(at, middle), _RADIUS + 1.5, _RADIUS + 1.5)


_DIRECTIONS: dict[int, float] = {
    Qt.Key.Key_Right: 1.0,
    Qt.Key.Key_Up: 1.0,
    Qt.Key.Key_Left: -1.0,
    Qt.Key.Key_Down: -1.0,
    Qt.Key.Key_PageUp: 10.0,
    Qt.Key.Key_PageDown: -10.0,
}
_OWN_KEYS = frozenset((*_DIRECTIONS, Qt.Key.Key_Home, Qt.Key.Key_End))
