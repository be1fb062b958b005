"""The slider with a mark, moved by real events."""

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QColor, QMouseEvent
from PySide6.QtWidgets import QApplication

from app.theme import theme
from app.widgets.mark_slider import MarkSlider
from app.widgets.slider_row import SliderRow
from app.widgets.step_burst import ScrollGuard
from tests.app.mouse import CTRL, LEFT, SHIFT, Log, drag, move, press, release, wheel
from tests.app.waiting import show

Key = Qt.Key


@pytest.fixture
def slider(qtbot):
    widget = MarkSlider(0.0, 4.0, 1.0, 0.1)
    show(qtbot, widget, 180, 24)
    widget.setFocus()
    return widget


@pytest.fixture
def log(slider):
    return Log(slider)


def test_a_drag_over_the_whole_range_reaches_both_ends_exactly(slider, log):
    middle = slider.height() / 2
    drag(slider, slider.handle_centre(), QPointF(slider.width() - 1, middle))
    assert slider.number == 4.0
    drag(slider, slider.handle_centre(), QPointF(0, middle))
    assert slider.number == 0.0
    assert log.events.count("began") == log.events.count("ended") == 2
    assert log.values[-1] == 0.0


def test_the_handle_stays_under_the_pointer(slider, log):
    start = slider.handle_centre() + QPointF(3, 0)
    target = start + QPointF(40, 0)
    drag(slider, start, target)
    assert slider.handle_centre().x() == pytest.approx(target.x() - 3, abs=0.6)


def test_a_press_beside_the_handle_brings_it_there(qtbot, slider, log):
    at = slider.handle_centre(3.0)
    qtbot.mouseClick(slider, LEFT, pos=at.toPoint())
    assert slider.number == pytest.approx(3.0, abs=0.02)
    assert log.events[0] == "began"
    assert log.events[-1] == "ended"


def test_a_click_on_the_handle_changes_nothing(qtbot, slider, log):
    slider.set_number(1.23456)
    qtbot.mouseClick(slider, LEFT, pos=slider.handle_centre().toPoint())
    assert log.values == []
    assert slider.number == 1.23456


def test_a_drag_there_and_back_is_the_old_value(slider, log):
    start = slider.handle_centre()
    press(slider, start)
    move(slider, start + QPointF(30, 0))
    move(slider, start)
    release(slider, start)
    assert slider.number == 1.0


def test_shift_makes_a_drag_ten_times_finer(qtbot, slider):
    start = slider.handle_centre().toPoint()
    press(slider, start, SHIFT)
    event_at = start + QPointF(40, 0).toPoint()
    event = QMouseEvent(
        QEvent.Type.MouseMove,
        QPointF(event_at),
        QPointF(slider.mapToGlobal(event_at)),
        Qt.MouseButton.NoButton,
        LEFT,
        SHIFT,
    )
    QApplication.sendEvent(slider, event)
    coarse = 40 / (slider.handle_centre(4.0).x() - slider.handle_centre(0.0).x()) * 4.0
    assert slider.number - 1.0 == pytest.approx(coarse / 10, abs=0.001)
    release(slider, event_at, SHIFT)


def test_escape_restores_and_the_rest_of_the_drag_is_nothing(qtbot, slider, log):
    start = slider.handle_centre()
    press(slider, start)
    move(slider, start + QPointF(50, 0))
    assert slider.number > 2.0
    qtbot.keyClick(slider, Key.Key_Escape)
    assert slider.number == 1.0
    move(slider, start + QPointF(60, 0))
    release(slider, start + QPointF(60, 0))
    assert slider.number == 1.0
    assert log.events[-1] == "cancelled"
    assert "ended" not in log.events


def test_other_buttons_do_nothing(qtbot, slider, log):
    qtbot.mouseClick(slider, Qt.MouseButton.MiddleButton, pos=slider.handle_centre(3).toPoint())
    assert log.events == []


