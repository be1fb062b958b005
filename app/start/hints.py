"""Three hints laid over the window; each points at a real thing and goes away for good."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from PySide6.QtCore import QObject, QPoint, QPointF, QRectF, QSettings, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPainterPath, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.state.stored import stored_words
from app.theme import theme
from sgb_core.values import dataclass

Side = Literal["left", "right", "top"]
KEY = "hints_seen"
ARROW = 12
WIDTH = 230
# How often the things that hints point at are looked for again: docks move, windows grow.
LOOK_MILLISECONDS = 300
# Square pixels of a window that has room for all hints at once.
ROOM_FOR_ALL = 1200 * 760


@dataclass(frozen=True, slots=True)
class Hint:
    """Words, where they point, from which side, and whether the user has found out by himself.

    ``target`` returns a point of the window, None while the thing is not to be seen. ``mark``
    returns (epoch, value): the value differs once the user has done what the hint says, unless
    the epoch differs too, as after opening another document.
    """

    name: str
    words: str
    side: Side
    target: Callable[[], QPoint | None]
    mark: Callable[[], tuple[object, object]]


class Bubble(QWidget):
    """One hint: a speech bubble whose tip lies on the thing it speaks of."""

    gone = Signal(str)

    def __init__(self, hint: Hint, window: QWidget) -> None:
        super().__init__(window)
        self.hint = hint
        self._before = hint.mark()
        self._tip = QPointF()
        self.setAccessibleName("Hint")
        self.setAccessibleDescription(hint.words)
        words = QLabel(hint.words, self)
        words.setWordWrap(True)
        words.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.button = QPushButton("Got it", self)
        self.button.setAccessibleName(f"Got it: {hint.words}")
        self.button.setToolTip("Put this hint away for good (Esc)")
        self.button.clicked.connect(lambda: self.gone.emit(self.hint.name))
        row = QHBoxLayout()
        row.addStretch(1)
        row.addWidget(self.button)
        self._layout = layout = QVBoxLayout(self)
        edge = ARROW + 11
        layout.setContentsMargins(edge, edge, edge, edge)
        layout.addWidget(words)
        layout.addLayout(row)

    def is_found_out(self) -> bool:
        """Return whether the user has done what the hint says since the bubble was made."""
        mark = self.hint.mark()
        if mark[0] != self._before[0]:
            self._before = mark
        return mark != self._before

    def point_at(self, target: QPoint) -> None:
        """Lay the bubble beside ``target``, inside the window, with its tip on it."""
        width = WIDTH * max(16, self.fontMetrics().height()) // 16 + 2 * ARROW
        height = self._layout.totalHeightForWidth(width)
        self.resize(width, height)
        side, window = self.hint.side, self.parentWidget()
        assert window is not None
        x = {"left": target.x() - width, "right": target.x()}.get(side, target.x() - width // 2)
        y = target.y() if side == "top" else target.y() - height // 2
        x = min(max(0, x), window.width() - width)
        y = min(max(0, y), window.height() - height)
        self.move(x, y)
        self._tip = QPointF(target.x() - x, target.y() - y)
        self.update()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.gone.emit(self.hint.name)
        else:
            super().keyPressEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        palette = theme.current()
        body = QRectF(self.rect()).adjusted(ARROW, ARROW, -ARROW, -ARROW)
        path = QPainterPath()
        path.addRoundedRect(body, 8, 8)
        arrow = QPainterPath()
        arrow.addPolygon(QPolygonF([*self._arrow_feet(body), self._tip]))
        arrow.closeSubpath()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setBrush(QColor(palette.panel))
        painter.setPen(QPen(QColor(palette.accent), 1.5))
        painter.drawPath(path.united(arrow))

    def _arrow_feet(self, body: QRectF) -> list[QPointF]:
        if self.hint.side == "top":
            x = min(max(body.left() + 20, self._tip.x()), body.right() - 20)
            return [QPointF(x - 8, body.top() + 1), QPointF(x + 8, body.top() + 1)]
        y = min(max(body.top() + 20, self._tip.y()), body.bottom() - 20)
        x = body.left() + 1 if self.hint.side == "right" else body.right() - 1
        return [QPointF(x, y - 8), QPointF(x, y + 8)]


class Hints(QObject):
    """The hints of one window that have not been put away yet."""

    def __init__(self, hints: list[Hint], window: QWidget) -> None:
        super().__init__(window)
        self._hints = hints
        self._window = window
        self.bubbles: list[Bubble] = []
        self._timer = QTimer(self, interval=LOOK_MILLISECONDS)
        self._timer.timeout.connect(self.look)

    def show(self) -> None:
        """Lay the hints over the window that were never put away."""
        self.hide()
        seen = _seen()
        for hint in self._hints:
            if hint.name not in seen:
                bubble = Bubble(hint, self._window)
                bubble.gone.connect(self._put_away)
                self.bubbles.append(bubble)
        self.look()
        if self.bubbles:
            self._timer.start()

    def show_again(self) -> None:
        """Show all hints once more, those that were put away too."""
        QSettings().remove(KEY)
        self.show()

    def hide(self) -> None:
        """Take the hints off the window without putting them away."""
        self._timer.stop()
        for bubble in self.bubbles:
            bubble.hide()
            bubble.deleteLater()
        self.bubbles = []

    def _put_away(self, name: str) -> None:
        QSettings().setValue(KEY, sorted(_seen() | {name}))
        for bubble in [each for each in self.bubbles if each.hint.name == name]:
            self.bubbles.remove(bubble)
            bubble.hide()
            bubble.deleteLater()
        if not self.bubbles:
            self._timer.stop()

    def put_away(self) -> bool:
        """Put away for good the first hint that is shown; returns whether there was one."""
        shown = next((each for each in self.bubbles if each.isVisible()), None)
        if shown is None:
            return False
        self._put_away(shown.hint.name)
        self.look()
        return True

    def look(self) -> None:
        """Point at where the things are now; put away what the user has found out.

        A small window would be covered by all at once: there they come one after the other.
        """
        size = self._window.size()
        room = len(self._hints) if size.width() * size.height() >= ROOM_FOR_ALL else 1
        for bubble in list(self.bubbles):
            target = bubble.hint.target()
            if bubble.is_found_out():
                self._put_away(bubble.hint.name)
            elif target is None or room == 0:
                bubble.hide()
            else:
                room -= 1
                bubble.point_at(target)
                bubble.setVisible(True)
                bubble.raise_()


def _seen() -> set[str]:
    return set(stored_words(KEY))
