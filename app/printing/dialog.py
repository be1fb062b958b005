"""Asks what to print with and how, and shows the path, what it comes to and its risks."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QSignalBlocker, Qt, QTimer
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QPushButton,
    QSlider,
    QVBoxLayout,
    QWidget,
)

from app.printing.path_view import PathView
from app.state import printers
from app.state.jobs import Job, Jobs
from app.state.path_colours import MEASURES
from app.state.window_reader import reason, sentence, why
from app.widgets.form import Row, add_rows, named, offering
from app.widgets.labels import take_labels
from app.widgets.number_field import NumberField
from sgb_core.bodies.solid import BodyKind
from sgb_core.document.errors import FileError
from sgb_core.document.manufacture import Stage
from sgb_core.document.model import Document
from sgb_core.findings.errors import FindingError
from sgb_core.toolpaths.plan_path import toolpath
from sgb_core.toolpaths.printer import Printer
from sgb_core.toolpaths.settings import MOST_FLOORS, MOST_WALLS, Wanted, fewest_beads
from sgb_core.toolpaths.toolpath import Toolpath

# How long to wait for the next change before the path is made, in milliseconds.
_PAUSE = 250
# Steps of the slider through the time of printing.
_MOMENTS = 1_000


class PrintDialog(QDialog):
    """Printer, layer, bead and more; the caller asks for the file and writes ``path``."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Print path")
        self._document = document
        self.path: Toolpath | None = None
        self._jobs = Jobs(self)
        self._timer = QTimer(self, singleShot=True, interval=_PAUSE)
        self._timer.timeout.connect(self._make)
        self._printers = printers.known()
        self._build_fields()
        self.view = PathView()
        self.moment = QSlider(Qt.Orientation.Horizontal)
        self.moment.setMaximum(_MOMENTS)
        self.moment.setValue(_MOMENTS)
        self.colouring = offering(QComboBox(), [(MEASURES[key].words, key) for key in MEASURES])
        self.range = QLabel()
        self.totals = QLabel()
        self.risks = QListWidget()
        self._build()
        self._connect()
        self._begin_as_last_time()

    def _begin_as_last_time(self) -> None:
        printer, layer = printers.chosen(self._printers)
        names = [each.name for each in self._printers]
        with QSignalBlocker(self.printer):
            self.printer.setCurrentIndex(names.index(printer.name))
        self._take_printer()
        self.layer.set_value(layer)

    def _build_fields(self) -> None:
        self.printer = offering(QComboBox(), [(each.title, each) for each in self._printers])
        self.add_printer = QPushButton("Add…")
        self.layer = NumberField(unit="mm", step=0.05)
        self.bead = NumberField(unit="mm", step=0.05)
        self.walls = NumberField(minimum=1, maximum=MOST_WALLS, whole=True, reset=1)
        self.floors = NumberField(minimum=0, maximum=MOST_FLOORS, whole=True)
        self.skirt = NumberField(minimum=0, maximum=50, whole=True)
        self.adaptive = QCheckBox("Climb less where the wall leans")
        self.arcs = QCheckBox("Arcs (G2, G3)")
        self.clockwise = QCheckBox("Turn clockwise")
        self.anyway = QCheckBox("Print what leans too far")
        self.stage = offering(QComboBox(), [("Wet, as printed", Stage.WET), ("Fired", Stage.FIRED)])

    def _build(self) -> None:
        machine = QHBoxLayout()
        machine.addWidget(named(self.printer, "Printer", "The machine to print with"), 1)
        tip = "Add a printer of one's own from its data file (.json)"
        machine.addWidget(named(self.add_printer, "Add a printer", tip))
        for box, tip in (
            (self.adaptive, "Keep neighbouring turns equally apart along the surface"),
            (self.arcs, "Write arcs where sections are circles: shorter files"),
            (self.clockwise, "Turn the other way round"),
            (self.anyway, "Make the path even where a bead has nothing to rest on"),
        ):
            box.setToolTip(tip)
        form = QFormLayout()
        bead = "How wide the bead is; of a vessel the wall is divided by its beads"
        add_rows(
            form,
            (
                Row("Printer", machine),
                Row("Layer", self.layer, "How far the path climbs in a turn"),
                Row("Bead", self.bead, bead),
                Row("Beads in the wall", self.walls, "How many beads lie side by side"),
                Row("Floor layers", self.floors, "Spirals that fill the foot"),
                Row("Skirt", self.skirt, "Circles around the foot, to get the flow going"),
                Row("Size", self.stage, "The size before or after shrinking"),
                *(Row("", box) for box in (self.adaptive, self.arcs, self.clockwise, self.anyway)),
            ),
        )
        self.totals.setWordWrap(True)
        self.totals.setAccessibleName("What the path comes to")
        self.totals.setMinimumHeight(5 * self.totals.fontMetrics().height())
        self.totals.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.risks.setWordWrap(True)
        named(self.risks, "Risks", "Where the print may fail, and what helps")
        left = QVBoxLayout()
        left.addLayout(form)
        left.addWidget(self.totals)
        left.addWidget(self.risks, 1)
        columns = QHBoxLayout()
        columns.addLayout(left, 2)
        columns.addLayout(self._build_view(), 3)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.write = buttons.addButton("Write G-code…", QDialogButtonBox.ButtonRole.AcceptRole)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(columns, 1)
        layout.addWidget(buttons)
        self.resize(900, 600)
        take_labels(self)

    def _build_view(self) -> QVBoxLayout:
        below = QHBoxLayout()
        below.addWidget(named(self.colouring, "Colour by", "What the colours of the path say"))
        below.addWidget(self.range)
        below.addStretch(1)
        right = QVBoxLayout()
        right.addWidget(self.view, 1)
        right.addWidget(named(self.moment, "Moment", "How far printing has come"))
        right.addLayout(below)
        return right

    def _connect(self) -> None:
        self.printer.currentIndexChanged.connect(self._take_printer)
        self.add_printer.clicked.connect(self._add)
        for field in (self.layer, self.bead, self.walls, self.floors, self.skirt):
            field.changed.connect(self._later)
        self.walls.changed.connect(self._divide)
        for box in (self.adaptive, self.arcs, self.clockwise, self.anyway):
            box.toggled.connect(self._later)
        self.stage.currentIndexChanged.connect(self._take_printer)
        self.moment.valueChanged.connect(lambda at: self.view.show_until(at / _MOMENTS))
        self.colouring.currentIndexChanged.connect(self._colour)

    @property
    def machine(self) -> Printer:
        """The printer chosen."""
        found: Printer = self.printer.currentData()
        return found

    @property
    def wanted(self) -> Wanted:
        """What is asked for."""
        return Wanted(
            layer=self.layer.value,
            bead=self.bead.value,
            walls=round(self.walls.value),
            floor_layers=round(self.floors.value),
            adaptive=self.adaptive.isChecked(),
            arcs=self.arcs.isChecked(),
            stage=Stage(self.stage.currentData()),
            skirt=round(self.skirt.value),
            clockwise=self.clockwise.isChecked(),
            anyway=self.anyway.isChecked(),
        )

    @property
    def _scale(self) -> float:
        stage = Stage(self.stage.currentData())
        shrinkage = self._document.manufacture.shrinkage
        return self._document.unit.millimetres * shrinkage.factor(stage)

    def _take_printer(self) -> None:
        """Begin with what is usual for the printer; a vessel's wall is divided into beads."""
        printer, solid = self.machine, self._document.solid
        self.layer.set_range(printer.layer.least, printer.layer.most)
        self.bead.set_range(printer.bead.least, printer.bead.most)
        self.layer.set_value(printer.layer.usual)
        self.skirt.set_value(printer.skirt)
        stage = Stage(self.stage.currentData())
        self.walls.set_value(fewest_beads(self._document, printer, stage))
        if solid.kind is BodyKind.VESSEL:
            self._divide()
        else:
            self.bead.set_value(printer.bead.usual)
        base = 0.0 if solid.kind is BodyKind.SURFACE else solid.base * self._scale
        self.floors.set_value(min(round(base / printer.layer.usual), MOST_FLOORS))
        self._later()

    def _divide(self) -> None:
        solid = self._document.solid
        if solid.kind is BodyKind.VESSEL:
            self.bead.set_value(solid.wall * self._scale / max(1.0, self.walls.value))

    def _add(self) -> None:
        name, _ = QFileDialog.getOpenFileName(self, "Add a printer", "", "Printer (*.json)")
        if not name:
            return
        try:
            added = printers.add(Path(name))
        except (FindingError, FileError, OSError) as error:
            self.totals.setText(f"{Path(name).name}: {why(error)}")
            return
        self._printers = printers.known()
        names = [each.name for each in self._printers]
        with QSignalBlocker(self.printer):
            self.printer.clear()
            offering(self.printer, [(each.title, each) for each in self._printers])
            self.printer.setCurrentIndex(names.index(added.name))
        self._take_printer()

    def _later(self) -> None:
        # What is still being planned is of choices that no longer hold.
        self._jobs.drop_all()
        self.path = None
        self.write.setEnabled(False)
        self._timer.start()

    def _make(self) -> None:
        document, printer, wanted = self._document, self.machine, self.wanted
        printers.choose(printer, self.layer.value)
        self.totals.setText("…")
        self._jobs.start(
            Job("Path", lambda _: toolpath(document, printer, wanted), self._show, self._refused)
        )

    def _show(self, path: Toolpath) -> None:
        self.path = path
        self.view.show_path(path)
        self.write.setEnabled(True)
        minutes = path.time / 60.0
        took = f"{minutes / 60.0:.1f} h" if minutes >= 100.0 else f"{minutes:.0f} min"
        lines = [
            f"{path.layer_count} layers, {path.length / 1000.0:.1f} m, {took} without acceleration",
            f"{path.extruded_volume / 1000.0:.1f} ml"
            + ("" if path.grams is None else f", {path.grams:.0f} g as printed"),
        ]
        if path.refills:
            lines.append(f"The tube is filled again {path.refills} times")
        self.totals.setText("\n".join(lines))
        self.risks.clear()
        self.risks.addItems([sentence(finding) for finding in path.findings])
        self._colour()

    def _refused(self, error: Exception) -> None:
        self.path = None
        self.view.show_path(None)
        self.risks.clear()
        self.range.clear()
        self.totals.setText(reason(error))

    def _colour(self) -> None:
        measure = str(self.colouring.currentData())
        self.view.colour_by(measure)
        self.range.setText("" if self.path is None else MEASURES[measure].range(self.path))

    def done(self, result: int) -> None:
        """End with what is being made dropped."""
        self._timer.stop()
        self._jobs.drop_all()
        self._jobs.wait()
        super().done(result)
