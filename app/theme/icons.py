"""The project's own icons, drawn in the text colour of the theme.

The files in ``resources/icons`` are 24-pixel stroke drawings in ``currentColor``. They are
rendered anew for each theme, at several sizes, so that they are sharp on any screen.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Protocol
from weakref import WeakKeyDictionary

import shiboken6
from PySide6.QtCore import QByteArray, QObject, QRectF, QSize, Qt
from PySide6.QtGui import QGuiApplication, QIcon, QPainter, QPixmap
from PySide6.QtSvg import QSvgRenderer

import resources
from app.theme import theme

# Up to a 24-pixel icon on a screen of scale 3.
_LARGEST = 24
_SIZES = (16, 20, 24, 32, 48, 72)


class HasIcon(Protocol):
    """A QAction or a button."""

    def setIcon(self, icon: QIcon) -> None:
        """Show ``icon``."""


def icon(name: str) -> QIcon:
    """Return an icon in the colours of the theme in force.

    Raises FileNotFoundError where the project has no icon of that name. To follow a change of
    theme use :func:`bind`.
    """
    return _icon(name, theme.current())


def bind(target: HasIcon, name: str) -> None:
    """Give ``target`` (a QAction or a button) an icon that follows the theme."""
    if not _bound.connected:
        _bound.connected = True
        theme.notifier().changed.connect(_bound.repaint)
    _bound.targets[target] = name
    target.setIcon(icon(name))


class _Bound:
    """Who shows which icon; the targets' lives are their own."""

    def __init__(self) -> None:
        self.targets: WeakKeyDictionary[HasIcon, str] = WeakKeyDictionary()
        self.connected = False

    def repaint(self, _palette: theme.Palette) -> None:
        for target, name in list(self.targets.items()):
            # The Python object may outlive the C++ one that Qt deleted with its parent.
            if not isinstance(target, QObject) or shiboken6.isValid(target):
                target.setIcon(icon(name))


_bound = _Bound()


def pixmap(name: str, size: int, colour: str, ratio: float = 1.0) -> QPixmap:
    """Return one drawing of an icon, ``size`` logical pixels square, in any colour."""
    return _drawn(_renderer(_source(name), colour), size, ratio)


def _source(name: str) -> bytes:
    return resources.read(f"icons/{name}.svg")


def _renderer(source: bytes, colour: str) -> QSvgRenderer:
    return QSvgRenderer(QByteArray(source.replace(b"currentColor", colour.encode())))


def _drawn(renderer: QSvgRenderer, size: int, ratio: float = 1.0) -> QPixmap:
    pixels = round(size * ratio)
    result = QPixmap(QSize(pixels, pixels))
    result.fill(Qt.GlobalColor.transparent)
    painter = QPainter(result)
    renderer.render(painter, QRectF(0, 0, pixels, pixels))
    painter.end()
    result.setDevicePixelRatio(ratio)
    return result


@lru_cache(maxsize=256)
def _icon(name: str, palette: theme.Palette) -> QIcon:
    result, source = QIcon(), _source(name)
    # The finest screen that there is decides: larger ones cost most, and nobody would see them.
    running = QGuiApplication.instance()
    ratio = running.devicePixelRatio() if isinstance(running, QGuiApplication) else 1.0
    sizes = [size for size in _SIZES if size <= _LARGEST * max(2.0, ratio)]
    for mode, colour in (
        (QIcon.Mode.Normal, palette.text),
        (QIcon.Mode.Selected, palette.accent_text),
        (QIcon.Mode.Disabled, palette.text_disabled),
    ):
        renderer = _renderer(source, colour)
        for size in sizes:
            result.addPixmap(_drawn(renderer, size), mode)
    return result
