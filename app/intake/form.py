"""The controls of the sheet: what there is to say of a source, for its kind."""

from __future__ import annotations

import re
from dataclasses import replace
from math import degrees, log10, radians
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.intake.work import Traced
from app.widgets.combo_box import QuietComboBox
from app.widgets.form import Row, add_rows, named, offering
from app.widgets.labels import take_labels
from app.widgets.mark_slider import MarkSlider
from app.widgets.number_field import NumberField
from sgb_core.document.model import Unit
from sgb_core.sources import Opened, Options, ScaleBar, Side
from sgb_core.sources.drawing import Drawing
from sgb_core.sources.options import MOST_LEAN

# The slider of the tolerance: powers of ten of the size.
_FINEST, _COARSEST, _USUAL = -4.0, -1.5, -3.0
_NUMBERS = re.compile(r"[-+]?\d+(?:\.\d+)?")
_BY_HEIGHT, _BY_POINTS, _BY_PIXEL = "height", "points", "pixel"
_OUTLINE, _LINE = "outline", "line"
Pair = tuple[float, float]


class SourceForm(QWidget):
    """Makes options of what is chosen; ``changed`` when they may have changed."""

    changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._kind, self._size, self._quiet = "", 0.0, False
        self._axis_given = self._threshold_given = False
        self.clicks: tuple[Pair, ...] = ()
        self.bar: tuple[Pair, Pair] = ((0.0, 0.0), (100.0, 0.0))
        self._tolerance_given = False
        self._build()
        self._connect()

    def _build(self) -> None:
        self.path = QuietComboBox()
        self.way = offering(
            QuietComboBox(), [("Outline of the object", _OUTLINE), ("A line, by clicks", _LINE)]
        )
        self.threshold = MarkSlider(0.02, 0.98, 0.5, 0.02)
        self.clicks_text = QLineEdit()
        self.clicks_text.setPlaceholderText("Click along the line")
        self.axis = NumberField(decimals=2)
        self.find_axis = QPushButton("Find")
        self.find_axis.setAutoDefault(False)
        self.mesh_axis = offering(
            QuietComboBox(), [("found", None), *((letter, letter) for letter in "xyz")]
        )
        self.lean = NumberField(minimum=-degrees(MOST_LEAN), maximum=degrees(MOST_LEAN), step=0.1)
        sides = [("both, their mean", Side.BOTH), ("left", Side.LEFT), ("right", Side.RIGHT)]
        self.side = offering(QuietComboBox(), sides)
        self.scaling = offering(
            QuietComboBox(),
            [
                ("true height", _BY_HEIGHT),
                ("two points", _BY_POINTS),
                ("length of a pixel", _BY_PIXEL),
            ],
        )
        self.length = NumberField(minimum=0.0, above_minimum=True, reset=100.0)
        self.bar_text = QLineEdit()
        self.slider = MarkSlider(_FINEST, _COARSEST, _USUAL, 0.05, grain=0.01)
        self.tolerance = NumberField(minimum=0.0, above_minimum=True, decimals=4, step=0.01)
        self.merge = QCheckBox("Fewer segments, within the tolerance")
        self._build_rows()

    def _build_rows(self) -> None:
        axis, tolerance = QHBoxLayout(), QHBoxLayout()
        for box, parts in ((axis, (self.axis, self.find_axis)), (tolerance, (self.tolerance,))):
            for part in parts:
                box.addWidget(part)
        tolerances = QVBoxLayout()
        tolerances.addWidget(self.slider)
        tolerances.addLayout(tolerance)
        named(self.axis, "Axis", "Abscissa of the axis in the source's own units, or drag the line")
        named(self.find_axis, "Find the axis", "Find the axis by the symmetry of what is seen")
        named(self.slider, "Tolerance", "How far the curve may be from the source; fewer segments")
        named(self.tolerance, "Tolerance, number", "Largest distance of a point from the curve")
        self.form = QFormLayout(self)
        self.form.setContentsMargins(0, 0, 0, 0)
        self.form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self._rows: dict[str, Any] = {
            "path": self.path,
            "way": self.way,
            "threshold": self.threshold,
            "clicks": self.clicks_text,
            "axis": axis,
            "mesh_axis": self.mesh_axis,
            "lean": self.lean,
            "side": self.side,
            "scaling": self.scaling,
            "length": self.length,
            "bar": self.bar_text,
            "tolerance": tolerances,
            "merge": self.merge,
        }
        for key, (label, tip, name) in _WORDS.items():
            add_rows(self.form, [Row(label, self._rows[key], tip, name)])
        take_labels(self)

    def _connect(self) -> None:
        for box in (self.path, self.mesh_axis, self.side):
            box.currentIndexChanged.connect(self._tell)
        for box in (self.way, self.scaling):
            box.currentIndexChanged.connect(self._show_rows)
        for field in (self.length, self.threshold):
            field.changed.connect(self._tell)
        self.axis.changed.connect(self._give_axis)
        self.lean.changed.connect(self._give_axis)
        self.find_axis.clicked.connect(self._forget_axis)
        self.slider.changed.connect(self._slide)
        self.tolerance.changed.connect(self._give_tolerance)
        self.merge.toggled.connect(self._tell)
        self.clicks_text.editingFinished.connect(self._type_clicks)
        self.bar_text.editingFinished.connect(self._type_bar)

    # What is shown.

    def show_source(self, source: Opened, unit: Unit, height: float) -> None:
        """Offer what there is to say of a source, for a document of this unit and height."""
        self._quiet = True
        self._kind, self._size = source.source.kind, 0.0
        self._axis_given = self._tolerance_given = False
        content = source.content
        self.path.clear()
        if isinstance(content, Drawing):
            for number in range(min(len(content.paths), 200)):
                self.path.addItem(
                    f"{number + 1}, likely" if number == 0 else f"{number + 1}", number
                )
        self.clicks = ()
        if source.data is not None:
            rows, columns = content.shape
            self.bar = ((0.1 * columns, 0.95 * rows), (0.3 * columns, 0.95 * rows))
        for field in (self.length, self.tolerance):
            field.set_unit(str(unit))
        self.length.set_value(float(f"{height:.3g}") or 100.0)
        self.threshold.set_number(0.5)
        self._threshold_given = False
        self.way.setCurrentIndex(0)
        self.slider.set_number(_USUAL)
        self._quiet = False
        self._show_rows()

    def show_traced(self, traced: Traced) -> None:
        """Show what was found where nothing was given: axis, lean, tolerance."""
        found = traced.taken.trace
        self._size = found.profile.size
        self._quiet = True
        if not self._axis_given and len(traced.reading.axis) == 1:
            self.axis.set_value(traced.reading.axis[0])
            self.lean.set_value(
                0.0 if traced.reading.frame is None else degrees(traced.reading.frame.turn)
            )
        if not self._tolerance_given:
            self.tolerance.set_value(found.tolerance)
            self.slider.set_number(self._power(found.tolerance))
        both = traced.reading.right is not None and traced.reading.left is not None
        self.form.setRowVisible(self.side, both)
        self.form.setRowVisible(self.merge, traced.taken.kind in _DRAWINGS)
        self._quiet = False

    def set_axis(self, place: float, lean: float) -> None:
        """Take an axis that was dragged."""
        self.axis.set_value(place)
        self.lean.set_value(degrees(lean))
        self._give_axis()

    def set_clicks(self, clicks: tuple[Pair, ...]) -> None:
        """Take clicks along a line."""
        self.clicks = clicks
        self.clicks_text.setText(" ".join(f"{x:g},{y:g}" for x, y in clicks))
        self._tell()

    def set_bar(self, bar: tuple[Pair, Pair]) -> None:
        """Take the two points whose distance is given."""
        self.bar = bar
        self._show_bar()
        self._tell()

    def set_path(self, number: int) -> None:
        """Choose a path."""
        self.path.setCurrentIndex(self.path.findData(number))

    @property
    def follows_line(self) -> bool:
        """Whether clicks along a line are wanted."""
        return self._kind == "picture" and self.way.currentData() == _LINE

    @property
    def scales_by_points(self) -> bool:
        """Whether two points of the picture say its scale."""
        return self._kind == "picture" and self.scaling.currentData() == _BY_POINTS

    @property
    def is_mesh(self) -> bool:
        """Whether the source lies in space."""
        return self._kind in _MESHES

    def options(self, unit: Unit) -> Options:
        """Return the options that are chosen; raises SourceError for what cannot be."""
        chosen = Options(
            unit=unit,
            tolerance=self.tolerance.value if self._tolerance_given else None,
            side=Side(self.side.currentData()),
            path=self.path.currentData() or 0,
            merge=self.merge.isChecked(),
        )
        if self.is_mesh:
            return replace(chosen, axis=self.mesh_axis.currentData())
        if self._axis_given:
            chosen = replace(chosen, axis=self.axis.value)
        if self._kind != "picture":
            return chosen
        by, length = self.scaling.currentData(), self.length.value
        return replace(
            chosen,
            lean=radians(self.lean.value) if self._axis_given else 0.0,
            height=length if by == _BY_HEIGHT else None,
            scale=length if by == _BY_PIXEL else None,
            scale_bar=ScaleBar(*self.bar, length) if by == _BY_POINTS else None,
            threshold=self.threshold.number if self._threshold_given else None,
            clicks=self.clicks if self.follows_line else (),
        )

    # What the controls lead to.

    def _show_rows(self) -> None:
        picture, mesh = self._kind == "picture", self.is_mesh
        shown = {
            "path": self.path.count() > 1,
            "way": picture,
            "threshold": picture and not self.follows_line,
            "clicks": self.follows_line,
            "axis": not mesh,
            "mesh_axis": mesh,
            "lean": picture,
            "side": False,
            "scaling": picture,
            "length": picture,
            "bar": self.scales_by_points,
            "merge": False,
        }
        for key, visible in shown.items():
            self.form.setRowVisible(self._rows[key], visible)
        self._show_bar()
        if self.follows_line:
            # The axis of a line is none that could be found: it begins where it was.
            self._axis_given = True
        self._tell()

    def _show_bar(self) -> None:
        (a, b), (c, d) = self.bar
        self.bar_text.setText(f"{a:g},{b:g} {c:g},{d:g}")

    def _power(self, tolerance: float) -> float:
        share = tolerance / self._size if self._size > 0.0 else 10.0**_USUAL
        return min(max(log10(share), _FINEST), _COARSEST)

    def _slide(self, power: float) -> None:
        if self._size > 0.0:
            self._tolerance_given = True
            self.tolerance.set_value(float(f"{10.0**power * self._size:.3g}"))
            self._tell()

    def _give_tolerance(self, value: float) -> None:
        self._tolerance_given = True
        self.slider.set_number(self._power(value))
        self._tell()

    def _give_axis(self) -> None:
        if not self._quiet:
            self._axis_given = True
            self._tell()

    def _forget_axis(self) -> None:
        self._axis_given = False
        self._tell()

    def _type_clicks(self) -> None:
        pairs = _pairs(self.clicks_text.text())
        if pairs != self.clicks:
            self.set_clicks(pairs)

    def _type_bar(self) -> None:
        pairs = _pairs(self.bar_text.text())
        if len(pairs) == 2 and pairs != self.bar:
            self.set_bar((pairs[0], pairs[1]))

    def _tell(self) -> None:
        if self.sender() is self.threshold:
            self._threshold_given = True
        if not self._quiet:
            self.changed.emit()


