"""A ring of choices around the pointer: what the thing that was pressed can do."""

from __future__ import annotations

import math

from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QAction,
    QCloseEvent,
    QColor,
    QFontMetricsF,
    QGuiApplication,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QRegion,
)
from PySide6.QtWidgets import QMenu, QWidget

from app.theme import theme

MOST = 8
# Nearer to the middle than this nothing is chosen.
HUB = 22.0
_REACH = (150.0, 92.0)
_PAD = (12.0, 7.0)


def choices(menu: QMenu) -> list[QAction]:
    """Return the first actions of a menu that can be done just now, as many as a ring holds."""
    able = [each for each in menu.actions() if not each.isSeparator() and each.isEnabled()]
    return able[:MOST]


class RadialMenu(QWidget):
    """Shows a menu's first actions around its middle, the first on top, clockwise.

    The menu goes with the ring.

    Moving towards one and letting go does it; so do a click, its digit, and arrows with Enter.
    Escape, or a click in the middle, closes.
    """

    def __init__(self, menu: QMenu, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Popup | Qt.WindowType.FramelessWindowHint)
        self._menu = menu
        actions = choices(menu)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.actions_shown = actions
        self.chosen: int | None = None
        self._done = False
        names = [self._text(k) for k in range(len(actions))]
        self.setAccessibleName("Choices")
        self.setAccessibleDescription(", ".join(names))
        metrics = QFontMetricsF(self.font())
        widths = [metrics.horizontalAdvance(name) + 2.0 * _PAD[0] for name in names]
        height = metrics.height() + 2.0 * _PAD[1]
        widest = max(widths, default=0.0)
        self._size = QSize(
            round(2.0 * _REACH[0] + widest + 8.0), round(2.0 * _REACH[1] + height + 8.0)
        )
        self._boxes = []
        for k, width in enumerate(widths):
            angle = self._angle(k)
            x = self._middle.x() + _REACH[0] * math.sin(angle)
            y = self._middle.y() - _REACH[1] * math.cos(angle)
            self._boxes.append(QRectF(x - width / 2.0, y - height / 2.0, width, height))
        self.resize(self._size)
        region = QRegion(self._hub().toAlignedRect(), QRegion.RegionType.Ellipse)
        for box in self._boxes:
            region += QRegion(box.adjusted(-1.0, -1.0, 1.0, 1.0).toAlignedRect())
        self.setMask(region)

    @property
    def _middle(self) -> QPointF:
        return QPointF(self._size.width() / 2.0, self._size.height() / 2.0)

    def _hub(self) -> QRectF:
        return QRectF(self._middle - QPointF(HUB, HUB), self._middle + QPointF(HUB, HUB))

    def _angle(self, index: int) -> float:
        return 2.0 * math.pi * index / max(1, len(self.actions_shown))

    def _text(self, index: int) -> str:
        words = self.actions_shown[index].text().partition("\t")[0].replace("&", "")
        return f"{index + 1}  {words}"

    def open_at(self, at: QPoint) -> None:
        """Show the ring around a place of the screen, all of it on the screen."""
        corner = at - self._middle.toPoint()
        screen = QGuiApplication.screenAt(at) or QGuiApplication.primaryScreen()
        room = screen.availableGeometry()
        x = min(max(corner.x(), room.left()), room.right() - self._size.width())
        y = min(max(corner.y(), room.top()), room.bottom() - self._size.height())
        self.move(x, y)
        self.show()
        self.setFocus(Qt.FocusReason.PopupFocusReason)

    def toward(self, at: QPointF) -> int | None:
        """Return which choice lies in the direction of a place; None in the middle."""
        away = at - self._middle
        if not self.actions_shown or math.hypot(away.x(), away.y()) <= HUB:
            return None
        # The ring is flat: directions are those of its own ellipse.
        angle = math.atan2(away.x() / _REACH[0], -away.y() / _REACH[1])
        return round(angle / self._angle(1)) % len(self.actions_shown)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._choose(self.toward(event.position()))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if not self.rect().contains(event.position().toPoint()) or (
            self.toward(event.position()) is None
        ):
            self.close()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        chosen = self.toward(event.position())
        # The button that opened the ring is let go in the middle: the ring stays.
        if chosen is not None:
            self._do(chosen)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key, count = event.key(), len(self.actions_shown)
        if Qt.Key.Key_1 <= key < Qt.Key.Key_1 + count:
            self._do(key - Qt.Key.Key_1)
        elif key in (Qt.Key.Key_Right, Qt.Key.Key_Down) and count:
            self._choose(0 if self.chosen is None else (self.chosen + 1) % count)
        elif key in (Qt.Key.Key_Left, Qt.Key.Key_Up) and count:
            self._choose((-1 if self.chosen is None else self.chosen - 1) % count)
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.chosen is not None:
            self._do(self.chosen)
        elif key == Qt.Key.Key_Escape:
            self.close()
        else:
            super().keyPressEvent(event)

    def _choose(self, index: int | None) -> None:
        if index != self.chosen:
            self.chosen = index
            self.update()

    def _do(self, index: int) -> None:
        action, at = self.actions_shown[index], self.mapToGlobal(self._middle.toPoint())
        below = action.menu()
        self._done = True
        self.close()
        if isinstance(below, QMenu):
            below.aboutToHide.connect(self._menu.deleteLater)
            below.popup(at)
        else:
            action.trigger()
            self._menu.deleteLater()

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self._done:
            self._menu.deleteLater()
        super().closeEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        palette = theme.current()
        painter = QPainter(self)
        painter.fillRect(self.rect(), QColor(palette.panel))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(palette.accent), 3.0))
        painter.drawEllipse(self._hub().adjusted(4.0, 4.0, -4.0, -4.0))
        for k, box in enumerate(self._boxes):
            lit = k == self.chosen
            painter.setPen(QPen(QColor(palette.accent if lit else palette.border), 1.2))
            painter.setBrush(QColor(palette.accent if lit else palette.panel))
            painter.drawRect(box.adjusted(0.5, 0.5, -0.5, -0.5))
            painter.setPen(QColor(palette.accent_text if lit else palette.text))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self._text(k))
        painter.end()
