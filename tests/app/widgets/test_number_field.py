"""The number field: typing, steps, gestures, refusals, the menu."""

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QGuiApplication, QKeyEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog

from app.widgets.number_field import NumberField
from app.widgets.number_kind import limits
from app.widgets.step_burst import BURST_MILLISECONDS
from sgb_core.document.manufacture import Material
from sgb_core.fields.kinds import Range
from sgb_core.fields.record import table_of
from tests.app.mouse import CTRL, SHIFT, Log, double_click, wheel
from tests.app.waiting import show

Key = Qt.Key


@pytest.fixture
def field(qtbot):
    widget = NumberField(minimum=0.0, maximum=4.0, step=0.1, unit="mm", reset=1.0)
    widget.set_value(1.0)
    widget.set_help("helpful words")
    show(qtbot, widget)
    widget.setFocus()
    qtbot.waitUntil(widget.hasFocus)
    return widget


@pytest.fixture
def log(field):
    return Log(field)


def enter(qtbot, field, text):
    field.selectAll()
    qtbot.keyClicks(field, text)
    qtbot.keyClick(field, Key.Key_Return)


def test_escape_with_nothing_to_take_back_is_the_dialogs(qtbot):
    dialog = QDialog()
    inner = NumberField(parent=dialog)
    show(qtbot, dialog)
    inner.setFocus()
    qtbot.keyClicks(inner, "5")
    qtbot.keyClick(inner, Key.Key_Escape)
    assert inner.text() == "0"
    assert dialog.isVisible()
    qtbot.keyClick(inner, Key.Key_Escape)
    assert not dialog.isVisible()


def test_enter_commits_a_sum_as_one_gesture(qtbot, field, log):
    enter(qtbot, field, "0.5/2 + 2mm")
    assert log.events == ["began", 2.25, "ended"]
    assert field.text() == "2.25"


def test_the_same_value_again_is_no_gesture(qtbot, field, log):
    enter(qtbot, field, "1.000")
    assert log.events == []
    assert field.text() == "1"


def test_full_precision_is_kept_behind_the_digits_shown(qtbot, field, log):
    enter(qtbot, field, "1/3")
    assert field.text() == "0.333"
    assert field.value == 1 / 3
    # Leaving the field without having typed must not round the value.
    field.clearFocus()
    assert field.value == 1 / 3
    assert log.values == [1 / 3]


@pytest.mark.parametrize(("text", "words"), [("5", "0 to 4"), ("-1", "0 to 4"), ("2+", "missing")])
def test_what_is_not_allowed_is_red_said_and_not_applied(qtbot, field, log, text, words):
    refused = []
    field.refused.connect(refused.append)
    enter(qtbot, field, text)
    assert log.events == []
    assert field.value == 1.0
    assert field.property("invalid") == "true"
    assert words in refused[0]
    assert "Allowed: 0 to 4 mm" in field.toolTip()
    qtbot.keyClick(field, Key.Key_Escape)
    assert field.property("invalid") == "false"
    assert field.text() == "1"
    assert field.toolTip() == "helpful words"


def test_a_wrong_text_is_red_while_it_is_typed(qtbot, field):
    field.selectAll()
    qtbot.keyClicks(field, "9")
    assert field.property("invalid") == "true"
    qtbot.keyClick(field, Key.Key_Backspace)
    qtbot.keyClicks(field, "2")
    assert field.property("invalid") == "false"


def test_the_lower_end_can_be_left_out(qtbot):
    field = NumberField(minimum=0.0, maximum=360.0, above_minimum=True, unit="deg")
    field.set_value(360.0)
    qtbot.addWidget(field)
    log = Log(field)
    enter(qtbot, field, "0")
    assert log.events == []
    assert "above 0 and at most 360 deg" in field.toolTip()
    enter(qtbot, field, "90")
    assert log.values == [90.0]


@pytest.mark.parametrize(
    ("limits", "words"),
    [((None, None), "any number"), ((1.0, None), "at least 1"), ((None, 2.0), "at most 2")],
)
def test_open_ranges_in_words(qtbot, limits, words):
    field = NumberField(minimum=limits[0], maximum=limits[1])
    qtbot.addWidget(field)
    assert field.allowed == words


def test_escape_drops_what_was_typed(qtbot, field, log):
    field.selectAll()
    qtbot.keyClicks(field, "3.7")
    qtbot.keyClick(field, Key.Key_Escape)
    assert field.text() == "1"
    assert log.events == []


def test_leaving_the_field_commits_what_is_right_and_drops_what_is_wrong(qtbot, field, log):
    field.selectAll()
    qtbot.keyClicks(field, "2")
    field.clearFocus()
    assert log.events == ["began", 2.0, "ended"]
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "99")
    field.clearFocus()
    assert field.text() == "2"
    assert log.values == [2.0]


def test_a_run_of_wheel_steps_is_one_gesture(qtbot, field, log):
    for _ in range(3):
        wheel(field)
    assert log.events == ["began", 1.1, 1.2, 1.3]
    with qtbot.waitSignal(field.ended):
        pass
    assert log.events == ["began", 1.1, 1.2, 1.3, "ended"]


def test_shift_is_finer_and_ctrl_coarser(field, log):
    wheel(field, 1, SHIFT)
    wheel(field, -1, CTRL)
    field.finish()
    assert log.values == pytest.approx([1.01, 0.01])


