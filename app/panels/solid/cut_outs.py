"""Rows of holes through a vessel's wall: their shape, size, number and what stays whole."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QCheckBox, QFormLayout, QLabel, QVBoxLayout, QWidget

from app.panels.solid.drawn_holes import DrawnRows
from app.panels.solid.length_row import align, length_row, set_reach
from app.panels.solid.pattern_row import PatternRow
from app.state.number_edits import NumberEdits
from app.state.presenter import Edit, Frame, Presenter
from app.widgets.combo_box import QuietComboBox
from app.widgets.number_field import NumberField
from app.widgets.slider_row import SliderRow
from sgb_core.bodies.cut_outs import CutOut, HoleShape, place_count
from sgb_core.bodies.solid import BodyKind
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Range
from sgb_core.fields.record import Row, table_of

_TABLE = table_of(CutOut)
SHAPE, STAGGER = _TABLE.row("shape"), _TABLE.row("stagger")
COUNTS = (_TABLE.row("rows"), _TABLE.row("around"))
LENGTHS = _TABLE.lengths
_NONE = "none"
# A circle is as high as wide, a text as wide as its letters, a picture as high as it is.
_UNUSED = {HoleShape.CIRCLE: "height", HoleShape.TEXT: "width", HoleShape.PICTURE: "height"}


class CutOutRows(QWidget):
    """The patterns of holes, and the one of them that is edited."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._number = 0
        self._edits = NumberEdits(presenter, self, self._show_again)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        layout.setSpacing(6)
        self.pattern = PatternRow(self)
        self.pattern.chosen.connect(self._turn_to)
        self.pattern.added.connect(self._add)
        layout.addWidget(self.pattern)
        self.shape = self._build_shape()
        head = QFormLayout()
        label = QLabel(SHAPE.label, self)
        label.setBuddy(self.shape)
        label.setToolTip(SHAPE.tip)
        head.addRow(label, self.shape)
        layout.addLayout(head)
        self.parts = QWidget(self)
        layout.addWidget(self.parts)
        self._build_parts(QVBoxLayout(self.parts))

    def _build_shape(self) -> QuietComboBox:
        box = QuietComboBox(self)
        box.addItem("None", _NONE)
        for value, text in SHAPE.titles.items():
            box.addItem(text, str(value))
        box.setAccessibleName("Holes through the wall")
        box.setToolTip("Holes through the wall, as in a lantern or a colander")
        box.activated.connect(lambda at: self._choose(str(box.itemData(at))))
        return box

    def _build_parts(self, inner: QVBoxLayout) -> None:
        inner.setContentsMargins(0, 0, 0, 0)
        inner.setSpacing(6)
        self.drawn = DrawnRows(
            self._presenter, self._edits, self._change, self._cut_picture, self.parts
        )
        inner.addWidget(self.drawn)
        self.lengths = {row.name: self._build_length(row) for row in LENGTHS}
        align(self.lengths.values())
        for row in self.lengths.values():
            inner.addWidget(row)
        form = QFormLayout()
        self.counts = {row.name: self._build_count(row, form) for row in COUNTS}
        self.stagger = QCheckBox(STAGGER.label, self)
        self.stagger.setToolTip(STAGGER.tip)
        self.stagger.clicked.connect(
            lambda on: self._presenter.do(STAGGER.label, self._change(stagger=on))
        )
        form.addRow("", self.stagger)
        inner.addLayout(form)
        self.told = QLabel(self)
        self.told.setWordWrap(True)
        self.told.setProperty("role", "muted")
        self.told.setAccessibleName("How many holes, and what they take")
        inner.addWidget(self.told)

    def _build_length(self, length: Row) -> SliderRow:
        row = length_row(length, self.parts)
        self._edits.connect(row, length.label, partial(self._setting, length.name))
        return row

    def _build_count(self, count: Row, form: QFormLayout) -> NumberField:
        allowed = count.kind
        assert isinstance(allowed, Range)
        field = NumberField(
            minimum=allowed.low,
            maximum=allowed.high,
            step=1.0,
            whole=True,
            reset=float(getattr(CutOut(), count.name)),
            parent=self.parts,
        )
        field.setAccessibleName(count.label)
        field.setToolTip(count.tip)
        label = QLabel(count.label, self.parts)
        label.setToolTip(count.tip)
        label.setBuddy(field)
        field.take_label(label)
        form.addRow(label, field)
        self._edits.connect(field, count.label, partial(self._counting, count.name))
        return field

    # Editing.

    def _change(self, **changes: object) -> Edit:
        """Return the edit that sets fields of the pattern shown."""
        number = self._number

        def changed(document: Document) -> Document:
            return edits.set_cut_out(document, number, **changes)  # type: ignore[arg-type]

        return changed

    def _cut_picture(self, data: bytes) -> Edit:
        return partial(edits.cut_out_picture, data=data, number=self._number)

    def _setting(self, name: str, value: float) -> Edit:
        return self._change(**{name: value})

    def _counting(self, name: str, value: float) -> Edit:
        return self._change(**{name: round(value)})

    def _choose(self, shape: str) -> None:
        if shape == _NONE:
            if self._presenter.document.cut_outs:
                self._presenter.do("No holes", partial(edits.remove_cut_out, number=self._number))
        else:
            title = SHAPE.titles[HoleShape(shape)]
            self._presenter.do(f"Holes: {title.lower()}", self._change(shape=shape))
        self._show_again()

    def _add(self) -> None:
        number = len(self._presenter.document.cut_outs)
        if self._presenter.do("Another pattern", partial(edits.set_cut_out, number=number)):
            self._number = number
        self._show_again()

    def _turn_to(self, number: int) -> None:
        self._number = number
        self._show_again()

    # Showing.

    def _show_again(self) -> None:
        self.show_frame(self._presenter.frame)

    def show_frame(self, frame: Frame) -> None:
        """Show the patterns of ``frame``."""
        document = frame.document
        patterns = document.cut_outs
        self._number = max(0, min(self._number, len(patterns) - 1))
        shown = patterns[self._number] if patterns else None
        self.pattern.show_patterns([SHAPE.titles[each.shape] for each in patterns], self._number)
        with QSignalBlocker(self.shape):
            self.shape.setCurrentIndex(self.shape.findData(_NONE if shown is None else shown.shape))
        self.parts.setVisible(shown is not None)
        if shown is None:
            return
        self.told.setText(_told(frame))
        self.drawn.show_pattern(shown)
        size = document.profile.size
        for length in LENGTHS:
            row = self.lengths[length.name]
            row.setVisible(_UNUSED.get(shown.shape) != length.name)
            high = max(length.reach * size, 1e-9)
            if not frame.dragging:
                set_reach(row, high)
            row.set_number(getattr(shown, length.name))
            row.field.set_unit(str(document.unit))
        for name, field in self.counts.items():
            field.set_value(float(getattr(shown, name)))
        with QSignalBlocker(self.stagger):
            self.stagger.setChecked(shown.stagger)


def _told(frame: Frame) -> str:
    """Return how many holes there are or are to be."""
    document, body = frame.document, frame.body
    if document.solid.kind is not BodyKind.VESSEL:
        return ""
    count = None
    if not any(pattern.shape.is_drawn for pattern in document.cut_outs):
        whole = document.surface.is_full_turn
        count = sum(place_count(pattern, whole) for pattern in document.cut_outs)
    elif body is not None and body.measures and body.document.cut_outs == document.cut_outs:
        # Letters and pictures are pieces that are known when they are cut.
        count = body.measures.holes
    if count is None:
        return "What they take is left out of the material."
    more = len(document.cut_outs)
    patterns = f" in {more} patterns" if more > 1 else ""
    return f"{count} holes{patterns}; what they take is left out of the material."
