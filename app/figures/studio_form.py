"""The left side of the figure studio: a plate's settings as controls, and back."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QGroupBox,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.figures.plate import WIDTHS
from app.figures.studio_row import VariationRow
from app.state.window_reader import segment_titles
from app.widgets.combo_box import QuietComboBox
from app.widgets.form import Row, add_rows, offering
from app.widgets.labels import take_labels
from app.widgets.number_field import NumberField
from sgb_core.document.model import Document
from sgb_core.document.plates import (
    MAX_DPI,
    MAX_PANELS,
    MAX_TITLE,
    MAX_WIDTH,
    MIN_DPI,
    MIN_WIDTH,
    PlateCamera,
    PlatePart,
    PlateSettings,
)
from sgb_core.findings.errors import FindingError
from sgb_core.findings.plates import NoPlate

PARTS = {
    PlatePart.GENERATRIX: "Generatrix",
    PlatePart.POLYGON: "Control polygon",
    PlatePart.CIRCLES: "Circles of P1 (*) and P2 (o)",
    PlatePart.AXES: "Axis",
}
# The step below the least height that a plate may have, 5 mm, stands for none.
AUTOMATIC = 4.99
AS_IT_IS = "(as it is now)"


class StudioForm(QWidget):
    """All settings of a plate; ``changed`` tells of any."""

    changed = Signal()
    camera_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._base = PlateSettings()
        self._quiet = True
        layout = QVBoxLayout(self)
        for group in (self._build_panels(), self._build_contents(), self._build_size()):
            layout.addWidget(group)
        self.problem = QLabel()
        self.problem.setWordWrap(True)
        layout.addWidget(self.problem)
        layout.addStretch(1)
        take_labels(self)
        self._connect()

    def _build_panels(self) -> QGroupBox:
        self.kind = offering(
            QuietComboBox(), (("Vary parameters", "vary"), ("Saved states", "states"))
        )
        self.first = VariationRow("First", optional=False)
        self.first.parameter.setCurrentIndex(self.first.parameter.findData("omega"))
        self.second = VariationRow("Second", optional=True)
        self.states = QListWidget()
        self.states.setMaximumHeight(110)
        group = QGroupBox("Panels")
        self._rows = QFormLayout(group)
        add_rows(
            self._rows,
            (
                Row("Made by", self.kind, "What tells one panel from another", "Panels"),
                Row("Vary", self.first),
                Row("And", self.second),
                Row("States", self.states, "The states that become panels, in this order"),
            ),
        )
        return group

    def _build_contents(self) -> QGroupBox:
        self.labels = _check("Labels (a), (b), …", "A letter below each panel")
        self.captions = _check("Captions with the values", "What tells the panel from the others")
        self.common = _check("Same scale for all panels", "Sizes can be compared across panels")
        self.parts = {part: _check(text, f"Draw: {text}") for part, text in PARTS.items()}
        self.camera = QPushButton("Take the viewport's view")
        self.camera.setAutoDefault(False)
        self.camera.setToolTip("See all panels as the viewport shows the object now")
        group = QGroupBox("Contents")
        column = QVBoxLayout(group)
        for widget in (self.labels, self.captions, self.common, *self.parts.values(), self.camera):
            column.addWidget(widget)
        return group

    def _build_size(self) -> QGroupBox:
        usual = self._base
        widths = [(f"{text} ({width:g} mm)", width) for text, width in WIDTHS.items()]
        self.preset = offering(QuietComboBox(), (*widths, ("Other", 0.0)))
        self.width_mm = NumberField(
            minimum=MIN_WIDTH, maximum=MAX_WIDTH, reset=usual.width_mm, unit="mm"
        )
        self.height_mm = NumberField(
            minimum=AUTOMATIC,
            maximum=MAX_WIDTH,
            reset=AUTOMATIC,
            unit="mm",
            words={AUTOMATIC: "automatic"},
        )
        self.dpi = NumberField(
            minimum=MIN_DPI, maximum=MAX_DPI, reset=usual.dpi, step=50.0, whole=True
        )
        self.columns = NumberField(
            minimum=0, maximum=MAX_PANELS, reset=usual.columns, whole=True, words={0.0: "automatic"}
        )
        self.title = QLineEdit()
        self.title.setMaxLength(MAX_TITLE)
        group = QGroupBox("Size")
        add_rows(
            QFormLayout(group),
            (
                Row("Width", self.preset, "Widths that journals ask for"),
                Row("In mm", self.width_mm, "Of the whole plate", "Width in millimetres"),
                Row(
                    "Panel height, mm",
                    self.height_mm,
                    "Of one panel without its caption; the least is automatic",
                    "Height of one panel in millimetres",
                ),
                Row(
                    "Resolution, dpi",
                    self.dpi,
                    "In dots per inch: of PNG files, and of the surfaces inside PDF and SVG",
                    "Resolution",
                ),
                Row("Columns", self.columns, "Panels beside each other; the rows follow"),
                Row("Title", self.title, "A line above the panels; journals want none"),
            ),
        )
        return group

    def _connect(self) -> None:
        self.kind.currentIndexChanged.connect(self._show_kind)
        self.preset.currentIndexChanged.connect(self._take_preset)
        self.width_mm.changed.connect(self._show_preset)
        self.camera.clicked.connect(self.camera_wanted)
        boxes = (self.labels, self.captions, self.common, *self.parts.values())
        for signal in (
            self.first.changed,
            self.second.changed,
            self.states.itemChanged,
            self.columns.changed,
            self.height_mm.changed,
            self.dpi.changed,
            self.title.editingFinished,
            *(box.toggled for box in boxes),
        ):
            signal.connect(self._tell)
        self._show_kind()

    def show_document(self, document: Document) -> None:
        """Offer the document's segments and states."""
        self._quiet = True
        for row in (self.first, self.second):
            row.set_segments(segment_titles(document.profile))
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
        self.columns.set_value(plate.columns)
        self.title.setText(plate.title)
        self.labels.setChecked(plate.labels)
        self.captions.setChecked(plate.captions)
        self.common.setChecked(plate.common_scale)
        for part, box in self.parts.items():
            box.setChecked(part in plate.show)
        self.width_mm.set_value(plate.width_mm)
        self.height_mm.set_value(plate.panel_height_mm or AUTOMATIC)
        self.dpi.set_value(plate.dpi)
        self._show_preset()
        self._quiet = False
        self._tell()

    def set_camera(self, camera: PlateCamera) -> None:
        """Take a camera."""
        self._base = replace(self._base, camera=camera)
        self._tell()

    def settings(self) -> PlateSettings:
        """Return the plate that is chosen; raises ValueError for values that are no numbers."""
        by_states = self.kind.currentData() == "states"
        height = self.height_mm.value
        rows = () if by_states else (self.first.variation(), self.second.variation())
        states = tuple(self._ticked()) if by_states else ()
        if by_states and not states:
            raise FindingError(NoPlate.NO_STATES)
        return replace(
            self._base,
            vary=tuple(each for each in rows if each is not None),
            states=states,
            columns=round(self.columns.value),
            title=self.title.text(),
            labels=self.labels.isChecked(),
            captions=self.captions.isChecked(),
            common_scale=self.common.isChecked(),
            show=frozenset(part for part, box in self.parts.items() if box.isChecked()),
            width_mm=self.width_mm.value,
            panel_height_mm=height if height > AUTOMATIC else None,
            dpi=round(self.dpi.value),
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
            self.width_mm.enter(self.preset.currentData())

    def _show_preset(self) -> None:
        number = self.preset.findData(self.width_mm.value)
        self.preset.blockSignals(True)
        self.preset.setCurrentIndex(number if number >= 0 else self.preset.count() - 1)
        self.preset.blockSignals(False)
        self._tell()

    def _tell(self) -> None:
        if not self._quiet:
            self.changed.emit()


def _check(text: str, tip: str) -> QCheckBox:
    box = QCheckBox(text)
    box.setToolTip(tip)
    return box
