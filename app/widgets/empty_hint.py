"""What stands in a panel that holds nothing yet: a drawing, and the first step in words."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from app.theme import icons, theme

_SIDE = 44


class _Drawing(QWidget):
    """One icon of the project, large and in the muted colour of the theme."""

    def __init__(self, name: str, parent: QWidget) -> None:
        super().__init__(parent)
        self._name = name
        self.setFixedHeight(_SIDE + 4)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        colour = theme.current().text_disabled
        drawn = icons.pixmap(self._name, _SIDE, colour, self.devicePixelRatioF())
        painter.drawPixmap((self.width() - _SIDE) // 2, 2, drawn)
        painter.end()


class EmptyHint(QWidget):
    """A drawing over a sentence or two that say what the panel is for and how to begin."""

    def __init__(self, icon: str, text: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.label = QLabel(text, self)
        self.label.setWordWrap(True)
        self.label.setProperty("role", "muted")
        self.label.setAlignment(Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 10, 12, 8)
        layout.setSpacing(6)
        layout.addWidget(_Drawing(icon, self))
        layout.addWidget(self.label)
        layout.addStretch(1)
