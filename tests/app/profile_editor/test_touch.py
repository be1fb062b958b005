"""The profile editor under a pen, fingers, a touchpad, and a right button that is held."""

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

from app.state.blank import blank_document
from app.widgets.radial_menu import RadialMenu
from tests.app import fingers
from tests.app.profile_editor.bench import CTRL, Bench, near, vase

RIGHT = Qt.MouseButton.RightButton


@pytest.fixture
def bench(qtbot):
    return Bench(qtbot, vase())


def pen_drag(bench, start, end, modifiers=CTRL):
    fingers.pen(bench.view, "Press", start, modifiers)
    for part in (0.3, 0.7, 1.0):
        fingers.pen(bench.view, "Move", start + (end - start) * part, modifiers)
    fingers.pen(bench.view, "Release", end, modifiers)
    bench.settle()


def test_a_pen_drags_a_point(bench):
    to = bench.place(0, 1) + QPointF(31.0, -17.0)
    pen_drag(bench, bench.place(0, 1), to)
    assert near(bench.place(0, 1), to)
    assert bench.undo_entries == ["Move P1 of segment 1"]


def test_a_pen_draws_with_the_pen_tool(qtbot):
    bench = Bench(qtbot, blank_document())
    bench.key(Qt.Key.Key_P)
    for place, handle in (((10, 0), (10, 0)), ((40, 20), (45, 40)), ((20, 80), (20, 80))):
        pen_drag(bench, bench.screen(place), bench.screen(handle))
    assert len(bench.document.profile) == 2
    assert bench.document.joints[0].measured != "G0"


def test_one_finger_drags_and_two_pan_and_zoom(bench):
    view, start = bench.view, bench.place(0, 1)
    to = start + QPointF(40.0, 10.0)
    fingers.touch(view, f0=("press", start))
    fingers.touch(view, f0=("move", start + QPointF(20.0, 5.0)))
    fingers.touch(view, f0=("move", to))
    fingers.touch(view, f0=("release", to))
    assert near(bench.place(0, 1), to, 2.0)
    assert len(bench.undo_entries) == 1
    before, a, b = view.transform, QPointF(200, 200), QPointF(300, 200)
    fingers.touch(view, f0=("press", a), f1=("press", b))
    fingers.touch(view, f0=("move", a + QPointF(-50, 30)), f1=("move", b + QPointF(50, 30)))
    fingers.touch(view, f0=("release", a), f1=("release", b))
    assert view.transform.scale == pytest.approx(2.0 * before.scale, rel=0.02)
    assert len(bench.undo_entries) == 1


def test_a_second_finger_takes_back_what_the_first_has_begun(bench):
    before, view, start = bench.document, bench.view, bench.place(0, 1)
    fingers.touch(view, f0=("press", start))
    fingers.touch(view, f0=("move", start + QPointF(40.0, 0.0)))
    assert bench.document is not before
    fingers.touch(view, f0=("rests", start), f1=("press", start + QPointF(90.0, 90.0)))
    assert bench.document is before
    fingers.touch(view, f0=("release", start), f1=("release", start))
    assert bench.undo_entries == []


def test_a_touchpad_pans_and_pinches(bench):
    before, at = bench.view.transform, QPointF(250, 250)
    fingers.swipe(bench.view, at, 25, -40)
    after = bench.view.transform
    assert after.scale == before.scale
    assert (after.x0 - before.x0, after.y0 - before.y0) == pytest.approx((25.0, -40.0))
    fingers.pinch(bench.view, at, 0.5)
    assert bench.view.transform.scale == pytest.approx(1.5 * before.scale)


def hold(bench, at, seconds=320):
    QTest.mousePress(bench.view, RIGHT, Qt.KeyboardModifier.NoModifier, at.toPoint())
    QTest.qWait(seconds)
    return [each for each in QApplication.topLevelWidgets() if isinstance(each, RadialMenu)]


def let_go(bench, at):
    QTest.mouseRelease(bench.view, RIGHT, Qt.KeyboardModifier.NoModifier, at.toPoint())
    bench.settle()


def test_the_right_button_held_still_opens_a_ring_of_choices(bench):
    at = bench.screen(bench.document.profile.point(0, 0.3))
    (ring,) = hold(bench, at)
    words = [ring._text(k) for k in range(len(ring.actions_shown))]
    split = next(k for k, text in enumerate(words) if "Split segment 1" in text)
    assert ring.isVisible()
    QTest.keyClick(ring, Qt.Key(Qt.Key.Key_1 + split))
    let_go(bench, at)
    assert len(bench.document.profile) == 3
    assert not [w for w in QApplication.topLevelWidgets() if isinstance(w, QMenu) and w.isVisible()]


def test_a_ring_is_chosen_from_by_direction_and_closed_by_escape(bench):
    at = bench.screen(bench.document.profile.point(0, 0.3))
    (ring,) = hold(bench, at)
    for k, box in enumerate(ring._boxes):
        assert ring.toward(box.center()) == k
    assert ring.toward(ring._middle) is None
    QTest.keyClick(ring, Qt.Key.Key_Escape)
    let_go(bench, at)
    assert bench.undo_entries == []


def test_a_hand_that_moves_opens_no_ring(bench):
    at = bench.screen((60.0, 90.0))
    QTest.mousePress(bench.view, RIGHT, Qt.KeyboardModifier.NoModifier, at.toPoint())
    bench.move(at + QPointF(20.0, 0.0), RIGHT)
    QTest.qWait(320)
    assert not [w for w in QApplication.topLevelWidgets() if isinstance(w, RadialMenu)]
    let_go(bench, at + QPointF(20.0, 0.0))
