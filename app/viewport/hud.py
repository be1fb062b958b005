"""The heads-up label over the viewport: a small widget beside the cursor, as in the editor."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QFont, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from app.hand.canvas import Canvas
from app.hand.coordinates import Area, ScreenPoint, Transform
from app.hand.readout import Label
from app.theme import theme
from sgb_core.arrays import Floats


class SurfaceHud(QWidget):
    """Says what is under the cursor or in the hand; the mouse does not notice it."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._label: Label | None = None
        self.hide()

    @property
    def lines(self) -> list[str]:
        """What is said; nothing while the label is hidden."""
        return [] if self._label is None else self._label.lines

    def tell(self, lines: list[str], at: ScreenPoint, clear_of: Floats) -> None:
        """Show these lines beside a place of the parent; none hide the label.

        It covers little of the places ``clear_of``, shape (m, 2).
        """
        if not lines:
            self._label = None
            self.hide()
            return
        font = QFont(self.font())
        if font.pointSizeF() > 0:
            font.setPointSizeF(max(7.0, 0.88 * font.pointSizeF()))
        self._label = Label.of(lines, font)
        holder = self.parentWidget()
        assert holder is not None
        room = Area(0.0, 0.0, float(holder.width()), float(holder.height()))

        def covered(box: QRectF) -> int:
            low, high = (box.left(), box.top()), (box.right(), box.bottom())
            return int(((clear_of > low) & (clear_of < high)).all(axis=1).sum())

        self.setGeometry(self._label.beside(at, room, covered).toAlignedRect())
        self.show()
        self.raise_()
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._label is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = Area(0.0, 0.0, float(self.width()), float(self.height()))
        font = self._label.fonts[-1]
        canvas = Canvas(painter, Transform(1.0, 0.0, 0.0), theme.current(), area, font)
        self._label.paint(canvas, QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5))
        painter.end()