def _pairs(text: str) -> tuple[Pair, ...]:
    numbers = [float(word) for word in _NUMBERS.findall(text)]
    return tuple(zip(numbers[::2], numbers[1::2], strict=False))


_DRAWINGS = ("svg", "dxf")
_MESHES = ("stl", "obj", "ply", "glb", "3mf")
_WORDS: dict[str, tuple[str, str, str]] = {
    "path": ("Path", "Which path of the drawing becomes the profile; or click on it", "Path"),
    "way": ("Trace", "What of the picture becomes the profile", "Trace"),
    "threshold": ("Threshold", "How dark (or how unlike the ground) the object is", "Threshold"),
    "clicks": ("Clicks", "Places along the line, in pixels: x,y x,y …", "Clicks along the line"),
    "axis": ("Axis", "", ""),
    "mesh_axis": ("Axis", "About which axis the object turns", "Axis"),
    "lean": ("Leans by", "How many degrees the axis leans, to the right downwards", "Lean"),
    "side": ("Side", "Which side of the axis becomes the profile", "Side"),
    "scaling": ("Scale by", "What says how large the picture is", "Scale by"),
    "length": ("Length", "True height, distance of the two points, or length of a pixel", "Length"),
    "bar": ("Points", "The two points, in pixels; or drag them in the picture", "Scale points"),
    "tolerance": ("Tolerance", "", ""),
    "merge": ("", "Trace exact lines and curves too; without, each is kept as it is", "Merge"),
}
