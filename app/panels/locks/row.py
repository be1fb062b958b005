"""One dimension in the panel: its padlock, its name, its value, and a button that removes it."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QToolButton, QWidget

from app.panels.locks.words import factor_of, name_of, shown_value, unit_of
from app.state.presenter import Frame
from app.theme import icons
from app.widgets.number_field import NumberField
from sgb_core.design.locks.dimension import Dimension, Quantity

_FIELD = 100


class DimensionRow(QWidget):
    """Shows one dimension; a lock that stopped the hand lights up."""

    lock_wanted = Signal(bool)
    removed = Signal()

    def __init__(self, dimension: Dimension, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.padlock = self._button("lock-open")
        self.padlock.setCheckable(True)
        self.padlock.toggled.connect(self.lock_wanted)
        self.label = _Name(self)
        self.label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.field = NumberField(decimals=3, parent=self)
        self.field.setFixedWidth(_FIELD)
        self.remove = self._button("close")
        self.remove.clicked.connect(self.removed)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(5)
        layout.addWidget(self.padlock)
        layout.addWidget(self.label, 1)
        layout.addWidget(self.field)
        layout.addWidget(self.remove)
        has_value = dimension.facts.quantity is not Quantity.NONE
        self.field.setVisible(has_value)

    def _button(self, icon: str) -> QToolButton:
        button = QToolButton(self)
        button.setAutoRaise(True)
        icons.bind(button, icon)
        return button

    def show_dimension(self, frame: Frame, dimension: Dimension, *, in_the_way: bool) -> None:
        """Show what a frame holds of it."""
        document = frame.document
        name, unit = name_of(document, dimension), unit_of(document, dimension)
        if self.label.toolTip() != name:
            self.label.show_name(_short(name))
            self.label.setToolTip(name)
            self.field.setAccessibleName(name)
            self.remove.setToolTip(f"Remove the dimension {name}")
            self.remove.setAccessibleName(f"Remove {name}")
        with QSignalBlocker(self.padlock):
            if self.padlock.isChecked() != dimension.locked or not self.padlock.toolTip():
                self.padlock.setChecked(dimension.locked)
                icons.bind(self.padlock, "lock" if dimension.locked else "lock-open")
                self.padlock.setToolTip(_LOCKED if dimension.locked else _FREE)
            self.padlock.setAccessibleName(f"Lock {name}")
        self.field.set_unit(unit)
        value = shown_value(frame, dimension)
        self.field.setEnabled(value is not None)
        if value is not None:
            self.field.set_value(value * factor_of(document, dimension))
        self._light(in_the_way)

    def _light(self, on: bool) -> None:
        role = "warning" if on else None
        if self.label.property("role") != role:
            self.label.setProperty("role", role)
            self.label.style().unpolish(self.label)
            self.label.style().polish(self.label)


class _Name(QLabel):
    """A name that ends in dots where there is no room for all of it."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._whole = ""

    def show_name(self, name: str) -> None:
        """Show as much of a name as there is room for."""
        self._whole = name
        self._cut()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._cut()

    def _cut(self) -> None:
        right = Qt.TextElideMode.ElideRight
        self.setText(self.fontMetrics().elidedText(self._whole, right, self.width()))


_LOCKED = "Locked: it holds while anything else changes. Click to let it only tell"
_FREE = "It only tells. Click to lock it at its present value"


def _short(name: str) -> str:
    """Return a name as it fits a narrow panel."""
    return name.replace(" diameter", " ⌀").replace("Radius of curvature", "R")
