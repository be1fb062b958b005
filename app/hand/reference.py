"""The picture that a profile came from, as it is drawn behind: pixels, sizes and places."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QPointF, Qt
from PySide6.QtGui import QImage, QImageReader, QPainter, QTransform

from app.hand.canvas import Canvas
from sgb_core.document.appearance.picture_file import Picture
from sgb_core.document.reference import Reference

# Each smaller copy of a picture has half as many pixels a side; so many copies at most.
_COPIES = 5


def picture_of(data: bytes) -> QImage:
    """Return the picture in the bytes of a PNG or JPEG, as upright as its camera was held."""
    buffer = QBuffer()
    buffer.setData(QByteArray(data))
    buffer.open(QIODevice.OpenModeFlag.ReadOnly)
    reader = QImageReader(buffer)
    reader.setAutoTransform(True)
    return reader.read()


@lru_cache(maxsize=12)
def _copy(picture: Picture, halvings: int) -> QImage:
    """Return a picture made smaller, so that drawing it small is quick and does not glitter."""
    if halvings == 0:
        found = picture_of(picture.data)
        return found.convertToFormat(QImage.Format.Format_ARGB32_Premultiplied)
    larger = _copy(picture, halvings - 1)
    smooth = Qt.TransformationMode.SmoothTransformation
    half = larger.size() / 2
    return larger.scaled(half, Qt.AspectRatioMode.IgnoreAspectRatio, smooth)


def draw_reference(canvas: Canvas, source: Reference | None) -> None:
    """Draw what lies behind a profile: a picture, or the points it was traced from."""
    if source is None or not source.shown:
        return
    painter = canvas.painter
    if source.picture is None:
        painter.setOpacity(source.opacity)
        painter.setPen(canvas.pen("text", 2.4))
        for x, y in canvas.transform.map(np.array(source.points).reshape(-1, 2)).tolist():
            painter.drawPoint(int(x), int(y))
        painter.setOpacity(1.0)
        return
    corners = canvas.transform.map(source.placed([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]))
    (x, y), across, down = corners[0].tolist(), corners[1] - corners[0], corners[2] - corners[0]
    scale = float(np.hypot(*across))
    halvings = int(np.clip(np.floor(np.log2(1.0 / max(scale, 1e-9))), 0, _COPIES))
    image = _copy(source.picture, halvings)
    times = 2.0**halvings
    painter.save()
    painter.setOpacity(source.opacity)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.setTransform(
        QTransform(times * across[0], times * across[1], times * down[0], times * down[1], x, y),
        True,
    )
    # A pixel's middle is a whole number.
    painter.drawImage(QPointF(-0.5 / times, -0.5 / times), image)
    painter.restore()
