"""Fill line, target volume, material and shrinkage: the part of the measures that can be set."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QSettings, QSignalBlocker
from PySide6.QtWidgets import (
    QCheckBox,
    QGridLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QWidget,
)

from app.hand.coordinates import nice_step
from app.panels.measures.lines import LIQUIDS, Units, shrinkage_text
from app.state.number_edits import NumberEdits
from app.state.presenter import Edit, Frame, Presenter
from app.state.stored import stored_number
from app.widgets.combo_box import QuietComboBox
from app.widgets.enter_key import on_enter
from app.widgets.labels import take_labels
from app.widgets.number_field import NumberField, Reset
from app.widgets.number_kind import limits
from sgb_core.bodies.solid import BodyKind
from sgb_core.document import edits
from sgb_core.document.manufacture import DENSITIES, MAX_DENSITY, Material, Shrinkage, Stage
from sgb_core.document.model import Document
from sgb_core.fields.kinds import COORDINATE, Kind, Range
from sgb_core.fields.record import table_of

STRETCHES = (("all", "Scale all"), ("height", "Only height"), ("radius", "Only radius"))
# Where the fill line is reset to: this part of the way from the foot to the rim.
FIRST_LINE = 0.9
# The fill line is counted down from the rim.
FROM_RIM = "rim"
# What is to be held until another volume is entered, in the unit that is shown.
FIRST_TARGET = 350.0
HOLDS = Range(above=0.0)
DENSITY = table_of(Material).row("density").kind
SHRINKAGE = table_of(Shrinkage).row("percent").kind
_NARROW = 70


class _Parts(QWidget):
    """A grid of labelled fields that edit what becomes of the object."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._edits = NumberEdits(presenter, self)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(8)
        self._grid.setVerticalSpacing(6)
        self._grid.setColumnStretch(1, 1)
        self.units = Units()
        self._build()
        take_labels(self)

    def _build(self) -> None:
        raise NotImplementedError

    def _row(self, name: str, tip: str, *parts: QWidget) -> QLabel:
        line = self._grid.rowCount()
        label = QLabel(name, self)
        label.setToolTip(tip)
        label.setBuddy(parts[0])
        self._grid.addWidget(label, line, 0)
        for column, part in enumerate(parts):
            part.setToolTip(tip) if not isinstance(part, NumberField) else part.set_help(tip)
            self._grid.addWidget(part, line, 1 + column)
        return label

    def _field(
        self, name: str, allowed: Kind, step: float, reset: Reset, unit: str = ""
    ) -> NumberField:
        field = NumberField(**limits(allowed), step=step, reset=reset, parent=self)
        field.set_suffix(unit)
        field.setAccessibleName(name)
        field.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        field.setMinimumWidth(_NARROW)
        return field

    def _combo(self, name: str, choices: tuple[tuple[str, str], ...]) -> QuietComboBox:
        box = QuietComboBox(self)
        for value, text in choices:
            box.addItem(text, value)
        box.setAccessibleName(name)
        # A narrow panel shows as much of the words as there is room for.
        box.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        box.setMinimumWidth(_NARROW)
        return box


