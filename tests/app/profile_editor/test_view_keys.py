import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMainWindow, QPushButton, QVBoxLayout, QWidget

from app.hand.coordinates import GridSteps, ScreenPoint
from app.profile_editor.view import ProfileView
from app.state.presenter import Presenter
from sgb_core.document.session import Session
from tests.app.profile_editor.bench import CTRL, MIDDLE, SHIFT, Bench, near, vase


@pytest.fixture
def bench(qtbot):
    return Bench(qtbot, vase())


def test_a_click_selects_and_changes_nothing(bench):
    before = bench.document
    bench.click(bench.place(1, 2))
    assert bench.presenter.view.segment == 1
    assert bench.presenter.view.points == {(1, 2)}
    assert bench.document is before
    assert bench.undo_entries == []


def test_a_click_on_the_curve_selects_its_segment_and_one_on_paper_clears_the_points(bench):
    bench.click(bench.screen(bench.document.profile.point(1, 0.5)))
    assert bench.presenter.view.segment == 1
    bench.click(bench.place(1, 1))
    bench.click(QPointF(480, 20))
    assert bench.presenter.view.points == frozenset()


def test_box_and_shift_select_several_points_that_are_dragged_together(bench):
    a, b = bench.place(0, 1), bench.place(0, 2)
    bench.drag(QPointF(max(a.x(), b.x()) + 20, a.y() + 20), QPointF(a.x() - 15, b.y() - 20))
    assert bench.presenter.view.points == {(0, 1), (0, 2)}
    bench.click(bench.place(1, 2), SHIFT)
    assert bench.presenter.view.points == {(0, 1), (0, 2), (1, 2)}
    bench.click(bench.place(0, 2), SHIFT)
    assert bench.presenter.view.points == {(0, 1), (1, 2)}
    before = bench.document.profile.control_points
    target = bench.place(0, 1) + QPointF(-20, -15)
    bench.drag(bench.place(0, 1), target)
    moved = bench.document.profile.control_points - before
    assert near(bench.place(0, 1), target)
    assert np.allclose(moved[0, 1], moved[1, 2])
    assert np.all(moved[0, 2] == 0.0)
    assert bench.undo_entries == ["Move 2 points"]


def test_arrows_nudge_and_shift_makes_it_tenfold(bench):
    bench.click(bench.place(0, 1))
    step = GridSteps.at(bench.view.transform.scale).minor / 10
    bench.key(Qt.Key.Key_Right)
    assert bench.point(0, 1).tolist() == pytest.approx([45 + step, 10])
    bench.key(Qt.Key.Key_Down, SHIFT)
    assert bench.point(0, 1).tolist() == pytest.approx([45 + step, 10 - 10 * step])
    assert bench.undo_entries == ["Nudge P1 of segment 1"] * 2


def test_a_key_held_down_is_one_undo_entry_and_adds_up_without_rounding(bench):
    bench.click(bench.place(0, 1))
    for _ in range(10):
        bench.qtbot.keyPress(bench.view, Qt.Key.Key_Up)
    bench.qtbot.keyRelease(bench.view, Qt.Key.Key_Up)
    bench.settle()
    step = GridSteps.at(bench.view.transform.scale).minor
    assert bench.point(0, 1)[1] == 10 + step
    assert bench.undo_entries == ["Nudge P1 of segment 1"]


def test_delete_removes_the_segment_of_the_selected_point(bench):
    bench.click(bench.place(1, 2))
    bench.key(Qt.Key.Key_Delete)
    assert len(bench.document.profile) == 1
    assert bench.undo_entries == ["Remove segment 2"]


def test_space_drag_and_middle_drag_pan_without_touching_the_document(bench):
    before, start = bench.document, bench.place(0, 1)
    bench.qtbot.keyPress(bench.view, Qt.Key.Key_Space)
    bench.drag(start, start + QPointF(40, -30))
    bench.qtbot.keyRelease(bench.view, Qt.Key.Key_Space)
    assert near(bench.place(0, 1), start + QPointF(40, -30), 1e-6)
    bench.drag(start, start + QPointF(-10, 5), MIDDLE)
    assert near(bench.place(0, 1), start + QPointF(30, -25), 1e-6)
    assert bench.document is before


