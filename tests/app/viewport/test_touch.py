"""The viewport under fingers, a pen and a held right button; bands dragged on the surface."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.hand.features import Kind, edge_places
from app.hand.hit_test import Target
from app.scene.standard_views import STANDARD_VIEWS
from app.state.cut import Cut
from app.viewport.handles import TurnEnd
from app.widgets.radial_menu import RadialMenu
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.appearance.model import Layer
from sgb_core.document.model import Document
from tests.app import fingers
from tests.app.mouse import CTRL, drag, hover
from tests.app.viewport.test_hand import Eye, free_point
from tests.app.window_stage import WindowStage


@pytest.fixture
def eye(qtbot):
    stage = WindowStage(qtbot)
    yield Eye(stage)
    stage.close()


def rings():
    return [each for each in QApplication.topLevelWidgets() if isinstance(each, RadialMenu)]


def test_two_fingers_orbit_and_zoom_and_a_pen_drags(eye):
    before, a, b = eye.view.pose, QPointF(200, 200), QPointF(300, 200)
    fingers.touch(eye.canvas, f0=("press", a), f1=("press", b))
    fingers.touch(eye.canvas, f0=("move", a + QPointF(60, 0)), f1=("move", b + QPointF(60, 0)))
    fingers.touch(eye.canvas, f0=("move", a + QPointF(10, 0)), f1=("move", b + QPointF(110, 0)))
    fingers.touch(eye.canvas, f0=("release", a), f1=("release", b))
    assert eye.view.pose.azimuth != before.azimuth
    assert eye.view.pose.parallel_scale == pytest.approx(before.parallel_scale / 2.0, rel=0.02)
    eye.view.fit(smooth=False)
    eye.stage.settle()
    segment, index = free_point(eye)
    at = eye.control(segment, index)
    to = at + QPointF(30, -20)
    for kind, place in (
        ("Press", at),
        ("Move", at + QPointF(9, -6)),
        ("Move", to),
        ("Release", to),
    ):
        fingers.pen(eye.canvas, kind, place, Qt.KeyboardModifier.ControlModifier)
    assert eye.stage.session.undo_label == f"Move P{index} of segment {segment + 1}"


def test_a_band_is_dragged_on_the_surface(eye):
    layer = Layer("band", color="#aa3311", start=0.3, end=0.6)
    eye.stage.presenter.do("Paint", lambda d: edits.set_appearance(d, drawing=(layer,)))
    eye.stage.presenter.set_view(show=frozenset({*eye.stage.presenter.view.show} - {"polygon"}))
    eye.stage.settle()
    place = edge_places(eye.stage.document.profile, layer, upper=True)[0]
    paper = eye.scenery.paper()
    at, to = (QPointF(*paper.map((place[0], place[1] + up)).tolist()) for up in (0.0, 12.0))
    hover(eye.canvas, at)
    assert eye.view.hand.active.feature.kind is Kind.BAND
    assert any("Painted band" in line for line in eye.view.hud.lines)
    drag(eye.canvas, at, to)
    eye.stage.settle()
    moved = eye.stage.document.appearance.drawing[0]
    low, high = (corner[1] for corner in eye.stage.document.profile.bounds())
    assert moved.end == pytest.approx(0.6 + 12.0 / (high - low), abs=0.02)
    assert moved.start == 0.3
    assert eye.stage.session.undo_label == "Painted band"


def test_wall_and_fill_line_are_dragged_in_the_section(eye):
    wall = Profile.of([line((0, 0), (30, 0)), line((30, 0), (40, 80))])
    cup = edits.set_fill(edits.set_solid(Document(wall), kind="vessel", wall=5, base=8), 50)
    eye.stage.presenter.replace_document(cup)
    eye.stage.presenter.set_view(cut=Cut.SECTION, snap=False)
    eye.stage.settle()

    def at(place):
        return QPointF(*eye.scenery.paper().map(place).tolist())

    hover(eye.canvas, at((12.0, 50.0)))
    assert eye.view.hand.active.target is Target.LEVEL
    drag(eye.canvas, at((12.0, 50.0)), at((12.0, 62.0)), modifiers=CTRL)
    assert eye.stage.document.manufacture.fill.height == pytest.approx(62.0, abs=0.5)
    eye.stage.settle()
    inner = (35.0 - 4.96, 40.0 + 0.62)
    hover(eye.canvas, at(inner))
    assert eye.view.hand.active.feature.kind is Kind.WALL
    drag(eye.canvas, at(inner), at((35.0 - 7.94, 40.0 + 0.99)))
    assert eye.stage.document.solid.wall == pytest.approx(8.0, abs=0.4)
    assert [each.label for each in eye.stage.session.history[1:]] == ["Fill line", "Wall"]


def test_the_right_button_held_still_opens_a_ring_for_the_turn(eye):
    at = eye.turn(TurnEnd.END).toPoint()
    hover(eye.canvas, QPointF(at))
    QTest.mousePress(eye.canvas, Qt.MouseButton.RightButton, Qt.KeyboardModifier.NoModifier, at)
    eye.stage.until(lambda: bool(rings()))
    (ring,) = rings()
    words = [ring._text(k) for k in range(len(ring.actions_shown))]
    QTest.keyClick(ring, Qt.Key(Qt.Key.Key_1 + words.index("3  Half a turn")))
    QTest.mouseRelease(eye.canvas, Qt.MouseButton.RightButton, Qt.KeyboardModifier.NoModifier, at)
    eye.stage.settle()
    assert eye.stage.document.revolution.sweep_deg == 180.0
    assert eye.stage.session.undo_label == "Sweep"


def test_over_what_cannot_be_grabbed_the_ring_is_that_of_the_view(eye):
    at = QPoint(8, eye.canvas.height() // 2)
    eye.view.set_view_direction("iso")
    hover(eye.canvas, QPointF(at))
    QTest.mousePress(eye.canvas, Qt.MouseButton.RightButton, Qt.KeyboardModifier.NoModifier, at)
    eye.stage.until(lambda: bool(rings()))
    (ring,) = rings()
    words = [ring._text(k) for k in range(len(ring.actions_shown))]
    place = next(k for k, text in enumerate(words) if text.endswith("Top"))
    QTest.keyClick(ring, Qt.Key(Qt.Key.Key_1 + place))
    QTest.mouseRelease(eye.canvas, Qt.MouseButton.RightButton, Qt.KeyboardModifier.NoModifier, at)
    eye.stage.settle()
    assert (eye.view.pose.azimuth, eye.view.pose.elevation) == STANDARD_VIEWS["top"].direction
    assert eye.stage.session.history[1:] == ()
