"""Fonts derived from the one that a widget has."""

from __future__ import annotations

from PySide6.QtGui import QFont


def small_font(font: QFont, part: float = 0.85) -> QFont:
    """Return a font for scales and labels, of this part of the size."""
    small = QFont(font)
    if small.pointSizeF() > 0:
        small.setPointSizeF(max(7.0, part * small.pointSizeF()))
    return small
