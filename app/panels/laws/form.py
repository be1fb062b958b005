"""The form of one law over the angle: what varies, how, between which values, and its curve."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any, Literal

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QMenu,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.panels.laws.curve_editor import AngleCurve
from app.panels.laws.height_curve import HeightCurve
from app.panels.laws.pictures import shape_picture
from app.panels.laws.words import CONSTANT, CONSTANT_TIP, advice, offered, segments_text
from app.state.number_edits import PARAMETER_STEPS, Span
from app.state.window_reader import WINDOW, segment_titles
from app.widgets.combo_box import QuietComboBox
from app.widgets.labels import take_labels
from app.widgets.menu_button import open_menu
from app.widgets.number_field import NumberField
from app.widgets.slider_row import SliderRow
from sgb_core.curves.segment import PARAMETER_RANGES, neutral
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Range
from sgb_core.fields.record import Row, table_of
from sgb_core.surfaces.laws.law import LAW_RANGES, LAW_SYMBOLS, RADIUS, Law, LawParameter
from sgb_core.surfaces.laws.shapes import SHAPES

# The numbers of a law that some shapes use, and the others leave alone.
_NUMBERS = tuple(
    row
    for row in table_of(Law).rows
    if isinstance(row.kind, Range) and row.name not in ("start", "end")
)

VARIED: tuple[LawParameter, ...] = tuple(LAW_RANGES)
# Sliders of the radius' factor reach from nothing to twice; the field takes what is allowed.
_FACTOR, _FACTOR_STEP = (0.0, 2.0), 0.01

End = Literal["start", "end"]
ENDS: tuple[End, End] = ("start", "end")


class LawForm(QWidget):
    """Shows one law of a document; tells what the hand does, changes nothing by itself.

    A gesture is ``began`` with its name, then ``changed`` with a function from law to law, and
    ``ended`` or ``cancelled``. ``chosen`` is one whole step: its name and such a function;
    ``for_all`` is one too, for all laws of the same parameter. ``animated`` asks to see all values
    of a number pass: its name, the lowest and the highest, and a function from a value to such.
    """

    began = Signal(str)
    changed = Signal(object)
    ended = Signal()
    cancelled = Signal()
    refused = Signal(str)
    chosen = Signal(str, object)
    for_all = Signal(str, object)
    animated = Signal(str, float, float, object)
    removed = Signal()
    omega_wanted = Signal()
    hovered = Signal(object)
    keys_wanted = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document: Document | None = None
        self._law: Law | None = None
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 2, 0, 0)
        layout.setSpacing(5)
        layout.addLayout(self._build_choices())
        self.rows: dict[tuple[LawParameter, str], SliderRow] = {}
        for parameter in VARIED:
            for end in ENDS:
                layout.addWidget(self._build_row(parameter, end))
        self.curve, self.heights = AngleCurve(self), HeightCurve(self)
        for sheet in (self.curve, self.heights):
            sheet.began.connect(self.began)
            sheet.changed.connect(lambda law: self.changed.emit(lambda _old: law))
            sheet.ended.connect(self.ended)
            sheet.cancelled.connect(self.cancelled)
            sheet.refused.connect(self.refused)
            layout.addWidget(sheet)
        self.curve.keys_wanted.connect(self.keys_wanted)
        self.curve.hovered.connect(self.hovered)
        layout.addLayout(self._build_advice())
        take_labels(self)

    # Building.

    def _build_choices(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(5)
        grid.setColumnStretch(1, 1)
        self.parameter = QuietComboBox(self)
        for name in VARIED:
            self.parameter.addItem(LAW_SYMBOLS[name], name)
        self.parameter.setAccessibleName("Parameter that varies")
        self.parameter.setToolTip(
            "What the law moves around the turn: a shape parameter, or the radius by a factor"
        )
        self.parameter.activated.connect(self._parameter_chosen)
        self.segments = _button("", "Which segments the law governs", self)
        self.segments.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        menu = QMenu(self.segments)
        menu.aboutToShow.connect(self.fill_segments)
        open_menu(self.segments, menu)
        self.kind = QuietComboBox(self)
        self.kind.setToolTip("How the parameter goes over the angle")
        self.kind.addItem(CONSTANT, "constant")
        self.kind.setItemData(0, CONSTANT_TIP, Qt.ItemDataRole.ToolTipRole)
        for line, shape in enumerate(offered(), start=1):
            self.kind.addItem(shape_picture(shape), shape.title, shape.name)
            self.kind.setItemData(line, shape.tip, Qt.ItemDataRole.ToolTipRole)
        self.kind.setAccessibleName("Law")
        self.kind.activated.connect(self._kind_chosen)
        self.numbers = {row.name: self._build_number(row) for row in _NUMBERS}
        self.number_labels = {}
        numbers: list[QWidget] = []
        for each in _NUMBERS:
            label = self.number_labels[each.name] = QLabel(each.label, self)
            label.setBuddy(self.numbers[each.name])
            numbers += [label, self.numbers[each.name]]
        for part in numbers:
            # Shown for the shapes that use them; all together they would widen the window.
            part.hide()
        lines: tuple[tuple[str, list[QWidget]], ...] = (
            ("Vary", [self.parameter, self.segments]),
            ("Law", [self.kind]),
            ("", numbers),
        )
        for line, (text, parts) in enumerate(lines):
            if text:
                label = QLabel(text, self)
                label.setBuddy(parts[0])
                grid.addWidget(label, line, 0)
            row = QHBoxLayout()
            row.setSpacing(6)
            for part in parts:
                row.addWidget(part, 1 if part in (self.segments, self.kind) else 0)
            grid.addLayout(row, line, 1)
        return grid

    def _build_number(self, row: Row) -> NumberField:
        """Return the field of a number that some shapes use."""
        allowed = row.kind
        assert isinstance(allowed, Range)
        # What a new law of the first shape that uses it has.
        firsts = (shape.first[row.name] for shape in SHAPES.values() if row.name in shape.first)
        first: Any = next(firsts, row.default)
        usual = float(first)
        field = NumberField(
            minimum=allowed.low,
            maximum=allowed.high,
            whole=allowed.whole,
            reset=usual,
            parent=self,
        )
        field.setAccessibleName(f"Number of {row.label.lower()} {row.key}")
        field.set_help(row.tip)
        self._connect(
            field, row.label, partial(_with_number, row), lambda: (allowed.low, 2.0 * usual)
        )
        return field

    def _build_advice(self) -> QHBoxLayout:
        row = QHBoxLayout()
        self.hint = QLabel(self)
        self.hint.setWordWrap(True)
        self.hint.setProperty("role", "muted")
        self.mend = _button("ω → 1", "Set ω to 1, so that the law takes full effect", self)
        self.mend.clicked.connect(self.omega_wanted)
        row.addWidget(self.hint, 1)
        row.addWidget(self.mend)
        return row

    def _build_row(self, parameter: LawParameter, end: End) -> SliderRow:
        words = "From" if end == "start" else "To"
        if parameter == RADIUS:
            allowed = LAW_RANGES[RADIUS]
            typed = (allowed.low, allowed.high)
            row = SliderRow(words, *_FACTOR, 1.0, _FACTOR_STEP, typed=typed, parent=self)
        else:
            low, high = PARAMETER_RANGES[parameter]
            step = PARAMETER_STEPS[parameter]
            row = SliderRow(words, low, high, neutral(parameter), step, parent=self)
        row.label.setMinimumWidth(row.label.fontMetrics().horizontalAdvance("From") + 3)
        name = LAW_SYMBOLS[parameter]
        row.set_name(f"{words}, {name}")
        row.set_help(
            ("What the radius is multiplied by" if parameter == RADIUS else name)
            + " where the curve is "
            + ("at its lowest (f = 0)" if end == "start" else "at its highest (f = 1)")
        )
        self._connect(row, f"{words} of {name}", partial(_with_end, end), lambda: row.range)
        self.rows[parameter, end] = row
        return row

    def _connect(
        self,
        part: SliderRow | NumberField,
        label: str,
        change: Callable[[Law, float], Law],
        span: Span,
    ) -> None:
        part.began.connect(lambda: self.began.emit(label))
        part.changed.connect(lambda value: self.changed.emit(lambda law: change(law, value)))
        part.ended.connect(self.ended)
        part.cancelled.connect(self.cancelled)
        part.refused.connect(self.refused)
        field = part.field if isinstance(part, SliderRow) else part

        def to(value: float) -> Callable[[Law], Law]:
            return lambda law: change(law, value)

        part.offer(
            "Apply to all laws of this parameter",
            lambda: self.for_all.emit(f"{label} of all laws", to(field.value)),
        )
        part.offer("Animate", lambda: self.animated.emit(label, *span(), to))

    # What the hand chooses.

    def _parameter_chosen(self, line: int) -> None:
        parameter = VARIED[line]
        if self._law is not None and parameter != self._law.parameter:
            self.chosen.emit(
                f"Vary {LAW_SYMBOLS[parameter]}", lambda law: edits.with_parameter(law, parameter)
            )

    def _kind_chosen(self, line: int) -> None:
        if line == 0:
            self.removed.emit()
            return
        shape = SHAPES[self.kind.itemData(line)]
        if self._law is None or shape is self._law.shape:
            return
        self.forget_keys()
        self.chosen.emit(shape.title, lambda law: edits.with_shape(law, shape))

    def fill_segments(self) -> None:
        """Offer all segments and each one, checked where the law governs it."""
        menu, law = self.segments.menu(), self._law
        menu.clear()
        if law is None or self._document is None:
            return
        every = menu.addAction("All segments")
        every.setCheckable(True)
        every.setChecked(law.segments is None)
        whole = partial(replace, segments=None)
        every.triggered.connect(lambda: self.chosen.emit("Law for all segments", whole))
        menu.addSeparator()
        for number, title in enumerate(segment_titles(self._document.profile)):
            action = menu.addAction(title)
            action.setCheckable(True)
            action.setChecked(law.segments is not None and number in law.segments)
            action.triggered.connect(partial(self._toggle_segment, number))

    def _toggle_segment(self, number: int, _checked: bool = False) -> None:
        def change(law: Law) -> Law:
            chosen = set(law.segments or ()) ^ {number}
            return replace(law, segments=tuple(sorted(chosen)))

        self.chosen.emit(f"Law of {WINDOW.segment(number)}", change)

    # Showing.

    def show_law(self, document: Document, index: int) -> None:
        """Show a law of a document; controls leave alone what they show already."""
        self._document = document
        law = self._law = document.variation[index]
        with QSignalBlocker(self.parameter):
            self.parameter.setCurrentIndex(VARIED.index(law.parameter))
        with QSignalBlocker(self.kind):
            self.kind.setCurrentIndex(self.kind.findData(law.kind))
        self.kind.setToolTip(law.shape.tip)
        words = segments_text(law)
        self.segments.setText(words[0].upper() + words[1:])
        for name, field in self.numbers.items():
            field.setVisible(name in law.shape.uses)
            self.number_labels[name].setVisible(name in law.shape.uses)
            field.set_value(float(getattr(law, name)))
        for (parameter, end), row in self.rows.items():
            row.setVisible(parameter == law.parameter)
            if parameter == law.parameter:
                row.set_number(law.start if end == "start" else law.end)
        self.curve.show_law(law, LAW_SYMBOLS[law.parameter], document.revolution.sweep_deg)
        self.heights.setVisible(law.parameter == RADIUS)
        self.heights.show_law(law)
        text, missing = advice(document, index)
        if self.hint.text() != text:
            self.hint.setText(text)
        self.mend.setVisible(missing is not None)

    def paint_pictures(self) -> None:
        """Draw the shapes in the theme's colours, which may have changed."""
        for line, shape in enumerate(offered(), start=1):
            self.kind.setItemIcon(line, shape_picture(shape))

    def forget_keys(self) -> None:
        """Let go of both curves' keys, as for another law."""
        self.curve.forget()
        self.heights.forget()

    def finish(self) -> None:
        """End runs of wheel or key steps at once."""
        self.curve.finish()
        self.heights.finish()
        for field in self.numbers.values():
            field.finish()
        for row in self.rows.values():
            row.finish()


def _with_end(end: End, law: Law, value: float) -> Law:
    return replace(law, start=value) if end == "start" else replace(law, end=value)


def _button(text: str, tip: str, parent: QWidget) -> QToolButton:
    button = QToolButton(parent)
    button.setText(text)
    button.setToolTip(tip)
    button.setAccessibleName(tip)
    button.setProperty("segment", "only")
    return button


def _with_number(row: Row, law: Law, value: float) -> Law:
    """Return a law with another number, where its shape uses it."""
    if row.name not in law.shape.uses:
        return law
    assert isinstance(row.kind, Range)
    change: dict[str, Any] = {row.name: round(value) if row.kind.whole else value}
    return replace(law, **change)
