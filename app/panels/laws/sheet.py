"""The sheet of the angle-curve editor: what is shown of a law, and painting it."""

from __future__ import annotations

from math import hypot, pi

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.panels.laws.plot import paint_curve, paint_keys, paint_paper, value_at
from app.theme import theme
from app.theme.fonts import small_font
from app.widgets.plot import Plot, paint_label
from app.widgets.quantity import format_number
from sgb_core.surfaces.laws.law import Law

REACH = 9.0


class AngleSheet(QWidget):
    """Shows f(θ) of one law with its keys and says what lies where."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._law: Law | None = None
        self._name = ""
        self._sweep = 360.0
        self._selected: int | None = None
        self._over: int | None = None
        self._held: int | None = None
        self._pointer: QPointF | None = None
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        theme.notifier().changed.connect(self._theme_changed)

    def show_law(self, law: Law | None, name: str, sweep: float) -> None:
        """Show a law; ``name`` is its parameter's symbol, ``sweep`` the turn in degrees."""
        if (law, name, sweep) == (self._law, self._name, self._sweep):
            return
        self._law, self._name, self._sweep = law, name, sweep
        count = len(law.keyframes) if law is not None and "keyframes" in law.shape.uses else 0
        if self._selected is not None and self._selected >= count:
            self._selected = None
        if self._over is not None and self._over >= count:
            self._over = None
        self._describe()
        self.update()

    @property
    def selected(self) -> int | None:
        """The number of the selected key."""
        return self._selected

    @property
    def plot(self) -> Plot:
        """Where angles and values lie in this widget."""
        return Plot.within(float(self.width()), float(self.height()), 360.0)

    def place(self, degrees: float, value: float) -> QPointF:
        """Return where an angle and f lie, in pixels."""
        return self.plot.place(degrees, value)

    def sizeHint(self) -> QSize:
        return QSize(220, 150)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, 130)

    @property
    def _keys(self) -> tuple[tuple[float, float], ...]:
        law = self._law
        return law.keyframes if law is not None and "keyframes" in law.shape.uses else ()

    def _key_at(self, at: QPointF) -> int | None:
        plot, best, least = self.plot, None, REACH
        for index, (degrees, value) in enumerate(self._keys):
            turn = degrees % 360.0
            for seen in (turn, 360.0) if turn == 0.0 else (turn,):
                away = plot.place(seen, value) - at
                distance = hypot(away.x(), away.y())
                if distance <= least:
                    best, least = index, distance
        return best

    def _select(self, index: int | None) -> None:
        self._selected = index
        self._describe()
        self.update()

    def _describe(self) -> None:
        law, index = self._law, self._selected
        words = ""
        if law is not None and index is not None and index < len(self._keys):
            degrees = self._keys[index][0]
            words = f"Key {index + 1} of {len(self._keys)}: " + ", ".join(self._told(law, degrees))
        self.setAccessibleDescription(words)

    def _theme_changed(self, _palette: object) -> None:
        self.update()

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
        if self.hasFocus():
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
            painter.setPen(QPen(QColor(theme.current().accent), 1.0))
            painter.drawRect(plot.box.adjusted(-1, -1, 1, 1))
        painter.end()

    def _paint_told(self, painter: QPainter, plot: Plot, law: Law) -> None:
        held = self._held if self._held is not None else self._over
        if held is None and self._pointer is None and self.hasFocus():
            held = self._selected
        font = small_font(self.font())
        if held is not None and held < len(self._keys):
            degrees, value = self._keys[held]
            at = plot.place(degrees % 360.0, value)
            paint_label(painter, plot, at, self._told(law, degrees), font)
        elif self._pointer is not None and plot.box.contains(self._pointer):
            degrees = plot.read(self._pointer)[0]
            at = plot.place(degrees, float(law.fraction(degrees * pi / 180.0)))
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(theme.current().accent))
            painter.drawEllipse(at, 3.0, 3.0)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            paint_label(painter, plot, at, self._told(law, degrees), font)

    def _told(self, law: Law, degrees: float) -> list[str]:
        turn = degrees if degrees == 360.0 else degrees % 360.0
        return [
            f"{format_number(turn, 1)}°",
            f"{self._name} = {format_number(value_at(law, degrees), 3)}",
        ]
