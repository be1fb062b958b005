"""One line of the shape panel: label, slider, number, reset; four of them make a card."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QPoint, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QEnterEvent, QFontMetrics, QKeyEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QToolButton,
    QToolTip,
    QVBoxLayout,
    QWidget,
)

from app.theme import icons
from app.theme.fonts import small_font
from app.widgets.mark_slider import GRAIN, MarkSlider
from app.widgets.number_field import NumberField

# What a tooltip is wider than its words, in pixels, with some to spare.
_AROUND_HELP = 48


class SliderRow(QWidget):
    """A slider and a number field that say the same thing.

    ``began``, ``changed``, ``ended`` and ``cancelled`` come from whichever part is used;
    ``hovered`` tells when the pointer comes over the row, or the keyboard to its slider, or goes.
    """

    began = Signal()
    changed = Signal(float)
    ended = Signal()
    cancelled = Signal()
    hovered = Signal(bool)
    refused = Signal(str)
    apply_to_all = Signal()
    animate = Signal()

    def __init__(
        self,
        label: str,
        low: float,
        high: float,
        neutral: float,
        step: float,
        *,
        unit: str = "",
        grain: float = GRAIN,
        typed: tuple[float | None, float | None] | None = None,
        above_low: bool = False,
        for_all: bool = False,
        animated: bool = False,
        parent: QWidget | None = None,
    ) -> None:
        """Make a row for values from ``low`` to ``high``; ``neutral`` is marked and reset to.

        ``typed`` is the range of the field where it is wider than the slider's; ``above_low``
        leaves out its lower end itself. ``for_all`` offers in the menu to apply the value to all
        segments, ``animated`` to move it over its range and back.
        """
        super().__init__(parent)
        # Help is shown below this: not over the neighbours, nor over the picture it speaks of.
        self._told_below: QWidget = self
        self.neutral = neutral
        self.range = (low, high)
        self.label = QLabel(label, self)
        self.slider = MarkSlider(low, high, neutral, step, self, grain=grain)
        self.field = NumberField(
            minimum=low if typed is None else typed[0],
            maximum=high if typed is None else typed[1],
            step=step,
            unit=unit,
            reset=neutral,
            above_minimum=above_low,
            parent=self,
        )
        self.reset_button = self._build_reset()
        self.field.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.slider.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.caption = self._build_caption()
        self._lay_out()
        if for_all:
            self.offer("Apply to all segments", self.apply_to_all.emit)
        if animated:
            self.offer("Animate", self.animate.emit)
        self._connect()
        self.slider.set_number(neutral)
        self.field.set_value(neutral)

    def _lay_out(self) -> None:
        self._outer = QHBoxLayout(self)
        self._outer.setContentsMargins(0, 0, 0, 0)
        self._outer.setSpacing(4)
        whole = QVBoxLayout()
        self._outer.addLayout(whole, 1)
        whole.setSpacing(0)
        whole.addWidget(self.caption)
        layout = QHBoxLayout()
        layout.setSpacing(4)
        whole.addLayout(layout)
        layout.addWidget(self.label)
        layout.addWidget(self.slider, 1)
        layout.addWidget(self.field)
        layout.addWidget(self.reset_button)

    def _build_caption(self) -> QLabel:
        caption = QLabel(self)
        caption.setProperty("role", "muted")
        caption.setFont(small_font(caption.font(), 0.88))
        caption.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        caption.hide()
        return caption

    def _build_reset(self) -> QToolButton:
        button = QToolButton(self)
        icons.bind(button, "reset")
        button.setIconSize(button.iconSize() * 0.7)
        button.setToolTip(f"Reset to {self.neutral:g}")
        policy = button.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        button.setSizePolicy(policy)
        button.hide()
        return button

    def _connect(self) -> None:
        for told in (self.label, self.slider):
            told.installEventFilter(self)
        parts: tuple[MarkSlider | NumberField, ...] = (self.slider, self.field)
        for part in parts:
            part.began.connect(self.began)
            part.changed.connect(self._take)
            part.ended.connect(self.ended)
            part.cancelled.connect(self._part_cancelled)
        self.slider.focused.connect(self._focused)
        self.slider.typed.connect(self._begin_number)
        self.slider.let_go.connect(self.field.take_text)
        self.field.refused.connect(self.refused)
        self.field.take_label(self.label)
        self.reset_button.clicked.connect(self._reset_clicked)

    @property
    def number(self) -> float:
        """The value in full precision."""
        return self.field.value

    def set_number(self, value: float) -> None:
        """Show ``value``; emits nothing."""
        if value != self.slider.number or value != self.field.value:
            self.slider.set_number(value)
            self.field.set_value(value)
            self.reset_button.setVisible(value != self.neutral)

    def set_effective(self, effective: bool) -> None:
        """Draw the row's slider faintly where moving it would change nothing."""
        self.slider.set_effective(effective)

    def set_help(self, text: str) -> None:
        """Set the tooltip of the whole row."""
        if self.label.toolTip() != text:
            self.label.setToolTip(text)
            self.slider.setToolTip(text)
            self.field.set_help(text)

    def put_before(self, picture: QWidget) -> None:
        """Let a picture stand before the slider and its caption."""
        self._outer.insertWidget(0, picture)

    def set_caption(self, text: str) -> None:
        """Say above the slider, in words, what it does."""
        if self.caption.text() != text:
            self.caption.setText(text)
            self.caption.setVisible(bool(text))

    def set_name(self, name: str) -> None:
        """Set what screen readers call the parts."""
        self.label.setAccessibleName(name)
        self.slider.setAccessibleName(name)
        self.field.setAccessibleName(f"{name}, number")
        self.reset_button.setAccessibleName(f"Reset {name}")

    def offer(self, words: str, action: Callable[[], object]) -> None:
        """Offer something to do with the number in the row's menu."""
        self.field.offer(words, action)

    def finish(self) -> None:
        """End a run of wheel or key steps at once."""
        self.slider.finish()
        self.field.finish()

    def _take(self, value: float) -> None:
        self.slider.set_number(value)
        self.field.set_value(value)
        self.reset_button.setVisible(value != self.neutral)
        self.changed.emit(value)

    def _part_cancelled(self) -> None:
        part = self.sender()
        self.set_number(part.number if isinstance(part, MarkSlider) else self.field.value)
        self.cancelled.emit()

    def _begin_number(self, text: str) -> None:
        """Go on with a number that was begun while the slider was dragged."""
        self.field.setFocus(Qt.FocusReason.OtherFocusReason)
        self.field.selectAll()
        self.field.insert(text)

    def _reset_clicked(self) -> None:
        # The button hides with the reset; the focus must not fall to some other panel.
        if self.reset_button.hasFocus():
            self.slider.setFocus(Qt.FocusReason.OtherFocusReason)
        self.field.reset()

    def _focused(self, inside: bool) -> None:
        # A pointer that rests on the row keeps it lit when the keyboard goes on.
        self.hovered.emit(inside or self.underMouse())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Enter:
            # Back from the number to the slider: another's focus may have put it out meanwhile.
            self.hovered.emit(True)
        if event.type() == QEvent.Type.ToolTip and isinstance(watched, QWidget):
            self._show_help(watched)
            return True
        if (
            watched is self.slider
            and event.type() == QEvent.Type.KeyPress
            and isinstance(event, QKeyEvent)
            and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
        ):
            self.field.setFocus(Qt.FocusReason.TabFocusReason)
            return True
        return super().eventFilter(watched, event)

    def tell_below(self, part: QWidget) -> None:
        """Show the help of the row's parts below ``part`` from now on."""
        self._told_below = part

    def _show_help(self, part: QWidget) -> None:
        below, words = self._told_below, part.toolTip()
        at = below.mapToGlobal(QPoint(0, below.height()))
        # Where there is no room to the right, Qt would show it all to the left, over the picture.
        width = QFontMetrics(QToolTip.font()).size(0, words).width() + _AROUND_HELP
        at.setX(min(at.x(), part.screen().availableGeometry().right() - width))
        QToolTip.showText(at, words, part)

    def enterEvent(self, event: QEnterEvent) -> None:
        self.hovered.emit(True)
        super().enterEvent(event)

    def leaveEvent(self, event: QEvent) -> None:
        self.hovered.emit(False)
        super().leaveEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        self.field.popup_menu(self, event.globalPos())
