"""How the viewport begins: what is seen before the 3-D part is there, and how it is loaded."""

from __future__ import annotations

import contextlib
import importlib
import threading

from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QLinearGradient, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from app.theme import theme

# What takes long to import: with it aside the window is painted and answers at once.
QT_NAMES = ("qtpy.QtCore", "qtpy.QtGui", "qtpy.QtWidgets")
HEAVY = ("pyvistaqt", "app.scene.scene", "PIL.PngImagePlugin", "PIL.JpegImagePlugin")


class Ground(QWidget):
    """What is seen until the 3-D part is loaded: its background, quietly."""

    def paintEvent(self, _event: QPaintEvent) -> None:
        palette = theme.current()
        gradient = QLinearGradient(0, 0, 0, self.height())
        gradient.setColorAt(0.0, QColor(palette.viewport_top))
        gradient.setColorAt(1.0, QColor(palette.viewport_bottom))
        QPainter(self).fillRect(QRectF(self.rect()), gradient)


def begin(loader: threading.Thread) -> None:
    """Start what imports the 3-D part.

    qtpy, which pyvistaqt brings, asks for every class of Qt at its import, and PySide6 makes each
    when it is asked for: aside that ends in a crash where events are handled meanwhile.
    """
    with contextlib.suppress(ImportError):
        for name in QT_NAMES:
            importlib.import_module(name)
    loader.start()


def import_heavy() -> None:
    """Import what the 3-D part needs; what cannot be imported is reported where it is used."""
    with contextlib.suppress(ImportError):
        for name in HEAVY:
            importlib.import_module(name)
