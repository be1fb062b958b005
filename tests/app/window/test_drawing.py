"""Drawing from nothing in the real window, with the mouse alone."""

import os
import sys

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.state.blank import blank_document
from tests.app import mouse
from tests.app.window_stage import WindowStage

pytestmark = pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)
# Where the hand presses, and where it lets go after a drag, in mm.
GLASS = (
    ((0, 0), None),
    ((30, 0), None),
    ((5, 9), (4, 14)),
    ((4, 44), (4, 54)),
    ((26, 76), (28, 90)),
    ((22, 110), None),
    ((23, 76), (20, 64)),
    ((0, 56), None),
)


def test_a_wine_glass_takes_eight_strokes_and_no_repair(qtbot):
    stage = WindowStage(qtbot, (1024, 700))
    stage.presenter.replace_document(blank_document())
    stage.settle()
    editor = stage.window.profile_view

    def screen(place):
        return QPointF(*editor.transform.map(place).tolist())

    editor.setFocus()
    QTest.keyClick(editor, Qt.Key.Key_P)
    for place, handle in GLASS:
        mouse.hover(editor, screen(place))
        if handle is None:
            mouse.press(editor, screen(place))
            mouse.release(editor, screen(place))
        else:
            mouse.drag(editor, screen(place), screen(handle))
        QApplication.processEvents()
    stage.settle()
    document = stage.document
    assert len(document.profile) == 7
    ends = document.profile.segments[0].points[0], document.profile.segments[-1].points[3]
    assert [end[0] for end in ends] == [0.0, 0.0]
    frame = stage.presenter.frame
    assert not frame.evaluation.self_intersections
    assert not frame.evaluation.axis_crossings
    joints = [str(report.measured) for report in document.joints]
    assert [name == "G0" for name in joints] == [True, False, False, False, True, False]
    assert abs(document.height - 110.0) < 1.0
    assert len(stage.session.history) == 8
    # All of it is seen in both views.
    places = editor.transform.map(document.profile.control_points.reshape(-1, 2))
    area = editor.area
    assert np.all((places > (area.left, area.top)) & (places < (area.right, area.bottom)))
    lens = stage.window.surface_view.lens
    corners = lens.to_screen(np.array(stage.window.surface_view.scene.points_to_fit()))
    assert np.all(corners >= 0.0)
    assert np.all(corners <= (lens.width, lens.height))
    stage.close()
