import math

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QAction, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication, QMainWindow, QPushButton, QVBoxLayout, QWidget

from app import theme
from app.presenter import Presenter
from app.profile_coords import DesignPoint, GridSteps, ScreenPoint
from app.profile_drag import State
from app.profile_hit import Target
from app.profile_view import ProfileView
from app.view_state import DEFAULT_OVERLAYS, Hover
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.model import Document
from sgb_core.document.session import Session

NONE = Qt.KeyboardModifier.NoModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
CTRL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier
LEFT, MIDDLE = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton


def vase(rule="G0"):
    shape = ShapeParameters(1.5, 3.0, 1.0, 1.0)
    return Document(
        Profile.of(
            [
                Segment(np.array([(20.0, 0), (45, 10), (52, 40), (38, 60)]), shape),
                Segment(np.array([(38.0, 60), (24, 80), (14, 95), (15, 112)])),
            ],
            [rule],
        )
    )


class Bench:
    """A shown profile editor with its presenter, worked by real events."""

    def __init__(self, qtbot, document):
        self.qtbot = qtbot
        self.presenter = Presenter(Session(document))
        self.view = ProfileView(self.presenter)
        self.presenter.add_view(self.view)
        qtbot.addWidget(self.view)
        self.view.resize(500, 600)
        self.notices = []
        self.presenter.noticed.connect(self.notices.append)
        with qtbot.waitExposed(self.view):
            self.view.show()
        self.view.setFocus()
        self.settle()

    def settle(self):
        self.presenter.refresh_now()
        QApplication.processEvents()

    @property
    def document(self):
        return self.presenter.document

    @property
    def undo_entries(self):
        return [entry.label for entry in self.presenter.session.history[1:]]

    def point(self, segment, index):
        return self.document.profile.segments[segment].points[index]

    def place(self, segment, index):
        return self.screen(self.point(segment, index))

    def screen(self, pair):
        x, y = self.view.transform.map(pair).tolist()
        return QPointF(x, y)

    def mouse(self, kind, at, button=LEFT, modifiers=NONE):
        at = QPointF(at)
        buttons = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseButtonRelease else button
        event = QMouseEvent(
            kind, at, QPointF(self.view.mapToGlobal(at)), button, buttons, modifiers
        )
        QApplication.sendEvent(self.view, event)

    def move(self, at, button=LEFT, modifiers=NONE):
        self.mouse(QEvent.Type.MouseMove, at, button, modifiers)
        self.settle()

    def press(self, at, button=LEFT, modifiers=NONE):
        self.mouse(QEvent.Type.MouseButtonPress, at, button, modifiers)

    def release(self, at, button=LEFT, modifiers=NONE):
        self.mouse(QEvent.Type.MouseButtonRelease, at, button, modifiers)
        self.settle()

    def drag(self, start, end, button=LEFT, modifiers=NONE):
        start, end = QPointF(start), QPointF(end)
        self.press(start, button, modifiers)
        for part in (0.2, 0.6, 1.0):
            self.move(start + (end - start) * part, button, modifiers)
        self.release(end, button, modifiers)

    def click(self, at, modifiers=NONE):
        self.press(at, modifiers=modifiers)
        self.release(at, modifiers=modifiers)

    def key(self, key, modifiers=NONE):
        self.qtbot.keyClick(self.view, key, modifiers)
        self.settle()

    def wheel(self, at, turned):
        at = QPointF(at)
        event = QWheelEvent(
            at,
            QPointF(self.view.mapToGlobal(at)),
            QPoint(),
            QPoint(0, turned),
            Qt.MouseButton.NoButton,
            NONE,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(self.view, event)
        self.settle()


@pytest.fixture
def bench(qtbot):
    return Bench(qtbot, vase())


def near(a, b, tolerance=1.0):
    return math.hypot(a.x() - b.x(), a.y() - b.y()) <= tolerance


@pytest.mark.parametrize("turns", [-600, 0, 480, 1200])
def test_a_drag_lands_where_the_cursor_is_at_any_zoom(bench, turns):
    bench.wheel(bench.place(0, 1), turns)
    target = bench.place(0, 1) + QPointF(37.4, -21.3)
    bench.drag(bench.place(0, 1), target)
    assert near(bench.place(0, 1), target)
    assert bench.undo_entries == ["Move P1 of segment 1"]


def test_escape_restores_the_very_document(bench):
    before = bench.document
    bench.press(bench.place(0, 2))
    bench.move(bench.place(0, 2) + QPointF(30, 30))
    assert bench.document is not before
    bench.key(Qt.Key.Key_Escape)
    assert bench.document is before
    bench.move(QPointF(300, 300))
    bench.release(QPointF(300, 300))
    assert bench.document is before
    assert bench.undo_entries == []


def test_undo_during_a_drag_ends_the_gesture(bench):
    before = bench.document
    bench.press(bench.place(0, 2))
    bench.move(bench.place(0, 2) + QPointF(30, 30))
    bench.presenter.undo()
    bench.settle()
    assert bench.view.gesture.state is State.IDLE
    bench.move(QPointF(100, 100))
    assert bench.document is before


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


def test_a_joint_is_dragged_as_one_point(bench):
    target = bench.place(0, 3) + QPointF(25, 10)
    bench.drag(bench.place(0, 3), target)
    assert near(bench.place(0, 3), target)
    assert np.array_equal(bench.point(0, 3), bench.point(1, 0))
    assert bench.undo_entries == ["Move joint 1–2"]


def test_alt_breaks_the_rule_of_the_joint_and_without_it_the_rule_holds(qtbot):
    bench = Bench(qtbot, vase("G1"))
    before = bench.point(1, 1).copy()
    bench.drag(bench.place(0, 2), bench.place(0, 2) + QPointF(30, 0), modifiers=ALT)
    assert np.array_equal(bench.point(1, 1), before)
    bench.presenter.undo()
    bench.settle()
    bench.drag(bench.place(0, 2), bench.place(0, 2) + QPointF(30, 0))
    assert not np.array_equal(bench.point(1, 1), before)
    legs = bench.point(0, 3) - bench.point(0, 2), bench.point(1, 1) - bench.point(1, 0)
    cross = legs[0][0] * legs[1][1] - legs[0][1] * legs[1][0]
    assert abs(cross) < 1e-9 * np.hypot(*legs[0]) * np.hypot(*legs[1])


def test_shift_holds_a_drag_horizontal_vertical_or_along_the_leg(bench):
    start = bench.point(0, 1).copy()
    bench.drag(bench.place(0, 1), bench.place(0, 1) + QPointF(60, -4), modifiers=SHIFT)
    assert bench.point(0, 1)[1] == start[1]
    bench.presenter.undo()
    bench.settle()
    bench.drag(bench.place(0, 1), bench.place(0, 1) + QPointF(3, -60), modifiers=SHIFT)
    assert bench.point(0, 1)[0] == start[0]
    bench.presenter.undo()
    bench.settle()
    leg = bench.place(0, 1) - bench.place(0, 0)
    bench.drag(bench.place(0, 1), bench.place(0, 1) + leg * 0.5, modifiers=SHIFT)
    step = bench.point(0, 1) - bench.point(0, 0)
    assert math.isclose(step[1] / step[0], 10 / 25)


def test_a_point_near_the_axis_snaps_to_it_unless_ctrl_is_held(bench):
    target = bench.screen((0.0, 20.0)) + QPointF(4.0, 0.0)
    bench.drag(bench.place(0, 1), target)
    assert bench.point(0, 1)[0] == 0.0
    bench.presenter.undo()
    bench.settle()
    bench.drag(bench.place(0, 1), target, modifiers=CTRL)
    assert bench.point(0, 1)[0] != 0.0
    assert near(bench.place(0, 1), target)


def test_with_snapping_on_points_land_on_the_grid_unless_ctrl_is_held(bench):
    bench.presenter.set_view(snap=True)
    bench.settle()
    minor = GridSteps.at(bench.view.transform.scale).minor
    target = bench.place(0, 1) + QPointF(31.7, 17.9)
    bench.drag(bench.place(0, 1), target)
    steps = bench.point(0, 1) / minor
    assert np.allclose(steps, np.round(steps))
    assert near(bench.place(0, 1), target, minor * bench.view.transform.scale)
    bench.drag(bench.place(0, 2), target, modifiers=CTRL)
    assert near(bench.place(0, 2), target)


def test_dragging_a_quartic_point_slides_it_along_its_leg_and_moves_the_parameter(bench):
    quartic = bench.document.profile.segments[0].quartic
    start = bench.screen(quartic[1])
    leg = bench.place(0, 1) - bench.place(0, 0)
    bench.move(start, Qt.MouseButton.NoButton)
    assert bench.view.active.target is Target.QUARTIC
    bench.press(start)
    bench.move(start - leg * 0.15)
    bench.move(start - leg * 0.3)
    hover = bench.presenter.view.hover
    assert (hover.parameter, hover.segment) == ("lambda1", 0)
    bench.release(start - leg * 0.3)
    segment = bench.document.profile.segments[0]
    assert near(bench.screen(segment.quartic[1]), start - leg * 0.3)
    assert segment.shape.lambda1 > 1.5
    assert np.array_equal(segment.points, vase().profile.segments[0].points)
    assert bench.undo_entries == ["Drag λ1 of segment 1"]
    assert bench.presenter.view.hover is None


@pytest.mark.parametrize("which", [0, 1, 2])
@pytest.mark.parametrize("segment", [0, 1])
def test_every_quartic_point_lands_where_the_cursor_is_also_at_omega_zero(bench, segment, which):
    bench.click(bench.screen(bench.document.profile.point(segment, 0.5)))
    quartic = bench.document.profile.segments[segment].quartic
    start, near_end = bench.screen(quartic[which + 1]), bench.place(segment, (0, 2, 3)[which])
    target = start + (near_end - start) * 0.4
    bench.drag(start, target)
    assert near(bench.screen(bench.document.profile.segments[segment].quartic[which + 1]), target)
    assert bench.undo_entries == [f"Drag λ{which + 1} of segment {segment + 1}"]


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


def test_a_double_click_on_the_curve_splits_it_there(bench):
    at = bench.screen(bench.document.profile.point(1, 0.5))
    curve = bench.document.profile.sample(65)[1]
    bench.click(at)
    bench.mouse(QEvent.Type.MouseButtonDblClick, at)
    bench.release(at)
    assert len(bench.document.profile) == 3
    assert near(bench.place(1, 3), at)
    assert bench.undo_entries == ["Split segment 2"]
    halves = bench.document.profile.sample(33)[1:].reshape(-1, 2)
    distances = np.hypot(*(curve[:, None] - halves[None]).T).min(axis=0)
    assert distances.max() < 0.5


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
    bench.drag(bench.place(0, 2), bench.place(0, 2) + QPointF(200, 0))
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


def test_keys_pressed_during_a_drag_count_at_once(bench):
    start = bench.point(0, 1).copy()
    bench.press(bench.place(0, 1))
    bench.move(bench.place(0, 1) + QPointF(50, 6))
    assert bench.point(0, 1)[1] != start[1]
    bench.qtbot.keyPress(bench.view, Qt.Key.Key_Shift)
    assert bench.point(0, 1)[1] == start[1]
    bench.release(QPointF(0, 0))


@pytest.fixture
def theme_restored(qapp):
    yield
    theme.apply(qapp, "light")


@pytest.mark.usefixtures("theme_restored")
def test_everything_paints_in_both_themes_with_all_overlays(bench):
    for hover in (Hover("lambda2", 0), Hover("omega", None)):
        bench.presenter.set_view(show=frozenset(DEFAULT_OVERLAYS | {"comb"}), hover=hover)
        for name in ("light", "dark"):
            theme.apply(QApplication.instance(), name)
            bench.settle()
            image = bench.view.grab().toImage()
            ground = image.pixelColor(image.width() - 3, 3).name()
            assert ground in (theme.current().canvas, theme.current().grid_minor)
            at = bench.screen(bench.document.profile.point(1, 0.5))
            assert image.pixelColor(at.toPoint()).name() != ground


def test_degenerate_and_far_out_pictures_paint(qtbot):
    point = Segment(np.full((4, 2), 5.0), ShapeParameters(4, 3, 4, 1))
    crossing = Segment(
        np.array([(20.0, 0), (-25, 20), (-22, 40), (18, 60)]), ShapeParameters(4, 3, 4, 1)
    )
    for segment in (point, crossing):
        bench = Bench(qtbot, Document(Profile.of([segment])))
        bench.wheel(bench.place(0, 1), 12000)
        assert not bench.view.grab().isNull()
        bench.wheel(bench.place(0, 1), -24000)
        assert not bench.view.grab().isNull()


def test_design_and_screen_coordinates_are_inverse(bench):
    there = bench.view.transform.to_screen(DesignPoint(12.5, -3.25))
    back = bench.view.transform.to_design(there)
    assert back.pair == pytest.approx((12.5, -3.25))


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
