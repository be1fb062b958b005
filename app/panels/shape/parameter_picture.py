"""What a slider does to its segment, as a small picture: the curve at both ends of its range."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from app.theme import theme
from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.parameter_fan import parameter_fan
from sgb_core.curves.segment import ParameterName, Segment

WIDTH, HEIGHT = 18, 34
_MARGIN = 2.5
_PIECES = 24


class ParameterPicture(QWidget):
    """The control polygon, the curve as it is, and where the slider's two ends would take it."""

    def __init__(self, parameter: ParameterName, parent: QWidget) -> None:
        super().__init__(parent)
        self._parameter = parameter
        self._segment: Segment | None = None
        self.setFixedSize(WIDTH, HEIGHT)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def show_segment(self, segment: Segment) -> None:
        """Show the range of the parameter on a segment."""
        self._segment = segment
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._segment is None:
            return
        lines = self._lines(self._segment)
        shown = np.concatenate(lines)
        low, high = shown.min(axis=0), shown.max(axis=0)
        room = np.array((WIDTH, HEIGHT)) - 2.0 * _MARGIN
        scale = float((room / np.maximum(high - low, 1e-300)).min())
        middle = np.array((WIDTH, HEIGHT)) / 2.0
        palette = theme.current()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        # Told apart by strength too: the polygon faint, both ends of the range thin.
        pens = (
            (palette.polygon, 0.8, 130),
            (palette.quartic, 1.2, 255),
            (palette.quartic, 1.2, 255),
            (palette.generatrix, 1.8, 255),
        )
        for line, (name, width, alpha) in zip(lines, pens, strict=True):
            color = QColor(name)
            color.setAlpha(alpha)
            painter.setPen(QPen(color, width))
            places = middle + (line - (low + high) / 2.0) * (scale, -scale)
            painter.drawPolyline(QPolygonF([QPointF(x, y) for x, y in places.tolist()]))
        painter.end()

    def _lines(self, segment: Segment) -> list[Floats]:
        """Return the polygon, the curves at both ends of the range, and the one that is."""
        (fan,) = parameter_fan([segment], self._parameter, 2)
        weights = basis.bernstein(4, np.linspace(0.0, 1.0, _PIECES + 1))
        return [segment.points, *(weights @ np.stack([*fan, segment.quartic]))]
