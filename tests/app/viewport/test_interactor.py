"""The drawing widget without and with a graphics card: the same pictures, drawn as seldom."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QLabel

from app.viewport import interactor
from tests.app.mouse import drag
from tests.app.viewport.helpers import document
from tests.app.viewport.test_view import Stage


def stage_of(qtbot, monkeypatch, software):
    monkeypatch.setattr(interactor, "draws_in_software", lambda: software)
    return Stage(qtbot, document())


@pytest.fixture
def raster(qtbot, monkeypatch):
    stage = stage_of(qtbot, monkeypatch, software=True)
    yield stage
    stage.view.shut_down()
    stage.window.close()


def test_this_machine_is_told_by_its_renderer(qtbot):
    """The tests' screen has no graphics card."""
    assert interactor.draws_in_software()


def test_painted_and_composed_pictures_are_the_same(qtbot, monkeypatch):
    pictures = []
    for software in (True, False):
        stage = stage_of(qtbot, monkeypatch, software)
        assert isinstance(stage.canvas, QOpenGLWidget) != software
        pictures.append(stage.pixels().astype(int))
        before = stage.view.pose
        middle = QPoint(stage.canvas.width() // 4, stage.canvas.height() // 2)
        drag(stage.canvas, middle, middle + QPoint(60, 0))
        assert stage.view.pose.azimuth != before.azimuth
        stage.settle()
        pictures.append(stage.pixels().astype(int))
        stage.view.shut_down()
    stage.window.close()
    painted, turned, composed, other = pictures
    assert np.ptp(painted) > 150
    assert np.abs(painted - composed).max() <= 1
    assert np.abs(turned - other).max() <= 1
    assert (np.abs(painted - turned).max(axis=2) > 20).mean() > 0.005


def test_what_is_on_the_screen_is_the_picture(raster):
    """Painted where the window is: not above, below or beside it, and not upside down."""
    shown = raster.canvas.grab().toImage()
    asked = raster.canvas.grabFramebuffer()
    assert shown.size() == asked.size()
    places = [(x, y) for x in (30, 200, 300) for y in (20, 150, 250, 330)]
    for x, y in places:
        one, other = shown.pixelColor(x, y), asked.pixelColor(x, y)
        assert one.getRgb()[:3] == pytest.approx(other.getRgb()[:3], abs=1), (x, y)


def test_uncovering_paints_the_last_picture_and_draws_none(qtbot, raster):
    painted = []
    raster.canvas.frameSwapped.connect(lambda: painted.append(None))
    before = raster.drawn
    cover = QLabel("cover", raster.canvas)
    cover.setGeometry(20, 20, 80, 40)
    cover.show()
    qtbot.waitUntil(lambda: bool(painted))
    shown = len(painted)
    cover.hide()
    qtbot.waitUntil(lambda: len(painted) > shown)
    assert raster.drawn == before


def test_a_picture_of_fewer_pixels_fills_the_widget(raster):
    whole = raster.pixels().astype(int)
    raster.canvas.ren_win.SetSize(raster.canvas.width() // 2, raster.canvas.height() // 2)
    raster.wait_for_drawing()
    coarse = raster.pixels().astype(int)
    assert coarse.shape == whole.shape
    # In its place and as large, only less sharp: lines differ, areas do not.
    apart = np.abs(coarse - whole).mean()
    assert 0.0 < apart < 0.5 * np.abs(coarse - np.roll(whole, 30, axis=1)).mean()
    assert apart < 0.5 * np.abs(coarse - whole[::-1]).mean()
