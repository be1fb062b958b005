"""The plot of curvature along the generatrix: over its length, joints marked, live."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QFontMetricsF,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
    QShowEvent,
)
from PySide6.QtWidgets import QWidget

from app.state.presenter import Frame, Presenter
from app.state.window_reader import WINDOW
from app.theme import theme
from app.theme.fonts import small_font
from app.widgets.plot import LEFT, Plot, paint_label
from app.widgets.quantity import format_number
from sgb_core.arrays import Floats
from sgb_core.curves.comb import Comb, comb, outward_sign, typical_curvature
from sgb_core.curves.continuity import JointClass
from sgb_core.curves.profile import Profile

_SAMPLES = 97
# The plot reaches so many times the typical curvature; sharper bends leave it.
_REACH = 1.6


class CurvaturePlot(QWidget):
    """Shows κ over the length run through; hovering points at the place in the editor."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._frame: Frame | None = None
        self._comb: Comb | None = None
        self._of: Profile | None = None
        self._scale, self._outward = 0.0, 1.0
        self._pointer: QPointF | None = None
        self.setMouseTracking(True)
        self.setMinimumSize(180, 110)
        self.setAccessibleName("Curvature along the profile")
        self.setToolTip(
            "Curvature over the length of the profile: above the line it bulges out, below it "
            "is hollow.\nA step at a joint is a jump of curvature; G2 joints have none."
        )
        theme.notifier().changed.connect(self._theme_changed)

    def sizeHint(self) -> QSize:
        return QSize(320, 150)

    def refresh(self, frame: Frame) -> None:
        """Show ``frame``; nothing is computed while the plot cannot be seen."""
        self._frame = frame
        if self.isVisible():
            self._measure(frame.document.profile)
            self.update()

    @property
    def scale(self) -> float:
        """The curvature at the plot's upper edge, 0 where all is straight."""
        return self._scale

    def place(self, segment: int, index: int) -> QPointF:
        """Return where a sample of the curvature is plotted, in pixels; y is nan for none."""
        x, y = self._places(self._plot, segment)[index].tolist()
        return QPointF(x, y)

    def _places(self, plot: Plot, segment: int) -> Floats:
        """Return where the samples of a segment are plotted, (K, 2), in pixels; nan for none."""
        found = self._comb
        assert found is not None
        values = 0.5 + 0.5 * self._outward * found.curvature[segment] / (self._scale or 1.0)
        x = plot.left + plot.width * found.distance[segment] / (self._length or 1.0)
        return np.stack([x, plot.top + plot.height * (1.0 - values)], axis=-1)

    def _measure(self, profile: Profile) -> None:
        if profile is not self._of:
            self._of, self._comb = profile, comb(profile, _SAMPLES)
            self._scale = _REACH * typical_curvature(self._comb)
            self._outward = outward_sign(profile)

    @property
    def _plot(self) -> Plot:
        widest = QFontMetricsF(small_font(self.font())).horizontalAdvance(self._number(0.0))
        return Plot.within(float(self.width()), float(self.height()), 1.0, max(LEFT, widest + 6.0))

    def _number(self, value: float) -> str:
        """Return the curvature at a height of the plot, from 0 to 1, as the scale tells it."""
        return _short(self.scale * (2.0 * value - 1.0), 2)

    @property
    def _length(self) -> float:
        return 0.0 if self._comb is None else float(self._comb.distance[-1, -1])

    def _under(self, at: QPointF) -> tuple[int, int] | None:
        """Return the segment and sample under a place, None beside the plot."""
        plot, found = self._plot, self._comb
        if found is None or not plot.box.contains(at):
            return None
        run = (at.x() - plot.left) / plot.width * self._length
        flat = int(np.abs(found.distance - run).argmin())
        segment, index = np.unravel_index(flat, found.distance.shape)
        return int(segment), int(index)

    # The mouse.

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._pointer = event.position()
        under = self._under(self._pointer)
        mark = None if under is None else (under[0], under[1] / (_SAMPLES - 1))
        self._presenter.set_view(mark=mark)
        self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        under = self._under(event.position())
        if under is not None:
            self._presenter.select(under[0])

    def leaveEvent(self, event: QEvent) -> None:
        self._pointer = None
        self._presenter.set_view(mark=None)
        self.update()
        super().leaveEvent(event)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._frame is not None:
            self.refresh(self._presenter.frame)

    # Drawing.

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        frame, found = self._frame, self._comb
        if frame is None or found is None:
            return
        colours, plot = theme.current(), self._plot
        font = small_font(self.font())
        painter.setFont(font)
        painter.fillRect(plot.box, QColor(colours.canvas))
        self._paint_joints(painter, plot, frame)
        middle = plot.place(0.0, 0.5).y()
        painter.setPen(QColor(colours.axis))
        painter.drawLine(QPointF(plot.left, middle), QPointF(plot.left + plot.width, middle))
        self._paint_scale(painter, plot)
        painter.setClipRect(plot.box)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for segment in range(len(found.curvature)):
            self._paint_segment(painter, plot, segment, middle)
        painter.setClipping(False)
        self._paint_told(painter, plot, frame)
        painter.end()

    def _paint_segment(self, painter: QPainter, plot: Plot, segment: int, middle: float) -> None:
        colours = theme.current()
        kept = self._places(plot, segment)
        kept = kept[np.isfinite(kept[:, 1])]
        if not len(kept):
            return
        places = [QPointF(x, y) for x, y in kept.tolist()]
        ground = [
            QPointF(places[0].x(), middle),
            *places,
            QPointF(places[-1].x(), middle),
        ]
        # Bulging out above the line, hollow below it: each side in its own colour.
        area = plot.box
        for name, top, bottom in (
            ("bend_out", area.top(), middle),
            ("bend_in", middle, area.bottom()),
        ):
            painter.save()
            painter.setClipRect(QRectF(area.left(), top, area.width(), bottom - top))
            colour = QColor(getattr(colours, name))
            painter.setPen(QPen(colour, 1.8))
            painter.drawPolyline(QPolygonF(places))
            colour.setAlpha(40)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(colour)
            painter.drawPolygon(QPolygonF(ground))
            painter.restore()

    def _paint_joints(self, painter: QPainter, plot: Plot, frame: Frame) -> None:
        colours, found = theme.current(), self._comb
        assert found is not None
        metrics = QFontMetricsF(painter.font())
        free = 0.0
        for report in frame.evaluation.joints:
            x = plot.place(float(found.distance[report.joint, -1]) / (self._length or 1.0), 0).x()
            smooth = report.measured is JointClass.G2
            painter.setPen(QPen(QColor(colours.grid_major if smooth else colours.warning), 1.0))
            painter.drawLine(QPointF(x, plot.top), QPointF(x, plot.top + plot.height))
            text = str(report.measured)
            wide = metrics.horizontalAdvance(text)
            painter.setPen(QColor(colours.text_muted))
            left = min(max(x - wide / 2.0, 0.0), self.width() - wide - 1.0)
            if left >= free:
                base = plot.top + plot.height + 3.0 + metrics.ascent()
                painter.drawText(QPointF(left, base), text)
                free = left + wide + 4.0

    def _paint_scale(self, painter: QPainter, plot: Plot) -> None:
        painter.setPen(QColor(theme.current().text_muted))
        high = QFontMetricsF(painter.font()).height()
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        for value in (0.0, 0.5, 1.0):
            number = self._number(value)
            y = plot.place(0.0, value).y()
            y = min(max(y, plot.top + high / 2.0), plot.top + plot.height - high / 2.0)
            painter.drawText(QRectF(0.0, y - high / 2.0, plot.left - 4.0, high), right, number)

    def _paint_told(self, painter: QPainter, plot: Plot, frame: Frame) -> None:
        under = None if self._pointer is None else self._under(self._pointer)
        if under is None or self._comb is None:
            return
        segment, index = under
        unit = frame.document.unit
        value = self._outward * float(self._comb.curvature[segment, index])
        lines = [f"{WINDOW.segment(segment)}   s = {format_number(index / (_SAMPLES - 1), 2)}"]
        if np.isfinite(value):
            lines.append(f"κ = {_short(value)} / {unit}")
            if value:
                lines.append(f"radius {_short(abs(1.0 / value))} {unit}")
            at = self.place(segment, index)
            at = QPointF(at.x(), min(max(at.y(), plot.top), plot.top + plot.height))
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(theme.current().accent))
            painter.drawEllipse(at, 3.5, 3.5)
        else:
            lines.append("the derivative vanishes here")
            at = plot.place(float(self._comb.distance[segment, index]) / self._length, 0.5)
        paint_label(painter, plot, at, lines, painter.font())

    def _theme_changed(self, _palette: object) -> None:
        self.update()


def _short(value: float, digits: int = 3) -> str:
    """Return so many significant digits."""
    return f"{value:.{digits}g}".replace("-", "−")
