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
from shiboken6 import isValid

from app.export.plan import Examined, ExportPlan, examine
from app.state.jobs import Cancelled, Stop
from app.state.unforeseen import tell_unforeseen
from app.state.window_reader import why
from app.theme import theme
from app.widgets.form import Row, add_rows, named, offering
from app.widgets.number_field import NumberField
from sgb_core import exchange
from sgb_core.document.manufacture import Stage
from sgb_core.document.model import Document, Unit
from sgb_core.interruption import interruptible
from sgb_core.surfaces.fineness import DEFAULT_TOLERANCE
from sgb_core.surfaces.revolution import Axis

# How long to wait for the next change before the mesh is made, in milliseconds.
PAUSE = 200
PREVIEW = QSize(300, 330)


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
        document, drawn = self._document, self._document.revolution.axis
        formats = ((f"{exchange.FORMATS[suffix].title} ({suffix})", suffix) for suffix in suffixes)
        units = (("inch" if unit is Unit.IN else unit.value, unit.value) for unit in Unit)
        axes = ((axis.value, axis.value) for axis in Axis if axis is not drawn)
        self.format = offering(QComboBox(), formats)
        self.unit = offering(QComboBox(), units)
        self.unit.setCurrentIndex(self.unit.findData(document.unit.value))
        self.axis = offering(QComboBox(), ((f"{drawn.value}, as drawn", ""), *axes))
        self.look = QCheckBox("Material and paint")
        self.look.setChecked(True)
        scale, form = self._build_scale(), QFormLayout()
        add_rows(
            form,
            (
                Row("Format", self.format, "The file format"),
                *self._fineness_rows(document.profile.size or 1.0),
                Row("Unit", self.unit, "The unit of the numbers in the file; the size stays true"),
                Row("Size", scale),
                Row("Axis up", self.axis, "Along which axis of the file the object stands"),
                Row(
                    "Look",
                    self.look,
                    "Put the look of the object in the file, with its picture if painted",
                    "",
                ),
            ),
        )
        self.factor.take_label(form.labelForField(scale))
        self._connect()
        return form

    def _fineness_rows(self, size: float) -> tuple[Row, ...]:
        """Make the three ways to say how fine the mesh is, and tie each to its numbers."""
        self.by_tolerance, self.by_samples = QRadioButton("Tolerance"), QRadioButton("Intervals")
        self.by_count = QRadioButton("Triangles")
        self.by_count.setToolTip("About so many triangles; the tolerance follows")
        self.by_tolerance.setToolTip("The mesh, or a fit in STEP, stays this near to the truth")
        self.by_samples.setToolTip("Per segment along the profile × around the sweep")
        self._ways = QButtonGroup(self)
        for button in (self.by_tolerance, self.by_samples, self.by_count):
            self._ways.addButton(button)
        self.by_tolerance.setChecked(True)
        self._ways.buttonToggled.connect(self._changed)
        self.tolerance_field = NumberField(
            minimum=1e-6 * size,
            maximum=size,
            step=1e-4 * size,
            unit=str(self._document.unit),
            reset=self._usual_tolerance,
        )
        self.along = _whole(1, 2000, 32, "Intervals per segment")
        self.around = _whole(3, 4000, 96, "Intervals around")
        self.count = _whole(500, 5_000_000, 50_000, "Triangles", 10_000.0)
        across = QLabel("×")
        samples = QHBoxLayout()
        for widget in (self.along, across, self.around):
            samples.addWidget(widget)
        samples.addStretch(1)
        for field, label in (
            (self.tolerance_field, self.by_tolerance),
            (self.count, self.by_count),
            (self.along, self.by_samples),
            (self.around, across),
        ):
            field.take_label(label)
        tip = self.by_tolerance.toolTip()
        return (
            Row(self.by_tolerance, self.tolerance_field, tip, "Tolerance"),
            Row(self.by_count, self.count),
            Row(self.by_samples, samples),
        )

    def _build_scale(self) -> QHBoxLayout:
        tip = "The drawn size, the wet or fired one, or any factor"
        self.scale = named(QComboBox(), "Size", tip)
        shrinkage = self._document.manufacture.shrinkage
        if shrinkage.percent == 0.0:
            self.scale.addItem("As drawn", 1.0)
        for stage in Stage if shrinkage.percent > 0.0 else ():
            # The wet size goes to the kiln, and is what an export begins with.
            factor = shrinkage.factor(stage)
            size = f"{stage.capitalize()} size" + (", for the kiln" if stage is Stage.WET else "")
            how = "as drawn" if stage is shrinkage.drawn else f"× {factor:.4f}"
            self.scale.addItem(f"{size}: {how}", factor)
        self.scale.setCurrentIndex(0)
        self.scale.addItem("Scaled by", None)
        field = NumberField(minimum=0.0, above_minimum=True, step=0.05, decimals=4, reset=1.0)
        self.factor = named(field, "Scale factor", "How many times as large as drawn")
        row = QHBoxLayout()
        row.addWidget(self.scale, 1)
        row.addWidget(self.factor)
        return row

    def _connect(self) -> None:
        self._usual = self._usual_tolerance()
        self.tolerance_field.set_value(self._usual)
        self.format.currentIndexChanged.connect(self._reformatted)
        for box in (self.format, self.unit, self.scale, self.axis):
            box.currentIndexChanged.connect(self._changed)
        for field in (self.tolerance_field, self.factor, self.along, self.around, self.count):
            field.changed.connect(self._changed)
        self._ways.buttonToggled.connect(self._changed)
        self.look.toggled.connect(self._changed)

    # What is asked for.

    @property
    def suffix(self) -> str:
        """The chosen format's suffix, such as ".stl"."""
        return str(self.format.currentData())

    @property
    def plan(self) -> ExportPlan:
        """All that is chosen."""
        factor = self.scale.currentData()
        axis = self.axis.currentData() if exchange.FORMATS[self.suffix].any_axis else None
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

    def _usual_tolerance(self) -> float:
        """Return how near the chosen format stays to the true surface where nothing is asked."""
        usual = exchange.FORMATS[self.suffix].tolerance or DEFAULT_TOLERANCE
        return usual * (self._document.profile.size or 1.0)

    def _reformatted(self) -> None:
        """Let the tolerance follow the format's own, unless it was changed."""
        unchanged = self.tolerance_field.value == self._usual
        self._usual = self._usual_tolerance()
        if unchanged:
            self.tolerance_field.set_value(self._usual)

    # What it will give.

    def _changed(self, *_change: object) -> None:
        plan = self.plan
        meshed, near = plan.meshed, plan.format.tolerance is not None
        for widget in (self.by_count, self.by_samples):
            widget.setEnabled(meshed)
        self.by_tolerance.setEnabled(near)
        self.tolerance_field.setEnabled(near and self.by_tolerance.isChecked())
        for field in (self.along, self.around):
            field.setEnabled(meshed and self.by_samples.isChecked())
        self.count.setEnabled(meshed and self.by_count.isChecked())
        self.factor.setVisible(self.scale.currentData() is None)
        self.unit.setEnabled(plan.format.any_unit)
        self.axis.setEnabled(plan.format.any_axis)
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
                found: Examined | Exception = examine(plan)
        except Cancelled as end:
            found = end
        except Exception as error:
            found = error
            tell_unforeseen(error)
        # A dialog that is gone meanwhile wants it no more.
        if isValid(self):
            self._examined.emit(number, found)

    def _take(self, number: int, found: Examined | Exception) -> None:
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
            self._summary.setText(f"⚠ {why(found)}")
            self._preview.clear()
            return
        self.result_shown = found
        self._summary.setText("\n".join(found.lines))
        self._show_preview(found)

    def _show_preview(self, found: Examined) -> None:
        if found.mesh is None:
            self._preview.setText("No mesh")
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


def _whole(low: int, high: int, value: int, name: str, step: float = 1.0) -> NumberField:
    field = NumberField(minimum=low, maximum=high, step=step, whole=True, reset=value)
    return named(field, name, name)
