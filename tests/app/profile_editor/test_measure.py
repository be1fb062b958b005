"""The measuring tool: what it reads, by mouse and by keys, and what it keeps."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

import sgb_core as sgb
from sgb_core.curves.nearest import arc_length
from sgb_core.design.locks.dimension import DimensionKind
from tests.app import mouse
from tests.app.profile_editor.bench import SHIFT, Bench, vase
from tests.sgb_core.design.locks.samples import pot

Key = Qt.Key


@pytest.fixture
def bench(qtbot):
    made = Bench(qtbot, vase())
    QTest.keyClick(made.view, Key.Key_M)
    made.settle()
    return made


def place(bench, r, h):
    x, y = bench.view.transform.map((r, h)).tolist()
    return QPoint(round(x), round(y))


def point_at(bench, r, h):
    mouse.hover(bench.view, QPointF(place(bench, r, h)))
    bench.settle()


def click(bench, r, h, modifiers=Qt.KeyboardModifier.NoModifier):
    at = place(bench, r, h)
    mouse.press(bench.view, at, modifiers)
    mouse.release(bench.view, at, modifiers)
    bench.settle()


def told(bench):
    return bench.view.tool.told()[1]


def test_from_point_to_point_it_reads_distance_steps_and_the_way_along(bench):
    document = bench.presenter.document
    click(bench, 20, 0)
    point_at(bench, 38, 60)
    lines = told(bench)
    assert lines[0].startswith("62.6")
    assert "∠ 73.3°" in lines[0]
    assert lines[1].startswith("Δr 18.0")
    assert "Δh 60.0" in lines[1]
    length = arc_length(document.profile[0])
    assert lines[2].startswith(f"{length:.1f}"[:4])
    assert bench.presenter.document is document


def test_a_third_place_reads_the_angle_between_and_the_next_press_begins_anew(bench):
    click(bench, 60, 20)
    click(bench, 60, 70)
    click(bench, 90, 70)
    assert any(line.startswith("∠ 90.0") for line in told(bench))
    assert len(bench.view.tool.placed) == 3
    click(bench, 70, 30)
    assert len(bench.view.tool.placed) == 1


def test_on_the_curve_it_reads_radius_tangent_and_wall(qtbot):
    document = pot(3)
    bench = Bench(qtbot, document)
    bench.view.take("measure")
    middle = document.profile[1].point(0.4).tolist()
    point_at(bench, *middle)
    lines = told(bench)
    assert lines[0] == "segment 2   s = 0.400" or lines[0].startswith("segment 2")
    assert any(line.startswith("⌀ ") for line in lines)
    assert any(line.startswith("R ") and "tangent ∠" in line for line in lines)
    assert any(line.startswith("wall 3.0") for line in lines)


def test_escape_ends_what_is_measured_then_leaves(bench):
    click(bench, 20, 0)
    QTest.keyClick(bench.view, Key.Key_Escape)
    bench.settle()
    assert bench.view.tool.placed == ()
    QTest.keyClick(bench.view, Key.Key_Escape)
    bench.settle()
    assert bench.view.tool is None


def test_ctrl_lets_go_of_points_and_shift_goes_straight(bench):
    at = place(bench, 20, 0) + QPoint(4, 0)
    mouse.press(bench.view, at, Qt.KeyboardModifier.ControlModifier)
    mouse.release(bench.view, at, Qt.KeyboardModifier.ControlModifier)
    assert bench.view.tool.placed[0].point is None
    QTest.keyClick(bench.view, Key.Key_Escape)
    click(bench, 20, 0)
    assert bench.view.tool.placed[0].point == (0, 0)
    click(bench, 70, 3, SHIFT)
    assert bench.view.tool.placed[1].place.h == 0.0


def test_the_keyboard_alone_measures(bench):
    QTest.keyClick(bench.view, Key.Key_Right)
    QTest.keyClick(bench.view, Key.Key_Space)
    start = bench.view.tool.placed[0].place
    for _ in range(3):
        QTest.keyClick(bench.view, Key.Key_Up, SHIFT)
    QTest.keyClick(bench.view, Key.Key_Return)
    bench.settle()
    assert len(bench.view.tool.placed) == 2
    assert bench.view.tool.placed[1].place.h > start.h
    QTest.keyClick(bench.view, Key.Key_Backspace)
    assert len(bench.view.tool.placed) == 1


def test_what_is_read_is_kept_as_a_dimension_in_one_step(bench):
    document = bench.presenter.document
    click(bench, 20, 0)
    point_at(bench, 38, 60)
    assert told(bench)[-1] == "D keeps it as a dimension"
    QTest.keyClick(bench.view, Key.Key_D)
    bench.settle()
    (kept,) = bench.presenter.document.dimensions
    assert kept.kind is DimensionKind.DISTANCE
    bench.presenter.undo()
    assert bench.presenter.document is document
    QTest.keyClick(bench.view, Key.Key_Escape)
    point_at(bench, *document.profile[0].point(0.5).tolist())
    QTest.keyClick(bench.view, Key.Key_D)
    bench.settle()
    assert bench.presenter.document.dimensions[0].kind is DimensionKind.RADIUS
    point_at(bench, 5, 100)
    QTest.keyClick(bench.view, Key.Key_D)
    assert "kept as dimensions" in bench.notices[-1].text
    assert len(bench.presenter.document.dimensions) == 1


def test_undo_under_the_tool_leaves_it_whole(bench):
    click(bench, 20, 0)
    bench.presenter.do("Split", lambda d: sgb.edits.split_segment(d, 0, 0.5)[0])
    bench.presenter.undo()
    bench.settle()
    point_at(bench, 38, 60)
    assert told(bench)
