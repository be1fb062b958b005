"""Handles dragged in the viewport of the real window, by real mouse and key events."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

from app.hand.coordinates import DesignPoint
from app.viewport.handles import Scenery, TurnEnd
from sgb_core.document import edits
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis
from tests.app.mouse import CTRL, LEFT, SHIFT, hover, move, press, release
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot)
    yield made
    made.close()


class Eye:
    """Where things are seen in a stage's viewport."""

    def __init__(self, stage):
        self.stage = stage
        self.view = stage.window.surface_view
        self.canvas = self.view.plotter

    @property
    def scenery(self):
        return Scenery(self.stage.presenter.frame, self.view.lens)

    def control(self, segment, index):
        points = self.stage.document.profile.segments[segment].points
        return QPointF(*self.scenery.paper().map(points[index]).tolist())

    def quartic(self, segment, which):
        quartic = self.stage.document.profile.segments[segment].quartic
        return QPointF(*self.scenery.paper().map(quartic[which + 1]).tolist())

    def turn(self, end):
        return QPointF(*self.view.lens.to_screen(self.scenery.place(end))[0].tolist())


@pytest.fixture
def eye(stage):
    stage.window.files.new_from_preset("vase")
    stage.settle()
    return Eye(stage)


def far(a, b):
    return float(np.hypot(a.x() - b.x(), a.y() - b.y()))


def free_point(eye):
    """A control point that no other handle comes near in the picture."""
    paper = eye.scenery.paper()
    places = paper.map(eye.stage.document.profile.control_points).reshape(-1, 2)
    for segment, points in enumerate(eye.stage.document.profile.control_points):
        for index in (1, 2):
            away = np.hypot(*(places - paper.map(points[index])).T)
            if np.sort(away)[1] > 12.0:
                return segment, index
    raise AssertionError("all points lie close together")


@pytest.mark.parametrize("projection", ["perspective", "parallel"])
@pytest.mark.parametrize("notches", [-3, 0, 4])
def test_a_point_lands_under_the_cursor_at_any_zoom(eye, projection, notches):
    eye.stage.presenter.set_view(projection=projection)
    segment, index = free_point(eye)
    eye.stage.settle()
    at = eye.control(segment, index)
    pose = eye.view.pose
    half = eye.canvas.height() / 2
    x, y = (at.x() - eye.canvas.width() / 2) / half, 1 - at.y() / half
    eye.view.move_camera(pose.zoomed(0.87**notches, x, y))
    before = eye.stage.document
    at = eye.control(segment, index)
    target = QPointF(at.toPoint() + QPoint(31, -23))
    press(eye.canvas, at)
    move(eye.canvas, at + QPointF(9, -5))
    move(eye.canvas, target)
    assert far(eye.control(segment, index), target) < 1.0
    release(eye.canvas, target)
    assert far(eye.control(segment, index), target) < 1.0
    assert eye.stage.session.undo_label == f"Move P{index} of segment {segment + 1}"
    eye.stage.presenter.undo()
    assert eye.stage.document is before
    assert eye.stage.session.undo_label is None


@pytest.mark.parametrize("axis", list(Axis))
def test_it_lands_with_any_axis_start_and_placement(eye, axis):
    placed = Placement((10.0, -15.0, 20.0), (12.0, -7.0, 30.0))
    eye.stage.presenter.do(
        "Turn",
        lambda d: replace(
            edits.set_revolution(d, axis=axis, start_deg=40.0, sweep_deg=250.0), placement=placed
        ),
    )
    eye.stage.settle()
    eye.view.fit(smooth=False)
    eye.stage.settle()
    segment, index = free_point(eye)
    at = eye.control(segment, index)
    target = QPointF(at.toPoint() + QPoint(-17, 12))
    press(eye.canvas, at)
    move(eye.canvas, at + QPointF(5, 5))
    move(eye.canvas, target)
    release(eye.canvas, target)
    assert far(eye.control(segment, index), target) < 1.0


def test_escape_restores_and_other_gestures_are_not_mixed(eye):
    before, pose = eye.stage.document, eye.view.pose
    at = eye.control(*free_point(eye))
    press(eye.canvas, at)
    move(eye.canvas, at + QPointF(20, 20))
    eye.stage.settle()
    assert eye.stage.document is not before
    assert eye.view.hud.isVisible()
    assert eye.view.hud.lines[1].startswith("r ")
    QTest.keyClick(eye.canvas, Qt.Key.Key_Escape)
    assert eye.stage.document is before
    move(eye.canvas, at + QPointF(40, 40))
    release(eye.canvas, at + QPointF(40, 40))
    assert eye.stage.document is before
    assert eye.view.pose == pose
    assert eye.stage.session.undo_label is None


