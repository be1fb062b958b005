"""A hand on mouse and keyboard: real events for widgets."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

NONE = Qt.KeyboardModifier.NoModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
CTRL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton


def wheel(widget, notches=1, modifiers=NONE, delta=None):
    """Turn the wheel over a widget; as in a window, who does not want it passes it up."""
    turn = QPoint(0, 120 * notches if delta is None else delta)
    at = widget.mapToGlobal(widget.rect().center())
    while widget is not None:
        event = QWheelEvent(
            QPointF(widget.mapFromGlobal(at)),
            QPointF(at),
            QPoint(),
            turn,
            Qt.MouseButton.NoButton,
            modifiers,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(widget, event)
        if event.isAccepted():
            return widget
        widget = None if widget.isWindow() else widget.parentWidget()
    return None


def press(widget, at, modifiers=NONE, button=LEFT):
    QTest.mousePress(widget, button, modifiers, _point(at))


def move(widget, at, button=LEFT):
    """Move with a button held, and let the window follow."""
    _move(widget, at, button)
    QApplication.processEvents()


def hover(widget, at):
    """Move with no button held."""
    _move(widget, at, Qt.MouseButton.NoButton)


def _move(widget, at, held):
    """Send a move without warping the screen's own pointer, whose moves would come as well."""
    at = _point(at)
    there = QPointF(widget.mapToGlobal(at))
    none = Qt.MouseButton.NoButton
    event = QMouseEvent(QEvent.Type.MouseMove, QPointF(at), there, none, held, NONE)
    QApplication.sendEvent(widget, event)


def release(widget, at, modifiers=NONE, button=LEFT):
    QTest.mouseRelease(widget, button, modifiers, _point(at))


def double_click(widget, at, modifiers=NONE, button=LEFT):
    """Click twice; Qt's own double click leaves the button down."""
    QTest.mouseDClick(widget, button, modifiers, _point(at))
    release(widget, at, modifiers, button)


def drag(widget, start, end, steps=8, button=LEFT, modifiers=NONE):
    """Drag from one point of a widget to another, letting the window breathe in between."""
    press(widget, start, modifiers, button)
    for step in range(1, steps + 1):
        move(widget, QPointF(start) + (QPointF(end) - QPointF(start)) * (step / steps), button)
    release(widget, end, modifiers, button)
    QApplication.processEvents()


def _point(at):
    return at.toPoint() if isinstance(at, QPointF) else at


class Log:
    """Writes down the signals of a number field or slider in order."""

    def __init__(self, part):
        self.events = []
        part.began.connect(lambda: self.events.append("began"))
        part.changed.connect(lambda value: self.events.append(value))
        part.ended.connect(lambda: self.events.append("ended"))
        part.cancelled.connect(lambda: self.events.append("cancelled"))

    @property
    def values(self):
        return [event for event in self.events if not isinstance(event, str)]