def test_a_smooth_wheel_adds_up_to_whole_steps(field, log):
    for _ in range(4):
        wheel(field, delta=40)
    assert log.values == [1.1]


def test_arrow_keys_step_and_stop_at_the_ends(qtbot, field, log):
    qtbot.keyClick(field, Key.Key_Up)
    qtbot.keyClick(field, Key.Key_Down, SHIFT)
    for _ in range(8):
        qtbot.keyClick(field, Key.Key_Up, CTRL)
    field.finish()
    assert log.values == pytest.approx([1.1, 1.09, 2.09, 3.09, 4.0])
    assert log.events[-1] == "ended"


def test_steps_at_the_end_of_the_range_are_no_gesture(field, log):
    field.set_value(4.0)
    wheel(field)
    assert log.events == []


def test_escape_takes_back_a_run_of_steps(qtbot, field, log):
    wheel(field, 3)
    wheel(field, 2)
    qtbot.keyClick(field, Key.Key_Escape)
    assert log.events[-1] == "cancelled"
    assert field.value == 1.0
    qtbot.wait(BURST_MILLISECONDS + 100)
    assert log.events[-1] == "cancelled"


def test_enter_ends_a_run_of_steps_at_once(qtbot, field, log):
    wheel(field)
    qtbot.keyClick(field, Key.Key_Return)
    assert log.events == ["began", 1.1, "ended"]


def test_a_click_into_the_field_takes_the_whole_number(qtbot, field):
    field.set_value(0.25)
    field.clearFocus()
    at = field.rect().center()
    qtbot.mouseClick(field, Qt.MouseButton.LeftButton, pos=at)
    assert field.selectedText() == "0.25"
    qtbot.mouseClick(field, Qt.MouseButton.LeftButton, pos=at)
    assert field.selectedText() == ""
    double_click(field, at)
    assert field.selectedText() == "0.25"


def test_a_new_value_from_outside_waits_while_something_is_typed(qtbot, field, log):
    field.selectAll()
    qtbot.keyClicks(field, "3")
    field.set_value(2.0)
    assert field.text() == "3"
    qtbot.keyClick(field, Key.Key_Escape)
    assert field.text() == "2"
    field.set_value(0.5)
    assert field.text() == "0.5"
    assert log.events == []


def test_the_menu_resets_copies_and_pastes(field, log):
    field.set_value(2.0 / 3.0)
    QGuiApplication.clipboard().setText("something")
    actions = {action.text(): action for action in field.menu(field).actions()}
    actions["Copy value"].trigger()
    assert float(QGuiApplication.clipboard().text()) == 2.0 / 3.0
    actions["Reset to 1"].trigger()
    assert field.value == 1.0
    actions["Paste value"].trigger()
    assert field.value == 2.0 / 3.0
    assert log.events == ["began", 1.0, "ended", "began", 2.0 / 3.0, "ended"]


def test_pasting_nonsense_is_refused(field, log):
    QGuiApplication.clipboard().setText("rm -rf")
    field.paste_value()
    assert log.events == []
    assert field.property("invalid") == "true"


def _override(field, key, modifiers=Qt.KeyboardModifier.NoModifier):
    event = QKeyEvent(QEvent.Type.ShortcutOverride, key, modifiers)
    event.ignore()
    QApplication.sendEvent(field, event)
    return event.isAccepted()


def test_undo_goes_to_the_window_unless_something_is_typed(qtbot, field):
    assert not _override(field, Key.Key_Z, CTRL)
    qtbot.keyClicks(field, "2")
    assert _override(field, Key.Key_Z, CTRL)


def test_escape_belongs_to_the_field_only_while_it_is_used(field):
    assert not _override(field, Key.Key_Escape)
    wheel(field)
    assert _override(field, Key.Key_Escape)
    assert _override(field, Key.Key_Up)


def test_limits_are_those_of_the_field_of_a_record():
    density = limits(table_of(Material).row("density").kind)
    assert density == {
        "minimum": 0.0,
        "maximum": 100.0,
        "above_minimum": True,
        "whole": False,
    }
    assert limits(Range(0, 1), 100.0)["maximum"] == 100.0
    assert limits(Range(1, whole=True)) == {
        "minimum": 1,
        "maximum": None,
        "above_minimum": False,
        "whole": True,
    }
    assert limits(Range())["minimum"] is None


@pytest.mark.parametrize("key", [Qt.Key.Key_E, Qt.Key.Key_K, Qt.Key.Key_B, Qt.Key.Key_P])
def test_keys_with_ctrl_are_the_windows_but_for_those_of_text(field, key):
    assert not _override(field, key, Qt.KeyboardModifier.ControlModifier)
    assert _override(field, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    assert _override(field, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)


def test_three_clicks_take_the_whole_number(qtbot, field):
    field.setFocus()
    qtbot.waitUntil(field.hasFocus)
    at = QPoint(field.width() - 12, field.height() // 2)
    QTest.mouseClick(field, Qt.MouseButton.LeftButton, pos=at)
    double_click(field, at)
    assert field.selectedText() == field.text()
    QTest.mouseClick(field, Qt.MouseButton.LeftButton, pos=at)
    assert field.selectedText() == field.text()