def test_shift_holds_a_direction_and_may_come_later(eye):
    segment, index = free_point(eye)
    r, h = eye.stage.document.profile.segments[segment].points[index]
    at = eye.control(segment, index)
    press(eye.canvas, at)
    move(eye.canvas, at + QPointF(30, 9))
    QTest.keyPress(eye.canvas, Qt.Key.Key_Shift)
    moved = eye.stage.document.profile.segments[segment].points[index]
    begun = DesignPoint(r, h)
    guide = eye.view.hand.landing.guide
    assert abs((moved[0] - begun.r) * guide[1] - (moved[1] - begun.h) * guide[0]) < 1e-9
    QTest.keyRelease(eye.canvas, Qt.Key.Key_Shift)
    assert eye.view.hand.landing.guide is None
    release(eye.canvas, at + QPointF(30, 9))


def test_a_quartic_point_is_its_slider(eye):
    stage = eye.stage
    stage.presenter.do("ω", lambda d: edits.set_shape_parameter(d, None, "omega", 1.0))
    stage.presenter.do("λ", lambda d: edits.set_shape_parameter(d, None, "lambda2", 3.0))
    legs = eye.scenery.paper().map(stage.document.profile.control_points[:, 1:3])
    segment = int(np.hypot(*(legs[:, 1] - legs[:, 0]).T).argmax())
    stage.presenter.select(segment)
    slider = stage.slider(segment, "lambda2")
    at = eye.quartic(segment, 1)

    hover(eye.canvas, at)
    assert stage.presenter.view.hover.parameter == "lambda2"
    points = stage.document.profile.segments[segment].points
    way = eye.control(segment, 1) - eye.control(segment, 2)
    goal = eye.control(segment, 2) + way * 0.75
    press(eye.canvas, at)
    move(eye.canvas, (at + goal) / 2)
    move(eye.canvas, goal)
    release(eye.canvas, goal)
    stage.settle()
    changed = stage.document.profile.segments[segment]
    assert np.array_equal(changed.points, points)
    assert changed.shape.lambda2 == pytest.approx(4.5, abs=0.25)
    assert slider.number == changed.shape.lambda2
    assert stage.session.undo_label == f"Drag λ2 of segment {segment + 1}"
    assert far(eye.quartic(segment, 1), goal) < 1.5


def test_a_drag_beside_all_handles_orbits_and_a_click_on_a_point_selects(eye):
    segment, index = free_point(eye)
    at = eye.control(segment, index)
    before, pose = eye.stage.document, eye.view.pose
    press(eye.canvas, at)
    release(eye.canvas, at)
    assert eye.stage.presenter.view.points == frozenset({(segment, index)})
    corner = QPointF(12, eye.canvas.height() - 12)
    press(eye.canvas, corner)
    move(eye.canvas, corner + QPointF(30, 0))
    release(eye.canvas, corner + QPointF(30, 0))
    assert eye.view.pose.azimuth != pose.azimuth
    assert eye.stage.document is before


def test_the_cursor_and_a_ring_tell_what_can_be_grabbed(eye):
    at = eye.control(*free_point(eye))
    hover(eye.canvas, QPointF(12, eye.canvas.height() - 12))
    assert eye.canvas.cursor().shape() == Qt.CursorShape.ArrowCursor
    assert not eye.view.scene.lights.grips.held.actor.GetVisibility()
    hover(eye.canvas, at)
    assert eye.canvas.cursor().shape() == Qt.CursorShape.SizeAllCursor
    assert eye.view.scene.lights.grips.held.actor.GetVisibility()
    assert eye.view.hud.isVisible()


@pytest.mark.parametrize("view", ["right", "top"])
def test_seen_edge_on_a_point_moves_across_the_view(eye, view):
    eye.view.set_view_direction(view)
    eye.stage.settle()
    segment, index = free_point(eye) if view == "right" else (0, 1)
    r, h = eye.stage.document.profile.segments[segment].points[index]
    at = eye.control(segment, index)
    found = eye.scenery.pick(_screen(at))
    segment, index = found.segment, found.index
    r, h = eye.stage.document.profile.segments[segment].points[index]
    press(eye.canvas, at)
    move(eye.canvas, at + QPointF(10, -10))
    move(eye.canvas, at + QPointF(25, -30))
    release(eye.canvas, at + QPointF(25, -30))
    moved = eye.stage.document.profile.segments[segment].points[index]
    if view == "right":
        assert moved[0] == pytest.approx(r, abs=1e-9)
        assert moved[1] > h
        assert abs(eye.control(segment, index).y() - (at.y() - 30)) < 1.0
    else:
        assert moved[1] == pytest.approx(h, abs=1e-9)
        assert moved[0] != pytest.approx(r)


