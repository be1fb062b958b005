import math

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QApplication, QToolTip

from app.hand.coordinates import DesignPoint, GridSteps
from app.hand.drag import State
from app.hand.hit_test import Target
from app.state.overlays import SHOWN_AT_FIRST, Overlay
from app.state.view_state import Hover
from app.theme import theme
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.model import Document
from tests.app.profile_editor.bench import ALT, CTRL, SHIFT, Bench, near, vase


@pytest.fixture
def bench(qtbot):
    return Bench(qtbot, vase())


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
    target = bench.place(0, 1) + QPointF(11.7, 17.9)
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
    # Pointing at it lights up its range for every view, as its slider does.
    hover = bench.presenter.view.hover
    assert (hover.parameter, hover.segment) == ("lambda1", 0)
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
    bench.move(start + QPointF(60, -60), Qt.MouseButton.NoButton)
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
        bench.presenter.set_view(show=SHOWN_AT_FIRST | {Overlay.COMB}, hover=hover)
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


class Paints(QObject):
    def __init__(self):
        super().__init__()
        self.count = 0

    def eventFilter(self, _watched, event):  # noqa: N802 - Qt names it
        self.count += event.type() == QEvent.Type.Paint
        return False


def test_only_what_the_picture_shows_repaints_it(bench):
    paints = Paints()
    bench.view.installEventFilter(paints)
    bench.settle()
    before = paints.count
    bench.presenter.do("Place", lambda d: edits.set_placement(d, translation=(5.0, 0.0, 0.0)))
    bench.settle()
    assert paints.count == before
    # The dial in the corner shows the turn.
    bench.presenter.do("Turn", lambda d: edits.set_revolution(d, sweep_deg=180.0))
    bench.settle()
    assert paints.count > before
    before = paints.count
    bench.presenter.do("Move", lambda d: edits.move_point(d, 0, 1, (44.0, 12.0)))
    bench.settle()
    assert paints.count > before


def test_rulers_say_what_they_measure(bench):
    for at, text in (((5, 100), "height"), ((200, 595), "distance"), ((5, 595), "mm")):
        event = QHelpEvent(QEvent.Type.ToolTip, QPoint(*at), bench.view.mapToGlobal(QPoint(*at)))
        QApplication.sendEvent(bench.view, event)
        assert text in QToolTip.text()


@pytest.mark.parametrize("size", [(190, 240), (300, 320), (500, 600), (700, 260)])
def test_a_fit_leaves_no_point_under_tools_or_dial(qtbot, size):
    bench = Bench(qtbot, vase())
    flaring = [(30.0, 0), (40, 10), (52, 100), (60, 110)]
    closing = [(20.0, 0), (90, 10), (90, 60), (5, 61)]
    for shape in (flaring, closing):
        segment = Segment(np.array(shape))
        bench.presenter.replace_document(Document(Profile.of([segment])))
        bench.view.resize(*size)
        bench.settle()
        bench.view.fit()
        bench.view.grab()
        # Tools and dial follow the ruler and the size once the picture is painted.
        bench.settle()
        places = [bench.place(0, index) for index in range(4)]
        for over in (bench.view._buttons.geometry(), bench.view._dial.geometry()):
            assert not any(over.contains(place.toPoint()) for place in places)
