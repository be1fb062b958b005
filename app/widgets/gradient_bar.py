"""A gradient to edit in place: stops are dragged, added, recoloured and removed."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QKeyEvent,
    QLinearGradient,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
)
from PySide6.QtWidgets import QColorDialog, QWidget

from app.theme import theme

Stops = tuple[tuple[float, str], ...]
MARGIN, BAR, HANDLE = 8.0, 20.0, 12.0


class GradientBar(QWidget):
    """Drag a mark to move it, double-click it for its colour, double-click beside to add one.

    With the keyboard: Tab in, Left and Right move the chosen mark, Up and Down choose, Enter asks
    for its colour, Del removes it.
    """

    began = Signal()
    changed = Signal(object)
    ended = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.stops: Stops = ()
        self.chosen = 0
        self._dragging = False
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName("Gradient")
        self.setToolTip(
            "Drag a mark; double-click a mark for its colour, beside one to add; Del removes"
        )
        self.setMinimumHeight(round(BAR + HANDLE + 6))

    def sizeHint(self) -> QSize:
        return QSize(140, round(BAR + HANDLE + 6))

    def set_stops(self, stops: Stops) -> None:
        """Show these stops; emits nothing."""
        if not self._dragging and stops != self.stops:
            self.stops = stops
            self.chosen = min(self.chosen, max(0, len(stops) - 1))
            self.update()

    def _x(self, place: float) -> float:
        return MARGIN + place * (self.width() - 2 * MARGIN)

    def _place(self, x: float) -> float:
        return min(max((x - MARGIN) / max(1.0, self.width() - 2 * MARGIN), 0.0), 1.0)

    def _at(self, x: float) -> int | None:
        near = [(abs(self._x(place) - x), k) for k, (place, _) in enumerate(self.stops)]
        distance, found = min(near, default=(99.0, 0))
        return found if distance <= HANDLE else None

    def _change(self, stops: list[tuple[float, str]]) -> None:
        self.stops = tuple(stops)
        self.update()
        self.changed.emit(tuple(sorted(stops, key=lambda stop: stop[0])))

    def _moved(self, place: float) -> None:
        stops = list(self.stops)
        low = stops[self.chosen - 1][0] if self.chosen > 0 else 0.0
        high = stops[self.chosen + 1][0] if self.chosen + 1 < len(stops) else 1.0
        stops[self.chosen] = (min(max(place, low), high), stops[self.chosen][1])
        self._change(stops)

    def _once(self, stops: list[tuple[float, str]]) -> None:
        self.began.emit()
        self._change(stops)
        self.ended.emit()

    def add(self, place: float) -> None:
        """Add a stop of the colour that is there."""
        before = [stop for stop in self.stops if stop[0] <= place]
        stops = list(self.stops)
        self.chosen = len(before)
        stops.insert(self.chosen, (place, self.colour_at(place)))
        self._once(stops)

    def remove(self) -> None:
        """Remove the chosen stop; two always stay."""
        if len(self.stops) > 2:
            stops = list(self.stops)
            del stops[self.chosen]
            self.chosen = min(self.chosen, len(stops) - 1)
            self._once(stops)

    def colour_at(self, place: float) -> str:
        """Return the gradient's colour at a place."""
        below = [stop for stop in self.stops if stop[0] <= place] or [self.stops[0]]
        above = [stop for stop in self.stops if stop[0] >= place] or [self.stops[-1]]
        (low, first), (high, second) = below[-1], above[0]
        part = (place - low) / (high - low) if high > low else 0.0
        a, b = QColor(first), QColor(second)
        mixed = (a.red(), b.red()), (a.green(), b.green()), (a.blue(), b.blue())
        return QColor(*(round(x + (y - x) * part) for x, y in mixed)).name()

    def ask_colour(self) -> None:
        """Ask for the chosen stop's colour."""
        dialog = QColorDialog(QColor(self.stops[self.chosen][1]), self)
        dialog.setOption(QColorDialog.ColorDialogOption.DontUseNativeDialog)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)

        def take(colour: QColor) -> None:
            stops = list(self.stops)
            stops[self.chosen] = (stops[self.chosen][0], colour.name())
            self._once(stops)

        dialog.colorSelected.connect(take)
        dialog.show()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        found = self._at(event.position().x())
        if event.button() == Qt.MouseButton.LeftButton and found is not None:
            self.chosen, self._dragging = found, True
            self.began.emit()
            self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._dragging:
            self._moved(self._place(event.position().x()))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._dragging:
            self._dragging = False
            self.ended.emit()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        found = self._at(event.position().x())
        if found is None and self.stops:
            self.add(self._place(event.position().x()))
        elif found is not None:
            self.chosen = found
            self.ask_colour()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = event.key()
        step = {Qt.Key.Key_Left: -0.01, Qt.Key.Key_Right: 0.01}.get(Qt.Key(key))
        if not self.stops:
            super().keyPressEvent(event)
        elif step is not None:
            self.began.emit()
            self._moved(self.stops[self.chosen][0] + step)
            self.ended.emit()
        elif key in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            way = 1 if key == Qt.Key.Key_Up else -1
            self.chosen = (self.chosen + way) % len(self.stops)
            self.update()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.ask_colour()
        elif key == Qt.Key.Key_Delete:
            self.remove()
        else:
            super().keyPressEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        palette = theme.current()
        bar = QRectF(MARGIN, 1.0, self.width() - 2 * MARGIN, BAR)
        gradient = QLinearGradient(bar.topLeft(), bar.topRight())
        for place, colour in self.stops:
            gradient.setColorAt(place, QColor(colour))
        painter.setPen(QPen(QColor(palette.border)))
        painter.setBrush(gradient)
        painter.drawRoundedRect(bar, 3.0, 3.0)
        for number, (place, colour) in enumerate(self.stops):
            x, y = self._x(place), BAR + 1.0
            chosen = number == self.chosen
            edge = palette.accent if chosen and self.hasFocus() else palette.text
            painter.setPen(QPen(QColor(edge), 2.0 if chosen else 1.0))
            painter.setBrush(QColor(colour))
            half = HANDLE / 2.0
            corners = ((0.0, -3.0), (half, 4.0), (half, HANDLE), (-half, HANDLE), (-half, 4.0))
            painter.drawPolygon(QPolygonF([QPointF(x + dx, y + dy) for dx, dy in corners]))
