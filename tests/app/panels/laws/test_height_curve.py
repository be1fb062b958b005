"""The strength along the height under a real hand: keys added, dragged, nudged, removed."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.panels.laws.height_curve import HeightCurve
from sgb_core.surfaces.variation import Law
from tests.app.mouse import double_click, drag, move, press, release
from tests.app.panels.laws.test_curve_editor import Told
from tests.app.waiting import show

FLUTES = Law("radius", "lobes", 0.9, 1.1, count=8)
KEYS = ((0.0, 0.0), (0.4, 1.0), (1.0, 0.5))


@pytest.fixture
def curve(qtbot):
    widget = HeightCurve()
    widget.show_law(Law("radius", "lobes", 0.9, 1.1, count=8, along=KEYS))
    show(qtbot, widget, 420, 120)
    widget.setFocus()
    return widget


def test_a_key_is_dragged_in_one_gesture_and_stays_between_its_neighbours(curve):
    told = Told(curve)
    drag(curve, curve.place(0.4, 1.0), curve.place(0.62, 0.3))
    assert told.events == ["Move key along the height", "ended"]
    u, k = told.laws[-1].along[1]
    assert (u, k) == (pytest.approx(0.62, abs=0.03), pytest.approx(0.3, abs=0.06))
    drag(curve, curve.place(u, k), curve.place(1.4, -3.0))
    assert told.laws[-1].along[1] == (pytest.approx(0.999), 0.0)
    assert told.laws[-1].along[::2] == KEYS[::2]


def test_a_double_click_adds_a_key_and_the_first_leaves_the_other_end_as_it_was(curve):
    told = Told(curve)
    double_click(curve, curve.place(0.7, 0.25))
    assert [key for key in told.laws[-1].along if key not in KEYS] == [(0.7, 0.25)]
    assert curve.selected == 2
    curve.show_law(FLUTES)
    double_click(curve, curve.place(0.2, 0.0))
    assert told.laws[-1].along == ((0.2, 0.0), (1.0, 1.0))
    assert told.events[-2:] == ["Add key along the height", "ended"]


def test_keys_are_chosen_nudged_added_and_removed_by_the_keyboard(curve):
    told = Told(curve)
    QTest.keyClick(curve, Qt.Key.Key_PageDown)
    QTest.keyClick(curve, Qt.Key.Key_PageDown)
    assert curve.selected == 1
    assert "40" in curve.accessibleDescription()
    QTest.keyClick(curve, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    QTest.keyClick(curve, Qt.Key.Key_Right)
    curve.finish()
    assert told.events == ["Nudge key along the height", "ended"]
    assert told.laws[-1].along[1] == (pytest.approx(0.41), pytest.approx(0.9))
    QTest.keyClick(curve, Qt.Key.Key_Insert)
    assert len(told.laws[-1].along) == 4
    QTest.keyClick(curve, Qt.Key.Key_Delete)
    assert len(told.laws[-1].along) == 3
    assert told.events[-2:] == ["Remove key along the height", "ended"]


def test_escape_cancels_a_drag(curve):
    told = Told(curve)
    press(curve, curve.place(0.4, 1.0))
    move(curve, curve.place(0.5, 0.5))
    QTest.keyClick(curve, Qt.Key.Key_Escape)
    assert told.events == ["Move key along the height", "cancelled"]
    release(curve, curve.place(0.5, 0.5))


def test_ctrl_adds_where_the_hand_is(curve):
    told = Told(curve)
    at = curve.place(0.703, 0.26)
    double_click(curve, at.toPoint(), Qt.KeyboardModifier.ControlModifier)
    (added,) = [key for key in told.laws[-1].along if key not in KEYS]
    assert added == pytest.approx(curve.read(at), abs=0.01)
    assert added != (0.7, 0.25)
