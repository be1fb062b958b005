"""A small picture of a document that is not on the screen: what its profile turns into."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen, QPixmap, QPolygonF

from app.theme import theme
from sgb_core.document.model import Document

SIDE = 72
# So many along the whole profile, and up to 24 along each segment, are smooth at any size here.
PLACES = 2400


def silhouette(document: Document, side: int = SIDE) -> QPixmap:
    """Return a small picture of what a document's profile turns into, seen from the side."""
    return QPixmap.fromImage(silhouette_image(document, side))


def silhouette_image(document: Document, side: int = SIDE) -> QImage:
    """Return the same as an image, on any thread."""
    points = np.concatenate(
        document.profile.sample(max(2, min(24, PLACES // len(document.profile))))
    )
    mirrored = points[::-1] * (-1.0, 1.0)
    # Of a ring each half is closed in itself.
    whole = np.concatenate([points, mirrored])
    outlines = [points, mirrored] if document.profile.closed else [whole]
    low, high = whole.min(axis=0), whole.max(axis=0)
    scale = (side - 8.0) / max(float(np.max(high - low)), 1e-300)
    middle = (low + high) / 2.0
    ratio = 2
    image = QImage(ratio * side, ratio * side, QImage.Format.Format_ARGB32_Premultiplied)
    image.setDevicePixelRatio(ratio)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor(theme.current().text), 1.2))
    painter.setBrush(QColor(theme.current().surface))
    for outline in outlines:
        places = ((outline - middle) * (scale, -scale) + side / 2.0).tolist()
        painter.drawPolygon(QPolygonF([QPointF(x, y) for x, y in places]))
    painter.end()
    return image
