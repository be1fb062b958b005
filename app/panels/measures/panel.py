"""The measures of the drawn surface and of its body, to read, to copy and to solve for."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np
from PySide6.QtCore import QSettings, Qt, QTimer
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import (
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.panels.measures.lines import (
    ALL_LINES,
    BODY,
    CLAY,
    DRAWN,
    ENCLOSED,
    GEOMETRY,
    HOLDS,
    LIQUIDS,
    SIZES,
    STABILITY,
    BodyMeasure,
    Measure,
    Units,
)
from app.panels.measures.making import ClayParts, HoldParts
from app.state.body_work import same_body
from app.state.presenter import Frame, Presenter
from app.state.stored import stored, stored_number
from app.theme import icons
from app.widgets.combo_box import QuietComboBox
from app.widgets.number_field import NumberField
from app.widgets.steady_label import SteadyLabel
from sgb_core.bodies.solid import BodyKind
from sgb_core.document import edits
from sgb_core.document.evaluation import Evaluation
from sgb_core.document.model import Unit

# The least time between two measurings.
PAUSE_MILLISECONDS = 150
# Beyond this lean most printers need support.
OVERHANG_DEG = 45.0
_AT_START = np.array(0.0)


class MeasuresPanel(QWidget):
    """Measures a few times a second, and only while it can be seen.

    Where laws hold that takes too long for a hand in motion: it waits until the hand has stopped.
    """

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._frame: Frame | None = None
        self._shown: Evaluation | None = None
        self._shown_body: object = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(PAUSE_MILLISECONDS)
        self._timer.timeout.connect(self._measure)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 8, 10, 10)
        layout.setSpacing(8)
        layout.addLayout(self._build_units())
        self.values: dict[str, QLabel] = {}
        self.body_values: dict[str, QLabel] = {}
        # What is shown of vessels, of all bodies, and of bare surfaces only.
        self._vessel_parts: list[QWidget] = []
        self._body_parts: list[QWidget] = []
        self._bare_parts: list[QWidget] = []
        self.holding, self.clay = HoldParts(presenter, self), ClayParts(presenter, self)
        self._build_holds(layout)
        layout.addWidget(_heading("Size"))
        self._bare_parts.append(self._lines(SIZES, self.values))
        layout.addWidget(self._bare_parts[-1])
        for lines, values in ((BODY, self.body_values), (DRAWN, self.values)):
            self._body_parts.append(self._lines(lines, values))
            layout.addWidget(self._body_parts[-1])
        layout.addWidget(_heading("Clay"))
        self._body_parts.append(self._lines(CLAY, self.body_values))
        layout.addWidget(self._body_parts[-1])
        layout.addWidget(self.clay)
        self._build_stability(layout)
        layout.addWidget(_heading("Geometry"))
        layout.addWidget(self._lines(GEOMETRY, self.values))
        self.copy_button = QPushButton("Copy all", self)
        icons.bind(self.copy_button, "copy")
        self.copy_button.setToolTip("Copy all measures as text")
        self.copy_button.clicked.connect(self.copy_all)
        layout.addWidget(self.copy_button, 0, Qt.AlignmentFlag.AlignRight)
        layout.addStretch(1)

    # Building.

    def _build_units(self) -> QHBoxLayout:
        self.length_unit, self.liquid_unit = QuietComboBox(self), QuietComboBox(self)
        self.length_unit.addItem("As drawn", "")
        for unit in Unit:
            self.length_unit.addItem("inch" if unit is Unit.IN else unit.value, unit.value)
        self.liquid_unit.addItem("ml, l or fl oz", "")
        for name in LIQUIDS:
            self.liquid_unit.addItem(name, name)
        self.length_unit.setAccessibleName("Unit of lengths, areas and volumes")
        self.liquid_unit.setAccessibleName("Unit of liquids")
        self.length_unit.setToolTip("In which unit lengths, areas and volumes are told")
        self.liquid_unit.setToolTip("In which unit liquids are told; fl oz are those of the US")
        row = QHBoxLayout()
        for box, key in ((self.length_unit, "length"), (self.liquid_unit, "liquid")):
            box.setCurrentIndex(stored(f"measures/{key}", 0, partial(_index_in, box)))
            box.activated.connect(self._units_chosen)
            box.setMinimumWidth(60)
            row.addWidget(box, 1)
        return row

    def _build_holds(self, layout: QVBoxLayout) -> None:
        layout.addWidget(_heading("Holds"))
        self._vessel_parts.append(self._lines(HOLDS, self.body_values))
        self._bare_parts.append(self._lines(ENCLOSED, self.values))
        self.make_vessel = QPushButton("Make it a vessel", self)
        self.make_vessel.setToolTip("Give the surface a wall and a floor: then it holds something")
        self.make_vessel.clicked.connect(
            lambda: self._presenter.do(
                "Body: vessel", lambda document: edits.set_solid(document, kind="vessel")
            )
        )
        self._bare_parts.append(self.make_vessel)
        for part in (*self._vessel_parts, *self._bare_parts, self.holding):
            layout.addWidget(part)

    def _build_stability(self, layout: QVBoxLayout) -> None:
        heading = _heading("Stability")
        holder = self._lines(STABILITY, self.body_values)
        grid = holder.layout()
        assert isinstance(grid, QGridLayout)
        self._build_overhang(grid, holder)
        for part in (heading, holder):
            self._body_parts.append(part)
            layout.addWidget(part)

    def _lines(self, lines: Sequence[Measure | BodyMeasure], values: dict[str, QLabel]) -> QWidget:
        """Return a grid of names and values; the values' labels are put into ``values``."""
        holder = QWidget(self)
        grid = QGridLayout(holder)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(10)
        grid.setVerticalSpacing(5)
        grid.setColumnStretch(1, 1)
        for number, line in enumerate(lines):
            name = QLabel(line.name, holder)
            name.setProperty("role", "muted")
            name.setToolTip(line.meaning)
            values[line.name] = _value_label(line.name, line.meaning, holder)
            grid.addWidget(name, number, 0)
            grid.addWidget(values[line.name], number, 1, Qt.AlignmentFlag.AlignRight)
        return holder

    def _build_overhang(self, grid: QGridLayout, holder: QWidget) -> None:
        tip = "Share of the area that leans over by more than this angle from the vertical"
        row = QHBoxLayout()
        label = QLabel("Overhang over", holder)
        label.setProperty("role", "muted")
        label.setToolTip(tip)
        self.limit = NumberField(
            minimum=0.0, maximum=90.0, step=5.0, unit="deg", reset=OVERHANG_DEG, parent=self
        )
        self.limit.setAccessibleName("Overhang angle in degrees")
        self.limit.set_help(tip)
        self.limit.setMaximumWidth(64)
        self.limit.set_value(stored_number("measures/overhang", OVERHANG_DEG, 0.0, 90.0))
        self.limit.changed.connect(self._limit_changed)
        label.setBuddy(self.limit)
        self.limit.take_label(label)
        self.limit.refused.connect(lambda text: self._presenter.notify(text, "warning"))
        self.body_values["Overhang"] = _value_label("Overhang", tip, holder)
        row.addWidget(self.limit)
        row.addStretch(1)
        row.addWidget(self.body_values["Overhang"])
        line = grid.rowCount()
        grid.addWidget(label, line, 0)
        grid.addLayout(row, line, 1)

    # What is asked.

    @property
    def units(self) -> Units:
        """The units in which measures are told."""
        length, liquid = self.length_unit.currentData(), self.liquid_unit.currentData()
        return Units(Unit(length) if length else None, str(liquid) or None)

    def refresh(self, frame: Frame) -> None:
        """Note ``frame``; what is newest then is measured in a moment."""
        self._frame = frame
        self._show_making(frame)
        if self.isVisible() and self._is_stale(frame) and not self._timer.isActive():
            self._timer.start()

    def _show_making(self, frame: Frame) -> None:
        self.holding.show_frame(frame, self.units)
        self.clay.show_frame(frame, self.units)
        kind = frame.document.solid.kind
        for parts, shown in (
            (self._vessel_parts, kind is BodyKind.VESSEL),
            (self._body_parts, kind is not BodyKind.SURFACE),
            (self._bare_parts, kind is BodyKind.SURFACE),
        ):
            for part in parts:
                part.setVisible(shown)

    def copy_all(self) -> None:
        """Put all measures on the clipboard, a line each."""
        self._measure()
        order = [line.name for line in ALL_LINES] + ["Overhang"]
        lines = []
        for name in order:
            for label in (self.body_values.get(name), self.values.get(name)):
                holder = None if label is None else label.parentWidget()
                if label is not None and holder is not None and not holder.isHidden():
                    lines.append(f"{name}: {label.text()}")
        QGuiApplication.clipboard().setText("\n".join(lines))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._frame is not None and self._is_stale(self._frame):
            self._timer.start()

    def _is_stale(self, frame: Frame) -> bool:
        return frame.evaluation is not self._shown or frame.body is not self._shown_body

    def _units_chosen(self) -> None:
        settings = QSettings()
        settings.setValue("measures/length", self.length_unit.currentData())
        settings.setValue("measures/liquid", self.liquid_unit.currentData())
        self._show_anew()

    def _limit_changed(self, value: float) -> None:
        QSettings().setValue("measures/overhang", value)
        self._show_anew()

    def _show_anew(self) -> None:
        self._shown = self._shown_body = None
        if self._frame is not None:
            self._show_making(self._frame)
            self._measure()
            # Others, as the status bar, read in the same units.
            self._presenter.refresh_now()

    def _measure(self) -> None:
        frame = self._frame
        if frame is None or not self._is_stale(frame):
            return
        if frame.dragging and frame.evaluation.surface.laws:
            self._timer.start()
            return
        units = self.units
        if frame.evaluation is not self._shown:
            self._shown = frame.evaluation
            for measure in (*ENCLOSED, *SIZES, *DRAWN, *GEOMETRY):
                self.values[measure.name].setText(measure.read(frame.evaluation, units))
        self._measure_body(frame, units)

    def _measure_body(self, frame: Frame, units: Units) -> None:
        state = frame.body
        self._shown_body = state
        if state is None:
            return
        if not frame.dragging and not same_body(state.document, frame.document):
            # The body of this document is being made: none of these numbers is its own.
            for label in self.body_values.values():
                label.setText("…")
            return
        found = state.measures
        if found is None or state.mesh is None:
            # With laws a coarse body is soon followed by the fine one with its measures.
            if state.error is not None:
                for label in self.body_values.values():
                    label.setText("–")
            return
        document = frame.document
        for measure in (*HOLDS, *BODY, *CLAY, *STABILITY):
            self.body_values[measure.name].setText(measure.read(document, found, units))
        from sgb_core.bodies.stability import overhang

        share = overhang(state.mesh, state.surface.directions(_AT_START)[2], self.limit.value)
        self.body_values["Overhang"].setText(f"{100.0 * share:.1f} %")


def _value_label(name: str, meaning: str, parent: QWidget) -> QLabel:
    value = SteadyLabel(parent)
    value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    value.setText("–")
    value.setTextInteractionFlags(
        Qt.TextInteractionFlag.TextSelectableByMouse
        | Qt.TextInteractionFlag.TextSelectableByKeyboard
    )
    value.setAccessibleName(name)
    value.setToolTip(meaning)
    return value


def _heading(text: str) -> QLabel:
    label = QLabel(text)
    label.setProperty("role", "heading")
    return label


def _index_in(box: QComboBox, value: object) -> int:
    index: int = box.findData(value)
    if index < 0:
        raise ValueError(value)
    return index
