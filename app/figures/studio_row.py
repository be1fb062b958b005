"""One line of the figure studio: a shape parameter, and the values that it takes."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel, QLineEdit, QVBoxLayout, QWidget

from app.widgets.combo_box import QuietComboBox
from app.widgets.number_field import NumberField
from sgb_core.curves.segment import PARAMETER_RANGES, PARAMETERS, SYMBOLS
from sgb_core.document.plates import MAX_VALUES, Variation
from sgb_core.findings.errors import FindingError
from sgb_core.findings.plates import NoPlate, NotNumbers


class VariationRow(QWidget):
    """One parameter that varies: which, of which segment, over which values."""

    changed = Signal()

    def __init__(self, title: str, optional: bool, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.parameter = named_combo(f"{title}: parameter", "The shape parameter that varies")
        if optional:
            self.parameter.addItem("None", None)
        for name in PARAMETERS:
            self.parameter.addItem(SYMBOLS[name], name)
        self.segment = named_combo(f"{title}: segment", "The segment whose parameter varies")
        self.segment.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.steps = NumberField(minimum=1, maximum=MAX_VALUES, whole=True, reset=4.0)
        self.steps.setAccessibleName(f"{title}: number of values")
        self.steps.set_help("So many values at equal steps over the whole range")
        values = QLabel("Values")
        self.steps.take_label(values)
        self.values = QLineEdit()
        self.values.setAccessibleName(f"{title}: values")
        self.values.setToolTip("The values, with commas or spaces between them")
        top, layout = QHBoxLayout(), QVBoxLayout(self)
        for widget in (self.parameter, self.segment, self.steps, values):
            top.addWidget(widget)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(top)
        layout.addWidget(self.values)
        self.parameter.currentIndexChanged.connect(self._spread)
        self.steps.changed.connect(self._spread)
        self.segment.currentIndexChanged.connect(self.changed)
        self.values.editingFinished.connect(self.changed)
        self._spread()

    def set_segments(self, titles: list[str]) -> None:
        """Offer the segments of a profile, keeping the one that is chosen."""
        if [self.segment.itemText(k) for k in range(1, self.segment.count())] == titles:
            return
        chosen = self.segment.currentData()
        self.segment.blockSignals(True)
        self.segment.clear()
        self.segment.addItem("All segments", None)
        for number, title in enumerate(titles):
            self.segment.addItem(title, number)
        self.segment.setCurrentIndex(max(0, self.segment.findData(chosen)))
        self.segment.blockSignals(False)
        # A combo box would rather cut its longest choice off than make its panel wider.
        self.segment.setMinimumWidth(self.segment.sizeHint().width())

    def _spread(self) -> None:
        name = self.parameter.currentData()
        for widget in (self.segment, self.steps, self.values):
            widget.setEnabled(name is not None)
        if name is not None:
            low, high = PARAMETER_RANGES[name]
            count = round(self.steps.value)
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
            raise FindingError(NotNumbers(self.values.text())) from None
        if not values:
            raise FindingError(NoPlate.NO_VALUES)
        return Variation(name, values, self.segment.currentData())

    def show_variation(self, variation: Variation | None) -> None:
        """Show a variation, or none."""
        self.blockSignals(True)
        name = None if variation is None else variation.parameter
        self.parameter.setCurrentIndex(max(0, self.parameter.findData(name)))
        if variation is not None:
            self.steps.set_value(len(variation.values))
            self.values.setText(", ".join(f"{value:.10g}" for value in variation.values))
            self.segment.setCurrentIndex(max(0, self.segment.findData(variation.segment)))
        self.blockSignals(False)


def named_combo(name: str, tip: str) -> QComboBox:
    """Return an empty choice that tells its name and what it is for."""
    combo = QuietComboBox()
    combo.setAccessibleName(name)
    combo.setToolTip(tip)
    return combo