class HoldParts(_Parts):
    """The volume to hold and the fill line."""

    def _build(self) -> None:
        self._build_hold()
        self._build_fill()

    def _build_hold(self) -> None:
        self.target = self._field("Volume to hold", HOLDS, 10.0, FIRST_TARGET, "ml")
        self.target.refused.connect(lambda text: self._presenter.notify(text, "warning"))
        on_enter(self.target, self.hold)
        self.stretch = self._combo("What changes to hold it", STRETCHES)
        tip = (
            "Type a volume and press Enter or Set: the profile is scaled until the object holds "
            "just that, to the fill line where there is one, else to the brim. Walls keep their "
            "thickness."
        )
        self._verb = self._row("Make it hold", tip, self.target)
        self.set_button = QPushButton("Set", self)
        self.set_button.setAccessibleName("Make it hold this volume")
        self.set_button.clicked.connect(self.hold)
        self.set_button.setToolTip(tip)
        self._row("By", "What of the profile changes", self.stretch, self.set_button)

    def _build_fill(self) -> None:
        self.fill_on = QCheckBox("Fill line", self)
        tip = "Where the fill line is; drag the blue line in the profile editor too"
        self.fill_on.setToolTip(tip)
        self.fill_on.clicked.connect(self._toggle_fill)
        self.fill = self._field("Height of the fill line", COORDINATE, 1.0, self._first_level)
        self.fill.set_help(tip)
        self._edits.connect(
            self.fill,
            "Fill line",
            self._fill_edit,
            lambda: (self._shown_level(self._level(0.0)), self._shown_level(self._level(1.0))),
        )
        self.fill_from = self._combo(
            "What the fill line is counted from", ((FROM_RIM, "Below the rim"), ("", "As height"))
        )
        self.fill_from.setToolTip(
            "Below the rim the line stays so far below it when the shape changes; as a height it "
            "stays where it is"
        )
        self.fill_from.activated.connect(self._choose_fill_from)
        line = self._grid.rowCount()
        self._grid.addWidget(self.fill_on, line, 0)
        self._grid.addWidget(self.fill, line, 1)
        self._grid.addWidget(self.fill_from, line + 1, 1)

    def hold(self) -> None:
        """Scale the profile until the object holds the wanted volume; one undo entry."""
        from sgb_core.document.edits.targets import hold

        self.target.finish()
        document = self._presenter.document
        unit = self._target_unit(document)
        stretch = str(self.stretch.currentData())
        volume = self.target.value * LIQUIDS[unit] / document.unit.millilitres
        done = self._presenter.do(
            f"Hold {self.target.value:g} {unit}", lambda d: hold(d, volume, stretch)
        )
        if done:
            verb = "holds" if document.solid.kind is BodyKind.VESSEL else "encloses"
            self._presenter.notify(
                f"It {verb} {self.target.value:g} {unit} {_to_where(document)} now."
            )

    def _target_unit(self, document: Document) -> str:
        return self.units.liquid_of(document)

    def _toggle_fill(self, wanted: bool) -> None:
        document = self._presenter.document
        below = _below_at_first(document) if wanted else None
        self._presenter.do("Fill line", partial(edits.set_fill, below_rim=below))

    def _fill_edit(self, value: float) -> Edit:
        if self.fill_from.currentData() == FROM_RIM:
            return partial(edits.set_fill, below_rim=value)
        return partial(edits.set_fill, height=value)

    def _choose_fill_from(self, _index: int) -> None:
        """Count the line from elsewhere; it stays where it is."""
        document = self._presenter.document
        height = document.fill_height
        if height is None:
            return
        below = max(0.0, document.rim_height - height)
        edit = (
            partial(edits.set_fill, below_rim=below)
            if self.fill_from.currentData() == FROM_RIM
            else partial(edits.set_fill, height=height)
        )
        self._presenter.do("Fill line", edit)

    def _level(self, part: float) -> float:
        """Return the height at a part of the way from the foot to the rim."""
        low, high = self._presenter.frame.evaluation.bounds
        return float(low[1] + part * (high[1] - low[1]))

    def _shown_level(self, height: float) -> float:
        """Return what the field shows for a line at a height."""
        if self.fill_from.currentData() != FROM_RIM:
            return height
        return max(0.0, self._presenter.document.rim_height - height)

    def _first_level(self) -> float:
        return self._shown_level(self._level(FIRST_LINE))

    # Showing.

    def show_frame(self, frame: Frame, units: Units) -> None:
        """Show what ``frame`` holds."""
        self.units = units
        document = frame.document
        fill = document.manufacture.fill
        vessel, lined = document.solid.kind is BodyKind.VESSEL, document.fill_height is not None
        self.fill_on.setChecked(lined)
        for part in (self.fill_on, self.fill, self.fill_from):
            part.setVisible(vessel)
        self.fill.setEnabled(lined)
        self.fill_from.setEnabled(lined)
        self.fill.set_unit(str(document.unit))
        if lined:
            with QSignalBlocker(self.fill_from):
                self.fill_from.setCurrentIndex(0 if fill.below_rim is not None else 1)
        shown = fill.height if fill.below_rim is None else fill.below_rim
        self.fill.set_range(*((0.0, None) if fill.below_rim is not None else (None, None)))
        self.fill.setAccessibleName(
            "Fill line below the rim" if fill.below_rim is not None else "Height of the fill line"
        )
        if shown is not None:
            self.fill.set_value(shown)
        self._verb.setText("Make it hold" if vessel else "Make it enclose")
        self.target.set_suffix(self._target_unit(document))


