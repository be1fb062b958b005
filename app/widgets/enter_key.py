"""A field whose Enter does what the button beside it does."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent

from app.widgets.number_field import NumberField


class _EnterKey(QObject):
    def __init__(self, field: NumberField, run: Callable[[], object]) -> None:
        super().__init__(field)
        self._field, self._run = field, run
        field.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if (
            watched is self._field
            and event.type() == QEvent.Type.KeyPress
            and isinstance(event, QKeyEvent)
            and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
        ):
            if self._field.take_text():
                self._run()
                self._field.selectAll()
            return True
        return super().eventFilter(watched, event)


def on_enter(field: NumberField, run: Callable[[], object]) -> None:
    """Let Enter in a field run something, also with the number that stands there already."""
    _EnterKey(field, run)