def test_wheel_steps_with_modifiers_are_one_gesture(qtbot, slider, log):
    wheel(slider, 2)
    wheel(slider, 1, SHIFT)
    wheel(slider, 1, CTRL)
    assert log.values == pytest.approx([1.2, 1.21, 2.21])
    with qtbot.waitSignal(slider.ended):
        pass
    assert [e for e in log.events if isinstance(e, str)] == ["began", "ended"]


def test_a_wheel_that_scrolls_the_panel_leaves_the_slider_alone(slider, log):
    ScrollGuard.scrolled()
    assert wheel(slider) is None
    assert log.events == []


def test_keys_step_and_jump_to_the_ends(qtbot, slider, log):
    for key in (Key.Key_Right, Key.Key_Up, Key.Key_Left, Key.Key_PageUp, Key.Key_PageDown):
        qtbot.keyClick(slider, key)
    assert log.values == pytest.approx([1.1, 1.2, 1.1, 2.1, 1.1])
    qtbot.keyClick(slider, Key.Key_End)
    assert slider.number == 4.0
    qtbot.keyClick(slider, Key.Key_Home)
    assert slider.number == 0.0
    slider.finish()
    assert [e for e in log.events if isinstance(e, str)] == ["began", "ended"]


def test_escape_takes_back_a_run_of_keys(qtbot, slider, log):
    qtbot.keyClick(slider, Key.Key_Right)
    qtbot.keyClick(slider, Key.Key_Escape)
    assert slider.number == 1.0
    assert log.events == ["began", 1.1, "cancelled"]


def test_assistive_technology_sets_the_value(slider, log):
    slider.setValue(2500)
    slider.finish()
    assert log.events == ["began", 2.5, "ended"]


def test_set_number_says_nothing_and_keeps_full_precision(slider, log):
    slider.set_number(1 / 3)
    assert slider.number == 1 / 3
    assert log.events == []


def test_a_value_beyond_the_range_is_drawn_at_the_end(slider):
    slider.set_number(7.0)
    assert slider.handle_centre() == slider.handle_centre(4.0)


def test_the_neutral_mark_is_drawn_where_the_value_is_not(qapp, slider):
    slider.set_number(3.0)
    image = slider.grab().toImage()
    x = round(slider.handle_centre(1.0).x())
    marks = {image.pixelColor(x + dx, 5).name() for dx in (-1, 0, 1)}
    axis = QColor(theme.current().axis)
    assert any(abs(QColor(m).lightness() - axis.lightness()) < 40 for m in marks)


@pytest.mark.parametrize("how", ["release", "enter"])
def test_a_number_typed_in_a_drag_takes_its_place(qtbot, how):
    row = SliderRow("λ1", 0.0, 4.0, 1.0, 0.1)
    show(qtbot, row, 320, 30)
    row.slider.setFocus()
    events, values = [], []
    row.began.connect(lambda: events.append("began"))
    row.ended.connect(lambda: events.append("ended"))
    row.cancelled.connect(lambda: events.append("cancelled"))
    row.changed.connect(values.append)
    at = row.slider.handle_centre()
    press(row.slider, at)
    move(row.slider, at + QPointF(30, 0))
    assert row.number > 1.0
    qtbot.keyClicks(row.slider, "2")
    # The drag is taken back, and the keys go to the number from here on.
    assert row.number == 1.0
    assert row.field.hasFocus()
    move(row.slider, at + QPointF(50, 0))
    qtbot.keyClicks(row.field, ".125")
    if how == "enter":
        qtbot.keyClick(row.field, Key.Key_Return)
    release(row.slider, at + QPointF(50, 0))
    assert row.number == row.slider.number == 2.125
    assert events == ["began", "cancelled", "began", "ended"]
    assert values[-1] == 2.125
    # What is no number, or out of range, is said and not taken.
    refused = []
    row.refused.connect(refused.append)
    at = row.slider.handle_centre()
    press(row.slider, at)
    move(row.slider, at + QPointF(-30, 0))
    qtbot.keyClicks(row.slider, "9")
    release(row.slider, at)
    assert len(refused) == 1
    assert row.number == 2.125
