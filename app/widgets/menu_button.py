"""Buttons that open a menu, and let go of it when it closes."""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication, QEvent, QTimer
from PySide6.QtGui import QCursor
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
    if button.underMouse() and not button.rect().contains(button.mapFromGlobal(QCursor.pos())):
        QCoreApplication.sendEvent(button, QEvent(QEvent.Type.HoverLeave))
        QCoreApplication.sendEvent(button, QEvent(QEvent.Type.Leave))
        button.update()
