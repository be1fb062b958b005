"""What the drawn surface means as an object: surface, filled solid or vessel, and its wall."""

from __future__ import annotations

from functools import partial
from math import floor, log10
from typing import Any

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QButtonGroup,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.panels.solid.cut_outs import CutOutRows
from app.panels.solid.length_row import align, length_row, set_reach
from app.state.number_edits import NumberEdits
from app.state.presenter import Edit, Frame, Presenter
from app.state.window_reader import told
from app.widgets.combo_box import QuietComboBox
from app.widgets.empty_hint import EmptyHint
from app.widgets.slider_row import SliderRow
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.fields.record import Row, table_of

_EMPTY = (
    "Choose Vessel, and the surface gets a wall, a floor and what it holds; Filled makes one solid "
    "piece of it."
)
_TABLE = table_of(Solid)
KIND = _TABLE.row("kind")
LENGTHS = _TABLE.lengths
CHOICES = tuple(row for row in _TABLE.rows if row.titles and row is not KIND)


class SolidPanel(QWidget):
    """Kind, wall, side, base, rim, drain hole, foot ring, cut-outs, and what is doubtful."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._edits = NumberEdits(presenter, self, lambda: self._show(presenter.frame))
        self._reach: list[float] = []
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 8, 8, 10)
        layout.setSpacing(7)
        layout.addLayout(self._build_kinds())
        self.meaning = QLabel(self)
        self.meaning.setWordWrap(True)
        self.meaning.setProperty("role", "muted")
        layout.addWidget(self.meaning)
        self.empty = EmptyHint("surface", _EMPTY, self)
        layout.addWidget(self.empty)
        self.wall_parts = QWidget(self)
        layout.addWidget(self.wall_parts)
        self._build_wall(self.wall_parts)
        self.findings = QLabel(self)
        self.findings.setAccessibleName("What is doubtful about the body")
        self.findings.setWordWrap(True)
        self.findings.setProperty("role", "warning")
        self.findings.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        layout.addWidget(self.findings)
        layout.addStretch(1)

    # Building.

    def _build_kinds(self) -> QHBoxLayout:
        group = QButtonGroup(self)
        self.kind_buttons: dict[BodyKind, QToolButton] = {}
        row = QHBoxLayout()
        row.setSpacing(0)
        for kind, place in zip(BodyKind, ("first", "middle", "last"), strict=True):
            button = QToolButton(self)
            button.setText(KIND.titles[kind])
            button.setToolTip(KIND.tips[kind])
            button.setAccessibleName(f"Body: {KIND.titles[kind]}")
            button.setCheckable(True)
            button.setProperty("segment", place)
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.clicked.connect(partial(self._choose, KIND, kind))
            group.addButton(button)
            self.kind_buttons[kind] = button
            row.addWidget(button, 1)
        return row

    def _build_wall(self, holder: QWidget) -> None:
        layout = QVBoxLayout(holder)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        self.rows: dict[str, SliderRow] = {}
        for length in LENGTHS:
            row = self._build_length(length, holder)
            self.rows[length.name] = row
            layout.addWidget(row)
        align(self.rows.values())
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(6)
        grid.setColumnStretch(1, 1)
        self.choices: dict[str, QuietComboBox] = {}
        for line, choice in enumerate(CHOICES):
            box = self._build_choice(choice)
            label = QLabel(choice.label, self)
            label.setToolTip(choice.tip)
            label.setBuddy(box)
            grid.addWidget(label, line, 0)
            grid.addWidget(box, line, 1)
            self.choices[choice.name] = box
        layout.addLayout(grid)
        self.cut_outs = CutOutRows(self._presenter, holder)
        layout.addWidget(self.cut_outs)

    def _build_length(self, length: Row, holder: QWidget) -> SliderRow:
        row = length_row(length, holder)
        self._edits.connect(row, length.label, partial(_setting, length.name), partial(_sizes, row))
        return row

    def _build_choice(self, choice: Row) -> QuietComboBox:
        box = QuietComboBox(self)
        for value, text in choice.titles.items():
            box.addItem(text, str(value))
        box.setAccessibleName(choice.label)
        box.setToolTip(choice.tip)
        box.activated.connect(lambda at: self._choose(choice, box.itemData(at)))
        return box

    # Editing.

    def _choose(self, row: Row, value: str, _clicked: bool = False) -> None:
        self._presenter.do(f"{row.label}: {value}", _setting(row.name, value))
        self._show(self._presenter.frame)

    # Showing.

    def refresh(self, frame: Frame) -> None:
        """Show ``frame``; what the newest finished body says is shown when it is ready."""
        self._show(frame)

    def _show(self, frame: Frame) -> None:
        solid = frame.document.solid
        self.kind_buttons[solid.kind].setChecked(True)
        _set_text(self.meaning, f"{KIND.tips[solid.kind]}.")
        self.wall_parts.setVisible(solid.kind is BodyKind.VESSEL)
        self.empty.setVisible(solid.kind is BodyKind.SURFACE)
        self._set_limits(frame.document, frame.dragging)
        for key, row in self.rows.items():
            row.set_number(getattr(solid, key))
            row.field.set_unit(str(frame.document.unit))
        for key, box in self.choices.items():
            with QSignalBlocker(box):
                box.setCurrentIndex(box.findData(str(getattr(solid, key))))
        self.cut_outs.show_frame(frame)
        self._show_findings(frame)

    def _set_limits(self, document: Document, dragging: bool) -> None:
        """Let the sliders reach as far as is sensible for an object of this size."""
        reach = [_round(row.reach * document.profile.size) for row in LENGTHS]
        if dragging or reach == self._reach or 0.0 in reach:
            return
        self._reach = reach
        for row, high in zip(LENGTHS, reach, strict=True):
            set_reach(self.rows[row.name], high)

    def _show_findings(self, frame: Frame) -> None:
        state = frame.body
        lines: tuple[str, ...] = ()
        if state is not None and state.document.solid.kind is frame.document.solid.kind:
            lines = tuple(map(told, state.findings))
        _set_text(self.findings, "\n".join(f"⚠ {line}" for line in lines))
        self.findings.setVisible(bool(lines))


def _setting(name: str, value: str | float) -> Edit:
    """Return the edit that sets the field ``name`` of the table of solids."""
    change: dict[str, Any] = {name: value}
    return lambda document: edits.set_solid(document, **change)


def _sizes(row: SliderRow) -> tuple[float, float]:
    """Return the sizes that an animation passes through: the slider's, above none."""
    high = row.slider.limits[1]
    return 0.02 * high, high


def _set_text(label: QLabel, text: str) -> None:
    if label.text() != text:
        label.setText(text)


def _round(value: float) -> float:
    """Return ``value`` rounded up to 1, 2 or 5 times a power of ten; 0 for 0."""
    if value <= 0.0:
        return 0.0
    power = 10.0 ** floor(log10(value))
    return next(step * power for step in (1.0, 2.0, 5.0, 10.0) if value <= step * power * 1.0001)