def test_the_end_of_the_turn_is_dragged_and_snaps(eye):
    assert eye.stage.document.revolution.sweep_deg == 360.0
    eye.view.set_view_direction("top")
    eye.stage.settle()
    ring = eye.scenery.ring
    at = eye.turn(TurnEnd.END)
    start = eye.scenery.surface.start

    def seen(degrees):
        place = ring.in_space(start + np.radians(degrees))
        return QPointF(*eye.view.lens.to_screen(place).tolist())

    press(eye.canvas, at)
    for degrees in (340, 300, 262):
        move(eye.canvas, seen(degrees - 5))
    assert eye.stage.document.revolution.sweep_deg == 255.0 or (
        eye.stage.document.revolution.sweep_deg == 270.0
    )
    eye.stage.settle()
    assert eye.view.hud.lines[0].startswith("Sweep 2")
    QTest.keyPress(eye.canvas, Qt.Key.Key_Control)
    assert eye.stage.document.revolution.sweep_deg == pytest.approx(262, abs=1.5)
    release(eye.canvas, seen(257), CTRL)
    assert eye.stage.document.revolution.sweep_deg == pytest.approx(262, abs=1.5)
    assert eye.stage.session.undo_label == "Sweep"
    eye.stage.presenter.undo()
    assert eye.stage.document.revolution.sweep_deg == 360.0


def test_the_turn_does_not_wrap_and_the_start_turns_the_whole(eye):
    eye.stage.presenter.do("Sweep", lambda d: edits.set_revolution(d, sweep_deg=345.0))
    eye.view.set_view_direction("top")
    eye.stage.settle()
    ring, surface = eye.scenery.ring, eye.scenery.surface

    def seen(angle):
        return QPointF(*eye.view.lens.to_screen(ring.in_space(angle)).tolist())

    at = eye.turn(TurnEnd.END)
    press(eye.canvas, at)
    for step in np.radians([5, 12, 20, 40, 80]):
        move(eye.canvas, seen(surface.start + surface.sweep - np.radians(5) + step))
    assert eye.stage.document.revolution.sweep_deg == 360.0
    QTest.keyClick(eye.canvas, Qt.Key.Key_Escape)
    assert eye.stage.document.revolution.sweep_deg == 345.0
    release(eye.canvas, at)
    at = eye.turn(TurnEnd.START)
    press(eye.canvas, at)
    for step in np.radians([5, 15, 31]):
        move(eye.canvas, seen(surface.start + np.radians(5) + step))
    release(eye.canvas, seen(surface.start + np.radians(36)))
    revolution = eye.stage.document.revolution
    assert (revolution.start_deg, revolution.sweep_deg) == (30.0, 345.0)
    assert eye.stage.session.undo_label == "Start angle"


def test_shift_click_adds_and_several_points_move_together(eye):
    segment, index = free_point(eye)
    other = (segment, 3 - index)
    start = eye.stage.document.profile.control_points.copy()
    for point, keys in (((segment, index), None), (other, SHIFT)):
        at = eye.control(*point)
        QTest.mouseClick(eye.canvas, LEFT, keys or Qt.KeyboardModifier.NoModifier, pos=at.toPoint())
    assert eye.stage.presenter.view.points == {(segment, index), other}
    eye.stage.settle()
    at = eye.control(segment, index)
    press(eye.canvas, at)
    move(eye.canvas, at + QPointF(12, 3))
    move(eye.canvas, at + QPointF(21, 6))
    release(eye.canvas, at + QPointF(21, 6))
    steps = eye.stage.document.profile.control_points - start
    assert steps[segment, index] == pytest.approx(steps[other])
    assert np.abs(steps[segment, index]).max() > 0


def _screen(at):
    from app.hand.coordinates import ScreenPoint

    return ScreenPoint(at.x(), at.y())


def test_the_paper_in_space_is_its_own_inverse(eye):
    paper = eye.scenery.paper()
    for r, h in ((10.0, 5.0), (-3.0, 80.0), (44.0, 120.5)):
        seen = paper.map((r, h))
        back = paper.to_design(_screen(QPointF(*seen.tolist())))
        assert back.pair == pytest.approx(DesignPoint(r, h).pair, abs=1e-9)


def test_numbers_typed_in_a_drag_are_exact(eye):
    segment, index = free_point(eye)
    at = eye.control(segment, index)
    press(eye.canvas, at)
    move(eye.canvas, at + QPointF(14, -9))
    QTest.keyClicks(eye.canvas, "51.25")
    assert eye.stage.document.profile.segments[segment].points[index][0] == 51.25
    QTest.keyClick(eye.canvas, Qt.Key.Key_Tab)
    QTest.keyClicks(eye.canvas, "12.3")
    point = eye.stage.document.profile.segments[segment].points[index]
    assert point.tolist() == [51.25, 12.3]
    release(eye.canvas, at + QPointF(14, -9))
    assert eye.stage.document.profile.segments[segment].points[index].tolist() == [51.25, 12.3]
    # The sweep too; Enter lets go.
    at = eye.turn(TurnEnd.END)
    press(eye.canvas, at)
    move(eye.canvas, at + QPointF(-20, 0))
    move(eye.canvas, at + QPointF(-40, 2))
    QTest.keyClicks(eye.canvas, "217.5")
    assert eye.stage.document.revolution.sweep_deg == 217.5
    QTest.keyClick(eye.canvas, Qt.Key.Key_Return)
    assert eye.stage.session.undo_label == "Sweep"
    move(eye.canvas, at + QPointF(-90, 20))
    release(eye.canvas, at + QPointF(-90, 20))
    assert eye.stage.document.revolution.sweep_deg == 217.5
