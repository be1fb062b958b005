"""A texture grabbed on the surface in the viewport, by real mouse and key events."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest

from app.hand.coordinates import ScreenPoint
from app.viewport.handles import Scenery
from app.viewport.texture_handle import Sheet, TextureGrip
from sgb_core.document import edits
from sgb_core.document.appearance.model import Texture
from sgb_core.surfaces.placement import Placement
from tests.app.mouse import SHIFT, hover, move, press, release
from tests.app.window_stage import WindowStage

LOTUS = (Texture("lotus", repeat=(6.0, 3.0)),)


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot)
    made.window.files.new_from_preset("vase")
    made.presenter.do("Look", lambda d: edits.set_appearance(d, textures=LOTUS))
    made.settle()
    yield made
    made.close()


def scenery(stage):
    return Scenery(stage.presenter.frame, stage.window.surface_view.lens)


def grip(stage):
    """Where the handle of the texture is seen."""
    seen = scenery(stage)
    return QPointF(*seen.lens.to_screen(seen.texture_places)[0].tolist())


def offset(stage):
    return np.array(stage.document.appearance.textures[0].offset)


def on_surface(stage, at):
    """The (u, v) that is seen at a pixel near the handle."""
    seen = scenery(stage)
    sheet = Sheet.of(seen.frame.document, seen.lens)
    return sheet.under(ScreenPoint(at.x(), at.y()), seen.textures[0])


@pytest.mark.parametrize("axis", ["z", "x"])
def test_the_picture_goes_with_the_hand_over_the_surface(stage, axis):
    placed = Placement((10.0, -15.0, 20.0), (12.0, -7.0, 30.0))
    stage.presenter.do("Axis", lambda d: edits.set_revolution(d, axis=axis, sweep_deg=300.0))
    stage.presenter.do("Place", lambda d: replace(d, placement=placed))
    stage.settle()
    stage.window.surface_view.fit(smooth=False)
    stage.settle()
    canvas, at = stage.window.surface_view.plotter, grip(stage)
    steps, pose = len(stage.session.history), stage.window.surface_view.pose
    hover(canvas, at.toPoint())
    assert stage.window.surface_view.hand.active == TextureGrip(0)
    assert stage.window.surface_view.hud.lines[0] == "Texture"
    goal = QPointF(at.toPoint()) + QPointF(22.0, -31.0)
    start = np.array(on_surface(stage, QPointF(at.toPoint())))
    press(canvas, at)
    move(canvas, at + QPointF(6.0, -8.0))
    move(canvas, goal)
    release(canvas, goal)
    end = np.array(on_surface(stage, goal))
    # Six tiles around and three along slide with the place that was grabbed.
    falls = stage.document.profile.control_points[0, 0, 1] > 0.0
    way = (end - start) * (6.0, -3.0 if falls else 3.0)
    assert offset(stage) == pytest.approx(-way, abs=0.02)
    assert np.abs(way).min() > 0.02
    assert len(stage.session.history) == steps + 1
    assert stage.session.undo_label == "Texture"
    assert stage.window.surface_view.pose == pose
    stage.session.undo()
    assert offset(stage).tolist() == [0.0, 0.0]


def test_shift_holds_it_around_and_escape_lays_it_back(stage):
    canvas, at, before = stage.window.surface_view.plotter, grip(stage), stage.document
    press(canvas, at)
    for goal in (at + QPointF(8.0, 2.0), at + QPointF(30.0, 9.0)):
        QTest.mouseMove(canvas, goal.toPoint())
        move(canvas, goal)
    stage.settle()
    both = offset(stage)
    assert both[1] != 0.0
    QTest.keyPress(canvas, Qt.Key.Key_Shift, SHIFT)
    assert offset(stage)[1] == 0.0
    assert offset(stage)[0] == pytest.approx(both[0], abs=1e-6)
    QTest.keyRelease(canvas, Qt.Key.Key_Shift)
    QTest.keyClick(canvas, Qt.Key.Key_Escape)
    assert stage.document is before
    release(canvas, at)
    assert stage.document is before


def test_its_menu_takes_the_shift_back(stage):
    shifted = (Texture("lotus", repeat=(6.0, 3.0), offset=(0.25, 0.5)),)
    stage.presenter.do("Look", lambda d: edits.set_appearance(d, textures=shifted))
    stage.settle()
    at = grip(stage)
    menu = stage.window.surface_view.hand.menu(ScreenPoint(at.x(), at.y()), stage.window)
    menu.actions()[0].trigger()
    assert offset(stage).tolist() == [0.0, 0.0]
    menu.actions()[1].trigger()
    assert stage.document.appearance.textures == ()


def test_it_stands_on_the_side_that_faces_the_viewer(stage):
    view = stage.window.surface_view
    for azimuth in (0.3, 1.9, 3.5, 5.1):
        view.look_from(azimuth, 0.2)
        stage.settle()
        seen = scenery(stage)
        place = seen.texture_places[0]
        r = np.hypot(*place[:2])
        outwards = np.array((place[0], place[1], 0.0)) / r
        # Within half a tile of the side that faces: 30 degrees of it.
        back = view.pose.basis[2] * (1.0, 1.0, 0.0)
        assert outwards @ back / np.hypot(*back[:2]) > np.cos(np.radians(31.0))
