"""A line of text that changes often, as while a hand moves, without moving what is around it."""

from __future__ import annotations

from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QLabel


class SteadyLabel(QLabel):
    """A label of its own fixed size: a text that fits lays out nothing, least of all the window.

    It grows with its text at once, and shrinks only where the text is much shorter.
    """

    def setText(self, text: str) -> None:
        if text != self.text():
            super().setText(text)
            self._make_room()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._make_room()

    def _make_room(self) -> None:
        # The size hint of a label is never narrower than the size that was fixed before.
        margins, metrics = self.contentsMargins(), self.fontMetrics()
        needed = metrics.horizontalAdvance(self.text()) + margins.left() + margins.right()
        height = metrics.height() + margins.top() + margins.bottom()
        spare = 2 * self.fontMetrics().averageCharWidth()
        fits = needed <= self.maximumWidth() <= needed + 4 * spare
        if not fits or self.maximumHeight() != height:
            self.setFixedSize(needed + (spare if self.text() else 0), height)
