"""The path on its bed, drawn up to a moment: coloured by what may go wrong, turned by dragging."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.state.path_colours import shade_numbers, shades
from app.theme import theme
from sgb_core.arrays import Floats
from sgb_core.toolpaths.beads import bed_lines
from sgb_core.toolpaths.strand import Part
from sgb_core.toolpaths.toolpath import Toolpath

# How far from above one looks, in radians, and how far an arrow key turns.
_ELEVATION = 0.42
_KEY = 0.12
# More points than this are thinned out for the eye.
_MOST = 60_000


class PathView(QWidget):
    """Draws the path; dragging and the arrow keys turn it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumSize(QSize(380, 380))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName("The path on the printer's bed")
        self.setToolTip("The nozzle's path; drag or use the arrow keys to turn it")
        self._path: Toolpath | None = None
        self._measure = "lean"
        self._part = 1.0
        self._azimuth = -0.6
        self._held: QPointF | None = None

    def show_path(self, path: Toolpath | None) -> None:
        """Draw another path, or none."""
        self._path = path
        self.update()

    def colour_by(self, measure: str) -> None:
        """Colour by one of the measures."""
        self._measure = measure
        self.update()

    def show_until(self, part: float) -> None:
        """Draw what is printed in this part, 0 to 1, of the time."""
        self._part = part
        self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._held = event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._held is not None:
            self._azimuth += (event.position().x() - self._held.x()) / 120.0
            self._held = event.position()
            self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._held = None

    def keyPressEvent(self, event: QKeyEvent) -> None:
        turn = {Qt.Key.Key_Left: -_KEY, Qt.Key.Key_Right: _KEY}.get(Qt.Key(event.key()))
        if turn is None:
            super().keyPressEvent(event)
            return
        self._azimuth += turn
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        colours = theme.current()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(colours.canvas))
        if self._path is None:
            return
        bed = self._path.plan.printer.bed
        low, high = self._path.bounds
        reach = float(np.abs(np.concatenate([low[:2], high[:2]])).max())
        width = 2.4 * max(reach, 1.0)
        height = (float(high[2]) + 2.4 * reach * np.sin(_ELEVATION)) * 1.06
        scale = min(self.width() / width, self.height() / max(height, 1e-9))
        middle = QPointF(
            self.width() / 2.0, self.height() - 1.25 * reach * np.sin(_ELEVATION) * scale
        )
        painter.translate(middle)
        painter.setPen(QPen(QColor(colours.grid_major), 1.0))
        painter.drawPolygon(self._polygon(bed_lines(bed)[0], scale))
        self._draw_path(painter, self._path, scale)

    def _draw_path(self, painter: QPainter, path: Toolpath, scale: float) -> None:
        stride = max(1, len(path.points) // _MOST)
        times = np.cumsum(path.times)
        count = int(np.searchsorted(times, self._part * times[-1], side="right"))
        shown = np.arange(0, max(count, 1), stride)
        shade = shade_numbers(path, self._measure)[shown]
        shade[path.parts[shown] == Part.TRAVEL] = -1
        spots = self._projected(path.points[shown], scale)
        colours = [QColor(*each) for each in shades(theme.current()).tolist()]
        edges = np.flatnonzero(np.diff(shade)) + 1
        starts = np.concatenate([[0], edges])
        ends = np.concatenate([edges, [len(shown)]])
        for start, end in zip(starts.tolist(), ends.tolist(), strict=True):
            if shade[start] < 0:
                continue
            painter.setPen(QPen(colours[int(shade[start])], 1.0))
            own = spots[max(start - 1, 0) : end]
            painter.drawPolyline(QPolygonF([QPointF(x, y) for x, y in own.tolist()]))
        tip = QPointF(*self._projected(path.points[shown[-1:]], scale)[0].tolist())
        painter.setPen(QPen(QColor(theme.current().accent), 1.5))
        painter.setBrush(QColor(theme.current().accent))
        painter.drawPolygon(QPolygonF([tip, tip + QPointF(-6.0, -14.0), tip + QPointF(6.0, -14.0)]))
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _projected(self, points: Floats, scale: float) -> Floats:
        """Return places in pixels from the bed's middle, x to the right and y down, (k, 2)."""
        cosine, sine = np.cos(self._azimuth), np.sin(self._azimuth)
        right = points[:, 0] * cosine - points[:, 1] * sine
        away = points[:, 0] * sine + points[:, 1] * cosine
        up = points[:, 2] * np.cos(_ELEVATION) + away * np.sin(_ELEVATION)
        return scale * np.column_stack([right, -up])

    def _polygon(self, points: Floats, scale: float) -> QPolygonF:
        return QPolygonF([QPointF(x, y) for x, y in self._projected(points, scale).tolist()])
