"""The picture of an angle curve: its paper, its scales, and where things lie on it."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen, QPolygonF

from app.theme import theme
from app.widgets.plot import RIGHT, Plot
from app.widgets.quantity import format_number
from sgb_core.surfaces.laws.law import Law

KEY = 5.0
_DEGREES = (0, 90, 180, 270, 360)
_PIECES_PER_PIXEL = 1.0


def value_at(law: Law, degrees: float) -> float:
    """Return the parameter's value at an angle."""
    return law.start + (law.end - law.start) * float(law.fraction(np.deg2rad(degrees)))


def paint_paper(painter: QPainter, plot: Plot, law: Law | None, sweep: float, font: QFont) -> None:
    """Paint the ground with its scales; what the sweep leaves out is shaded."""
    colours = theme.current()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    painter.fillRect(plot.box, QColor(colours.canvas))
    if sweep < 360.0:
        start = plot.place(sweep, 1.0)
        rest = QRectF(start.x(), plot.top, plot.left + plot.width - start.x(), plot.height)
        painter.fillRect(rest, QColor(colours.hover))
    painter.setFont(font)
    metrics = QFontMetricsF(font)
    high = metrics.height()
    for degrees in _DEGREES:
        x = round(plot.place(degrees, 0.0).x()) + 0.5
        painter.setPen(QColor(colours.grid_major))
        painter.drawLine(QPointF(x, plot.top), QPointF(x, plot.top + plot.height))
        text = f"{degrees}°"
        wide = metrics.horizontalAdvance(text)
        start_x = min(max(x - wide / 2.0, 0.0), plot.left + plot.width + RIGHT - wide)
        painter.setPen(QColor(colours.text_muted))
        painter.drawText(
            QRectF(start_x, plot.top + plot.height + 3.0, wide + 1.0, high),
            Qt.AlignmentFlag.AlignLeft,
            text,
        )
    for value in (0.0, 0.25, 0.5, 0.75, 1.0):
        y = round(plot.place(0.0, value).y()) + 0.5
        strong = value in (0.0, 0.5, 1.0)
        painter.setPen(QColor(colours.grid_major if strong else colours.grid_minor))
        painter.drawLine(QPointF(plot.left, y), QPointF(plot.left + plot.width, y))
        if strong and law is not None:
            number = format_number(law.start + (law.end - law.start) * value, 2)
            painter.setPen(QColor(colours.text_muted))
            painter.drawText(
                QRectF(0.0, y - high / 2.0, plot.left - 5.0, high),
                Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter,
                number,
            )


def paint_curve(painter: QPainter, plot: Plot, law: Law) -> None:
    """Paint f(θ), and where it leaves creases."""
    colours = theme.current()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor(colours.warning), 1.4, Qt.PenStyle.DashLine))
    for degrees in np.rad2deg(law.creases).tolist():
        # The start is the end too.
        for seen in (degrees, 360.0) if degrees == 0.0 else (degrees,):
            painter.drawLine(plot.place(seen, 0.0), plot.place(seen, 1.0))
    # Many waves need more pieces than there are pixels.
    waves = max(law.waves, len(law.keyframes))
    pieces = int(min(max(plot.width * _PIECES_PER_PIXEL, 24.0 * waves), 6000.0))
    marks = np.unique(np.concatenate([np.linspace(0.0, 360.0, pieces + 1), np.rad2deg(law.breaks)]))
    values = law.fraction(np.deg2rad(marks))
    places = [plot.place(d, v) for d, v in zip(marks.tolist(), values.tolist(), strict=True)]
    under = QColor(colours.accent)
    under.setAlpha(30)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(under)
    floor = 1.0 if plot.down else 0.0
    painter.drawPolygon(QPolygonF([plot.place(0.0, floor), *places, plot.place(360.0, floor)]))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(QColor(colours.accent), 2.0))
    painter.drawPolyline(QPolygonF(places))


def paint_keys(
    painter: QPainter, plot: Plot, law: Law, selected: int | None, held: int | None
) -> None:
    """Paint the keys; one at 0° is seen at 360° too, hollow."""
    colours = theme.current()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for index, (degrees, value) in enumerate(law.keyframes):
        turn = degrees % 360.0
        chosen = index == selected
        colour = QColor(colours.selection if chosen else colours.quartic)
        size = KEY + 1.5 if index in (selected, held) else KEY
        painter.setPen(QPen(QColor(colours.canvas), 1.4))
        painter.setBrush(colour)
        painter.drawPolygon(_diamond(plot.place(turn, value), size))
        if turn == 0.0:
            painter.setPen(QPen(colour, 1.4))
            painter.setBrush(QColor(colours.canvas))
            painter.drawPolygon(_diamond(plot.place(360.0, value), size - 1.0))
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _diamond(at: QPointF, size: float) -> QPolygonF:
    corners = ((0.0, -size), (size, 0.0), (0.0, size), (-size, 0.0))
    return QPolygonF([at + QPointF(x, y) for x, y in corners])
