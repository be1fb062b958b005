"""Asks what to export, how fine, and says beforehand what that will give."""

from __future__ import annotations

from PySide6.QtWidgets import (
    QButtonGroup,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QRadioButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.number_field import NumberField
from sgb_core.document.model import Document
from sgb_core.surfaces.tessellation import samples_for_tolerance

FORMATS = {
    ".stl": "STL: triangles for 3-D printing",
    ".obj": "OBJ: mesh with normals and texture coordinates",
    ".ply": "PLY: mesh with normals",
    ".glb": "GLB: for viewers and the web, in metres",
    ".3mf": "3MF: for 3-D printing, states its unit",
    ".csv": "CSV: points of the generatrix",
}
# The default of the command line: this part of the size.
DEFAULT_TOLERANCE = 1e-3


class ExportDialog(QDialog):
    """Format and fineness; the caller asks for the path."""

    def __init__(
        self, document: Document, suffixes: tuple[str, ...], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle("Export")
        self._document = document
        size = document.profile.size or 1.0
        self._format = QComboBox()
        self._format.setAccessibleName("Format")
        self._format.setToolTip("The file format")
        for suffix in suffixes:
            self._format.addItem(FORMATS.get(suffix, suffix.lstrip(".").upper()), suffix)
        self._by_tolerance = QRadioButton("Tolerance")
        self._by_tolerance.setToolTip("The mesh stays this near to the true surface")
        self._by_samples = QRadioButton("Intervals")
        self._by_samples.setToolTip("Per segment along the profile × around the sweep")
        group = QButtonGroup(self)
        group.addButton(self._by_tolerance)
        group.addButton(self._by_samples)
        self._by_tolerance.setChecked(True)
        self._tolerance = NumberField(
            minimum=1e-6 * size,
            maximum=size,
            value=DEFAULT_TOLERANCE * size,
            step=1e-4 * size,
            unit=str(document.unit),
        )
        self._tolerance.setAccessibleName("Tolerance")
        self._along = _spin(1, 2000, 32, "Intervals per segment")
        self._around = _spin(3, 4000, 96, "Intervals around")
        samples = QHBoxLayout()
        samples.addWidget(self._along)
        samples.addWidget(QLabel("×"))
        samples.addWidget(self._around)
        samples.addStretch(1)
        self._summary = QLabel()
        self._summary.setWordWrap(True)
        form = QFormLayout()
        form.addRow("Format", self._format)
        form.addRow(self._by_tolerance, self._tolerance)
        form.addRow(self._by_samples, samples)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self._ok = buttons.addButton("Export…", QDialogButtonBox.ButtonRole.AcceptRole)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addWidget(self._summary)
        layout.addStretch(1)
        layout.addWidget(buttons)
        self.setMinimumWidth(440)
        self._format.currentIndexChanged.connect(self._show_summary)
        group.buttonToggled.connect(self._show_summary)
        self._tolerance.changed.connect(self._show_summary)
        self._along.valueChanged.connect(self._show_summary)
        self._around.valueChanged.connect(self._show_summary)
        self._show_summary()

    @property
    def suffix(self) -> str:
        """The chosen format's suffix, such as ".stl"."""
        return str(self._format.currentData())

    @property
    def tolerance(self) -> float | None:
        """The chosen tolerance, None where intervals are chosen."""
        return self._tolerance.value if self._by_tolerance.isChecked() else None

    @property
    def samples(self) -> tuple[int, int] | None:
        """The chosen intervals (per segment, around), None where a tolerance is chosen."""
        if self._by_tolerance.isChecked():
            return None
        return self._along.value(), self._around.value()

    def _show_summary(self) -> None:
        meshed = self.suffix != ".csv"
        for widget in (self._by_tolerance, self._by_samples):
            widget.setEnabled(meshed)
        self._tolerance.setEnabled(meshed and self._by_tolerance.isChecked())
        self._along.setEnabled(meshed and self._by_samples.isChecked())
        self._around.setEnabled(meshed and self._by_samples.isChecked())
        if not meshed:
            self._summary.setText("65 points per segment, full precision.")
            return
        try:
            count = self._triangles()
        except ValueError as error:
            self._summary.setText(str(error))
            self._ok.setEnabled(False)
            return
        self._ok.setEnabled(True)
        text = f"About {count:,} triangles".replace(",", "\u2009")
        if self.suffix == ".stl":
            text += f", {(84 + 50 * count) / 1e6:.2g} MB"
        self._summary.setText(f"{text}. Lengths are in {self._document.unit}.")

    def _triangles(self) -> int:
        samples = self.samples
        if samples is not None:
            along, around = len(self._document.profile.segments) * samples[0], samples[1]
        else:
            per_segment, around = samples_for_tolerance(
                self._document.surface, self._tolerance.value
            )
            along = sum(per_segment)
        return 2 * along * around


def _spin(low: int, high: int, value: int, name: str) -> QSpinBox:
    spin = QSpinBox()
    spin.setRange(low, high)
    spin.setValue(value)
    spin.setAccessibleName(name)
    spin.setToolTip(name)
    return spin
