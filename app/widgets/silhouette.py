"""A profile as a small picture: turned, from the side."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPen, QPixmap, QPolygonF

from app.theme import theme
from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile

SIDE = 34
_PER_SEGMENT = 12
_MARGIN = 2.0


def silhouette(profile: Profile, ratio: float = 1.0) -> QIcon:
    """Return the outline of a turned profile, filled, ``SIDE`` logical pixels square."""
    return QIcon(outline_picture(profile, SIDE, ratio))


def outline_picture(
    profile: Profile, side: int, ratio: float = 1.0, other: Profile | None = None
) -> QPixmap:
    """Return the outline of a turned profile, filled, ``side`` logical pixels square.

    Where there is an ``other``, both are drawn at one scale, the other as a line over it.
    """
    drawn = QPixmap(QSize(round(side * ratio), round(side * ratio)))
    drawn.setDevicePixelRatio(ratio)
    drawn.fill(Qt.GlobalColor.transparent)
    outlines = _outlines(profile)
    lines = [] if other is None else _outlines(other)
    everything = np.concatenate(outlines + lines)
    low, high = everything.min(axis=0), everything.max(axis=0)
    scale = (side - 2.0 * _MARGIN) / (float((high - low).max()) or 1.0)
    corner = side / 2.0 - scale * (low + high) / 2.0
    palette = theme.current()
    painter = QPainter(drawn)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QColor(palette.text_muted))
    painter.setBrush(QColor(palette.surface))
    for drawn_lines in (outlines, lines):
        for outline in drawn_lines:
            places = corner + scale * outline
            painter.drawPolygon(QPolygonF([QPointF(x, side - y) for x, y in places.tolist()]))
        painter.setPen(QPen(QColor(palette.text), 1.0, Qt.PenStyle.DotLine))
        painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.end()
    return drawn


def _outlines(profile: Profile) -> list[Floats]:
    """Return both sides of the axis as one outline; a ring is two."""
    points = profile.sample(_PER_SEGMENT).reshape(-1, 2)
    left = points * (-1.0, 1.0)
    return [left, points] if profile.closed else [np.concatenate((points, left[::-1]))]
