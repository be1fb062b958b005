"""Small pictures of laws' shapes: a circle's outline as the law would make it."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPen, QPixmap, QPolygonF

from app.theme import theme
from sgb_core.surfaces.laws.law import RADIUS, Law
from sgb_core.surfaces.laws.shape import LawShape

SIZE = 22
# Drawn so many times as large, for sharp screens.
_RATIO = 3
_POINTS = 361
# How deep a wave cuts into the circle, so that it can be seen.
_DEPTH = 0.28


def shape_picture(shape: LawShape) -> QIcon:
    """Return the outline of a round section under a law of this shape, in the theme's colours."""
    low, high = shape.natural
    law = Law(RADIUS, shape.name, low, high, **shape.first)
    theta = np.linspace(0.0, 2.0 * np.pi, _POINTS)
    f = law.fraction(theta)
    spread = float(np.ptp(f))
    r = 1.0 - _DEPTH * (f.max() - f) / spread if spread and shape.natural != (0.0, 1.0) else f
    pixmap = QPixmap(SIZE * _RATIO, SIZE * _RATIO)
    pixmap.setDevicePixelRatio(_RATIO)
    pixmap.fill(Qt.GlobalColor.transparent)
    colours = theme.current()
    middle, reach = SIZE / 2.0, SIZE / 2.0 - 2.0
    places = [
        QPointF(middle + reach * x, middle - reach * y)
        for x, y in zip((r * np.cos(theta)).tolist(), (r * np.sin(theta)).tolist(), strict=True)
    ]
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor(colours.text), 1.4))
    painter.setBrush(QColor(colours.hover))
    painter.drawPolygon(QPolygonF(places))
    painter.end()
    return QIcon(pixmap)
