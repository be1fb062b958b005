"""Numbers typed in the middle of a drag: what is in the hand goes exactly there."""

import math

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt

from app.hand.drag import State
from app.hand.hit_test import Target
from app.hand.scale_frame import SIDES, PointFrame
from sgb_core.document import edits
from tests.app.profile_editor.bench import Bench, vase

Key = Qt.Key


@pytest.fixture
def bench(qtbot):
    return Bench(qtbot, vase())


def take(bench, at, by=(31.0, -17.0)):
    """Drag what is at a place by so many pixels, and hold it."""
    bench.press(at)
    there = at + QPointF(*by)
    bench.move(at + 0.5 * QPointF(*by))
    bench.move(there)
    return there


def type_in(bench, text):
    bench.qtbot.keyClicks(bench.view, text)
    bench.settle()


def told(bench):
    gesture = bench.view.gesture
    return [] if gesture.typed is None else gesture.typed.lines()


def test_a_point_goes_exactly_where_is_typed_and_the_rest_follows_the_hand(bench):
    there = take(bench, bench.place(0, 1))
    dragged = bench.point(0, 1).copy()
    type_in(bench, "30+12.5/5")
    assert bench.point(0, 1).tolist() == [32.5, dragged[1]]
    assert told(bench)[0] == "r = 30+12.5/5▏ = 32.5 mm"
    # The hand goes on, and moves what is not typed.
    bench.move(there + QPointF(20.0, -40.0))
    r, h = bench.point(0, 1).tolist()
    assert r == 32.5
    assert h > dragged[1]
    bench.key(Key.Key_Tab)
    type_in(bench, "1.5cm")
    assert bench.point(0, 1).tolist() == [32.5, 15.0]
    bench.release(there)
    assert bench.point(0, 1).tolist() == [32.5, 15.0]
    assert bench.undo_entries == ["Move P1 of segment 1"]


def test_enter_lets_go_and_escape_takes_back(bench):
    before = bench.document
    there = take(bench, bench.place(0, 1))
    type_in(bench, "31")
    bench.key(Key.Key_Return)
    assert bench.view.gesture.state is State.IDLE
    assert bench.undo_entries == ["Move P1 of segment 1"]
    # The button is still down: nothing follows it any more.
    bench.move(there + QPointF(60.0, 60.0))
    bench.release(there + QPointF(60.0, 60.0))
    assert bench.point(0, 1)[0] == 31.0
    assert len(bench.undo_entries) == 1
    bench.presenter.undo()
    bench.settle()
    there = take(bench, bench.place(0, 1))
    type_in(bench, "31")
    bench.key(Key.Key_Escape)
    bench.release(there)
    assert bench.document is before


def test_a_leg_takes_length_and_angle(bench):
    there = take(bench, bench.place(0, 2))
    for _ in range(2):
        bench.key(Key.Key_Tab)
    type_in(bench, "25")
    leg = bench.point(0, 2) - bench.point(0, 3)
    assert math.hypot(*leg) == pytest.approx(25.0, rel=1e-14)
    bench.key(Key.Key_Tab)
    type_in(bench, "-90")
    assert (bench.point(0, 2) - bench.point(0, 3)).tolist() == [0.0, -25.0]
    # A coordinate takes the place of both.
    bench.key(Key.Key_Tab)
    type_in(bench, "40")
    assert bench.point(0, 2)[0] == 40.0
    assert "leg" not in " ".join(told(bench)[:1])
    bench.release(there)


def test_backspace_and_what_is_no_number(bench):
    take(bench, bench.place(0, 1))
    dragged = bench.point(0, 1).copy()
    type_in(bench, "33")
    bench.key(Key.Key_Backspace)
    assert bench.point(0, 1)[0] == 3.0
    type_in(bench, "0/0")
    assert "division by zero" in told(bench)[1]
    # Without a number the hand decides.
    assert bench.point(0, 1).tolist() == dragged.tolist()
    for _ in range(4):
        bench.key(Key.Key_Backspace)
    assert told(bench) == []
    assert bench.view.gesture.state is State.MOVING


def test_a_quartic_point_takes_its_slider(bench):
    quartic = bench.document.profile.segments[0].quartic
    there = take(bench, bench.screen(quartic[1]), (6.0, -4.0))
    assert bench.view.active.target is Target.QUARTIC
    type_in(bench, "2.75")
    assert bench.document.profile.segments[0].shape.lambda1 == 2.75
    bench.key(Key.Key_Backspace)
    type_in(bench, "9")
    assert bench.document.profile.segments[0].shape.lambda1 == 2.79
    bench.release(there)
    assert bench.undo_entries == ["Drag λ1 of segment 1"]
    there = take(bench, bench.screen(bench.document.profile.segments[0].quartic[1]), (6.0, -4.0))
    type_in(bench, "7")
    assert "out of range" in told(bench)[1]
    bench.key(Key.Key_Escape)
    bench.release(there)


def test_several_points_take_a_step_and_a_frame_its_factors(bench):
    points = frozenset({(0, 1), (0, 2)})
    bench.presenter.set_view(points=points)
    bench.settle()
    before = [bench.point(0, k).copy() for k in (1, 2)]
    there = take(bench, bench.place(0, 1))
    type_in(bench, "-2")
    bench.key(Key.Key_Tab)
    type_in(bench, "5")
    for k, old in zip((1, 2), before, strict=True):
        assert np.allclose(bench.point(0, k) - old, (-2.0, 5.0), rtol=0, atol=1e-13)
    bench.release(there)
    frame = PointFrame.of(bench.document.profile, points)
    side = SIDES.index((1, 1))
    grip = frame.grip(side, bench.view.transform)
    there = take(bench, QPointF(grip.x, grip.y))
    type_in(bench, "1.5")
    wide = abs(bench.point(0, 2)[0] - bench.point(0, 1)[0])
    assert wide == pytest.approx(1.5 * abs(before[1][0] - before[0][0]))
    bench.release(there)


def test_lines_on_the_drawing_take_their_values(qtbot):
    cup = vase()
    document = edits.set_fill(edits.set_solid(cup, kind="vessel", wall=3.0), 70.0)
    bench = Bench(qtbot, document)
    at = QPointF(bench.screen((0.0, 70.0)).x() + 40.0, bench.screen((0.0, 70.0)).y())
    there = take(bench, at, (0.0, 12.0))
    assert bench.view.active.target is Target.LEVEL
    type_in(bench, "66.25")
    assert bench.document.fill_height == 66.25
    bench.release(there)
    assert bench.document.fill_height == 66.25


def test_digits_are_shortcuts_again_without_a_drag(bench):
    before = bench.document
    type_in(bench, "45")
    assert bench.document is before
    assert told(bench) == []
