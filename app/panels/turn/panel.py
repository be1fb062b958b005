"""How the profile turns and how large it is: axis, angles, unit, height, diameter, scale."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.panels.turn.placement import PlaceSection
from app.state.number_edits import NumberEdits, Span, around
from app.state.presenter import Frame, Presenter
from app.theme import icons
from app.widgets.combo_box import QuietComboBox
from app.widgets.labels import take_labels
from app.widgets.number_field import NumberField
from app.widgets.slider_row import SliderRow
from sgb_core.document import edits
from sgb_core.document.evaluation import evaluate
from sgb_core.document.model import Document, Unit
from sgb_core.surfaces.revolution import Axis

_AXIS_TIPS = {
    Axis.X: "Turn about the x-axis: the height of the profile lies along x",
    Axis.Y: "Turn about the y-axis: the height of the profile lies along y",
    Axis.Z: "Turn about the z-axis: the height of the profile lies along z",
}
# Drags of the angles land on half degrees, with Shift on twentieths.
_ANGLE_GRAIN = 0.5


class TurnPanel(QWidget):
    """Rotation and size of the document, by slider and by number."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._edits = NumberEdits(presenter, self, lambda: self._show(presenter.frame))
        self.sway = self._edits.sway
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 8, 8, 10)
        layout.setSpacing(6)
        layout.addWidget(_heading("Rotation"))
        layout.addLayout(self._build_axes())
        self.start = self._angle("Start", -180.0, 180.0, 0.0, (None, None))
        self.start.set_help("Angle at which the turn starts, in degrees, from the profile's plane")
        self.sweep = self._angle("Sweep", 1.0, 360.0, 360.0, (0.0, 360.0))
        self.sweep.set_help("How far the profile turns: above 0 and at most 360 degrees")
        width = max(row.label.sizeHint().width() for row in (self.start, self.sweep)) + 4
        for row in (self.start, self.sweep):
            row.label.setMinimumWidth(width)
            layout.addWidget(row)
        layout.addSpacing(8)
        layout.addWidget(_heading("Size"))
        sizes = self._build_sizes()
        self._build_scale(sizes)
        layout.addLayout(sizes)
        layout.addSpacing(8)
        self.place = PlaceSection(presenter, self)
        layout.addWidget(self.place)
        layout.addStretch(1)
        connect = self._edits.connect
        for row, name, angle in (
            (self.start, "Start angle", lambda v: partial(edits.set_revolution, start_deg=v)),
            (self.sweep, "Sweep", lambda v: partial(edits.set_revolution, sweep_deg=v)),
        ):
            connect(row, name, angle, _whole(row))
        for field, name, edit in (
            (self.height_field, "Height", edits.set_height),
            (self.diameter_field, "Largest diameter", edits.set_largest_diameter),
            (self.scale_field, "Scale", edits.scale),
        ):
            connect(field, name, lambda v, edit=edit: lambda d: edit(d, v), around(field))
        take_labels(self)
        self.scale_field.ended.connect(lambda: self.scale_field.set_value(1.0))

    # Building.

    def _build_axes(self) -> QHBoxLayout:
        self._axes = QButtonGroup(self)
        self.axis_buttons: dict[Axis, QToolButton] = {}
        row = QHBoxLayout()
        row.setSpacing(0)
        label = QLabel("Axis", self)
        row.addWidget(label)
        row.addSpacing(8)
        for axis, place in zip(Axis, ("first", "middle", "last"), strict=True):
            button = QToolButton(self)
            button.setText(axis.value)
            button.setCheckable(True)
            button.setProperty("segment", place)
            button.setToolTip(_AXIS_TIPS[axis])
            button.setAccessibleName(f"Axis {axis.value}")
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.clicked.connect(partial(self._choose_axis, axis))
            self._axes.addButton(button)
            self.axis_buttons[axis] = button
            row.addWidget(button, 1)
        return row

    def _angle(
        self,
        label: str,
        low: float,
        high: float,
        neutral: float,
        typed: tuple[float | None, float | None],
    ) -> SliderRow:
        row = SliderRow(
            label,
            low,
            high,
            neutral,
            1.0,
            unit="deg",
            grain=_ANGLE_GRAIN,
            typed=typed,
            above_low=True,
            parent=self,
        )
        row.set_name(f"{label} angle in degrees")
        return row

    def _build_sizes(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(6)
        grid.setColumnStretch(1, 1)
        self.unit = QuietComboBox(self)
        for unit in Unit:
            self.unit.addItem({"mm": "mm", "cm": "cm", "in": "inch"}[unit.value], unit.value)
        self.unit.setAccessibleName("Unit")
        self.unit.setToolTip("The unit of all lengths of this document")
        self.unit.activated.connect(self._choose_unit)
        self.keep_size = QCheckBox("Keep true size", self)
        self.keep_size.setChecked(True)
        self.keep_size.setToolTip(
            "On: the numbers are converted and the size stays.\n"
            "Off: the numbers stay and mean the new unit."
        )
        grid.addWidget(QLabel("Unit", self), 0, 0)
        grid.addWidget(self.unit, 0, 1)
        grid.addWidget(self.keep_size, 1, 1, 1, 2)
        self.height_field = self._length("Height", 2, grid, self._height_before)
        self.height_field.set_help("Stretch the profile along its axis to this height")
        self.diameter_field = self._length("Diameter", 3, grid, self._diameter_before)
        self.diameter_field.set_help("Stretch the profile away from its axis to this diameter")
        self.diameter_field.setAccessibleName("Largest diameter")
        return grid

    def _length(
        self, name: str, line: int, grid: QGridLayout, before: Callable[[], float]
    ) -> NumberField:
        field = NumberField(minimum=0.0, above_minimum=True, unit="mm", reset=before, parent=self)
        field.setAccessibleName(name)
        field.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        label = QLabel(name, self)
        label.setBuddy(field)
        grid.addWidget(label, line, 0)
        grid.addWidget(field, line, 1, 1, 2)
        return field

    def _build_scale(self, grid: QGridLayout) -> None:
        self.scale_field = NumberField(
            minimum=0.0, above_minimum=True, step=0.05, decimals=4, reset=1.0, parent=self
        )
        self.scale_field.setAccessibleName("Scale factor")
        self.scale_field.set_help("Enter a factor: the whole profile becomes that much larger")
        self.scale_field.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        label = QLabel("Scale ×", self)
        label.setBuddy(self.scale_field)
        grid.addWidget(label, 4, 0)
        grid.addWidget(self.scale_field, 4, 1)
        row = QHBoxLayout()
        row.setSpacing(6)
        for text, factor in (("½", 0.5), ("2", 2.0)):
            button = self._button(f"× {text}", f"Scale the profile by {text}")
            button.setAccessibleName(f"Scale by {text}")
            button.clicked.connect(lambda _checked=False, value=factor: self._scale_by(value))
            row.addWidget(button, 1)
        self.flip = self._button("Flip", "Turn the profile upside down")
        self.flip.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        icons.bind(self.flip, "flip")
        self.flip.clicked.connect(
            lambda: self._presenter.do("Flip upside down", edits.mirror_height)
        )
        row.addWidget(self.flip, 2)
        grid.addLayout(row, 5, 0, 1, 3)

    def _button(self, text: str, tip: str) -> QToolButton:
        button = QToolButton(self)
        button.setText(text)
        button.setToolTip(tip)
        button.setProperty("segment", "only")
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        return button

    # What is chosen.

    def _choose_axis(self, axis: Axis) -> None:
        self._presenter.do(f"Axis {axis.value}", partial(edits.set_revolution, axis=axis))

    def _choose_unit(self, index: int) -> None:
        unit, convert = Unit(self.unit.itemData(index)), self.keep_size.isChecked()
        if unit != self._presenter.document.unit:
            self._presenter.do(
                f"Unit {unit.value}", lambda document: edits.set_unit(document, unit, convert)
            )

    def _scale_by(self, factor: float) -> None:
        self._presenter.do(f"Scale × {factor:g}", partial(_scale, factor=factor))

    def _height_before(self) -> float:
        """Return the height that the document had when it was opened or last saved."""
        return _sizes(self._edits.origin, self._presenter.document.unit)[0]

    def _diameter_before(self) -> float:
        return _sizes(self._edits.origin, self._presenter.document.unit)[1]

    # Showing.

    def refresh(self, frame: Frame) -> None:
        """Show ``frame``; each control leaves a value alone that it shows already.

        Not by the document's identity: a button that was just pressed has changed by itself.
        """
        self._show(frame)

    def _show(self, frame: Frame) -> None:
        self.place.refresh(frame)
        document = frame.document
        self.axis_buttons[document.revolution.axis].setChecked(True)
        self.start.set_number(document.revolution.start_deg)
        self.sweep.set_number(document.revolution.sweep_deg)
        unit = document.unit.value
        with QSignalBlocker(self.unit):
            self.unit.setCurrentIndex(self.unit.findData(unit))
        height, diameter = frame.evaluation.facts.size
        self.height_field.set_unit(unit)
        self.diameter_field.set_unit(unit)
        self.height_field.set_value(height)
        self.diameter_field.set_value(diameter)


def _whole(row: SliderRow) -> Span:
    return lambda: row.range


def _sizes(document: Document, unit: Unit) -> tuple[float, float]:
    """Return height and largest diameter of a document in a unit."""
    height, diameter = evaluate(document).facts.size
    factor = document.unit.factor_to(unit)
    return factor * height, factor * diameter


def _scale(document: Document, factor: float) -> Document:
    return edits.scale(document, factor)


def _heading(text: str) -> QLabel:
    label = QLabel(text)
    label.setProperty("role", "heading")
    return label
