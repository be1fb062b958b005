"""The sheet of the angle-curve editor: what is shown of a law, and painting it."""

from __future__ import annotations

from math import pi

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent

from app.panels.laws.key_curve import KeyCurve
from app.panels.laws.key_sheet import Key
from app.panels.laws.plot import paint_curve, paint_keys, paint_paper, value_at
from app.theme import theme
from app.theme.fonts import small_font
from app.widgets.plot import Plot, paint_label
from app.widgets.quantity import format_number
from sgb_core.surfaces.laws.law import Law


class AngleSheet(KeyCurve):
    """Shows f(θ) of one law with its keys and says what lies where; larger values lie higher."""

    _name = ""
    _sweep = 360.0

    def show_law(self, law: Law | None, name: str, sweep: float) -> None:
        """Show a law; ``name`` is its parameter's symbol, ``sweep`` the turn in degrees."""
        if (law, name, sweep) != (self._law, self._name, self._sweep):
            self._name, self._sweep = name, sweep
            self._show(law)

    @property
    def plot(self) -> Plot:
        """Where angles and parts of the way from start to end lie in this widget."""
        law = self._law
        falls = law is not None and law.start > law.end
        return Plot.within(float(self.width()), float(self.height()), 360.0, down=falls)

    def place(self, x: float, y: float) -> QPointF:
        """Return where an angle in degrees and f lie, in pixels."""
        return self.plot.place(x, y)

    def read(self, at: QPointF) -> Key:
        """Return the angle in degrees and f at a place, not limited to the plot."""
        return self.plot.read(at)

    def sizeHint(self) -> QSize:
        return QSize(220, 150)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, 130)

    def _keys_of(self, law: Law) -> tuple[Key, ...]:
        return law.keyframes if "keyframes" in law.shape.uses else ()

    def _places_of(self, key: Key) -> tuple[QPointF, ...]:
        turn = key[0] % 360.0
        # The start is the end too.
        return tuple(self.place(seen, key[1]) for seen in ((turn,) if turn else (turn, 360.0)))

    def _key_words(self, index: int) -> str:
        assert self._law is not None
        return ", ".join(self._lines_at(self._law, self._keys[index][0]))

    # Drawing.

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        font, plot, law = small_font(self.font()), self.plot, self._law
        paint_paper(painter, plot, law, self._sweep, font)
        if law is not None:
            paint_curve(painter, plot, law)
            if self._keys:
                paint_keys(painter, plot, law, self._selected, self._over)
            self._paint_told(painter, plot, law)
        self._paint_focus(painter, plot)
        painter.end()

    def _paint_told(self, painter: QPainter, plot: Plot, law: Law) -> None:
        marked = self._marked
        font = small_font(self.font())
        if marked is not None and marked < len(self._keys):
            degrees, value = self._keys[marked]
            at = plot.place(degrees % 360.0, value)
            paint_label(painter, plot, at, self._lines_at(law, degrees), font)
        elif self._pointer is not None and plot.box.contains(self._pointer):
            degrees = plot.read(self._pointer)[0]
            at = plot.place(degrees, float(law.fraction(degrees * pi / 180.0)))
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(theme.current().accent))
            painter.drawEllipse(at, 3.0, 3.0)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            paint_label(painter, plot, at, self._lines_at(law, degrees), font)

    def _lines_at(self, law: Law, degrees: float) -> list[str]:
        turn = degrees if degrees == 360.0 else degrees % 360.0
        return [
            f"{format_number(turn, 1)}°",
            f"{self._name} = {format_number(value_at(law, degrees), 3)}",
        ]
