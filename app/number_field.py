"""A field for one number: sums and units, steps by wheel and keys, one undo entry a gesture."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint, QSize, Qt, Signal
from PySide6.QtGui import (
    QAction,
    QContextMenuEvent,
    QFocusEvent,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QLineEdit, QMenu, QWidget

from app.gesture import Burst, ScrollGuard, WheelSteps, step_scale
from app.quantity import QuantityError, format_number, parse_number

__all__ = ["NumberField", "QuantityError", "format_number", "parse_number"]


class NumberField(QLineEdit):
    """Shows and takes one number.

    A change by the user is ``began``, one or more ``changed``, then ``ended`` or ``cancelled``;
    typing, a run of wheel steps and a held key are one gesture each. ``refused`` says in words
    why a text was not taken. :meth:`set_value` emits nothing.
    """

    began = Signal()
    changed = Signal(float)
    ended = Signal()
    cancelled = Signal()
    refused = Signal(str)

    def __init__(
        self,
        *,
        minimum: float | None = None,
        maximum: float | None = None,
        step: float = 1.0,
        decimals: int = 3,
        unit: str = "",
        reset: float | None = None,
        above_minimum: bool = False,
        parent: QWidget | None = None,
    ) -> None:
        """Make a field for numbers from ``minimum`` to ``maximum`` (None: no limit).

        ``above_minimum`` leaves out the minimum itself. ``decimals`` limits what is shown, never
        what is kept. ``reset`` is the value that the menu's Reset goes back to.
        """
        super().__init__(parent)
        self._minimum, self._maximum = minimum, maximum
        self._above_minimum = above_minimum
        self._step, self._decimals, self._unit = step, decimals, unit
        self._reset = reset
        self._value = 0.0
        self._base_tooltip = ""
        self._burst_start = 0.0
        self._just_entered = False
        self._wheel = WheelSteps()
        self._burst = Burst(self)
        self._burst.began.connect(self.began)
        self._burst.ended.connect(self.ended)
        self._extra_actions: list[QAction] = []
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.textEdited.connect(self._check)
        self._show_value()

    # The value.

    @property
    def value(self) -> float:
        """The number in full precision, in the field's unit."""
        return self._value

    def set_value(self, value: float) -> None:
        """Show ``value``; a text that is being typed stays until it is entered or dropped."""
        if value == self._value and not self._is_invalid:
            return
        self._value = value
        if not (self.hasFocus() and self.isModified()):
            self._show_value()

    def set_range(self, minimum: float | None, maximum: float | None) -> None:
        """Allow numbers from ``minimum`` to ``maximum``, None for no limit."""
        self._minimum, self._maximum = minimum, maximum

    def set_unit(self, unit: str) -> None:
        """Take plain numbers in ``unit``, as :func:`parse_number` does."""
        self._unit = unit

    def set_step(self, step: float) -> None:
        """Change by ``step`` for each notch of the wheel and each arrow key."""
        self._step = step

    def set_help(self, text: str) -> None:
        """Set the tooltip shown while the text is in order."""
        self._base_tooltip = text
        if not self._is_invalid:
            self.setToolTip(text)

    @property
    def allowed(self) -> str:
        """The allowed range in words."""
        low, high = self._minimum, self._maximum
        suffix = f" {self._unit}" if self._unit else ""
        above = "above " if self._above_minimum else "at least "
        if low is not None and high is not None:
            if self._above_minimum:
                return f"above {low:g} and at most {high:g}{suffix}"
            return f"{low:g} to {high:g}{suffix}"
        if low is not None:
            return f"{above}{low:g}{suffix}"
        return f"at most {high:g}{suffix}" if high is not None else "any number"

    def add_menu_action(self, action: QAction) -> None:
        """Offer ``action`` in the context menu too."""
        self._extra_actions.append(action)

    def enter(self, value: float) -> None:
        """Change to ``value`` as if it had been typed: one whole gesture."""
        self._burst.finish()
        if value != self._value:
            self._value = value
            self.began.emit()
            self.changed.emit(value)
            self.ended.emit()
        self._show_value()

    def finish(self) -> None:
        """End a run of steps at once, as before something else happens to the document."""
        self._burst.finish()

    # Typing.

    def _parsed(self) -> float:
        value = parse_number(self.text(), self._unit)
        low, high = self._minimum, self._maximum
        below = low is not None and (value <= low if self._above_minimum else value < low)
        if below or (high is not None and value > high):
            raise QuantityError(f"{format_number(value)} is out of range; allowed: {self.allowed}")
        return value

    def _check(self) -> None:
        try:
            self._parsed()
        except QuantityError as error:
            self._set_invalid(str(error))
        else:
            self._set_invalid("")

    def _commit_text(self) -> bool:
        if not self.isModified():
            return True
        try:
            value = self._parsed()
        except QuantityError as error:
            self._set_invalid(str(error))
            self.refused.emit(str(error))
            return False
        self.enter(value)
        return True

    def _show_value(self) -> None:
        self.setText(format_number(self._value, self._decimals))
        self.setModified(False)
        self.setCursorPosition(0)
        self._set_invalid("")

    @property
    def _is_invalid(self) -> bool:
        return self.property("invalid") == "true"

    def _set_invalid(self, message: str) -> None:
        state = "true" if message else "false"
        if message:
            self.setToolTip(f"{message}\nAllowed: {self.allowed}")
        if self.property("invalid") == state:
            return
        if not message:
            self.setToolTip(self._base_tooltip)
        self.setProperty("invalid", state)
        self.style().unpolish(self)
        self.style().polish(self)

    # Steps.

    def step_by(self, steps: float) -> None:
        """Change by a number of steps, within the allowed range, as part of a run."""
        if self.isModified() and not self._commit_text():
            return
        # Rounded far below a step, so that ten steps of 0.1 make 1.
        value = round(self._value + steps * self._step, 10)
        low, high = self._minimum, self._maximum
        if low is not None:
            value = max(value, low if not self._above_minimum else low + 1e-3 * self._step)
        if high is not None:
            value = min(value, high)
        if value == self._value:
            return
        if not self._burst.active:
            self._burst_start = self._value
        self._burst.touch()
        self._value = value
        self._show_value()
        self.changed.emit(value)

    # Events.

    def sizeHint(self) -> QSize:
        width = self.fontMetrics().horizontalAdvance("0" * 6) + 14
        return QSize(width, super().sizeHint().height())

    def minimumSizeHint(self) -> QSize:
        return QSize(self.fontMetrics().horizontalAdvance("0" * 5) + 14, self.sizeHint().height())

    def wheelEvent(self, event: QWheelEvent) -> None:
        if not self.isEnabled() or ScrollGuard.scrolling():
            event.ignore()
            return
        steps = self._wheel.take(event.angleDelta())
        if steps:
            self.step_by(steps * step_scale(event.modifiers()))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = event.key()
        if key in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            sign = 1 if key == Qt.Key.Key_Up else -1
            self.step_by(sign * step_scale(event.modifiers()))
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._burst.finish()
            if self._commit_text():
                self.selectAll()
        elif key == Qt.Key.Key_Escape:
            self._escape()
        else:
            super().keyPressEvent(event)

    def _escape(self) -> None:
        if self._burst.drop():
            self._value = self._burst_start
            self.cancelled.emit()
        self._show_value()
        self.selectAll()

    def event(self, event: QEvent) -> bool:
        # Escape and the arrows belong to the field while it is being used, whatever the
        # window's shortcuts say.
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            busy = self._burst.active or self.isModified()
            arrows = event.key() in (Qt.Key.Key_Up, Qt.Key.Key_Down)
            if arrows or (busy and event.key() == Qt.Key.Key_Escape):
                event.accept()
                return True
            undo = event.matches(QKeySequence.StandardKey.Undo)
            if (undo or event.matches(QKeySequence.StandardKey.Redo)) and not self.isModified():
                # With nothing typed there is nothing of the field's own to undo.
                event.ignore()
                return False
        return super().event(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        if event.reason() in (Qt.FocusReason.TabFocusReason, Qt.FocusReason.BacktabFocusReason):
            self.selectAll()
        self._just_entered = event.reason() == Qt.FocusReason.MouseFocusReason

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        super().mouseReleaseEvent(event)
        # The click that comes into the field takes the whole number; a drag takes its part.
        if self._just_entered and not self.hasSelectedText():
            self.selectAll()
        self._just_entered = False

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        # A number is one word, whatever its point.
        self.selectAll()
        event.accept()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._burst.finish()
        popup = event.reason() == Qt.FocusReason.PopupFocusReason
        if not popup and self.isModified() and not self._commit_text():
            self._show_value()
        super().focusOutEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        self.menu(self).popup(event.globalPos())

    # The menu.

    def menu(self, parent: QWidget) -> QMenu:
        """Return the context menu, which the parts of a row share."""
        menu = QMenu(parent)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        if self._reset is not None:
            reset = menu.addAction(f"Reset to {self._reset:g}")
            reset.setEnabled(self._value != self._reset)
            reset.triggered.connect(self.reset)
            menu.addSeparator()
        menu.addAction("Copy value").triggered.connect(self.copy_value)
        paste = menu.addAction("Paste value")
        paste.setEnabled(bool(QGuiApplication.clipboard().text().strip()))
        paste.triggered.connect(self.paste_value)
        if self._extra_actions:
            menu.addSeparator()
            menu.addActions(self._extra_actions)
        return menu

    def popup_menu(self, source: QObject, at: QPoint) -> None:
        """Open the menu at a global position, for a widget that belongs to this field."""
        self.menu(source if isinstance(source, QWidget) else self).popup(at)

    def reset(self) -> None:
        """Go to the reset value."""
        if self._reset is not None:
            self.enter(self._reset)

    def copy_value(self) -> None:
        """Put the number, in full precision, on the clipboard."""
        QGuiApplication.clipboard().setText(repr(self._value))

    def paste_value(self) -> None:
        """Enter what the clipboard holds."""
        self.setText(QGuiApplication.clipboard().text().strip()[:200])
        self.setModified(True)
        self._commit_text()
