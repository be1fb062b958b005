"""The left side of the figure studio: a plate's settings as controls, and back."""

from __future__ import annotations

from dataclasses import replace
from typing import get_args

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.figures_model import WIDTHS
from app.quiet_combo import QuietComboBox
from sgb_core.curves.segment import PARAMETER_RANGES, ParameterName
from sgb_core.document.model import Document
from sgb_core.document.plates import (
    MAX_DPI,
    MAX_PANELS,
    MAX_TITLE,
    MAX_VALUES,
    MAX_WIDTH,
    MIN_DPI,
    MIN_WIDTH,
    PlateCamera,
    PlatePart,
    PlateSettings,
    Variation,
)

WORDS: dict[ParameterName, str] = {"lambda1": "λ1", "lambda2": "λ2", "lambda3": "λ3", "omega": "ω"}
PARTS = {
    PlatePart.GENERATRIX: "Generatrix",
    PlatePart.POLYGON: "Control polygon",
    PlatePart.CIRCLES: "Circles of P1 (*) and P2 (o)",
    PlatePart.AXES: "Axis",
}
AS_IT_IS = "(as it is now)"


class VariationRow(QWidget):
    """One parameter that varies: which, of which segment, over which values."""

    changed = Signal()

    def __init__(self, title: str, optional: bool, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.parameter = _combo(f"{title}: parameter", "The shape parameter that varies")
        if optional:
            self.parameter.addItem("nothing", None)
        for name in get_args(ParameterName):
            self.parameter.addItem(WORDS[name], name)
        self.segment = _combo(f"{title}: segment", "The segment whose parameter varies")
        self.steps = QSpinBox()
        self.steps.setRange(1, MAX_VALUES)
        self.steps.setValue(4)
        self.steps.setSuffix(" values")
        self.steps.setAccessibleName(f"{title}: number of values")
        self.steps.setToolTip("So many values at equal steps over the whole range")
        self.values = QLineEdit()
        self.values.setAccessibleName(f"{title}: values")
        self.values.setToolTip("The values, with commas or spaces between them")
        top, layout = QHBoxLayout(), QVBoxLayout(self)
        for widget in (self.parameter, self.segment, self.steps):
            top.addWidget(widget)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(top)
        layout.addWidget(self.values)
        self.parameter.currentIndexChanged.connect(self._spread)
        self.steps.valueChanged.connect(self._spread)
        self.segment.currentIndexChanged.connect(self.changed)
        self.values.editingFinished.connect(self.changed)
        self._spread()

    def set_segments(self, count: int) -> None:
        """Offer the segments of a profile, keeping the one that is chosen."""
        if self.segment.count() == count + 1:
            return
        chosen = self.segment.currentData()
        self.segment.blockSignals(True)
        self.segment.clear()
        self.segment.addItem("all segments", None)
        for number in range(count):
            self.segment.addItem(f"segment {number + 1}", number)
        self.segment.setCurrentIndex(max(0, self.segment.findData(chosen)))
        self.segment.blockSignals(False)

    def _spread(self) -> None:
        name = self.parameter.currentData()
        for widget in (self.segment, self.steps, self.values):
            widget.setEnabled(name is not None)
        if name is not None:
            low, high = PARAMETER_RANGES[name]
            count = self.steps.value()
            spread = np.linspace(low, high, count) if count > 1 else [high]
            self.values.setText(", ".join(f"{value:.4g}" for value in spread))
        self.changed.emit()

    def variation(self) -> Variation | None:
        """Return what is chosen, None for nothing; raises ValueError for what is no number."""
        name = self.parameter.currentData()
        if name is None:
            return None
        words = self.values.text().replace(",", " ").split()
        try:
            values = tuple(float(word) for word in words[:MAX_VALUES])
        except ValueError:
            raise ValueError(f"{self.values.text()!r} is not a list of numbers") from None
        if not values:
            raise ValueError("a list of values is empty")
        return Variation(name, values, self.segment.currentData())

    def show_variation(self, variation: Variation | None) -> None:
        """Show a variation, or none."""
        self.blockSignals(True)
        name = None if variation is None else variation.parameter
        self.parameter.setCurrentIndex(max(0, self.parameter.findData(name)))
        if variation is not None:
            self.steps.setValue(len(variation.values))
            self.values.setText(", ".join(f"{value:.10g}" for value in variation.values))
            self.segment.setCurrentIndex(max(0, self.segment.findData(variation.segment)))
        self.blockSignals(False)


class StudioForm(QWidget):
    """All settings of a plate; ``changed`` tells of any."""

    changed = Signal()
    camera_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._base = PlateSettings()
        self._quiet = True
        self.kind = _combo("Panels", "What tells one panel from another")
        self.kind.addItem("Vary parameters", "vary")
        self.kind.addItem("Saved states", "states")
        self.first = VariationRow("First", optional=False)
        self.first.parameter.setCurrentIndex(self.first.parameter.findData("omega"))
        self.second = VariationRow("Second", optional=True)
        self.states = QListWidget()
        self.states.setAccessibleName("States")
        self.states.setToolTip("The states that become panels, in this order")
        self.states.setMaximumHeight(110)
        panels = QGroupBox("Panels")
        rows = QFormLayout(panels)
        rows.addRow("Made by", self.kind)
        rows.addRow("Vary", self.first)
        rows.addRow("and", self.second)
        rows.addRow("States", self.states)
        self._rows = rows
        self.columns = QSpinBox()
        self.columns.setRange(0, MAX_PANELS)
        self.columns.setSpecialValueText("automatic")
        self.columns.setAccessibleName("Columns")
        self.columns.setToolTip("Panels beside each other; the rows follow")
        self.title = QLineEdit()
        self.title.setMaxLength(MAX_TITLE)
        self.title.setAccessibleName("Title")
        self.title.setToolTip("A line above the panels; journals want none")
        self.labels = _check("Labels (a), (b), …", "A letter below each panel")
        self.captions = _check("Captions with the values", "What tells the panel from the others")
        self.common = _check("Same scale for all panels", "Sizes can be compared across panels")
        self.parts = {part: _check(text, f"Draw: {text}") for part, text in PARTS.items()}
        self.camera = QPushButton("Take the viewport's view")
        self.camera.setToolTip("See all panels as the viewport shows the object now")
        looks = QGroupBox("Contents")
        column = QVBoxLayout(looks)
        for widget in (self.labels, self.captions, self.common, *self.parts.values(), self.camera):
            column.addWidget(widget)
        self.preset = _combo("Width", "Widths that journals ask for")
        for text, width in WIDTHS.items():
            self.preset.addItem(f"{text} ({width:g} mm)", width)
        self.preset.addItem("Other", 0.0)
        self.width_mm = QDoubleSpinBox()
        self.width_mm.setRange(MIN_WIDTH, MAX_WIDTH)
        self.width_mm.setSuffix(" mm")
        self.width_mm.setAccessibleName("Width in millimetres")
        self.dpi = QSpinBox()
        self.dpi.setRange(MIN_DPI, MAX_DPI)
        self.dpi.setSingleStep(50)
        self.dpi.setSuffix(" dpi")
        self.dpi.setAccessibleName("Resolution")
        self.dpi.setToolTip("Of PNG files, and of the surfaces inside PDF and SVG")
        size = QGroupBox("Size")
        form = QFormLayout(size)
        form.addRow("Width", self.preset)
        form.addRow("", self.width_mm)
        form.addRow("Resolution", self.dpi)
        form.addRow("Columns", self.columns)
        form.addRow("Title", self.title)
        self.problem = QLabel()
        self.problem.setWordWrap(True)
        layout = QVBoxLayout(self)
        for group in (panels, looks, size):
            layout.addWidget(group)
        layout.addWidget(self.problem)
        layout.addStretch(1)
        self._connect()

    def _connect(self) -> None:
        self.kind.currentIndexChanged.connect(self._show_kind)
        self.preset.currentIndexChanged.connect(self._take_preset)
        self.width_mm.valueChanged.connect(self._show_preset)
        self.camera.clicked.connect(self.camera_wanted)
        boxes = (self.labels, self.captions, self.common, *self.parts.values())
        for signal in (
            self.first.changed,
            self.second.changed,
            self.states.itemChanged,
            self.columns.valueChanged,
            self.dpi.valueChanged,
            self.title.editingFinished,
            *(box.toggled for box in boxes),
        ):
            signal.connect(self._tell)
        self._show_kind()

    def show_document(self, document: Document) -> None:
        """Offer the document's segments and states."""
        self._quiet = True
        for row in (self.first, self.second):
            row.set_segments(len(document.profile))
        names = ["", *(state.name for state in document.states)]
        if names != [self._state_name(k) for k in range(self.states.count())]:
            ticked = set(self._ticked())
            self.states.clear()
            for name in names:
                item = QListWidgetItem(name or AS_IT_IS, self.states)
                item.setData(Qt.ItemDataRole.UserRole, name)
                on = name in ticked or not ticked
                item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
        self._quiet = False

    def show_settings(self, plate: PlateSettings) -> None:
        """Show a plate's settings."""
        self._quiet = True
        self._base = plate
        self.kind.setCurrentIndex(1 if plate.states else 0)
        for row, number in ((self.first, 0), (self.second, 1)):
            if plate.vary or number:
                row.show_variation(plate.vary[number] if number < len(plate.vary) else None)
        for number in range(self.states.count()) if plate.states else ():
            on = self._state_name(number) in plate.states
            state = Qt.CheckState.Checked if on else Qt.CheckState.Unchecked
            self.states.item(number).setCheckState(state)
        self.columns.setValue(plate.columns)
        self.title.setText(plate.title)
        self.labels.setChecked(plate.labels)
        self.captions.setChecked(plate.captions)
        self.common.setChecked(plate.common_scale)
        for part, box in self.parts.items():
            box.setChecked(part in plate.show)
        self.width_mm.setValue(plate.width_mm)
        self.dpi.setValue(plate.dpi)
        self._quiet = False
        self._tell()

    def set_camera(self, camera: PlateCamera) -> None:
        """Take a camera."""
        self._base = replace(self._base, camera=camera)
        self._tell()

    def settings(self) -> PlateSettings:
        """Return the plate that is chosen; raises ValueError for values that are no numbers."""
        by_states = self.kind.currentData() == "states"
        rows = () if by_states else (self.first.variation(), self.second.variation())
        states = tuple(self._ticked()) if by_states else ()
        if by_states and not states:
            raise ValueError("no state is ticked")
        return replace(
            self._base,
            vary=tuple(each for each in rows if each is not None),
            states=states,
            columns=self.columns.value(),
            title=self.title.text(),
            labels=self.labels.isChecked(),
            captions=self.captions.isChecked(),
            common_scale=self.common.isChecked(),
            show=frozenset(part for part, box in self.parts.items() if box.isChecked()),
            width_mm=self.width_mm.value(),
            dpi=self.dpi.value(),
        )

    def _ticked(self) -> list[str]:
        checked = Qt.CheckState.Checked
        numbers = range(self.states.count())
        return [self._state_name(k) for k in numbers if self.states.item(k).checkState() == checked]

    def _state_name(self, number: int) -> str:
        return str(self.states.item(number).data(Qt.ItemDataRole.UserRole))

    def _show_kind(self) -> None:
        by_states = self.kind.currentData() == "states"
        self._rows.setRowVisible(self.states, by_states)
        for row in (self.first, self.second):
            self._rows.setRowVisible(row, not by_states)
        self._tell()

    def _take_preset(self) -> None:
        if self.preset.currentData():
            self.width_mm.setValue(self.preset.currentData())

    def _show_preset(self) -> None:
        number = self.preset.findData(self.width_mm.value())
        self.preset.blockSignals(True)
        self.preset.setCurrentIndex(number if number >= 0 else self.preset.count() - 1)
        self.preset.blockSignals(False)
        self._tell()

    def _tell(self) -> None:
        if not self._quiet:
            self.changed.emit()


def _combo(name: str, tip: str) -> QComboBox:
    combo = QuietComboBox()
    combo.setAccessibleName(name)
    combo.setToolTip(tip)
    return combo


def _check(text: str, tip: str) -> QCheckBox:
    box = QCheckBox(text)
    box.setToolTip(tip)
    return box
