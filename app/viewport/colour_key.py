"""The colour bar in the viewport: which colour means how much influence."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QLinearGradient, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from app.state.presenter import Frame
from app.state.window_reader import WINDOW
from app.theme import theme
from app.theme.fonts import small_font
from sgb_core.curves.segment import SYMBOLS
from sgb_core.document.appearance.colour_tables import scale_of, table
from sgb_core.document.appearance.model import ColourMap, MapKind

_PAD, _BAR = 8.0, 12.0


class ColourKey(QWidget):
    """Floats over the viewport's corner while the surface is coloured by influence."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._title = ""
        self._unit = ""
        self._largest = 0.0
        self.setAccessibleName("Colours of influence")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()
        theme.notifier().changed.connect(self._theme_changed)

    def show_state(self, frame: Frame, largest: float) -> None:
        """Say what the colours of a frame mean; ``largest`` is what the last one stands for."""
        parameter = frame.view.influence
        if parameter is None:
            self.hide()
            return
        segment = frame.view.influenced
        whose = "all segments" if segment is None else WINDOW.segment(segment)
        said = (f"Influence of {SYMBOLS[parameter]}, {whose}", str(frame.document.unit), largest)
        if said != (self._title, self._unit, self._largest):
            self._title, self._unit, self._largest = said
            self.setAccessibleDescription(f"{self._title}: 0 to {self.top} per unit")
            self.resize(self.sizeHint())
            self.update()
        self.place()
        self.show()
        self.raise_()

    def place(self) -> None:
        """Keep to the lower left corner of the viewport."""
        parent = self.parentWidget()
        assert parent is not None
        self.move(10, parent.height() - self.height() - 10)

    @property
    def top(self) -> str:
        """What the last colour stands for: "12.3 mm", or "nothing moves"."""
        return f"{self._largest:.3g} {self._unit}" if self._largest > 0.0 else "nothing moves"

    def sizeHint(self) -> QSize:
        metrics = QFontMetricsF(small_font(self.font()))
        width = max(metrics.horizontalAdvance(self._title) + 2.0 * _PAD, 215.0)
        return QSize(round(width), round(2.0 * metrics.height() + _BAR + 2.0 * _PAD + 4.0))

    def _theme_changed(self, _palette: object) -> None:
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        colours = theme.current()
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(colours.panel))
        painter.setPen(QColor(colours.border))
        painter.drawRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5))
        font = small_font(self.font())
        metrics = QFontMetricsF(font)
        painter.setFont(font)
        painter.setPen(QColor(colours.text))
        painter.drawText(QPointF(_PAD, _PAD + metrics.ascent() - 2.0), self._title)
        bar = QRectF(_PAD, _PAD + metrics.height(), self.width() - 2.0 * _PAD, _BAR)
        gradient = QLinearGradient(bar.left(), 0.0, bar.right(), 0.0)
        shades = table(scale_of(ColourMap(MapKind.INFLUENCE), 0.0, self._largest))
        if self._largest <= 0.0:
            shades = shades[:1]
        for k, (red, green, blue) in enumerate(shades.tolist()):
            gradient.setColorAt(k / max(len(shades) - 1, 1), QColor(red, green, blue))
        painter.fillRect(bar, gradient)
        painter.setPen(QPen(QColor(colours.border), 1.0))
        painter.drawRect(bar)
        painter.setPen(QColor(colours.text))
        below = QRectF(bar.left(), bar.bottom() + 2.0, bar.width(), metrics.height())
        painter.drawText(below, Qt.AlignmentFlag.AlignLeft, "0")
        painter.drawText(below, Qt.AlignmentFlag.AlignHCenter, "moves per unit")
        painter.drawText(below, Qt.AlignmentFlag.AlignRight, self.top)
        painter.end()
