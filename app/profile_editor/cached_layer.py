"""Layers of the profile editor that stay the same from frame to frame, painted once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field, replace

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QPainter, QPixmap

from app.hand.canvas import Canvas
from app.profile_editor.slump_line import SlumpLine
from sgb_core.values import dataclass


class CachedLayer:
    """Something laid over the paper that is painted anew only when what it shows has changed."""

    def __init__(self) -> None:
        self._key: object = None
        self._sheet = QPixmap()

    def draw(
        self, canvas: Canvas, size: QSize, shown: object, paint: Callable[[Canvas], None]
    ) -> None:
        """Draw what ``paint`` draws; ``shown`` is equal as long as that is the same.

        ``size`` is the widget's. Labels do not belong here: they keep clear of each other.
        """
        ratio = canvas.painter.device().devicePixelRatioF()
        key = (shown, size, ratio, canvas.transform, canvas.area, canvas.palette)
        if key != self._key:
            self._key = key
            self._sheet = QPixmap(size * ratio)
            self._sheet.setDevicePixelRatio(ratio)
            self._sheet.fill(Qt.GlobalColor.transparent)
            painter = QPainter(self._sheet)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            paint(replace(canvas, painter=painter))
            painter.end()
        canvas.painter.drawPixmap(0, 0, self._sheet)


@dataclass(frozen=True, slots=True)
class CachedLayers:
    """The layers of one editor: the range of a slider, that shown large, and another state.

    While a slider moves they stay: what it can reach, and what it is compared with. And the slump
    line, worked out once for each document.
    """

    range: CachedLayer = field(default_factory=CachedLayer)
    inset: CachedLayer = field(default_factory=CachedLayer)
    compared: CachedLayer = field(default_factory=CachedLayer)
    slump: SlumpLine = field(default_factory=SlumpLine)
