"""Told in another unit an object of the same true size stays where it is in both views."""

import numpy as np

from app.hand.coordinates import ScreenPoint
from sgb_core.document import edits
from tests.app.window_stage import WindowStage


def test_the_views_keep_an_object_that_is_told_in_another_unit(qtbot):
    stage = WindowStage(qtbot)
    editor, viewport = stage.window.profile_view, stage.window.surface_view
    viewport.set_view_direction("front")
    editor.zoom(1.2, ScreenPoint(150.0, 150.0))
    stage.settle()

    def seen():
        stage.settle()
        points = editor.transform.map(stage.document.profile.control_points)
        pose = viewport.pose
        return points, pose.distance / stage.document.height, np.array(pose.focal)

    points, far, focal = seen()
    stage.presenter.do("Unit", lambda document: edits.set_unit(document, "in", True))
    after, still, there = seen()
    assert np.allclose(after, points)
    assert np.isclose(still, far)
    assert np.allclose(25.4 * there, focal)
    stage.presenter.undo()
    back, again, _ = seen()
    assert np.allclose(back, points)
    assert np.isclose(again, far)
    # Where the numbers stay, so does the picture.
    stage.presenter.do("Unit", lambda document: edits.set_unit(document, "cm", False))
    same, nearly, _ = seen()
    assert np.allclose(same, points)
    assert np.isclose(nearly, far)
    stage.close()
