"""Rows of holes through a vessel's wall: their shape, size, number and what stays whole."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QCheckBox, QFormLayout, QLabel, QVBoxLayout, QWidget

from app.panels.solid.length_row import align, length_row, set_reach
from app.state.number_edits import NumberEdits
from app.state.presenter import Edit, Frame, Presenter
from app.widgets.combo_box import QuietComboBox
from app.widgets.number_field import NumberField
from app.widgets.slider_row import SliderRow
from sgb_core.bodies.cut_outs import CutOut, HoleShape, hole_count
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


class CutOutRows(QWidget):
    """The first pattern of holes; the file may hold more, which stay as they are."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._edits = NumberEdits(presenter, self, lambda: self.show_frame(presenter.frame))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 4, 0, 0)
        layout.setSpacing(6)
        self.shape = self._build_shape()
        self.parts = QWidget(self)
        inner = QVBoxLayout(self.parts)
        inner.setContentsMargins(0, 0, 0, 0)
        inner.setSpacing(6)
        head = QFormLayout()
        label = QLabel(SHAPE.label, self)
        label.setBuddy(self.shape)
        label.setToolTip(SHAPE.tip)
        head.addRow(label, self.shape)
        layout.addLayout(head)
        self.lengths = {row.name: self._build_length(row) for row in LENGTHS}
        align(self.lengths.values())
        for row in self.lengths.values():
            inner.addWidget(row)
        form = QFormLayout()
        self.counts = {row.name: self._build_count(row, form) for row in COUNTS}
        self.stagger = QCheckBox(STAGGER.label, self)
        self.stagger.setToolTip(STAGGER.tip)
        self.stagger.clicked.connect(self._set_stagger)
        form.addRow("", self.stagger)
        inner.addLayout(form)
        self.told = QLabel(self)
        self.told.setWordWrap(True)
        self.told.setProperty("role", "muted")
        self.told.setAccessibleName("How many holes, and what they take")
        inner.addWidget(self.told)
        layout.addWidget(self.parts)

    def _build_shape(self) -> QuietComboBox:
        box = QuietComboBox(self)
        box.addItem("None", _NONE)
        for value, text in SHAPE.titles.items():
            box.addItem(text, str(value))
        box.setAccessibleName("Holes through the wall")
        box.setToolTip("Rows of holes through the wall, as in a lantern or a colander")
        box.activated.connect(lambda at: self._choose(str(box.itemData(at))))
        return box

    def _build_length(self, length: Row) -> SliderRow:
        row = length_row(length, self.parts)
        self._edits.connect(row, length.label, partial(_setting, length.name))
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
        self._edits.connect(field, count.label, partial(_counting, count.name))
        return field

    # Editing.

    def _choose(self, shape: str) -> None:
        if shape == _NONE:
            rest = self._presenter.document.cut_outs[1:]
            self._presenter.do("No holes", partial(edits.set_cut_outs, cut_outs=rest))
        else:
            title = SHAPE.titles[HoleShape(shape)]
            self._presenter.do(f"Holes: {title.lower()}", partial(edits.set_cut_out, shape=shape))
        self.show_frame(self._presenter.frame)

    def _set_stagger(self, wanted: bool) -> None:
        self._presenter.do(STAGGER.label, partial(edits.set_cut_out, stagger=wanted))

    # Showing.

    def show_frame(self, frame: Frame) -> None:
        """Show the pattern of ``frame``."""
        document = frame.document
        first = document.cut_outs[0] if document.cut_outs else None
        with QSignalBlocker(self.shape):
            self.shape.setCurrentIndex(self.shape.findData(_NONE if first is None else first.shape))
        self.parts.setVisible(first is not None)
        self.told.setText(_told(frame))
        if first is None:
            return
        round_hole = first.shape is HoleShape.CIRCLE
        self.lengths["height"].setVisible(not round_hole)
        size = document.profile.size
        for length in LENGTHS:
            row = self.lengths[length.name]
            high = max(length.reach * size, 1e-9)
            if not frame.dragging:
                set_reach(row, high)
            row.set_number(getattr(first, length.name))
            row.field.set_unit(str(document.unit))
        for name, field in self.counts.items():
            field.set_value(float(getattr(first, name)))
        with QSignalBlocker(self.stagger):
            self.stagger.setChecked(first.stagger)


def _told(frame: Frame) -> str:
    """Return how many holes there are to be."""
    document = frame.document
    if document.solid.kind is not BodyKind.VESSEL:
        return ""
    whole = document.surface.is_full_turn
    count = sum(hole_count(pattern, whole) for pattern in document.cut_outs)
    more = len(document.cut_outs) - 1
    others = (
        f", {more} more {'pattern' if more == 1 else 'patterns'} among them" if more > 0 else ""
    )
    return f"{count} holes{others}; what they take is left out of the material."


def _setting(name: str, value: float) -> Edit:
    """Return the edit that sets a length of the first pattern."""
    change: dict[str, object] = {name: value}
    return lambda document: _changed(document, change)


def _counting(name: str, value: float) -> Edit:
    change: dict[str, object] = {name: round(value)}
    return lambda document: _changed(document, change)


def _changed(document: Document, change: dict[str, object]) -> Document:
    return edits.set_cut_out(document, **change)  # type: ignore[arg-type]
