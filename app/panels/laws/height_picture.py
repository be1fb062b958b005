"""The picture of a strength along the height: its scale, its curve, its keys."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen, QPolygonF

from app.theme import theme
from app.widgets.plot import LEFT, Plot, paint_label
from app.widgets.quantity import format_number
from sgb_core.arrays import Floats
from sgb_core.surfaces.laws.strength import Key, Strength
from sgb_core.values import dataclass

_KEY = 5.0


@dataclass(frozen=True, slots=True)
class Scale:
    """A plot in which shares of the height run right and strengths from ``low`` to ``high`` up."""

    plot: Plot
    low: float
    high: float

    @classmethod
    def of(cls, width: float, height: float, keys: Sequence[Key]) -> Scale:
        """Return the scale of a widget of this size that shows 0, 1 and all keys."""
        strengths = [0.0, 1.0, *(k for _, k in keys)]
        return cls(Plot.within(width, height, 1.0, LEFT), min(strengths), max(strengths))

    def place(self, u: float, k: float) -> QPointF:
        """Return where a share of the height and a strength lie, in pixels."""
        return self.plot.place(u, (k - self.low) / (self.high - self.low))

    def read(self, at: QPointF) -> tuple[float, float]:
        """Return the share and the strength at a place, not limited to the plot."""
        u, share = self.plot.read(at)
        return u, self.low + share * (self.high - self.low)


def strengths_of(keys: Sequence[Key], u: Sequence[float] | Floats) -> Floats:
    """Return the strength at shares of the height; 1 without keys."""
    places = np.asarray(u, dtype=np.float64)
    if len(keys) < 2:
        return np.full(places.shape, keys[0][1] if keys else 1.0)
    return Strength.through(keys, 0.0, 1.0).jet(places)[0]


def paint_heights(
    painter: QPainter,
    scale: Scale,
    keys: Sequence[Key],
    selected: int | None,
    marked: int | None,
    font: QFont,
) -> None:
    """Paint the curve with its keys; the ``marked`` one is told in a label."""
    colours, plot = theme.current(), scale.plot
    painter.fillRect(plot.box, QColor(colours.canvas))
    painter.setFont(font)
    metrics = QFontMetricsF(font)
    for k in sorted({0.0, 1.0, scale.low, scale.high}):
        y = round(scale.place(0.0, k).y()) + 0.5
        painter.setPen(QColor(colours.grid_major))
        painter.drawLine(QPointF(plot.left, y), QPointF(plot.left + plot.width, y))
        painter.setPen(QColor(colours.text_muted))
        room = QRectF(0.0, y - metrics.height() / 2.0, plot.left - 5.0, metrics.height())
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        painter.drawText(room, right, format_number(k, 2))
    below = QRectF(plot.left, plot.top + plot.height + 3.0, plot.width, metrics.height())
    for words, side in (
        ("foot", Qt.AlignmentFlag.AlignLeft),
        ("strength along the height", Qt.AlignmentFlag.AlignHCenter),
        ("rim", Qt.AlignmentFlag.AlignRight),
    ):
        painter.drawText(below, side, words)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    u = np.linspace(0.0, 1.0, max(2, int(plot.width)))
    points = [scale.place(*each) for each in zip(u, strengths_of(keys, u), strict=True)]
    painter.setPen(QPen(QColor(colours.generatrix), 2.0))
    painter.drawPolyline(QPolygonF(points))
    for index, key in enumerate(keys):
        chosen = index == selected
        size = _KEY + 1.5 if index in (selected, marked) else _KEY
        painter.setPen(QPen(QColor(colours.canvas), 1.4))
        painter.setBrush(QColor(colours.selection if chosen else colours.quartic))
        steps = ((0.0, -size), (size, 0.0), (0.0, size), (-size, 0.0))
        at = scale.place(*key)
        painter.drawPolygon(QPolygonF([at + QPointF(x, y) for x, y in steps]))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    if marked is not None and marked < len(keys):
        share, k = keys[marked]
        lines = [f"{format_number(100.0 * share, 1)} % of the height", f"{100.0 * k:.4g} % strong"]
        paint_label(painter, plot, scale.place(share, k), lines, font)
