"""A field over a dimension line, to type its value where it stands."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QFocusEvent, QKeyEvent
from PySide6.QtWidgets import QWidget

from app.hand.coordinates import ScreenPoint
from app.hand.drag import Gesture, State
from app.hand.hit_test import Target
from app.state.presenter import Presenter
from app.widgets.number_field import NumberField
from sgb_core.document import edits
from sgb_core.document.dimensions import dimension_value

_WIDTH = 96


class DimensionField(NumberField):
    """Takes one value: Enter sets it, Esc and a click elsewhere leave it."""

    def __init__(self, presenter: Presenter, number: int, value: float, owner: QWidget) -> None:
        super().__init__(unit=str(presenter.document.unit), parent=owner)
        self._presenter = presenter
        self._number = number
        self._owner = owner
        dimension = presenter.document.dimensions[number]
        self._name = dimension.label
        self.setAccessibleName(self._name)
        self.set_help(f"{self._name}: Enter sets it, Esc leaves it")
        self.set_value(value)
        self.setFixedWidth(_WIDTH)
        self.changed.connect(self._enter)
        self.refused.connect(lambda text: presenter.notify(f"{self._name}: {text}", "warning"))

    def open_at(self, at: ScreenPoint) -> None:
        """Show it around a place, with its text selected."""
        owner = self._owner
        x = min(max(0, round(at.x) - _WIDTH // 2), max(0, owner.width() - _WIDTH))
        y = min(max(0, round(at.y) - self.sizeHint().height() // 2), owner.height() - 24)
        self.move(x, y)
        self.show()
        self.setFocus(Qt.FocusReason.OtherFocusReason)
        self.selectAll()

    def _enter(self, value: float) -> None:
        number = self._number
        self._presenter.do(
            f"{self._name}", lambda d: edits.set_dimension(d, number, value).document
        )

    def keyPressEvent(self, event: QKeyEvent) -> None:
        super().keyPressEvent(event)
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape):
            self._close()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.deleteLater()

    def _close(self) -> None:
        self.hide()
        self._owner.setFocus(Qt.FocusReason.OtherFocusReason)


def type_into(presenter: Presenter, gesture: Gesture, at: ScreenPoint, owner: QWidget) -> None:
    """Open the field of a dimension that was pressed and not moved, around a place."""
    handle = gesture.handle
    if gesture.state is not State.ARMED or handle is None:
        return
    if handle.target is not Target.DIMENSION:
        return
    document, number = presenter.document, handle.index
    dimension = document.dimensions[number]
    value = dimension_value(document, dimension) if dimension.value is None else dimension.value
    if value is not None:
        DimensionField(presenter, number, value, owner).open_at(at)
