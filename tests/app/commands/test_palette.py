"""The rows of the command palette: level with each other, icons seen on the chosen one."""

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAction, QColor, QIcon, QPixmap
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit, QListWidget

from app.commands.palette import CommandPalette


def palette(qtbot):
    done, entries = [], []
    for name in ("Fit view", "Save", "Save as"):
        action = QAction(name)
        action.triggered.connect(lambda _checked=False, name=name: done.append(name))
        entries.append((name, action))
    picture = QPixmap(32, 32)
    picture.fill(Qt.GlobalColor.red)
    entries[0][1].setIcon(QIcon(picture))
    made = CommandPalette(entries)
    qtbot.addWidget(made)
    made.show()
    return made, made.findChild(QListWidget), done


def test_rows_are_level_and_the_chosen_icon_keeps_its_colour(qtbot):
    _, rows, _ = palette(qtbot)
    heights = {rows.visualItemRect(rows.item(k)).height() for k in range(rows.count())}
    assert len(heights) == 1
    icon = rows.item(0).icon()
    for mode in (QIcon.Mode.Normal, QIcon.Mode.Selected):
        colour = icon.pixmap(QSize(16, 16), mode).toImage().pixelColor(5, 5)
        assert colour == QColor(Qt.GlobalColor.red)


def test_letters_narrow_and_enter_does(qtbot):
    made, rows, done = palette(qtbot)
    QTest.keyClicks(made.findChild(QLineEdit), "sas")
    assert rows.currentItem().text() == "Save as"
    QTest.keyClick(made.findChild(QLineEdit), Qt.Key.Key_Return)
    assert done == ["Save as"]


def test_what_is_typed_arrives_without_a_click(qtbot):
    made, rows, done = palette(qtbot)
    qtbot.waitExposed(made)
    # As the window system delivers keys: to the window, whose part with the focus gets them.
    for key in (Qt.Key.Key_S, Qt.Key.Key_A, Qt.Key.Key_S):
        QTest.keyClick(made.windowHandle(), key)
    assert rows.currentItem().text() == "Save as"
    QTest.keyClick(made.windowHandle(), Qt.Key.Key_Return)
    assert done == ["Save as"]
