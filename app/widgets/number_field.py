"""A field for one number: sums and units, steps by wheel and keys, one undo entry a gesture."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from PySide6.QtCore import QEvent, QObject, QPoint, Qt, Signal
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
from PySide6.QtWidgets import QMenu, QWidget

from app.widgets.field_keys import is_command
from app.widgets.number_kind import NumberKind
from app.widgets.quantity import QuantityError
from app.widgets.step_burst import Burst, ScrollGuard, WheelSteps, step_scale
from app.widgets.unit_edit import UnitEdit, sign

# A value to go back to, or what finds it when it is wanted; it may find none.
Reset = float | Callable[[], float | None]


class NumberField(UnitEdit):
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
        reset: Reset | None = None,
        above_minimum: bool = False,
        whole: bool = False,
        words: Mapping[float, str] | None = None,
        parent: QWidget | None = None,
    ) -> None:
        """Make a field for numbers of a :class:`NumberKind`.

        ``reset`` is the value that Reset goes back to, or returns it when it is wanted; the
        field begins with it where it is a number.
        """
        super().__init__(parent)
        self.kind = NumberKind(
            minimum, maximum, unit, 0 if whole else decimals, above_minimum, whole, words or {}
        )
        self._step = step
        self._reset = reset
        self._value = 0.0 if reset is None or callable(reset) else float(reset)
        self._base_tooltip = ""
        self._burst_start = 0.0
        self._just_entered = False
        self._wheel = WheelSteps()
        self._burst = Burst(self)
        self._burst.began.connect(self.began)
        self._burst.ended.connect(self.ended)
        self._offers: list[QAction] = []
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.set_suffix(sign(unit))
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
        self.kind = replace(self.kind, minimum=minimum, maximum=maximum)

    def set_unit(self, unit: str) -> None:
        """Take plain numbers in ``unit``, as :func:`parse_number` does, and show its sign."""
        self.kind = replace(self.kind, unit=unit)
        self.set_suffix(sign(unit))

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
        return self.kind.allowed

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

    def _check(self) -> None:
        try:
            self.kind.parsed(self.text())
        except QuantityError as error:
            self._set_invalid(str(error))
        else:
            self._set_invalid("")

    def take_text(self) -> bool:
        """Enter what has been typed; return whether it is a number that the field takes."""
        if not self.isModified():
            return True
        try:
            value = self.kind.parsed(self.text())
        except QuantityError as error:
            self._set_invalid(str(error))
            name = self.accessibleName().removesuffix(", number")
            self.refused.emit(f"{name}: {error}" if name else str(error))
            return False
        self.enter(value)
        return True

    def _show_value(self) -> None:
        self.setText(self.kind.text(self._value))
        self.setModified(False)
        self.setCursorPosition(0)
        self._set_invalid("")

    @property
    def _is_invalid(self) -> bool:
        return bool(self.property("invalid") == "true")

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
        if self.isModified() and not self.take_text():
            return
        value = self.kind.stepped(self._value, steps, self._step)
        if value == self._value:
            return
        if not self._burst.active:
            self._burst_start = self._value
        self._burst.touch()
        self._value = value
        self._show_value()
        self.changed.emit(value)

    # Events.

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
            # With nothing to enter, it is the dialog's key.
            event.setAccepted(self.isModified())
            if self.take_text():
                self.selectAll()
        elif key == Qt.Key.Key_Escape and self.is_busy:
            self._escape()
        else:
            super().keyPressEvent(event)

    @property
    def is_busy(self) -> bool:
        """Whether Escape would take something back: a run of steps, or what has been typed."""
        return self._burst.active or self.isModified()

    def _escape(self) -> None:
        if self._burst.drop():
            self._value = self._burst_start
            self.cancelled.emit()
        self._show_value()
        self.selectAll()

    def event(self, event: QEvent) -> bool:
        # Escape and the arrows belong to the field while it is being used, whatever is bound.
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            arrows = event.key() in (Qt.Key.Key_Up, Qt.Key.Key_Down)
            if arrows or (self.is_busy and event.key() == Qt.Key.Key_Escape):
                event.accept()
                return True
            undo = event.matches(QKeySequence.StandardKey.Undo)
            if (undo or event.matches(QKeySequence.StandardKey.Redo)) and not self.isModified():
                # With nothing typed there is nothing of the field's own to undo.
                event.ignore()
                return False
            if is_command(event):
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
        # A number is one word, whatever its point; the line edit counts on, to a third click.
        super().mouseDoubleClickEvent(event)
        self.selectAll()
        event.accept()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._burst.finish()
        popup = event.reason() == Qt.FocusReason.PopupFocusReason
        if not popup and self.isModified() and not self.take_text():
            self._show_value()
        super().focusOutEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        self.popup_menu(self, event.globalPos())

    # The menu and the label.

    def offer(self, words: str, action: Callable[[], object], tip: str = "") -> None:
        """Offer something to do with the number in its menu."""
        offered = QAction(words, self)
        offered.setToolTip(tip)
        offered.triggered.connect(lambda: action())
        self._offers.append(offered)

    def menu(self, parent: QWidget) -> QMenu:
        """Return the context menu, which the field shares with its label and its slider."""
        menu = QMenu(parent)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.setToolTipsVisible(True)
        value, enabled = self.reset_value, self.isEnabled()
        reset = menu.addAction("Reset" if value is None else f"Reset to {self.kind.text(value)}")
        reset.setEnabled(enabled and value is not None and self._value != value)
        reset.triggered.connect(self.reset)
        menu.addSeparator()
        menu.addAction("Copy value").triggered.connect(self.copy_value)
        paste = menu.addAction("Paste value")
        paste.setEnabled(enabled and bool(QGuiApplication.clipboard().text().strip()))
        paste.triggered.connect(self.paste_value)
        if self._offers:
            menu.addSeparator()
        for offered in self._offers:
            offered.setEnabled(enabled)
            menu.addAction(offered)
        return menu

    def popup_menu(self, source: QWidget, at: QPoint) -> None:
        """Open the menu at a global position, for a widget that belongs to this field."""
        self.menu(source).popup(at)

    def take_label(self, label: QWidget) -> None:
        """Let a double click on ``label`` reset the number, and a right click open its menu."""
        label.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.MouseButtonDblClick and self.isEnabled():
            self.reset()
        elif isinstance(event, QContextMenuEvent) and isinstance(watched, QWidget):
            self.popup_menu(watched, event.globalPos())
        else:
            return super().eventFilter(watched, event)
        return True

    @property
    def reset_value(self) -> float | None:
        """What Reset goes back to, None where there is no such value now."""
        return self._reset() if callable(self._reset) else self._reset

    def reset(self) -> None:
        """Go to the reset value."""
        value = self.reset_value
        if value is not None:
            self.enter(value)

    def copy_value(self) -> None:
        """Put the number, in full precision, on the clipboard."""
        QGuiApplication.clipboard().setText(repr(self._value))

    def paste_value(self) -> None:
        """Enter what the clipboard holds."""
        self.setText(QGuiApplication.clipboard().text().strip()[:200])
        self.setModified(True)
        self.take_text()
