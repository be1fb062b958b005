"""Where things lie in a small plot beside its scales, and the label that tells of one of them."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter

from app.theme import theme
from sgb_core.values import dataclass

LEFT, RIGHT, TOP, BELOW = 34.0, 12.0, 10.0, 20.0


@dataclass(frozen=True, slots=True)
class Plot:
    """A rectangle in which x runs right from 0 to ``span`` and y runs up from 0 to 1.

    Where it is turned ``down`` y runs down.
    """

    left: float
    top: float
    width: float
    height: float
    span: float
    down: bool = False

    @classmethod
    def within(
        cls, width: float, height: float, span: float, left: float = LEFT, *, down: bool = False
    ) -> Plot:
        """Return the plot of a widget of this size, its scale written in the first ``left``."""
        room = (max(width - left - RIGHT, 1.0), max(height - TOP - BELOW, 1.0))
        return cls(left, TOP, *room, span, down)

    @property
    def box(self) -> QRectF:
        """Its rectangle in pixels."""
        return QRectF(self.left, self.top, self.width, self.height)

    def place(self, x: float, y: float) -> QPointF:
        """Return where a pair of values lies, in pixels."""
        below = y if self.down else 1.0 - y
        return QPointF(self.left + self.width * x / self.span, self.top + self.height * below)

    def read(self, at: QPointF) -> tuple[float, float]:
        """Return the values that lie at a place, not limited to the plot."""
        below = (at.y() - self.top) / self.height
        return self.span * (at.x() - self.left) / self.width, below if self.down else 1.0 - below


def paint_label(painter: QPainter, plot: Plot, at: QPointF, lines: list[str], font: QFont) -> None:
    """Paint a heads-up label beside a place, on the side where there is room."""
    colours = theme.current()
    metrics = QFontMetricsF(font)
    width = max(metrics.horizontalAdvance(line) for line in lines) + 12.0
    height = metrics.height() * len(lines) + 6.0
    x = at.x() + 12.0
    if x + width > plot.left + plot.width:
        x = at.x() - 12.0 - width
    y = at.y() - 10.0 - height
    if y < plot.top:
        y = at.y() + 12.0
    y = min(y, plot.top + plot.height - height)
    box = QRectF(max(x, 1.0), y, width, height)
    painter.setPen(QColor(colours.border))
    ground = QColor(colours.panel)
    ground.setAlpha(240)
    painter.setBrush(ground)
    painter.drawRoundedRect(box, 4.0, 4.0)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setFont(font)
    painter.setPen(QColor(colours.text))
    for k, line in enumerate(lines):
        baseline = box.top() + 3.0 + metrics.ascent() + k * metrics.height()
        painter.drawText(QPointF(box.left() + 6.0, baseline), line)
