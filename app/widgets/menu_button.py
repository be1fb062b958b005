"""Buttons that open a menu, and let go of it when it closes."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, QEvent, QPointF, QTimer
from PySide6.QtGui import QCursor, QHoverEvent
from PySide6.QtWidgets import QMenu, QToolButton

# By then what was chosen has been laid out, in milliseconds.
_SETTLED = 60


def open_menu(button: QToolButton, menu: QMenu) -> None:
    """Let a press of ``button`` open ``menu``.

    The menu takes the pointer, and what is chosen in it may move the button from under it: without
    being told of that it would go on looking pressed.
    """
    button.setMenu(menu)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    menu.aboutToHide.connect(lambda: QTimer.singleShot(_SETTLED, button, lambda: _let_go(button)))


def _let_go(button: QToolButton) -> None:
    button.setDown(False)
    there = QCursor.pos()
    here = button.mapFromGlobal(there)
    if button.underMouse() and not button.rect().contains(here):
        # Qt reads the places of such an event, whatever object is sent under its type.
        places = QPointF(here), QPointF(there), QPointF(here)
        QCoreApplication.sendEvent(button, QHoverEvent(QEvent.Type.HoverLeave, *places))
        QCoreApplication.sendEvent(button, QEvent(QEvent.Type.Leave))
        button.update()
