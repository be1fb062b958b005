"""Where the finished object stands: rotation and translation, part of the Turn panel."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QSizePolicy, QToolButton, QWidget

from app.state.number_edits import NumberEdits
from app.state.presenter import Edit, Frame, Presenter
from app.widgets.number_field import NumberField
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.surfaces.placement import Placement

AXES = ("x", "y", "z")
HALF_TURN = (-180.0, 180.0)
_TURN_TIP = (
    "Turn the object about the fixed {axis}-axis, in degrees; x, y and z in that order, "
    "before it is moved.\nExports and measures follow."
)
_MOVE_TIP = "Move the object along the {axis}-axis. Exports and measures follow."


class PlaceSection(QWidget):
    """Six numbers and a way back to none of them."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._edits = NumberEdits(presenter, self, lambda: self.refresh(presenter.frame))
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(6)
        grid.setVerticalSpacing(6)
        heading = QLabel("Place", self)
        heading.setProperty("role", "heading")
        self.home = QToolButton(self)
        self.home.setText("Home")
        self.home.setToolTip("No rotation and no translation")
        self.home.setAccessibleName("Reset rotation and translation")
        self.home.setProperty("segment", "only")
        self.home.clicked.connect(self._go_home)
        top = QHBoxLayout()
        top.addWidget(heading, 1)
        top.addWidget(self.home)
        grid.addLayout(top, 0, 0, 1, 4)
        self.fields: dict[tuple[str, int], NumberField] = {}
        self.labels: dict[QObject, str] = {}
        for axis, name in enumerate(AXES):
            letter = QLabel(name, self)
            letter.setProperty("role", "muted")
            grid.addWidget(letter, 1, axis + 1, Qt.AlignmentFlag.AlignRight)
        for line, (key, label) in enumerate(
            (("rotation_deg", "Rotate °"), ("translation", "Move")), start=2
        ):
            words = QLabel(label, self)
            words.installEventFilter(self)
            self.labels[words] = key
            if key == "translation":
                self._move_words = words
            grid.addWidget(words, line, 0)
            for axis in range(3):
                grid.addWidget(self._field(key, axis), line, axis + 1)
                grid.setColumnStretch(axis + 1, 1)

    def _field(self, key: str, axis: int) -> NumberField:
        turns = key == "rotation_deg"
        field = NumberField(
            step=5.0 if turns else 1.0, unit="deg" if turns else "mm", reset=0.0, parent=self
        )
        name = AXES[axis]
        field.set_help((_TURN_TIP if turns else _MOVE_TIP).format(axis=name))
        field.setAccessibleName(f"{'Rotation about' if turns else 'Translation along'} {name}")
        field.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        field.setMinimumWidth(40)
        label = f"{'Rotate about' if turns else 'Move along'} {name}"
        self._edits.connect(
            field,
            label,
            partial(_placed, key, axis),
            (lambda: HALF_TURN) if turns else self._beside,
        )
        self.fields[key, axis] = field
        return field

    def _beside(self) -> tuple[float, float]:
        reach = self._presenter.document.profile.size
        return -0.5 * reach, 0.5 * reach

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # The label of a row resets its three numbers in one step.
        if event.type() == QEvent.Type.MouseButtonDblClick and watched in self.labels:
            key = self.labels[watched]
            self._presenter.do(
                f"Reset {'rotation' if key == 'rotation_deg' else 'translation'}",
                partial(_set_place, key, (0.0, 0.0, 0.0)),
            )
            return True
        return super().eventFilter(watched, event)

    def _go_home(self) -> None:
        zero = (0.0, 0.0, 0.0)
        self._presenter.do(
            "Reset place", lambda d: edits.set_placement(d, rotation_deg=zero, translation=zero)
        )

    def refresh(self, frame: Frame) -> None:
        """Show ``frame``; each field leaves a value alone that it shows already."""
        placement: Placement = frame.document.placement
        for (key, axis), field in self.fields.items():
            if key == "translation":
                field.set_unit(frame.document.unit.value)
            # Three in a row have no room for it: the row's name says the unit.
            field.set_suffix("")
            field.set_value(getattr(placement, key)[axis])
        self._move_words.setText(f"Move {frame.document.unit.value}")
        self.home.setEnabled(not placement.is_identity)


def _placed(key: str, axis: int, value: float) -> Edit:
    def edit(document: Document) -> Document:
        numbers = list(getattr(document.placement, key))
        numbers[axis] = value
        return _set_place(key, numbers, document)

    return edit


def _set_place(key: str, numbers: Sequence[float], document: Document) -> Document:
    if key == "rotation_deg":
        return edits.set_placement(document, rotation_deg=numbers)
    return edits.set_placement(document, translation=numbers)
