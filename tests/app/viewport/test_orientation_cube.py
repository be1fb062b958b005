"""The orientation cube, gliding views and navigation styles, in a window by real events."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

from app.scene.camera import standard_pose
from app.scene.standard_views import STANDARD_VIEWS
from app.state import preferences
from app.viewport.camera_transition import between
from app.viewport.mouse_styles import STYLES, Hand
from sgb_core.surfaces.revolution import Axis
from tests.app.mouse import CTRL, SHIFT, drag
from tests.app.viewport.helpers import document
from tests.app.viewport.test_view import Stage

LEFT, MIDDLE, RIGHT = (
    Qt.MouseButton.LeftButton,
    Qt.MouseButton.MiddleButton,
    Qt.MouseButton.RightButton,
)
NONE = Qt.KeyboardModifier.NoModifier


@pytest.fixture
def stage(qtbot):
    made = Stage(qtbot, document())
    yield made
    made.view.shut_down()
    made.window.close()


@pytest.mark.parametrize("name", ["front", "right", "top"])
def test_a_click_on_a_face_looks_from_there(stage, name):
    cube = stage.view.cube
    place = cube.face_centre(name)
    QTest.mouseClick(cube, LEFT, pos=place.toPoint())
    stage.settle()
    assert (stage.view.pose.azimuth, stage.view.pose.elevation) == pytest.approx(
        STANDARD_VIEWS[name].direction
    )
    assert stage.view.scene.pose == stage.view.pose
    # Seen from there the face is in the middle of the cube.
    middle = QPointF(cube.width() / 2, cube.height() / 2)
    assert (cube.face_centre(name) - middle).manhattanLength() < 0.01


def test_edges_and_corners_look_from_between(stage):
    cube = stage.view.cube
    directions = set()
    for x in range(0, cube.width(), 3):
        for y in range(0, cube.height(), 3):
            zone = cube.zone_at(QPointF(x, y))
            if zone is not None:
                directions.add(zone.direction)
    kinds = {sum(map(abs, direction)) for direction in directions}
    assert kinds == {1, 2, 3}
    assert cube.zone_at(QPointF(1, 1)) is None


def test_a_drag_on_the_cube_orbits(stage):
    pose = stage.view.pose
    drag(stage.view.cube, QPointF(48, 48), QPointF(68, 40))
    assert stage.view.pose.azimuth < pose.azimuth
    assert stage.view.pose.distance == pose.distance


@pytest.mark.parametrize("axis", list(Axis))
@pytest.mark.parametrize("parallel", [False, True])
def test_a_glide_turns_about_the_pivot_and_ends_at_the_goal(axis, parallel):
    first = replace(standard_pose(axis, "left"), distance=5.0, focal=(1.0, 2.0, 0.5))
    goal = replace(
        first.turned_to(*STANDARD_VIEWS["back"].direction), distance=8.0, parallel=parallel
    )
    poses = [between(first, goal, part) for part in np.linspace(0.0, 1.0, 21)]
    assert poses[-1] is goal
    assert poses[0].basis == pytest.approx(first.basis)
    assert poses[0].focal == pytest.approx(first.focal)
    for one, other in pairwise(poses):
        assert abs(other.azimuth - one.azimuth) % (2 * np.pi) < 0.3 or other is goal
    for pose in poses[1:-1]:
        offset = pose.basis @ (np.asarray(pose.focal) - pose.pivot)
        assert offset == pytest.approx(first.basis @ (np.asarray(first.focal) - first.pivot))


def test_views_change_smoothly_and_the_next_input_stops_them(stage, qtbot):
    # Slowly enough for a machine that draws few pictures in a second.
    stage.view._glide._animation.setDuration(5000)
    seen = []
    stage.view.plotter.ren_win.AddObserver(
        "EndEvent", lambda *_: seen.append(stage.view.scene.pose.azimuth)
    )

    def is_between(start, goal):
        low, high = sorted((start, goal))
        return any(low + 0.01 < azimuth < high - 0.01 for azimuth in seen)

    start, goal = stage.view.pose.azimuth, STANDARD_VIEWS["back"].azimuth
    stage.view.set_view_direction("back")
    assert stage.view.pose.azimuth == goal
    qtbot.waitUntil(lambda: is_between(start, goal))
    stage.view._glide._animation.setDuration(200)
    stage.settle()
    assert seen[-1] == goal
    seen.clear()
    stage.view._glide._animation.setDuration(5000)
    stage.view.set_view_direction("front")
    qtbot.waitUntil(lambda: is_between(goal, STANDARD_VIEWS["front"].azimuth))
    stage.wheel(QPoint(100, 100), 1)
    stopped = stage.view.pose
    assert stopped.azimuth != STANDARD_VIEWS["front"].azimuth
    QTest.qWait(100)
    assert stage.view.pose == stopped
    assert stage.view.scene.pose == stopped


def test_the_preference_switches_it_off(stage):
    preferences.change(animate_views=False)
    stage.view.set_view_direction("top")
    assert stage.view.scene.pose == stage.view.pose
    assert stage.view.pose.elevation == STANDARD_VIEWS["top"].elevation


def test_the_projection_changes_through_ever_flatter_perspective(stage):
    openings = []
    stage.view.plotter.ren_win.AddObserver(
        "EndEvent", lambda *_: openings.append(stage.view.scene.pose.opening)
    )
    QTest.keyClick(stage.canvas, Qt.Key.Key_P)
    stage.settle()
    assert stage.view.scene.pose.parallel
    assert stage.view.scene.pose.opening == 1.0
    middle = [opening for opening in openings if opening < 1.0]
    assert middle == sorted(middle, reverse=True)


@pytest.mark.parametrize(
    ("style", "button", "keys", "hand"),
    [
        ("studio", LEFT, NONE, Hand.ORBIT),
        ("studio", MIDDLE, NONE, Hand.PAN),
        ("blender", MIDDLE, NONE, Hand.ORBIT),
        ("blender", MIDDLE, SHIFT, Hand.PAN),
        ("blender", MIDDLE, CTRL, Hand.ZOOM),
        ("blender", LEFT, NONE, Hand.IDLE),
        ("rhino", RIGHT, NONE, Hand.ORBIT),
        ("rhino", RIGHT, SHIFT, Hand.PAN),
        ("rhino", RIGHT, CTRL, Hand.ZOOM),
        ("fusion", MIDDLE, NONE, Hand.PAN),
        ("fusion", MIDDLE, SHIFT, Hand.ORBIT),
    ],
)
def test_navigation_styles(stage, style, button, keys, hand):
    stage.view.set_navigation_style(style)
    pose = stage.view.pose
    start, end = QPoint(30, 250), QPoint(60, 230)
    drag(stage.canvas, start, end, button=button, modifiers=keys)
    after = stage.view.pose
    did = Hand.IDLE
    if after.azimuth != pose.azimuth:
        did = Hand.ORBIT
    elif after.distance != pose.distance:
        did = Hand.ZOOM
    elif after.focal != pose.focal:
        did = Hand.PAN
    assert did is hand


def test_styles_have_titles_and_unknown_ones_are_refused(stage):
    assert [style.title for style in STYLES.values()] == [
        "SGB Studio",
        "Blender",
        "Rhino",
        "Fusion",
    ]
    with pytest.raises(KeyError):
        stage.view.set_navigation_style("paint")


def test_keys_move_the_camera(stage):
    pose = stage.view.pose
    QTest.keyClick(stage.canvas, Qt.Key.Key_Right)
    assert stage.view.pose.azimuth == pytest.approx(pose.azimuth + np.radians(15))
    pose = stage.view.pose
    QTest.keyClick(stage.canvas, Qt.Key.Key_Up, SHIFT)
    assert stage.view.pose.focal != pose.focal
    QTest.keyClick(stage.canvas, Qt.Key.Key_Plus)
    assert stage.view.pose.distance < pose.distance


@pytest.mark.parametrize("parallel", [False, True])
def test_zoom_keeps_what_is_under_the_cursor_within_a_pixel(stage, parallel):
    if parallel:
        QTest.keyClick(stage.canvas, Qt.Key.Key_P)
        stage.settle()
    at = QPoint(300, 120)
    lens = stage.view.lens
    half = lens.height / 2
    x, y = (at.x() - lens.width / 2) / half, 1 - at.y() / half
    right, up, _ = lens.pose.basis
    place = np.asarray(lens.pose.focal) + (right * x + up * y) * lens.pose.parallel_scale
    assert lens.to_screen(place) == pytest.approx((at.x(), at.y()), abs=1e-9)
    stage.wheel(at, 5)
    assert stage.view.lens.to_screen(place) == pytest.approx((at.x(), at.y()), abs=1e-6)
