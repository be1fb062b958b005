"""The source with the chain over it: axis, scale and clicks are grabbed here."""

from __future__ import annotations

from math import tan

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.hand.canvas import Canvas
from app.hand.coordinates import Area, ScreenPoint, Transform
from app.hand.preferences import wheel_turn
from app.intake.backdrop import Backdrop, draw_dots
from app.intake.chain import draw_chain, draw_scale
from app.intake.grabs import Grabs, Part, axis_through, draw_axis, draw_clicks
from app.intake.work import Traced
from app.theme import theme
from app.theme.fonts import small_font
from sgb_core.arrays import Floats
from sgb_core.sources.reading import Frame

_MARGIN = 26.0
# How near to the axis, to its ends, or to a mark a press must be, in pixels.
_NEAR, _END = 7.0, 12.0
# How far from a picture's edge the axis' handles stand.
_INSET = 18.0


class SourceView(QWidget):
    """Shows a source in its own coordinates, y upwards, and what was traced from it.

    ``axis_moved`` tells its abscissa at ``middle`` and its lean, ``scale_moved`` and
    ``clicks_moved`` their points, y downwards as pixels count; ``path_chosen`` a path's number.
    """

    axis_moved = Signal(float, float)
    scale_moved = Signal(object)
    clicks_moved = Signal(object)
    path_chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.backdrop: Backdrop | None = None
        self.traced: Traced | None = None
        self.grabs = Grabs()
        self.axis: tuple[float, float] | None = None
        self.path = 0
        self._transform = Transform(1.0, 0.0, 0.0)
        self._fit_wanted = True
        self._held: tuple[Part, int] | None = None
        self._last = QPointF()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setMinimumSize(260, 260)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName("Source and chain")
        self.setWhatsThis(_HELP)
        theme.notifier().changed.connect(self._theme_changed)

    def sizeHint(self) -> QSize:
        return QSize(620, 560)

    def _theme_changed(self, _palette: object) -> None:
        self.update()

    # What is shown.

    def show_source(self, backdrop: Backdrop | None) -> None:
        """Show another source, whole."""
        self.backdrop, self.traced, self.axis = backdrop, None, None
        self._fit_wanted = True
        self.update()

    def show_traced(self, traced: Traced | None) -> None:
        """Show what was traced; a mesh's section is fitted the first time."""
        if self.traced is None and self.backdrop is None:
            self._fit_wanted = True
        self.traced = traced
        if traced is not None and traced.reading.frame is not None and self._held is None:
            frame = traced.reading.frame
            self.axis = (self._abscissa(frame), frame.turn)
        self.update()

    @property
    def transform(self) -> Transform:
        """Where the source's coordinates lie in this widget."""
        return self._transform

    @property
    def middle(self) -> float:
        """The ordinate at which the axis has its abscissa: half way up."""
        if self.backdrop is None:
            return 0.0
        return float(self.backdrop.low[1] + self.backdrop.high[1]) / 2.0

    def _abscissa(self, frame: Frame) -> float:
        x, y = frame.origin
        return x - (self.middle - y) * tan(frame.turn)

    def fit(self) -> None:
        """Show all of the source."""
        box = self._box()
        inner = Area(0.0, 0.0, float(self.width()), float(self.height())).grown(-_MARGIN)
        self._transform = Transform.fitting(*box, inner)
        self._fit_wanted = False
        self.update()

    def _box(self) -> tuple[Floats, Floats]:
        if self.backdrop is not None:
            return self.backdrop.low, self.backdrop.high
        if self.traced is not None:
            points = self.traced.taken.points
            low, high = points.min(axis=0), points.max(axis=0)
            return np.array([min(-high[0], low[0]), low[1]]), high
        return np.zeros(2), np.ones(2)

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._fit_wanted:
            self.fit()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = Area(0.0, 0.0, float(self.width()), float(self.height()))
        font = small_font(self.font(), 0.88)
        canvas = Canvas(painter, self._transform, theme.current(), area, font)
        painter.fillRect(self.rect(), canvas.color("canvas"))
        if self.backdrop is not None:
            self.backdrop.draw(canvas, self.path, 0.75)
        elif self.traced is not None:
            draw_dots(canvas, self.traced.taken.points)
        ends = self._axis_ends()
        if ends is not None:
            held = self._held is not None and self._held[0] in (Part.AXIS, Part.TOP, Part.BOTTOM)
            draw_axis(canvas, ends, held=held, leans=self.grabs.lean)
        if self.traced is not None:
            draw_chain(canvas, self.traced)
        if self.grabs.scale is not None:
            draw_scale(canvas, [self._mark(place) for place in self.grabs.scale])
        draw_clicks(canvas, (self._mark(place) for place in self.grabs.clicks or ()))
        if self.hasFocus():
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
            painter.setPen(canvas.pen("accent", 1.0))
            painter.drawRect(QRectF(0, 0, self.width() - 1, self.height() - 1))
        painter.end()

    def _axis_ends(self) -> tuple[Floats, Floats] | None:
        """Return the lower and the upper end of the axis on the screen."""
        if self.axis is None:
            return None
        (x, lean), box = self.axis, self._box()
        inset = _INSET / self._transform.scale if self.grabs.lean else -_INSET
        found = []
        for y in (box[0][1] + inset, box[1][1] - inset):
            found.append(self._transform.map((x - (y - self.middle) * tan(lean), y)))
        return found[0], found[1]

    def _mark(self, place: tuple[float, float]) -> Floats:
        return self._transform.map((place[0], -place[1]))

    # The hand.

    def _part_at(self, at: QPointF) -> tuple[Part, int]:
        here = np.array([at.x(), at.y()])

        def away(place: Floats) -> float:
            return float(np.hypot(*(place - here)))

        for number, place in enumerate(self.grabs.clicks or ()):
            if away(self._mark(place)) < _END:
                return Part.CLICK, number
        for number, place in enumerate(self.grabs.scale or ()):
            if away(self._mark(place)) < _END:
                return (Part.FIRST, Part.SECOND)[number], 0
        ends = self._axis_ends()
        if ends is not None and self.grabs.axis:
            if self.grabs.lean:
                for part, end in zip((Part.BOTTOM, Part.TOP), ends, strict=True):
                    if away(end) < _END:
                        return part, 0
            step = ends[1] - ends[0]
            length = float(np.hypot(*step)) or 1.0
            off = here - ends[0]
            if abs(float(step[0] * off[1] - step[1] * off[0])) / length < _NEAR:
                return Part.AXIS, 0
        return Part.PAPER, 0

    def mousePressEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        self._last = at
        if event.button() == Qt.MouseButton.RightButton and self.grabs.clicks:
            part, number = self._part_at(at)
            self._drop_click(number if part is Part.CLICK else len(self.grabs.clicks) - 1)
            return
        if event.button() == Qt.MouseButton.MiddleButton:
            self._held = (Part.PAPER, 0)
        elif event.button() == Qt.MouseButton.LeftButton:
            self._held = self._part_at(at)
            if self._held[0] is Part.PAPER:
                self._press_paper(at)
        self.update()

    def _press_paper(self, at: QPointF) -> None:
        if self.grabs.clicks is not None:
            clicks = (*self.grabs.clicks, self._pixel(at))
            self._held = (Part.CLICK, len(clicks) - 1)
            self.clicks_moved.emit(clicks)
        elif self.backdrop is not None and len(self.backdrop.paths) > 1:
            here = np.array([at.x(), at.y()])
            placed = [self._transform.map(path) for path in self.backdrop.paths]
            found = self.backdrop.path_at(here, placed)
            if found is not None:
                self._held = None
                self.path_chosen.emit(found)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if self._held is None:
            self._show_cursor(at)
            return
        part, number = self._held
        if part is Part.PAPER:
            step = at - self._last
            self._transform = self._transform.panned(step.x(), step.y())
        elif part in (Part.FIRST, Part.SECOND) and self.grabs.scale is not None:
            ends = list(self.grabs.scale)
            ends[part is Part.SECOND] = self._pixel(at)
            self.scale_moved.emit(tuple(ends))
        elif part is Part.CLICK and self.grabs.clicks is not None:
            clicks = list(self.grabs.clicks)
            clicks[number] = self._pixel(at)
            self.clicks_moved.emit(tuple(clicks))
        elif self.axis is not None:
            self._move_axis(part, at)
        self._last = at
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._held = None
        self._show_cursor(event.position())
        self.update()

    def _move_axis(self, part: Part, at: QPointF) -> None:
        assert self.axis is not None
        x, lean = self.axis
        if part is Part.AXIS:
            x += (at.x() - self._last.x()) / self._transform.scale
        else:
            # The other end stays where it is.
            ends = self._axis_ends()
            assert ends is not None
            fixed = self._place(ends[part is Part.BOTTOM])
            moved = self._place(np.array([at.x(), at.y()]))
            low, high = (moved, fixed) if part is Part.BOTTOM else (fixed, moved)
            x, lean = axis_through(low, high, fixed, self.middle)
        self.axis = (x, lean)
        self.axis_moved.emit(x, lean)

    def _place(self, at: Floats) -> tuple[float, float]:
        return self._transform.to_design(ScreenPoint(*at.tolist())).pair

    def _pixel(self, at: QPointF) -> tuple[float, float]:
        x, y = self._transform.to_design(ScreenPoint(at.x(), at.y())).pair
        return round(x, 1), round(-y, 1)

    def _show_cursor(self, at: QPointF) -> None:
        part = self._part_at(at)[0]
        shape = Qt.CursorShape.ArrowCursor
        if part is Part.PAPER:
            if self.grabs.clicks is not None:
                shape = Qt.CursorShape.CrossCursor
        elif part is Part.AXIS:
            shape = Qt.CursorShape.SizeHorCursor
        else:
            shape = Qt.CursorShape.SizeAllCursor
        self.setCursor(shape)

    def wheelEvent(self, event: QWheelEvent) -> None:
        turned = wheel_turn(event.angleDelta().y() or event.angleDelta().x())
        at = event.position()
        self.zoom(1.0015**turned, ScreenPoint(at.x(), at.y()))
        event.accept()

    def zoom(self, factor: float, at: ScreenPoint) -> None:
        """Scale the picture; what lies under ``at`` stays there."""
        low, high = self._box()
        size = max(float(np.hypot(*(high - low))), 1e-9)
        wanted = min(max(self._transform.scale * factor, 20.0 / size), 1e5 / size)
        self._transform = self._transform.zoomed(wanted / self._transform.scale, at)
        self.update()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = event.key()
        centre = ScreenPoint(self.width() / 2.0, self.height() / 2.0)
        if key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace) and self.grabs.clicks:
            self._drop_click(len(self.grabs.clicks) - 1)
        elif key in _SHIFTS and self.grabs.axis and self.axis is not None:
            tenth = event.modifiers() & Qt.KeyboardModifier.ShiftModifier
            x = self.axis[0] + _SHIFTS[key] * (10.0 if tenth else 1.0) / self._transform.scale
            self.axis = (x, self.axis[1])
            self.axis_moved.emit(*self.axis)
        elif key == Qt.Key.Key_F:
            self.fit()
        elif key in (Qt.Key.Key_Plus, Qt.Key.Key_Equal, Qt.Key.Key_Minus):
            self.zoom(0.8 if key == Qt.Key.Key_Minus else 1.25, centre)
        else:
            super().keyPressEvent(event)
        self.update()

    def _drop_click(self, number: int) -> None:
        clicks = list(self.grabs.clicks or ())
        del clicks[number]
        self.clicks_moved.emit(tuple(clicks))

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._fit_wanted = True
        super().resizeEvent(event)


_SHIFTS: dict[int, float] = {Qt.Key.Key_Left: -1.0, Qt.Key.Key_Right: 1.0}
_HELP = (
    "Drag the axis, or the squares at its ends to let it lean; drag the ends of the scale. While a "
    "line is followed each click adds a point on it, a right click or Del takes the last away. "
    "Left and right arrows move the axis, the wheel, plus and minus zoom, F fits."
)
