"""Asks what to export, how fine and how large, and shows beforehand what that will give."""

from __future__ import annotations

import threading

from PySide6.QtCore import QSize, Qt, QTimer, Signal
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from app.export.plan import Examined, ExportPlan, examine
from app.state.jobs import Stop
from app.theme import theme
from app.widgets.number_field import NumberField
from sgb_core import exchange
from sgb_core.document.manufacture import Stage
from sgb_core.document.model import Document, Unit
from sgb_core.interruption import interruptible
from sgb_core.surfaces.revolution import Axis

# The default of the command line: this part of the size.
DEFAULT_TOLERANCE = 1e-3
# How long to wait for the next change before the mesh is made, in milliseconds.
PAUSE = 200
PREVIEW = QSize(300, 330)
# Formats in which the object can stand along another axis.
TURNED = (".stl", ".obj", ".ply", ".3mf", ".step")


class ExportDialog(QDialog):
    """Format, fineness, unit, scale and axis; the caller asks for the path."""

    _examined = Signal(int, object)

    def __init__(
        self, document: Document, suffixes: tuple[str, ...], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle("Export")
        self._document = document
        self._number = 0
        self._thread: threading.Thread | None = None
        self._drop = Stop()
        self._over = False
        self.result_shown: Examined | None = None
        self._timer = QTimer(self, singleShot=True, interval=PAUSE)
        self._timer.timeout.connect(self._start)
        self._examined.connect(self._take, Qt.ConnectionType.QueuedConnection)
        self.form = self._build_form(suffixes)
        self._summary = QLabel("…")
        self._summary.setAccessibleName("What will be in the file")
        self._summary.setWordWrap(True)
        self._summary.setMinimumHeight(6 * self._summary.fontMetrics().height())
        self._summary.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._preview = QLabel()
        self._preview.setFixedSize(PREVIEW)
        self._preview.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._preview.setAccessibleName("Preview of the mesh")
        left = QVBoxLayout()
        left.addLayout(self.form)
        left.addWidget(self._summary)
        left.addStretch(1)
        columns = QHBoxLayout()
        columns.addLayout(left, 1)
        columns.addWidget(self._preview)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self._ok = buttons.addButton("Export…", QDialogButtonBox.ButtonRole.AcceptRole)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(columns)
        layout.addWidget(buttons)
        self.setMinimumWidth(720)
        self._changed()

    # Building.

    def _build_form(self, suffixes: tuple[str, ...]) -> QFormLayout:
        document = self._document
        size = document.profile.size or 1.0
        self.format = _combo("Format", "The file format")
        for suffix in suffixes:
            self.format.addItem(f"{exchange.FORMATS[suffix].title} ({suffix})", suffix)
        self.by_tolerance, self.by_samples = QRadioButton("Tolerance"), QRadioButton("Intervals")
        self.by_count = QRadioButton("Triangles")
        self.by_count.setToolTip("About so many triangles; the tolerance follows")
        self.by_tolerance.setToolTip("The mesh stays this near to the true surface")
        self.by_samples.setToolTip("Per segment along the profile × around the sweep")
        group = QButtonGroup(self)
        group.addButton(self.by_tolerance)
        group.addButton(self.by_samples)
        group.addButton(self.by_count)
        self.by_tolerance.setChecked(True)
        self.tolerance_field = NumberField(
            minimum=1e-6 * size,
            maximum=size,
            step=1e-4 * size,
            unit=str(document.unit),
            reset=DEFAULT_TOLERANCE * size,
        )
        self.tolerance_field.setAccessibleName("Tolerance")
        self.tolerance_field.set_help(self.by_tolerance.toolTip())
        self.along = _whole(1, 2000, 32, "Intervals per segment")
        self.around = _whole(3, 4000, 96, "Intervals around")
        self.count = _whole(500, 5_000_000, 50_000, "Triangles", 10_000.0)
        across = QLabel("×")
        samples = QHBoxLayout()
        samples.addWidget(self.along)
        samples.addWidget(across)
        samples.addWidget(self.around)
        samples.addStretch(1)
        for field, label in (
            (self.tolerance_field, self.by_tolerance),
            (self.count, self.by_count),
            (self.along, self.by_samples),
            (self.around, across),
        ):
            field.take_label(label)
        self.unit = _combo("Unit", "The unit of the numbers in the file; the size stays true")
        for unit in Unit:
            self.unit.addItem("inch" if unit is Unit.IN else unit.value, unit.value)
        self.unit.setCurrentIndex(self.unit.findData(document.unit.value))
        self.scale, self.factor = self._build_scale()
        self.axis = _combo("Axis up", "Along which axis of the file the object stands")
        self.axis.addItem(f"{document.revolution.axis.value}, as drawn", "")
        for axis in Axis:
            if axis is not document.revolution.axis:
                self.axis.addItem(axis.value, axis.value)
        scale = QHBoxLayout()
        scale.addWidget(self.scale, 1)
        scale.addWidget(self.factor)
        form = QFormLayout()
        form.addRow("Format", self.format)
        form.addRow(self.by_tolerance, self.tolerance_field)
        form.addRow(self.by_count, self.count)
        form.addRow(self.by_samples, samples)
        form.addRow("Unit", self.unit)
        form.addRow("Size", scale)
        form.addRow("Axis up", self.axis)
        self.look = QCheckBox("Material and paint")
        self.look.setToolTip("Put the look of the object in the file, with its picture if painted")
        self.look.setChecked(True)
        self.look.toggled.connect(self._changed)
        form.addRow("Look", self.look)
        for box in (self.format, self.unit, self.scale, self.axis):
            box.currentIndexChanged.connect(self._changed)
        group.buttonToggled.connect(self._changed)
        self.factor.take_label(form.labelForField(scale))
        for field in (self.tolerance_field, self.factor, self.along, self.around, self.count):
            field.changed.connect(self._changed)
        return form

    def _build_scale(self) -> tuple[QComboBox, NumberField]:
        scale = _combo("Size", "The drawn size, the wet or fired one, or any factor")
        shrinkage = self._document.manufacture.shrinkage
        scale.addItem("as drawn", 1.0)
        if shrinkage.percent > 0.0:
            other = Stage.WET if shrinkage.drawn is Stage.FIRED else Stage.FIRED
            factor = shrinkage.factor(other)
            words = f"{other} size, × {factor:.4f} ({shrinkage.percent:g} % of {shrinkage.of})"
            scale.addItem(words, factor)
        scale.addItem("scaled by", None)
        field = NumberField(minimum=0.0, above_minimum=True, step=0.05, decimals=4, reset=1.0)
        field.setAccessibleName("Scale factor")
        field.set_help("How many times as large as drawn")
        return scale, field

    # What is asked for.

    @property
    def suffix(self) -> str:
        """The chosen format's suffix, such as ".stl"."""
        return str(self.format.currentData())

    @property
    def plan(self) -> ExportPlan:
        """All that is chosen."""
        factor = self.scale.currentData()
        axis = self.axis.currentData() if self.suffix in TURNED else None
        return ExportPlan(
            self._document,
            self.suffix,
            self.tolerance_field.value if self.by_tolerance.isChecked() else None,
            self._samples if self.by_samples.isChecked() else None,
            Unit(self.unit.currentData()),
            self.factor.value if factor is None else float(factor),
            Axis(axis) if axis else None,
            round(self.count.value) if self.by_count.isChecked() else None,
            self.look.isChecked(),
        )

    @property
    def _samples(self) -> tuple[int, int]:
        return round(self.along.value), round(self.around.value)

    # What it will give.

    def _changed(self, *_change: object) -> None:
        plan = self.plan
        meshed = plan.meshed
        for widget in (self.by_tolerance, self.by_count, self.by_samples):
            widget.setEnabled(meshed)
        self.tolerance_field.setEnabled(meshed and self.by_tolerance.isChecked())
        for field in (self.along, self.around):
            field.setEnabled(meshed and self.by_samples.isChecked())
        self.count.setEnabled(meshed and self.by_count.isChecked())
        self.factor.setVisible(self.scale.currentData() is None)
        # A GLB file is in metres and upright whatever is asked for.
        self.unit.setEnabled(self.suffix != ".glb")
        self.axis.setEnabled(self.suffix in TURNED)
        self.form.setRowVisible(self.look, plan.has_look)
        self._number += 1
        self._drop.set()
        self.result_shown = None
        self._timer.start()

    def _start(self) -> None:
        if self._thread is not None or self._over:
            return
        self._drop = Stop()
        self._thread = threading.Thread(
            target=self._run, args=(self._number, self.plan, self._drop), daemon=True
        )
        self._thread.start()

    def _run(self, number: int, plan: ExportPlan, drop: Stop) -> None:
        try:
            with interruptible(drop.ask):
                found: object = examine(plan)
        except Exception as error:
            found = error
        self._examined.emit(number, found)

    def _take(self, number: int, found: object) -> None:
        self._thread = None
        if self._over:
            return
        if number != self._number:
            # Made for what was asked before.
            self._timer.start()
            return
        self._ok.setEnabled(isinstance(found, Examined))
        if not isinstance(found, Examined):
            self.result_shown = None
            self._summary.setText(f"⚠ {found}")
            self._preview.clear()
            return
        self.result_shown = found
        self._summary.setText("\n".join(found.lines))
        self._show_preview(found)

    def _show_preview(self, found: Examined) -> None:
        if found.mesh is None:
            self._preview.setText("no mesh")
            return
        from app.scene.mesh_preview import mesh_picture

        ratio = self.devicePixelRatioF()
        size = (round(PREVIEW.width() * ratio), round(PREVIEW.height() * ratio))
        axis = found.plan.exported.revolution.axis
        pixels = mesh_picture(found.mesh, axis, size, theme.current())
        image = QImage(pixels.tobytes(), *size, 4 * size[0], QImage.Format.Format_RGBA8888)
        picture = QPixmap.fromImage(image)
        picture.setDevicePixelRatio(ratio)
        self._preview.setPixmap(picture)

    def done(self, result: int) -> None:
        # A result that is still under way must start nothing new.
        self._over = True
        self._drop.set()
        if self._thread is not None:
            self._thread.join()
        super().done(result)


def _combo(name: str, tip: str) -> QComboBox:
    box = QComboBox()
    box.setAccessibleName(name)
    box.setToolTip(tip)
    return box


def _whole(low: int, high: int, value: int, name: str, step: float = 1.0) -> NumberField:
    field = NumberField(minimum=low, maximum=high, step=step, whole=True, reset=value)
    field.setAccessibleName(name)
    field.set_help(name)
    return field
