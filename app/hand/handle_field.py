"""A field over a line or an edge that is seen, to type its value where it stands."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QFocusEvent, QKeyEvent
from PySide6.QtWidgets import QWidget

from app.hand.coordinates import ScreenPoint
from app.hand.drag import Gesture, State
from app.hand.handle_number import HandleNumber, handle_number
from app.state.presenter import Presenter
from app.widgets.number_field import NumberField

_WIDTH = 96
# Its own menu, or another window for a moment: the field stays for what is typed next.
_COMES_BACK = (Qt.FocusReason.PopupFocusReason, Qt.FocusReason.ActiveWindowFocusReason)


class HandleField(NumberField):
    """Takes one value: Enter sets it, Esc and a click elsewhere leave it."""

    def __init__(self, presenter: Presenter, number: HandleNumber, owner: QWidget) -> None:
        kind = number.kind
        super().__init__(
            minimum=kind.minimum,
            maximum=kind.maximum,
            unit=kind.unit,
            above_minimum=kind.above_minimum,
            parent=owner,
        )
        self._presenter = presenter
        self._number = number
        self._owner = owner
        self.setAccessibleName(number.name)
        self.set_help(f"{number.name}: Enter sets it, Esc leaves it")
        self.set_value(number.value)
        self.setFixedWidth(_WIDTH)
        self.changed.connect(self._enter)
        self.refused.connect(self._refuse)

    def open_at(self, at: ScreenPoint) -> None:
        """Show it around a place, with its text selected."""
        owner = self._owner
        x = min(max(0, round(at.x) - _WIDTH // 2), max(0, owner.width() - _WIDTH))
        y = min(max(0, round(at.y) - self.sizeHint().height() // 2), owner.height() - 24)
        self.move(x, y)
        self.show()
        self.raise_()
        self.setFocus(Qt.FocusReason.OtherFocusReason)
        self.selectAll()

    def _enter(self, value: float) -> None:
        edit = self._number.edit
        self._presenter.do(self._number.name, lambda d: edit(d, value))

    def _refuse(self, text: str) -> None:
        self._presenter.notify(f"{self._number.name}: {text}", "warning")

    def keyPressEvent(self, event: QKeyEvent) -> None:
        super().keyPressEvent(event)
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape):
            self._close()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        if event.reason() not in _COMES_BACK:
            self.deleteLater()

    def _close(self) -> None:
        self.hide()
        self._owner.setFocus(Qt.FocusReason.OtherFocusReason)


def type_into(presenter: Presenter, gesture: Gesture, at: ScreenPoint, owner: QWidget) -> None:
    """Open the field of what was pressed and not moved, around a place; of what has a number."""
    if gesture.state is not State.ARMED:
        return
    number = handle_number(presenter.document, gesture.handle)
    if number is not None:
        HandleField(presenter, number, owner).open_at(at)
