"""A button that opens a menu lets go of the pointer when what was chosen has moved it away."""

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt, QTimer
from PySide6.QtGui import QCursor, QHoverEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QToolButton, QWidget

from app.widgets.menu_button import open_menu
from tests.app.waiting import show


class Button(QToolButton):
    """Writes down how the pointer leaves it."""

    def __init__(self, parent):
        super().__init__(parent)
        self.left = []

    def event(self, event):
        if event.type() == QEvent.Type.HoverLeave:
            self.left.append((type(event), event.position().toPoint()))
        return super().event(event)


@pytest.fixture
def button(qtbot):
    window = QWidget()
    made = Button(window)
    made.setText("Add")
    made.setGeometry(20, 20, 80, 30)
    menu = QMenu(made)
    menu.addAction("Lobes", lambda: made.move(20, 260))
    open_menu(made, menu)
    show(qtbot, window, 300, 320)
    yield made
    window.close()


def test_what_is_chosen_may_move_the_button_from_under_the_pointer(qtbot, button):
    QCursor.setPos(button.mapToGlobal(button.rect().center()))
    qtbot.waitUntil(button.underMouse)
    button.left.clear()

    def choose():
        menu = QApplication.activePopupWidget()
        QTest.keyClick(menu, Qt.Key.Key_Down)
        QTest.keyClick(menu, Qt.Key.Key_Return)
        # As where the system, its menu gone, tells of no leaving.
        button.setAttribute(Qt.WidgetAttribute.WA_UnderMouse)

    QTimer.singleShot(50, choose)
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: button.pos() == QPoint(20, 260))
    qtbot.waitUntil(lambda: not button.underMouse())
    assert not button.isDown()
    # Its places are real: reading those of a bare event ended the program.
    assert button.left
    assert all(kind is QHoverEvent for kind, _ in button.left)
    pointer = button.mapFromGlobal(QCursor.pos())
    assert button.left[-1][1] == pointer
