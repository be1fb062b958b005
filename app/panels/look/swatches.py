"""Small pictures of what the look panel offers: a ball of each material, a patch of a texture."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import QBuffer, QByteArray, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QBrush,
    QColor,
    QIcon,
    QImageReader,
    QPainter,
    QPainterPath,
    QPixmap,
    QRadialGradient,
)

import resources
from app.theme import theme
from sgb_core.document.appearance.finishes import FINISHES, Finish
from sgb_core.document.appearance.model import MaterialName

SIDE = 18
# Drawn finer than shown, for screens of any scale.
_FINE = 3
_LIGHT = QPointF(0.36, 0.32)


def material_swatch(finish: Finish, colour: str | None = None) -> QIcon:
    """Return a ball of a material, in its own colour unless another is given."""
    drawn, painter = _begun()
    side = float(SIDE * _FINE)
    base = QColor(colour or finish.color)
    gloss = max(finish.coat, 1.0 - finish.roughness)
    bright = _towards(base, QColor("#ffffff"), 0.25 + 0.65 * gloss)
    shade = _towards(base, QColor("#000000"), 0.45 + 0.25 * finish.metallic)
    ball = QRadialGradient(_LIGHT * side, 0.72 * side)
    ball.setColorAt(0.0, bright)
    ball.setColorAt(0.12 + 0.4 * finish.roughness * (1.0 - finish.coat), base)
    ball.setColorAt(1.0, shade)
    painter.setOpacity(max(0.35, finish.opacity))
    painter.setBrush(QBrush(ball))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.drawEllipse(QRectF(1.0, 1.0, side - 2.0, side - 2.0))
    painter.setOpacity(1.0)
    _rim(painter).drawEllipse(QRectF(1.5, 1.5, side - 3.0, side - 3.0))
    painter.end()
    return QIcon(drawn)


def look_swatch(look: Mapping[str, Any] | None) -> QIcon:
    """Return the texture of a ready-made look, or a ball of its material where it has none."""
    if look is None:
        return QIcon()
    if look.get("textures"):
        return texture_swatch(look["textures"][0]["image"])
    finish = FINISHES[MaterialName(look.get("material", MaterialName.CLAY))]
    return material_swatch(finish, look.get("color"))


def texture_swatch(name: str) -> QIcon:
    """Return a patch of one of the program's textures."""
    return picture_swatch(resources.texture(name))


def picture_swatch(data: bytes) -> QIcon:
    """Return a patch of a picture, a PNG or JPEG file's bytes."""
    drawn, painter = _begun()
    side = float(SIDE * _FINE)
    buffer = QBuffer()
    buffer.setData(QByteArray(data))
    reader = QImageReader(buffer)
    # A reader of JPEG makes a small picture quickly where it is told so first.
    reader.setScaledSize(QSize(SIDE * _FINE, SIDE * _FINE))
    patch = QPainterPath()
    patch.addRoundedRect(QRectF(1.0, 1.0, side - 2.0, side - 2.0), 6.0, 6.0)
    painter.setClipPath(patch)
    painter.drawImage(QPointF(0.0, 0.0), reader.read())
    _rim(painter).drawPath(patch)
    painter.end()
    return QIcon(drawn)


def _begun() -> tuple[QPixmap, QPainter]:
    drawn = QPixmap(QSize(SIDE * _FINE, SIDE * _FINE))
    drawn.fill(Qt.GlobalColor.transparent)
    painter = QPainter(drawn)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    return drawn, painter


def _rim(painter: QPainter) -> QPainter:
    """Return the painter, ready for an outline that parts white things from a white ground."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QColor(theme.current().border))
    return painter


def _towards(colour: QColor, other: QColor, part: float) -> QColor:
    pairs = (
        (colour.redF(), other.redF()),
        (colour.greenF(), other.greenF()),
        (colour.blueF(), other.blueF()),
    )
    return QColor.fromRgbF(*((1.0 - part) * a + part * b for a, b in pairs))
