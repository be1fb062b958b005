"""The angle-curve editor under a real hand: keys dragged, added, removed, nudged."""

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.panels.laws.curve_editor import AngleCurve
from sgb_core.surfaces.variation import Law
from tests.app.mouse import CTRL, LEFT, NONE, SHIFT, double_click, drag, hover, move, press, release
from tests.app.waiting import show

KEYS = ((0.0, 0.0), (90.0, 1.0), (200.0, 0.4))
LAW = Law("lambda2", "keyframes", 1.0, 5.0, keyframes=KEYS)


class Told:
    """Writes down what an angle curve says."""

    def __init__(self, curve):
        self.events, self.laws = [], []
        curve.began.connect(lambda label: self.events.append(label))
        curve.changed.connect(self.laws.append)
        curve.ended.connect(lambda: self.events.append("ended"))
        curve.cancelled.connect(lambda: self.events.append("cancelled"))
        curve.refused.connect(lambda text: self.events.append(text))


@pytest.fixture
def curve(qtbot):
    widget = AngleCurve()
    widget.show_law(LAW, "λ2", 360.0)
    show(qtbot, widget, 420, 180)
    widget.setFocus()
    return widget


def test_a_key_is_dragged_in_one_gesture(curve):
    told = Told(curve)
    drag(curve, curve.place(90.0, 1.0), curve.place(127.0, 0.63))
    assert told.events == ["Move key of λ2", "ended"]
    assert len(told.laws) > 3
    degrees, value = told.laws[-1].keyframes[1]
    assert degrees == pytest.approx(127.0, abs=1.5)
    assert value == pytest.approx(0.63, abs=0.02)
    assert told.laws[-1].keyframes[::2] == KEYS[::2]
    assert curve.selected == 1


def test_it_snaps_to_round_angles_and_to_the_heights_of_other_keys(curve):
    told = Told(curve)
    drag(curve, curve.place(90.0, 1.0), curve.place(136.0, 0.41))
    assert told.laws[-1].keyframes[1] == (135.0, 0.4)
    press(curve, curve.place(135.0, 0.4))
    move(curve, curve.place(150.0, 0.7))
    QTest.mouseRelease(curve, LEFT, NONE, curve.place(150.0, 0.7).toPoint())


def test_it_stays_within_the_values_and_goes_round_the_turn(curve):
    told = Told(curve)
    drag(curve, curve.place(0.0, 0.0), curve.place(-40.0, -3.0))
    degrees, value = told.laws[-1].keyframes[0]
    assert degrees == pytest.approx(320.0, abs=6.0)
    assert value == 0.0


def test_escape_cancels_a_drag(curve):
    told = Told(curve)
    press(curve, curve.place(90.0, 1.0))
    move(curve, curve.place(120.0, 0.5))
    QTest.keyClick(curve, Qt.Key.Key_Escape)
    move(curve, curve.place(160.0, 0.5))
    release(curve, curve.place(160.0, 0.5))
    assert told.events == ["Move key of λ2", "cancelled"]


def test_a_click_selects_and_changes_nothing(curve):
    told = Told(curve)
    press(curve, curve.place(200.0, 0.4))
    release(curve, curve.place(200.0, 0.4))
    assert curve.selected == 2
    assert "200°" in curve.accessibleDescription()
    assert not told.events


def test_a_double_click_adds_a_key(curve):
    told = Told(curve)
    at = curve.place(270.0, 0.75).toPoint()
    double_click(curve, at, NONE)
    assert told.events == ["Add key to λ2", "ended"]
    assert len(told.laws[-1].keyframes) == 4
    assert told.laws[-1].keyframes[3] == (270.0, 0.75)
    assert curve.selected == 3


def test_a_double_click_makes_keys_of_another_law(curve):
    told = Told(curve)
    curve.show_law(Law("omega", "raised-cosine", 0.0, 1.0), "ω", 360.0)
    double_click(curve, curve.place(20.0, 0.5).toPoint(), CTRL)
    law = told.laws[-1]
    assert law.kind == "keyframes"
    assert len(law.keyframes) == 9


def test_a_double_click_on_many_waves_asks_before_it_makes_dozens_of_keys(curve):
    told, asked = Told(curve), []
    curve.keys_wanted.connect(asked.append)
    curve.show_law(Law("omega", "cosine", 0.0, 1.0, count=8), "ω", 360.0)
    double_click(curve, curve.place(20.0, 0.5).toPoint(), NONE)
    assert asked == [64]
    assert not told.events


def test_del_removes_the_selected_key_but_not_the_last(curve):
    told = Told(curve)
    press(curve, curve.place(90.0, 1.0))
    release(curve, curve.place(90.0, 1.0))
    QTest.keyClick(curve, Qt.Key.Key_Delete)
    assert told.laws[-1].keyframes == (KEYS[0], KEYS[2])
    assert told.events == ["Remove key of λ2", "ended"]
    curve.show_law(Law("omega", "keyframes", 0, 1, keyframes=((90.0, 0.5),)), "ω", 360.0)
    QTest.keyClick(curve, Qt.Key.Key_PageDown)
    QTest.keyClick(curve, Qt.Key.Key_Delete)
    assert "only key" in told.events[-1]


def test_arrows_nudge_as_one_gesture(curve):
    told = Told(curve)
    QTest.keyClick(curve, Qt.Key.Key_PageDown)
    QTest.keyClick(curve, Qt.Key.Key_PageDown)
    assert curve.selected == 1
    for _ in range(3):
        QTest.keyClick(curve, Qt.Key.Key_Right)
    QTest.keyClick(curve, Qt.Key.Key_Down, SHIFT)
    assert told.laws[-1].keyframes[1] == (93.0, 0.9)
    assert told.events == ["Nudge key of λ2"]
    curve.finish()
    assert told.events == ["Nudge key of λ2", "ended"]


def test_larger_values_lie_higher_from_whichever_end_the_law_runs(curve):
    told = Told(curve)
    falling = Law("lambda2", "keyframes", 5.0, 1.0, keyframes=KEYS)
    curve.show_law(falling, "λ2", 360.0)
    assert curve.place(0.0, 0.0).y() < curve.place(90.0, 1.0).y()
    drag(curve, curve.place(200.0, 0.4), curve.place(240.0, 0.0))
    assert told.laws[-1].keyframes[2] == (240.0, 0.0)
    curve.show_law(falling, "λ2", 360.0)
    press(curve, curve.place(90.0, 1.0))
    release(curve, curve.place(90.0, 1.0))
    QTest.keyClick(curve, Qt.Key.Key_Up, SHIFT)
    assert told.laws[-1].keyframes[1] == (90.0, 0.9)
    curve.finish()


def test_shift_drags_straight(curve):
    told = Told(curve)
    start, end = curve.place(200.0, 0.4), curve.place(260.0, 0.45)
    press(curve, start)
    there = QPointF(curve.mapToGlobal(end))
    none = Qt.MouseButton.NoButton
    event = QMouseEvent(QEvent.Type.MouseMove, end, there, none, LEFT, SHIFT)
    QApplication.sendEvent(curve, event)
    release(curve, end)
    assert told.laws[-1].keyframes[2][1] == 0.4
    assert told.laws[-1].keyframes[2][0] == pytest.approx(260.0, abs=5.0)


def test_hovering_tells_the_angle(curve):
    angles = []
    curve.hovered.connect(angles.append)
    hover(curve, curve.place(180.0, 0.9))
    assert angles[-1] == pytest.approx(180.0, abs=1.0)
    hover(curve, QPointF(2.0, 2.0))
    assert angles[-1] is None
