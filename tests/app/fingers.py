"""Fingers on a screen, a pen on a tablet, two fingers on a touchpad: their real events."""

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import (
    QInputDevice,
    QNativeGestureEvent,
    QPointingDevice,
    QTabletEvent,
    QWheelEvent,
)
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

LEFT, NONE = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
FREE = Qt.KeyboardModifier.NoModifier
PEN = QPointingDevice(
    "pen",
    1,
    QInputDevice.DeviceType.Stylus,
    QPointingDevice.PointerType.Pen,
    QInputDevice.Capability.Position | QInputDevice.Capability.Pressure,
    1,
    3,
)
PAD = QPointingDevice(
    "pad",
    2,
    QInputDevice.DeviceType.TouchPad,
    QPointingDevice.PointerType.Finger,
    QInputDevice.Capability.Position | QInputDevice.Capability.PixelScroll,
    2,
    3,
)
_kept = []


def screen():
    """A touch screen; Qt wants one for the whole run."""
    if not _kept:
        _kept.append(QTest.createTouchDevice())
    return _kept[0]


def touch(widget, **fingers):
    """Send one touch event: a finger "f0" to "f9" is (what it does, where)."""
    sequence = QTest.touchEvent(widget, screen(), False)
    for name, (does, at) in fingers.items():
        number, at = int(name[1:]), QPointF(at).toPoint()
        if does == "rests":
            sequence.stationary(number)
        else:
            getattr(sequence, does)(number, at, widget)
    sequence.commit()
    QApplication.processEvents()


def pen(widget, kind, at, modifiers=FREE):
    """Send one event of a pen's tip: "Press", "Move" or "Release"."""
    button = NONE if kind == "Move" else LEFT
    held = NONE if kind == "Release" else LEFT
    at = QPointF(at)
    event = QTabletEvent(
        getattr(QEvent.Type, f"Tablet{kind}"),
        PEN,
        at,
        QPointF(widget.mapToGlobal(at)),
        0.6,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        modifiers,
        button,
        held,
    )
    QApplication.sendEvent(widget, event)
    QApplication.processEvents()


def pinch(widget, at, value):
    """Send a pinch of a touchpad as the system reports it: scaled by 1 + value."""
    at = QPointF(at)
    event = QNativeGestureEvent(
        Qt.NativeGestureType.ZoomNativeGesture,
        PAD,
        2,
        at,
        at,
        QPointF(widget.mapToGlobal(at)),
        value,
        QPointF(),
    )
    QApplication.sendEvent(widget, event)
    QApplication.processEvents()


def swipe(widget, at, dx, dy):
    """Move two fingers over a touchpad."""
    at = QPointF(at)
    event = QWheelEvent(
        at,
        QPointF(widget.mapToGlobal(at)),
        QPoint(dx, dy),
        QPoint(3 * dx, 3 * dy),
        NONE,
        FREE,
        Qt.ScrollPhase.ScrollUpdate,
        False,
        Qt.MouseEventSource.MouseEventNotSynthesized,
        PAD,
    )
    QApplication.sendEvent(widget, event)
    QApplication.processEvents()
