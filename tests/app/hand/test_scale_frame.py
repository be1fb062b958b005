"""The frame around several selected points: scaling by its handles, moving by its body."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt

from app.hand.coordinates import DesignPoint, ScreenPoint
from app.hand.drag import State
from app.hand.scale_frame import MARGIN, PointFrame
from tests.app.profile_editor.bench import ALT, CTRL, NONE, SHIFT, Bench, near, vase

CHOSEN = frozenset({(0, 1), (0, 2), (1, 1)})  # (45, 10), (52, 40), (24, 80)
LOW, HIGH = np.array((24.0, 10.0)), np.array((52.0, 80.0))
LOWER_RIGHT, RIGHT, UPPER_RIGHT, TOP = 2, 3, 4, 5


@pytest.fixture
def bench(qtbot):
    bench = Bench(qtbot, vase())
    bench.presenter.set_view(points=CHOSEN)
    bench.settle()
    return bench


def frame_of(bench):
    return PointFrame.of(bench.document.profile, bench.presenter.view.points)


def grip(bench, side):
    at = frame_of(bench).grip(side, bench.view.transform)
    return QPointF(at.x, at.y)


def places(bench):
    return np.array([bench.point(*key) for key in sorted(CHOSEN)])


@pytest.mark.parametrize(
    ("side", "keys", "factors", "about"),
    [
        (UPPER_RIGHT, NONE, (1.5, 1.2), LOW),
        (LOWER_RIGHT, NONE, (1.5, 1.2), (24.0, 80.0)),
        (RIGHT, NONE, (1.5, 1.0), LOW),
        (TOP, NONE, (1.0, 1.2), LOW),
        (TOP, SHIFT, (1.2, 1.2), (38.0, 10.0)),
        (RIGHT, ALT, (2.0, 1.0), (38.0, 45.0)),
        (UPPER_RIGHT, ALT, (2.0, 1.4), (38.0, 45.0)),
    ],
)
def test_a_handle_scales_the_points_about_the_other_side(bench, side, keys, factors, about):
    before = places(bench)
    size = (HIGH - LOW) * bench.view.transform.scale
    up = -1.0 if side == LOWER_RIGHT else 1.0
    way = QPointF(0.5 * size[0], -0.2 * up * size[1])
    if side == TOP:
        way = QPointF(3.0, way.y())
    elif side == RIGHT:
        way = QPointF(way.x(), 3.0)
    bench.drag(grip(bench, side), grip(bench, side) + way, modifiers=keys | CTRL)
    wanted = about + (before - about) * factors
    assert np.allclose(places(bench), wanted, atol=1e-9)
    assert bench.undo_entries == ["Scale 3 points"]


def test_shift_on_a_corner_keeps_the_proportions(bench):
    before = places(bench)
    bench.drag(
        grip(bench, UPPER_RIGHT), grip(bench, UPPER_RIGHT) + QPointF(40, -7), modifiers=SHIFT
    )
    factor = (bench.point(0, 2)[0] - LOW[0]) / (HIGH[0] - LOW[0])
    assert factor > 1.01
    assert np.allclose(places(bench) - LOW, factor * (before - LOW))


def test_the_corner_stays_under_the_hand_and_the_label_says_the_factor(bench):
    start, end = grip(bench, UPPER_RIGHT), grip(bench, UPPER_RIGHT) + QPointF(31.0, -22.0)
    bench.press(start, modifiers=CTRL)
    bench.move(start + QPointF(8.0, 0.0), modifiers=CTRL)
    bench.move(end, modifiers=CTRL)
    assert bench.view.gesture.state is State.SCALING
    assert near(grip(bench, UPPER_RIGHT), end)
    factor = bench.view._hand.landing.factors[0]
    lines = frame_of(bench).lines((factor, factor), 10.0, "mm")
    assert lines[:2] == ["3 points", f"× {factor:.3f}"]
    bench.key(Qt.Key.Key_Escape)
    assert np.allclose(places(bench)[0], (45.0, 10.0))
    assert bench.undo_entries == []
    bench.release(end)
    assert bench.undo_entries == []


def test_inside_the_frame_all_points_move_from_where_they_were_grabbed(bench):
    inside = bench.screen((30.0, 30.0))
    before = places(bench)
    bench.drag(inside, inside + QPointF(20.0, -10.0), modifiers=CTRL)
    step = np.array((20.0, 10.0)) / bench.view.transform.scale
    assert np.allclose(places(bench), before + step)
    assert bench.undo_entries == ["Move 3 points"]


def test_a_click_inside_lets_the_points_go_and_points_come_before_handles(bench):
    assert bench.view._pick(_screen(bench.place(0, 1))).index == 1
    bench.click(bench.screen((30.0, 30.0)))
    assert bench.presenter.view.points == frozenset()


def test_while_it_snaps_a_handle_stops_at_another_points_height(bench):
    bench.presenter.set_view(snap=True)
    bench.settle()
    level = bench.point(1, 2)[1]
    end = QPointF(grip(bench, TOP).x(), bench.screen((0.0, level)).y() - MARGIN + 4.0)
    bench.drag(grip(bench, TOP), end)
    assert bench.point(1, 1)[1] == pytest.approx(level)


def test_points_on_a_line_have_handles_along_it_only():
    profile = vase().profile
    assert PointFrame.of(profile, {(0, 1)}) is None
    both = PointFrame((((0, 1)), (0, 2)), DesignPoint(5.0, 1.0), DesignPoint(5.0, 9.0))
    assert both.sides == [1, 5]
    assert both.factors(5, DesignPoint(7.0, 17.0), proportional=False, centred=False) == (1.0, 2.0)


def test_the_rule_of_a_joint_in_the_frame_is_kept(qtbot):
    bench = Bench(qtbot, vase("G1"))
    bench.presenter.set_view(points=frozenset({(0, 2), (0, 3)}))
    bench.settle()
    bench.drag(grip(bench, TOP), grip(bench, TOP) + QPointF(0.0, -30.0), modifiers=CTRL)
    report = bench.presenter.frame.evaluation.joints[0]
    assert report.measured in ("G1", "C1", "G2")
    assert np.array_equal(bench.point(0, 3), bench.point(1, 0))


def _screen(at):
    return ScreenPoint(at.x(), at.y())
