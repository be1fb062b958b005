"""The hints: all at once where there is room, else one after the other; Esc puts one away."""

import pytest
from PySide6.QtCore import QPoint, QSettings, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from app.start.hints import KEY, Hint, Hints
from tests.app.window_stage import WindowStage

NAMES = ("slider", "point", "orbit")


def hints_over(window):
    return Hints(
        [
            Hint(name, f"Drag the {name}.", "top", lambda: QPoint(200, 200), lambda: (0, 0))
            for name in NAMES
        ],
        window,
    )


def shown(hints):
    return [each.hint.name for each in hints.bubbles if each.isVisible()]


@pytest.mark.parametrize(("size", "count"), [((1024, 700), 1), ((1440, 900), 3)])
def test_a_small_window_shows_them_one_after_the_other(qtbot, size, count):
    window = QWidget()
    qtbot.addWidget(window)
    window.resize(*size)
    window.show()
    qtbot.waitExposed(window)
    hints = hints_over(window)
    hints.show()
    assert shown(hints) == list(NAMES[:count])
    QTest.mouseClick(hints.bubbles[0].button, Qt.MouseButton.LeftButton)
    hints.look()
    assert shown(hints) == list(NAMES[1 : 1 + count])
    assert QSettings().value(KEY) == ["slider"]


def test_escape_puts_one_away_wherever_the_focus_is(qtbot):
    stage = WindowStage(qtbot, wait_for_scene=False)
    hints = stage.window.welcome.hints
    hints.show_again()
    count = len(hints.bubbles)
    assert count == 3
    stage.window.setFocus()
    for left in (2, 1, 0):
        QTest.keyClick(stage.window, Qt.Key.Key_Escape)
        assert len(hints.bubbles) == left
    stage.close()