def test_the_wheel_zooms_at_the_cursor_and_f_fits(bench):
    at = bench.place(0, 2)
    fitted = bench.view.transform
    bench.wheel(at, 360)
    assert bench.view.transform.scale > 1.5 * fitted.scale
    assert near(bench.place(0, 2), at, 1e-6)
    bench.key(Qt.Key.Key_F)
    assert bench.view.transform.scale == pytest.approx(fitted.scale)


def test_edits_never_change_the_zoom_but_another_document_is_fitted(bench):
    bench.wheel(bench.place(0, 2), 360)
    zoomed = bench.view.transform
    bench.drag(bench.place(0, 2), bench.view.rect().center().toPointF())
    assert bench.view.transform == zoomed
    bench.presenter.replace_document(vase())
    bench.settle()
    assert bench.view.transform != zoomed
    area = bench.view.area
    for segment in range(2):
        for index in range(4):
            at = bench.place(segment, index)
            assert area.contains(ScreenPoint(at.x(), at.y()))


def test_tab_walks_through_the_points_and_leaves_after_the_last(bench):
    visited = []
    for _ in range(7):
        bench.key(Qt.Key.Key_Tab)
        visited.append(next(iter(bench.presenter.view.points)))
    assert visited == [(0, 0), (0, 1), (0, 2), (0, 3), (1, 1), (1, 2), (1, 3)]
    assert "P3 of segment 2" in bench.view.accessibleDescription()
    bench.key(Qt.Key.Key_Backtab, SHIFT)
    assert bench.presenter.view.points == {(1, 2)}
    assert not bench.view.focusNextPrevChild(False) or bench.presenter.view.points == {(1, 1)}


def test_being_hidden_with_the_focus_chooses_no_point(bench):
    bench.view.setFocus()
    bench.view.hide()
    assert bench.presenter.view.points == frozenset()


def test_the_cursor_tells_what_a_press_would_do(bench):
    def shape_at(at):
        bench.move(at, Qt.MouseButton.NoButton)
        return bench.view.cursor().shape()

    assert shape_at(bench.place(0, 1)) == Qt.CursorShape.SizeAllCursor
    on_curve = bench.document.profile.point(1, 0.6)
    assert shape_at(bench.screen(on_curve)) == Qt.CursorShape.PointingHandCursor
    # The middle leg of the first segment is nearly upright.
    middle = bench.document.profile.segments[0].quartic[2]
    assert shape_at(bench.screen(middle)) == Qt.CursorShape.SizeVerCursor
    assert shape_at(QPointF(480, 20)) == Qt.CursorShape.ArrowCursor


def test_ctrl_a_takes_every_point_and_plus_and_minus_zoom(bench):
    bench.key(Qt.Key.Key_A, CTRL)
    assert len(bench.presenter.view.points) == 7
    before = bench.document.profile.control_points
    bench.drag(bench.place(0, 1), bench.place(0, 1) + QPointF(10, -20))
    moved = bench.document.profile.control_points - before
    assert np.allclose(moved, moved[0, 0], atol=1e-9)
    scale = bench.view.transform.scale
    bench.key(Qt.Key.Key_Plus)
    assert bench.view.transform.scale == pytest.approx(1.25 * scale)
    bench.key(Qt.Key.Key_Minus)
    assert bench.view.transform.scale == pytest.approx(scale)


def test_the_editor_keeps_its_keys_from_the_menus_only_while_it_has_the_focus(qtbot):
    window = QMainWindow()
    qtbot.addWidget(window)
    presenter = Presenter(Session(vase()))
    view, other = ProfileView(presenter), QPushButton("other")
    presenter.add_view(view)
    box = QWidget()
    layout = QVBoxLayout(box)
    layout.addWidget(view)
    layout.addWidget(other)
    window.setCentralWidget(box)
    taken = []
    action = QAction("Fit", window)
    action.setShortcut("F")
    action.triggered.connect(lambda: taken.append("menu"))
    window.addAction(action)
    window.resize(400, 500)
    with qtbot.waitActive(window):
        window.show()
        window.activateWindow()
    presenter.refresh_now()
    view.setFocus()
    qtbot.keyClick(view, Qt.Key.Key_F)
    assert taken == []
    other.setFocus()
    qtbot.keyClick(other, Qt.Key.Key_F)
    assert taken == ["menu"]
