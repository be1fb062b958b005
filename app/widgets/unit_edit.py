"""A line to type in with a unit shown behind the text, which is no part of it."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QLineEdit, QWidget

from app.theme import theme

# Between a number and its unit, and from the unit to the field's edge, in pixels.
_SUFFIX_GAP, _SUFFIX_EDGE = 4, 7
# What is read for a unit, where that is not how it is typed.
_SIGNS = {"deg": "°"}


def sign(unit: str) -> str:
    """Return what is read for a unit: "°" for "deg"."""
    return _SIGNS.get(unit, unit)


class UnitEdit(QLineEdit):
    """As wide as six figures and the unit."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._suffix = ""

    def set_suffix(self, suffix: str) -> None:
        """Show a unit behind the number, which is no part of its text."""
        if suffix == self._suffix:
            return
        self._suffix = suffix
        self.setTextMargins(0, 0, self._suffix_width, 0)
        self.updateGeometry()
        self.update()

    @property
    def suffix(self) -> str:
        """The unit that is shown behind the number."""
        return self._suffix

    @property
    def _suffix_width(self) -> int:
        if not self._suffix:
            return 0
        return self.fontMetrics().horizontalAdvance(self._suffix) + _SUFFIX_GAP

    def sizeHint(self) -> QSize:
        width = self.fontMetrics().horizontalAdvance("0" * 6) + 14
        return QSize(width + self._suffix_width, super().sizeHint().height())

    def minimumSizeHint(self) -> QSize:
        width = self.fontMetrics().horizontalAdvance("0" * 5) + 14
        return QSize(width + self._suffix_width, self.sizeHint().height())

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._suffix:
            return
        painter = QPainter(self)
        palette = theme.current()
        painter.setPen(QColor(palette.text_muted if self.isEnabled() else palette.text_disabled))
        # Beside where the text ends: its margin and the frame's own.
        box = self.rect().adjusted(0, 0, -_SUFFIX_EDGE, 0)
        painter.drawText(
            box, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, self._suffix
        )
        painter.end()
