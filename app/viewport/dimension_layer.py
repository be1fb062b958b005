"""Dimension lines over the viewport, in the half-plane where the turn starts."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from app.hand.canvas import Canvas
from app.hand.coordinates import Area, DesignPoint, Transform
from app.hand.dimension_picture import draw_dimensions
from app.hand.hit_test import Handle
from app.state.presenter import Frame
from app.theme import theme
from app.theme.fonts import small_font
from app.viewport.half_plane import Lens, SpacePaper


class DimensionLayer(QWidget):
    """As large as the viewport, and transparent to the mouse; hidden while nothing is drawn."""

    def __init__(self, parent: QWidget | None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._shown: tuple[Frame, Lens, Handle | None] | None = None
        self.hide()

    def show_dimensions(
        self, frame: Frame | None, lens: Lens | None, active: Handle | None
    ) -> None:
        """Draw the dimensions of a frame as seen through a lens, where they are switched on."""
        if frame is None or lens is None or not frame.view.dimensions_in_space:
            self._shown = None
            self.hide()
            return
        self._shown = frame, lens, active
        self.setGeometry(0, 0, round(lens.width), round(lens.height))
        if self.isHidden():
            self.show()
            self.raise_()
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._shown is None:
            return
        frame, lens, active = self._shown
        paper = SpacePaper.of(frame.evaluation.surface, lens, DesignPoint(0.0, 0.0))
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = Area(0.0, 0.0, float(self.width()), float(self.height()))
        font = small_font(self.font(), 0.88)
        canvas = Canvas(painter, Transform(1.0, 0.0, 0.0), theme.current(), area, font)
        draw_dimensions(canvas, frame, active, paper)
        painter.end()
