"""The axis grabbed at its tip in the viewport, by real mouse and key events."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest

from app.viewport.axis_handle import AxisTip
from app.viewport.handles import Scenery
from sgb_core.document import edits
from sgb_core.surfaces.revolution import Axis
from tests.app.mouse import hover, move, press, release
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot)
    made.window.files.new_from_preset("vase")
    made.settle()
    yield made
    made.close()


def tip(stage, axis):
    """Where the end of an axis is seen."""
    view = stage.window.surface_view
    scenery = Scenery(stage.presenter.frame, view.lens)
    return QPointF(*view.lens.to_screen(scenery.axes.tip(axis))[0].tolist())


def test_the_axis_follows_the_hand_to_x_and_y_as_one_undo_step(stage):
    canvas, before = stage.window.surface_view.plotter, stage.document
    pose = stage.window.surface_view.pose
    at = tip(stage, Axis.Z)
    hover(canvas, at.toPoint())
    assert stage.window.surface_view.hand.active == AxisTip()
    goals = [tip(stage, Axis.Y), tip(stage, Axis.X)]
    press(canvas, at)
    for goal, axis in zip(goals, (Axis.Y, Axis.X), strict=True):
        move(canvas, goal)
        stage.settle()
        assert stage.document.revolution.axis is axis
        assert stage.window.surface_view.pose == pose
        # The handle is under the hand that holds it.
        here = tip(stage, axis)
        assert np.hypot(here.x() - goal.x(), here.y() - goal.y()) < 1.0
    release(canvas, goals[-1])
    assert [entry.label for entry in stage.session.history[1:]] == ["Axis"]
    stage.settle()
    # The camera stood still under the hand; now it stands to the new axis as it did to the old.
    assert stage.window.surface_view.pose == pose.carried_to(Axis.X)
    stage.session.undo()
    assert stage.document is before


def test_escape_lays_the_axis_back(stage):
    canvas, before = stage.window.surface_view.plotter, stage.document
    at, goal = tip(stage, Axis.Z), tip(stage, Axis.X)
    press(canvas, at)
    move(canvas, goal)
    assert stage.document.revolution.axis is Axis.X
    QTest.keyClick(canvas, Qt.Key.Key_Escape)
    assert stage.document is before
    release(canvas, goal)
    assert len(stage.session.history) == 1


def test_the_tip_stands_over_a_placed_profile_too(stage):
    stage.presenter.do("Place", lambda d: edits.set_placement(d, rotation_deg=(30.0, 0.0, 20.0)))
    stage.settle()
    hover(stage.window.surface_view.plotter, tip(stage, Axis.Z).toPoint())
    assert stage.window.surface_view.hand.active == AxisTip()
