"""What the drawn surface means as an object: surface, filled solid or vessel, and its wall."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import floor, log10

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QButtonGroup,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.state.number_binding import NumberEdits
from app.state.presenter import Edit, Frame, Presenter
from app.state.window_reader import told
from app.widgets.combo_box import QuietComboBox
from app.widgets.slider_row import SliderRow
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.document import edits
from sgb_core.document.model import Document

KINDS = (
    (BodyKind.SURFACE, "Surface", "The bare surface as drawn, without thickness"),
    (BodyKind.FILLED, "Filled", "A full solid: the ends of the profile are closed to the axis"),
    (BodyKind.VESSEL, "Vessel", "A pot: a wall of even thickness along the profile, and a floor"),
)
SIDES = (
    (WallSide.INSIDE, "inside the drawn line"),
    (WallSide.OUTSIDE, "outside the drawn line"),
)
RIMS = ((Rim.FLAT, "flat"), (Rim.ROUND, "rounded"))
_DEFAULT = Solid()
# Name in the document, label, tooltip, whether zero is allowed, what sets it, part of the size
# that the slider reaches to.
LENGTHS: tuple[tuple[str, str, str, bool, Callable[[Document, float], Document], float], ...] = (
    (
        "wall",
        "Wall",
        "How thick the wall is, measured straight through it and not level: shoulders and belly "
        "are as thick as the rest",
        False,
        lambda document, value: edits.set_solid(document, wall=value),
        0.06,
    ),
    (
        "base",
        "Base",
        "How thick the floor is. With 0 a profile that ends off the axis stays open below",
        True,
        lambda document, value: edits.set_solid(document, base=value),
        0.08,
    ),
    (
        "drain_hole",
        "Drain hole ⌀",
        "Width of a round hole through the middle of the floor; 0 is none",
        True,
        lambda document, value: edits.set_solid(document, drain_hole=value),
        0.15,
    ),
    (
        "foot_ring",
        "Foot ring",
        "Height of a ring below the floor to stand on, as wide as the wall; 0 is none",
        True,
        lambda document, value: edits.set_solid(document, foot_ring=value),
        0.06,
    ),
)


class SolidPanel(QWidget):
    """Kind, wall, side, base, rim, drain hole and foot ring, and what is doubtful about it."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._edits = NumberEdits(presenter, self, lambda: self._show(presenter.frame))
        self._reach: list[float] = []
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 8, 8, 10)
        layout.setSpacing(7)
        layout.addLayout(self._build_kinds())
        self.meaning = QLabel(self)
        self.meaning.setWordWrap(True)
        self.meaning.setProperty("role", "muted")
        layout.addWidget(self.meaning)
        self.wall_parts = QWidget(self)
        layout.addWidget(self.wall_parts)
        self._build_wall(self.wall_parts)
        self.findings = QLabel(self)
        self.findings.setAccessibleName("What is doubtful about the body")
        self.findings.setWordWrap(True)
        self.findings.setProperty("role", "warning")
        self.findings.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        layout.addWidget(self.findings)
        layout.addStretch(1)

    # Building.

    def _build_kinds(self) -> QHBoxLayout:
        group = QButtonGroup(self)
        self.kind_buttons: dict[BodyKind, QToolButton] = {}
        row = QHBoxLayout()
        row.setSpacing(0)
        for (kind, text, tip), place in zip(KINDS, ("first", "middle", "last"), strict=True):
            button = QToolButton(self)
            button.setText(text)
            button.setToolTip(tip)
            button.setAccessibleName(f"Body: {text}")
            button.setCheckable(True)
            button.setProperty("segment", place)
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.clicked.connect(partial(self._choose_kind, kind))
            group.addButton(button)
            self.kind_buttons[kind] = button
            row.addWidget(button, 1)
        return row

    def _build_wall(self, holder: QWidget) -> None:
        layout = QVBoxLayout(holder)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        self.rows: dict[str, SliderRow] = {}
        for key, label, tip, zero, edit, _part in LENGTHS:
            neutral = getattr(_DEFAULT, key)
            row = SliderRow(
                label,
                0.0,
                10.0,
                neutral,
                0.1,
                unit="mm",
                typed=(0.0, 1e9),
                above_low=not zero,
                parent=holder,
            )
            row.set_help(tip)
            row.set_name(label)
            self._edits.connect(row, label, partial(_sized, edit), partial(_sizes, row))
            self.rows[key] = row
            layout.addWidget(row)
        width = max(row.label.sizeHint().width() for row in self.rows.values()) + 4
        for row in self.rows.values():
            row.label.setMinimumWidth(width)
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(6)
        grid.setColumnStretch(1, 1)
        self.side = self._choice(
            grid, 0, "Wall lies", SIDES, "On which side of the drawn line the material is"
        )
        self.side.activated.connect(lambda at: self._choose_side(WallSide(self.side.itemData(at))))
        self.rim = self._choice(
            grid, 1, "Rim", RIMS, "Cut level, or rounded over across the wall, as high as drawn"
        )
        self.rim.activated.connect(lambda at: self._choose_rim(Rim(self.rim.itemData(at))))
        layout.addLayout(grid)

    def _choice(
        self,
        grid: QGridLayout,
        line: int,
        name: str,
        choices: tuple[tuple[WallSide, str], ...] | tuple[tuple[Rim, str], ...],
        tip: str,
    ) -> QuietComboBox:
        box = QuietComboBox(self)
        for value, text in choices:
            box.addItem(text, str(value))
        box.setAccessibleName(name)
        box.setToolTip(tip)
        label = QLabel(name, self)
        label.setToolTip(tip)
        label.setBuddy(box)
        grid.addWidget(label, line, 0)
        grid.addWidget(box, line, 1)
        return box

    # Editing.

    def _choose_kind(self, kind: BodyKind) -> None:
        self._choose("Body", kind, partial(edits.set_solid, kind=kind))

    def _choose_side(self, side: WallSide) -> None:
        self._choose("Side of the wall", side, partial(edits.set_solid, side=side))

    def _choose_rim(self, rim: Rim) -> None:
        self._choose("Rim", rim, partial(edits.set_solid, rim=rim))

    def _choose(self, what: str, chosen: str, edit: Edit) -> None:
        self._presenter.do(f"{what}: {chosen}", edit)
        self._show(self._presenter.frame)

    # Showing.

    def refresh(self, frame: Frame) -> None:
        """Show ``frame``; what the newest finished body says is shown when it is ready."""
        self._show(frame)

    def _show(self, frame: Frame) -> None:
        solid = frame.document.solid
        self.kind_buttons[solid.kind].setChecked(True)
        _set_text(self.meaning, next(tip for kind, _, tip in KINDS if kind is solid.kind) + ".")
        self.wall_parts.setVisible(solid.kind is BodyKind.VESSEL)
        self._set_limits(frame.document, frame.dragging)
        for key, row in self.rows.items():
            row.set_number(getattr(solid, key))
            row.field.set_unit(str(frame.document.unit))
        for box, value in ((self.side, solid.side), (self.rim, solid.rim)):
            with QSignalBlocker(box):
                box.setCurrentIndex(box.findData(str(value)))
        self._show_findings(frame)

    def _set_limits(self, document: Document, dragging: bool) -> None:
        """Let the sliders reach as far as is sensible for an object of this size."""
        reach = [_round(part * document.profile.size) for *_words, part in LENGTHS]
        if dragging or reach == self._reach or 0.0 in reach:
            return
        self._reach = reach
        for (key, *_words), high in zip(LENGTHS, reach, strict=True):
            # A hundredth of the range a step, a drag ten times finer.
            self.rows[key].slider.set_limits(0.0, high, high / 100.0, high / 1000.0)
            self.rows[key].field.set_step(high / 100.0)

    def _show_findings(self, frame: Frame) -> None:
        state = frame.body
        lines: tuple[str, ...] = ()
        if state is not None and state.document.solid.kind is frame.document.solid.kind:
            lines = tuple(map(told, state.findings))
        _set_text(self.findings, "\n".join(f"⚠ {line}" for line in lines))
        self.findings.setVisible(bool(lines))


def _sized(edit: Callable[[Document, float], Document], value: float) -> Edit:
    return lambda document: edit(document, value)


def _sizes(row: SliderRow) -> tuple[float, float]:
    """Return the sizes that an animation passes through: the slider's, above none."""
    high = row.slider.limits[1]
    return 0.02 * high, high


def _set_text(label: QLabel, text: str) -> None:
    if label.text() != text:
        label.setText(text)


def _round(value: float) -> float:
    """Return ``value`` rounded up to 1, 2 or 5 times a power of ten; 0 for 0."""
    if value <= 0.0:
        return 0.0
    power = 10.0 ** floor(log10(value))
    return next(step * power for step in (1.0, 2.0, 5.0, 10.0) if value <= step * power * 1.0001)
