"""The live viewport with real events, in a window on the (virtual) screen."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QImage, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMainWindow

from app.scene.standard_views import STANDARD_VIEWS
from app.theme import theme
from app.viewport.view import SurfaceView
from sgb_core.document.model import Revolution
from sgb_core.surfaces.revolution import Axis
from tests.app.mouse import double_click, drag
from tests.app.viewport.helpers import DRUM, FakePresenter, document, reshaped
from tests.app.waiting import is_drawn, let_turn


class Stage:
    """A window with a viewport, its presenter, and a count of what was drawn."""

    def __init__(self, qtbot, doc):
        theme.apply(QApplication.instance(), "light")
        self.qtbot = qtbot
        self.presenter = FakePresenter(doc)
        self.window = QMainWindow()
        self.view = SurfaceView(self.presenter)
        self.presenter.target = self.view
        self.window.setCentralWidget(self.view)
        self.window.resize(480, 360)
        self.presenter.send()
        self.window.show()
        qtbot.waitUntil(lambda: self.view.scene is not None)
        self.drawn = 0
        self.view.plotter.ren_win.AddObserver("EndEvent", self._count)
        self.settle()

    def _count(self, *_event):
        self.drawn += 1

    @property
    def canvas(self):
        return self.view.plotter

    def settle(self):
        """Wait until the picture is refined and drawn."""
        let_turn()
        self.qtbot.waitUntil(lambda: is_drawn(self.view))
        self.wait_for_drawing()

    def wait_for_drawing(self):
        """Wait until what has been changed is drawn; updates that are due go into one drawing."""
        before = self.drawn
        self.canvas.update()
        self.qtbot.waitUntil(lambda: self.drawn > before)

    def pixels(self):
        """What the window shows, shape (h, w, 3)."""
        let_turn()
        picture = self.view.plotter.grabFramebuffer().convertToFormat(QImage.Format.Format_RGB888)
        rows = np.frombuffer(picture.constBits(), np.uint8)
        rows = rows.reshape(picture.height(), picture.bytesPerLine())
        return rows[:, : picture.width() * 3].reshape(picture.height(), picture.width(), 3).copy()

    def wheel(self, at, steps):
        event = QWheelEvent(
            QPointF(at),
            QPointF(self.canvas.mapToGlobal(at)),
            QPoint(),
            QPoint(0, 120 * steps),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(self.canvas, event)


@pytest.fixture
def stage(qtbot):
    made = Stage(qtbot, document())
    yield made
    made.view.shut_down()
    made.window.close()


def test_the_window_is_not_made_anew_when_the_drawing_begins(qtbot):
    window = QMainWindow()
    presenter = FakePresenter(document())
    view = SurfaceView(presenter)
    window.setCentralWidget(view)
    window.show()
    qtbot.waitExposed(window)
    before = window.winId()
    qtbot.waitUntil(lambda: view.scene is not None)
    let_turn()
    assert window.winId() == before
    view.shut_down()
    window.close()


def test_a_driver_that_fails_is_reported_and_the_window_lives(qtbot, monkeypatch):
    presenter = FakePresenter(document())
    said = []
    presenter.notify = lambda text, level: said.append((text, level))
    view = SurfaceView(presenter)
    qtbot.addWidget(view)

    def fail():
        raise RuntimeError("no OpenGL here")

    monkeypatch.setattr(view, "_build", fail)
    view.show()
    qtbot.waitUntil(lambda: bool(said))
    assert said == [("The 3-D view could not start: no OpenGL here", "error")]
    view.refresh(presenter.frame)
    view.fit()
    view.shut_down()


def test_shows_the_surface_and_then_rests(stage):
    pixels = stage.pixels().astype(int)
    is_green = (pixels[..., 1] > pixels[..., 0] + 12) & (pixels[..., 1] > pixels[..., 2] + 12)
    assert is_green.mean() > 0.08
    stage.drawn = 0
    QTest.qWait(1000)
    assert stage.drawn == 0


def test_an_edit_changes_pixels_and_not_the_camera(stage):
    before, pose = stage.pixels(), stage.view.pose
    stage.presenter.edit(reshaped(document(), 1.0))
    stage.settle()
    assert not np.array_equal(before, stage.pixels())
    assert stage.view.pose == pose


def test_many_edits_in_one_turn_are_drawn_once(stage, qtbot):
    stage.drawn = 0
    for omega in np.linspace(0, 1, 20):
        stage.presenter.edit(reshaped(document(), float(omega)), dragging=True)
    qtbot.waitUntil(lambda: stage.drawn > 0)
    QTest.qWait(100)
    assert stage.drawn == 1


def test_plain_while_dragging_refined_when_the_hand_rests(stage):
    window = stage.view.plotter.ren_win
    assert window.GetMultiSamples() > 0
    stage.presenter.edit(reshaped(document(), 0.2), dragging=True)
    assert not stage.view._refined
    assert window.GetMultiSamples() == 0
    QTest.qWait(400)
    # The hand holds still without letting go: nothing is refined under it.
    assert not stage.view._refined
    stage.presenter.edit(stage.presenter.document, dragging=False)
    stage.settle()
    assert window.GetMultiSamples() > 0


def test_in_place_drawing_equals_a_fresh_window(stage, qtbot):
    changed = reshaped(document(), 0.95)
    stage.presenter.edit(changed, dragging=True)
    stage.presenter.edit(changed, dragging=False)
    stage.settle()
    seen = stage.pixels()
    other = Stage(qtbot, changed)
    other.view.move_camera(stage.view.pose)
    other.view.hand_rested()
    other.settle()
    assert np.array_equal(seen, other.pixels())
    other.view.shut_down()
    other.window.close()


def test_hiding_overlays_by_the_menu(stage):
    for overlay, action in stage.view.buttons.overlays.items():
        before = stage.pixels()
        assert action.isChecked() == (overlay in stage.presenter.view.show)
        action.trigger()
        stage.settle()
        assert action.isChecked() == (overlay in stage.presenter.view.show)
        if overlay in ("liquid", "print"):
            # A bare surface holds none, and no path is planned outside a window.
            continue
        assert not np.array_equal(before, stage.pixels()), overlay


def test_left_drag_orbits_without_roll(stage):
    pose = stage.view.pose
    drag(stage.canvas, QPoint(200, 200), QPoint(260, 180))
    after = stage.view.pose
    assert after.azimuth < pose.azimuth
    assert after.elevation < pose.elevation
    assert after.distance == pose.distance
    assert abs(after.basis[0][2]) < 1e-12


def test_looking_around_is_drawn_as_coarsely_as_the_hand_needs(stage):
    view = stage.view
    view._resolution.coarse = True
    view.move_camera(view.pose)
    assert view.scene.halved
    view._resolution.coarse = False
    view.move_camera(view.pose)
    assert not view.scene.halved


@pytest.mark.parametrize(
    ("button", "modifiers"),
    [
        (Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ShiftModifier),
        (Qt.MouseButton.MiddleButton, Qt.KeyboardModifier.NoModifier),
    ],
)
def test_shift_or_middle_drag_pans(stage, button, modifiers):
    pose = stage.view.pose
    drag(stage.canvas, QPoint(200, 200), QPoint(240, 230), button=button, modifiers=modifiers)
    after = stage.view.pose
    assert (after.azimuth, after.elevation) == (pose.azimuth, pose.elevation)
    step = (np.subtract(after.focal, pose.focal) @ pose.basis.T)[:2]
    half = stage.canvas.height() / 2
    assert step / pose.parallel_scale == pytest.approx([-40 / half, 30 / half], abs=1e-6)


def test_wheel_zooms_at_the_cursor(stage):
    pose = stage.view.pose
    at = QPoint(120, 90)
    stage.wheel(at, 2)
    after = stage.view.pose
    assert after.distance < pose.distance
    half = stage.canvas.height() / 2
    x, y = (at.x() - stage.canvas.width() / 2) / half, 1 - at.y() / half
    right, up, _ = pose.basis
    fixed = np.asarray(pose.focal) + (x * right + y * up) * pose.parallel_scale
    moved = np.asarray(after.focal) + (x * right + y * up) * after.parallel_scale
    assert fixed == pytest.approx(moved, abs=1e-9)


def test_double_click_sets_the_pivot_on_the_surface(stage):
    middle = QPoint(stage.canvas.width() // 2, stage.canvas.height() // 2)
    pose = stage.view.pose
    double_click(stage.canvas, middle)
    pivot = np.asarray(stage.view.pose.pivot)
    assert stage.view.pose.focal == pose.focal
    # In front of the axis, on the side of the viewer.
    assert (pivot - pose.pivot) @ pose.basis[2] > 5.0
    double_click(stage.canvas, QPoint(3, 3))
    assert stage.view.pose.pivot == tuple(pivot)


@pytest.mark.parametrize(
    ("key", "plain", "opposite"),
    [
        (Qt.Key.Key_1, "front", "back"),
        (Qt.Key.Key_3, "right", "left"),
        (Qt.Key.Key_7, "top", "bottom"),
    ],
)
def test_keys_give_standard_views(stage, key, plain, opposite):
    QTest.keyClick(stage.canvas, key)
    assert (stage.view.pose.azimuth, stage.view.pose.elevation) == STANDARD_VIEWS[plain].direction
    QTest.keyClick(stage.canvas, key, Qt.KeyboardModifier.ControlModifier)
    assert (stage.view.pose.azimuth, stage.view.pose.elevation) == STANDARD_VIEWS[
        opposite
    ].direction


def test_p_changes_the_projection_and_f_fits(stage):
    QTest.keyClick(stage.canvas, Qt.Key.Key_P)
    assert stage.presenter.view.projection == "parallel"
    assert stage.view.pose.parallel
    assert stage.view.buttons.projection.isChecked()
    QTest.keyClick(stage.canvas, Qt.Key.Key_P)
    home = stage.view.pose
    stage.wheel(QPoint(50, 50), -6)
    assert stage.view.pose.distance > 1.5 * home.distance
    QTest.keyClick(stage.canvas, Qt.Key.Key_F)
    assert stage.view.pose.distance == pytest.approx(home.distance, rel=0.02)


def test_another_file_is_fitted_and_another_axis_is_not(stage):
    pose = stage.view.pose
    stage.presenter.edit(replace(document(), revolution=Revolution(Axis.X)))
    assert stage.view.pose == pose.carried_to(Axis.X)
    stage.presenter.generation += 1
    stage.presenter.edit(document(DRUM))
    assert stage.view.pose.distance < pose.distance / 10


def test_resizing_refits_only_what_nobody_has_touched(stage):
    def resize(width, height):
        stage.window.resize(width, height)
        stage.settle()

    fitted = stage.view.pose
    resize(300, 420)
    narrow = stage.view.pose
    assert narrow.distance > fitted.distance
    stage.presenter.edit(reshaped(document(), 0.9))
    resize(480, 360)
    assert stage.view.pose == narrow
    stage.view.fit()
    stage.wheel(QPoint(100, 100), 1)
    moved = stage.view.pose
    resize(300, 420)
    assert stage.view.pose == moved


def test_pictures_are_drawn_at_any_size(stage):
    width, height = 3 * stage.view.width(), 3 * stage.view.height()
    large = QImage.fromData(stage.view.picture((width, height), transparent=False), "PNG")
    assert (large.width(), large.height()) == (width, height)
    clear = QImage.fromData(stage.view.picture((60, 90), transparent=True), "PNG")
    assert clear.pixelColor(1, 1).alpha() == 0
    assert clear.pixelColor(30, 45).alpha() == 255
    stage.drawn = 0
    QTest.qWait(100)
    assert stage.drawn == 0


def test_theme_changes_recolour_the_ground(stage):
    light = stage.pixels()[5, 5]
    theme.apply(QApplication.instance(), "dark")
    dark = stage.pixels()[5, 5]
    theme.apply(QApplication.instance(), "light")
    assert int(dark.max()) < int(light.min()) - 60


def test_pressing_over_the_buttons_does_not_move_the_camera(stage):
    pose = stage.view.pose
    buttons = stage.view.buttons
    assert stage.view.rect().contains(buttons.geometry())
    QApplication.sendEvent(buttons, QEvent(QEvent.Type.Enter))
    assert stage.view.pose == pose


def test_nothing_is_loaded_before_the_first_paint(qtbot):
    presenter = FakePresenter(document())
    view = SurfaceView(presenter)
    qtbot.addWidget(view)
    view.refresh(presenter.frame)
    view.fit()
    view.set_view_direction("top")
    assert view.scene is None
    assert view.plotter is None
    view.shut_down()
