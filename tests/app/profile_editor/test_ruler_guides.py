"""Guides pulled from the rulers: seen, magnetic, moved, dragged back, one step of undo each."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

import sgb_core as sgb
from app.state.blank import blank_document
from sgb_core.document.guides import Guide, GuideAt
from tests.app import mouse
from tests.app.profile_editor.bench import CTRL, Bench, vase


@pytest.fixture
def bench(qtbot):
    return Bench(qtbot, vase())


def place(bench, r, h):
    x, y = bench.view.transform.map((r, h)).tolist()
    return QPoint(round(x), round(y))


def on_ruler(bench, at):
    area = bench.view.area
    middle = QPoint(round((area.left + area.right) / 2), round((area.top + area.bottom) / 2))
    if at is GuideAt.RADIUS:
        return QPoint(round(area.left) - 6, middle.y())
    return QPoint(middle.x(), round(area.bottom) + 6)


def pull(bench, at, end, **keys):
    bench.drag(QPointF(on_ruler(bench, at)), QPointF(end), **keys)
    bench.settle()


@pytest.mark.parametrize("at", list(GuideAt))
def test_one_is_pulled_from_each_ruler_and_undone(bench, at):
    document = bench.presenter.document
    end = place(bench, 49.0, 77.0)
    pull(bench, at, end)
    (guide,) = bench.presenter.document.guides
    assert guide.at is at
    wanted = (49.0, 77.0)[at.coordinate]
    assert guide.value == pytest.approx(wanted, abs=1.5 / bench.view.transform.scale)
    assert bench.presenter.document.profile is document.profile
    bench.presenter.undo()
    assert bench.presenter.document is document


def test_it_stops_at_a_control_point_but_with_ctrl(bench):
    near = place(bench, 45.0, 60.0) + QPoint(3, 0)
    pull(bench, GuideAt.RADIUS, near)
    assert bench.presenter.document.guides == (Guide("r", 45.0),)
    bench.presenter.undo()
    bench.settle()
    pull(bench, GuideAt.RADIUS, near, modifiers=CTRL)
    (guide,) = bench.presenter.document.guides
    assert guide.value != 45.0


def test_a_dragged_point_is_drawn_to_it(bench):
    bench.presenter.do("Guide", lambda d: sgb.edits.add_guide(d, Guide("r", 43.25)))
    bench.settle()
    point = bench.presenter.document.profile[0].points[3]
    start = place(bench, *point.tolist())
    beside = round((43.25 - point[0]) * bench.view.transform.scale) + 4
    mouse.drag(bench.view, start, start + QPoint(beside, 9))
    bench.settle()
    assert bench.presenter.document.profile[0].points[3][0] == 43.25
    bench.presenter.undo()
    bench.settle()
    bench.drag(QPointF(start), QPointF(start + QPoint(beside, 9)), modifiers=CTRL)
    bench.settle()
    assert bench.presenter.document.profile[0].points[3][0] != 43.25


def test_it_is_moved_and_dragged_back_to_be_removed(bench):
    bench.presenter.do("Guide", lambda d: sgb.edits.add_guide(d, Guide("h", 105.0)))
    bench.settle()
    start = place(bench, 55.0, 105.0)
    mouse.drag(bench.view, start, place(bench, 55.0, 70.0))
    bench.settle()
    (guide,) = bench.presenter.document.guides
    assert guide.value == pytest.approx(70.0, abs=1.5 / bench.view.transform.scale)
    mouse.drag(bench.view, place(bench, 55.0, guide.value), on_ruler(bench, GuideAt.HEIGHT))
    bench.settle()
    assert bench.presenter.document.guides == ()
    for _ in range(3):
        bench.presenter.undo()
    assert not bench.presenter.session.undo()


def test_escape_puts_it_back(bench):
    document = bench.presenter.document
    mouse.press(bench.view, on_ruler(bench, GuideAt.RADIUS))
    mouse.move(bench.view, place(bench, 49.0, 70.0))
    assert bench.presenter.document.guides
    QTest.keyClick(bench.view, Qt.Key.Key_Escape)
    mouse.release(bench.view, place(bench, 49.0, 70.0))
    bench.settle()
    assert bench.presenter.document is document


def test_points_come_before_guides_and_a_click_on_a_ruler_changes_nothing(bench):
    bench.presenter.do("Guide", lambda d: sgb.edits.add_guide(d, Guide("h", 60.0)))
    bench.settle()
    start = place(bench, 38.0, 60.0)
    mouse.drag(bench.view, start, start + QPoint(12, 0))
    bench.settle()
    moved = bench.presenter.document
    assert moved.guides == (Guide("h", 60.0),)
    assert not np.array_equal(moved.profile.control_points, vase().profile.control_points)
    at = on_ruler(bench, GuideAt.RADIUS)
    mouse.press(bench.view, at)
    mouse.release(bench.view, at)
    bench.settle()
    assert bench.presenter.document is moved


def test_the_pen_and_the_measuring_tool_are_drawn_to_it(qtbot):
    bench = Bench(qtbot, blank_document())
    for guide in (Guide("r", 41.37), Guide("h", 63.21)):
        bench.presenter.do("Guide", lambda d, guide=guide: sgb.edits.add_guide(d, guide))
    bench.settle()
    bench.key(Qt.Key.Key_P)
    bench.click(QPointF(place(bench, 20.0, 0.0)))
    near = QPointF(place(bench, 41.37, 63.21)) + QPointF(3.0, -3.0)
    bench.click(near)
    assert bench.point(0, 3).tolist() == [41.37, 63.21]
    bench.key(Qt.Key.Key_Escape)
    bench.key(Qt.Key.Key_M)
    level = QPointF(place(bench, 90.0, 63.21)) + QPointF(0.0, 3.0)
    bench.move(level, Qt.MouseButton.NoButton)
    _, lines = bench.view._tool.told()
    assert any("h 63.2" in line for line in lines)
    bench.move(level, Qt.MouseButton.NoButton, CTRL)
    _, lines = bench.view._tool.told()
    assert not any("h 63.2" in line for line in lines)
