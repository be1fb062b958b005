"""A profile as a small picture: turned, from the side."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPixmap, QPolygonF

from app.theme import theme
from sgb_core.curves.profile import Profile

SIDE = 34
_PER_SEGMENT = 12
_MARGIN = 2.0


def silhouette(profile: Profile, ratio: float = 1.0) -> QIcon:
    """Return the outline of a turned profile, filled, ``SIDE`` logical pixels square."""
    drawn = QPixmap(QSize(round(SIDE * ratio), round(SIDE * ratio)))
    drawn.setDevicePixelRatio(ratio)
    drawn.fill(Qt.GlobalColor.transparent)
    points = profile.sample(_PER_SEGMENT).reshape(-1, 2)
    # Both sides of the axis; a ring is two outlines.
    left = points * (-1.0, 1.0)
    outlines = [left, points] if profile.closed else [np.concatenate((points, left[::-1]))]
    everything = np.concatenate(outlines)
    low, high = everything.min(axis=0), everything.max(axis=0)
    scale = (SIDE - 2.0 * _MARGIN) / (float((high - low).max()) or 1.0)
    corner = SIDE / 2.0 - scale * (low + high) / 2.0
    painter = QPainter(drawn)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QColor(theme.current().text_muted))
    painter.setBrush(QColor(theme.current().surface))
    for outline in outlines:
        places = corner + scale * outline
        painter.drawPolygon(QPolygonF([QPointF(x, SIDE - y) for x, y in places.tolist()]))
    painter.end()
    return QIcon(drawn)