class ClayParts(_Parts):
    """Material, density and shrinkage."""

    def _build(self) -> None:
        self._build_material()
        self._build_shrinkage()

    def _build_material(self) -> None:
        names = tuple((name, name.capitalize()) for name in DENSITIES)
        self.material = self._combo("Material", names)
        self.material.activated.connect(self._choose_material)
        self._row("Material", "What it is made of; sets the density", self.material)
        self.density = self._field("Density", DENSITY, 0.01, self._usual_density, "g/cm³")
        self._edits.connect(
            self.density, "Density", lambda value: partial(edits.set_material, density=value)
        )
        self.density.ended.connect(self._remember_density)
        tip = "Density in grams per cubic centimetre; remembered for this material"
        self._row("Density", tip, self.density)

    def _build_shrinkage(self) -> None:
        self.percent = self._field("Shrinkage in percent", SHRINKAGE, 0.5, 0.0, "%")
        self._edits.connect(
            self.percent, "Shrinkage", lambda value: partial(edits.set_shrinkage, percent=value)
        )
        tip = "By how much the clay shrinks from wet to fired, 0 for none"
        self._row("Shrinkage", tip, self.percent)
        self.of = self._combo(
            "Shrinkage counts of",
            ((Stage.WET.value, "Of the wet size"), (Stage.FIRED.value, "Of the fired size")),
        )
        self.of.activated.connect(
            lambda at: self._shrinkage(partial(edits.set_shrinkage, of=self.of.itemData(at)))
        )
        tip = "Suppliers of clay mostly mean the wet size. At 12 % the two differ by over 1 %."
        self._row("Counts", tip, self.of)
        self.drawn = self._combo(
            "The drawing is of",
            ((Stage.FIRED.value, "The fired piece"), (Stage.WET.value, "The wet piece")),
        )
        self.drawn.activated.connect(
            lambda at: self._shrinkage(partial(edits.set_shrinkage, drawn=self.drawn.itemData(at)))
        )
        self._row("Drawn is", "Which of the two sizes the profile has", self.drawn)
        self.sizes = QLabel(self)
        self.sizes.setWordWrap(True)
        self.sizes.setProperty("role", "muted")
        self.sizes.setAccessibleName("Wet and fired size")
        self._grid.addWidget(self.sizes, self._grid.rowCount(), 0, 1, 3)

    # Editing.

    def _usual_density(self) -> float | None:
        return DENSITIES.get(self._presenter.document.manufacture.material.name)

    def _choose_material(self, index: int) -> None:
        name = str(self.material.itemData(index))
        density = stored_number(f"density/{name}", DENSITIES.get(name, 1.0), 0.0, MAX_DENSITY)
        self._presenter.do(
            f"Material {name}",
            lambda document: edits.set_material(document, name=name, density=density),
        )

    def _remember_density(self) -> None:
        material = self._presenter.document.manufacture.material
        QSettings().setValue(f"density/{material.name}", material.density)

    def _shrinkage(self, edit: Edit) -> None:
        self._presenter.do("Shrinkage", edit)

    # Showing.

    def show_frame(self, frame: Frame, units: Units) -> None:
        """Show what ``frame`` holds."""
        document = frame.document
        manufacture = document.manufacture
        self._show_material(manufacture.material.name, manufacture.material.density)
        self.percent.set_value(manufacture.shrinkage.percent)
        for box, value in (
            (self.of, manufacture.shrinkage.of),
            (self.drawn, manufacture.shrinkage.drawn),
        ):
            with QSignalBlocker(box):
                box.setCurrentIndex(box.findData(value.value))
        self.sizes.setVisible(manufacture.shrinkage.percent > 0.0)
        if manufacture.shrinkage.percent > 0.0:
            self.sizes.setText(shrinkage_text(document, *_size(frame), units))

    def _show_material(self, name: str, density: float) -> None:
        with QSignalBlocker(self.material):
            if self.material.findData(name) < 0:
                self.material.addItem(name, name)
            self.material.setCurrentIndex(self.material.findData(name))
        self.density.set_value(density)


def _size(frame: Frame) -> tuple[float, float]:
    """Return diameter and height of the body, of the drawn surface where there is none."""
    if frame.body is not None and frame.body.measures is not None:
        return frame.body.measures.diameter, frame.body.measures.height
    height, diameter = frame.evaluation.size
    return diameter, height


def _below_at_first(document: Document) -> float:
    """Return how far below the rim a new line lies: a tenth of the height, a round number."""
    low, high = document.profile.bounds()
    tenth = 0.1 * float(high[1] - low[1])
    return nice_step(tenth) if tenth > 0.0 else 0.0


def _to_where(document: Document) -> str:
    if document.solid.kind is not BodyKind.VESSEL:
        return "in all"
    return "to the brim" if document.fill_height is None else "to the line"
