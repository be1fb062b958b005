"""Lining up with other points, and the paper that moves along at the editor's edge."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF

from app.hand.coordinates import DesignPoint, GridSteps
from app.hand.snapping import DragKeys, Snapping, land, other_points
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from tests.app.mouse import move, press, release
from tests.app.profile_editor.bench import CTRL, SHIFT, Bench, vase
from tests.app.viewport.helpers import VASE
from tests.app.window_stage import WindowStage

OTHERS = np.array([(10.0, 40.0), (25.0, 3.0)])
START = DesignPoint(18.0, 18.0)


def test_near_another_points_radius_or_height_it_lines_up():
    snapping = Snapping(None, 0.5, OTHERS, 0.6)
    landing = land(START, DesignPoint(10.4, 12.9), DragKeys(), snapping)
    assert landing.point == DesignPoint(10.0, 12.9)
    assert landing.aligned == (10.0, None)
    grid = Snapping(GridSteps(10.0, 2.0), 0.5, OTHERS, 1e-6)
    landing = land(START, DesignPoint(10.4, 2.7), DragKeys(), grid)
    assert landing.point == DesignPoint(10.0, 2.0)
    assert landing.aligned == (10.0, None)
    both = land(START, DesignPoint(24.6, 40.5), DragKeys(), snapping)
    assert both.point == DesignPoint(25.0, 40.0)
    assert both.aligned == (25.0, 40.0)


def test_while_it_snaps_another_point_draws_before_the_grid():
    grid = Snapping(GridSteps(10.0, 2.0), 0.5, OTHERS, 1.2)
    landing = land(START, DesignPoint(25.9, 4.1), DragKeys(), grid)
    assert landing.point == DesignPoint(25.0, 3.0)
    assert landing.aligned == (25.0, 3.0)
    beyond = land(START, DesignPoint(23.7, 4.3), DragKeys(), grid)
    assert beyond.point == DesignPoint(24.0, 4.0)
    assert beyond.aligned == (None, None)
    level = land(START, DesignPoint(24.1, 18.9), DragKeys(constrain=True), grid)
    assert level.point == DesignPoint(25.0, 18.0)
    assert level.aligned == (25.0, None)


@pytest.mark.parametrize(("away", "held", "drawn"), [(5.0, 0, True), (-5.0, 0, True),
                         (5.0, CTRL, False), (5.0, SHIFT, True)])  # fmt: skip
def test_snapping_a_drag_stops_five_pixels_from_another_point_and_ctrl_lets_it_go(
    qtbot, away, held, drawn
):
    bench = Bench(qtbot, vase())
    bench.presenter.set_view(snap=True)
    bench.settle()
    other = bench.point(0, 2)[0]
    end = QPointF(bench.screen((other, 0.0)).x() + away, bench.place(1, 1).y())
    bench.drag(bench.place(1, 1), end, **({"modifiers": held} if held else {}))
    assert bool(bench.point(1, 1)[0] == other) is drawn


def test_ctrl_and_a_distance_leave_it_alone():
    snapping = Snapping(None, 0.5, OTHERS, 0.6)
    assert land(START, DesignPoint(10.4, 12.9), DragKeys(free=True), snapping).aligned == (
        None,
        None,
    )
    far = DesignPoint(17.0, 20.0)
    assert land(START, far, DragKeys(), snapping).point == far


def test_what_moves_along_is_no_guide():
    profile = Profile.of([Segment(points) for points in VASE])
    points = profile.control_points
    assert len(other_points(profile, [(1, 1)])) == 11
    others = other_points(profile, [(0, 3)])
    assert len(others) == 8
    for gone in (points[0, 2], points[0, 3], points[1, 1]):
        assert not (others == gone).all(axis=1).any()


def test_at_the_edge_the_paper_follows_and_the_point_stays_under_the_cursor(qtbot):
    stage = WindowStage(qtbot, wait_for_scene=False)
    stage.window.files.new_from_preset("vase")
    stage.settle()
    editor = stage.window.profile_view
    original = stage.document

    def place():
        point = stage.document.profile.segments[3].points[1]
        at = editor.transform.to_screen(DesignPoint.of(point))
        return QPointF(at.x, at.y)

    start, before = place(), editor.transform
    edge = QPointF(start.x(), 1.0)
    press(editor, start)
    move(editor, start + QPointF(0, -10))
    move(editor, edge)
    stage.until(lambda: editor.transform.y0 > before.y0 + 1.0)
    assert editor.transform.scale == before.scale
    assert (place() - edge.toPoint()).manhattanLength() < 2.0
    inside = QPointF(QPoint(round(start.x()), 60))
    move(editor, inside)
    rested = editor.transform
    qtbot.wait(100)
    assert editor.transform == rested
    release(editor, inside)
    assert stage.session.undo_label.startswith("Move")
    stage.presenter.undo()
    assert stage.document is original
    stage.close()
