"""Heads-up labels go when what they tell of is pointed at no longer, by real events."""

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.viewport.handles import Scenery
from tests.app.mouse import hover
from tests.app.window_stage import WindowStage

Key = Qt.Key


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot)
    yield made
    made.close()


def strike(stage, *keys):
    for key in keys:
        QTest.keyClick(stage.window.windowHandle(), key)


def in_space(stage, segment, index):
    """Where a control point is seen in the viewport."""
    paper = Scenery(stage.presenter.frame, stage.window.surface_view.lens).paper()
    points = stage.document.profile.segments[segment].points
    return QPointF(*paper.map(points[index]).tolist())


def pictures(editor):
    return editor.grab().toImage()


def test_the_editors_label_goes_with_the_keyboards_focus(stage):
    editor = stage.window.profile_view
    editor.setFocus()
    strike(stage, Key.Key_Tab)
    stage.settle()
    told = pictures(editor)
    strike(stage, Key.Key_F6)
    stage.until(lambda: not editor.hasFocus())
    stage.settle()
    left = pictures(editor)
    # The same point is still chosen; what has gone besides the frame is the label.
    assert stage.presenter.view.points
    inside = [(x, y) for x in range(4, told.width() - 4, 4) for y in range(4, told.height() - 4, 4)]
    gone = sum(told.pixel(x, y) != left.pixel(x, y) for x, y in inside)
    assert gone > 20
    editor.setFocus()
    stage.settle()
    again = pictures(editor)
    assert sum(told.pixel(x, y) != again.pixel(x, y) for x, y in inside) == 0


def test_the_viewports_label_goes_when_the_pointer_leaves_or_the_view_changes(stage):
    view = stage.window.surface_view
    hover(view.plotter, in_space(stage, 2, 2))
    assert view.hud.isVisible()
    QApplication.sendEvent(view.plotter, QEvent(QEvent.Type.Leave))
    assert not view.hud.isVisible()
    hover(view.plotter, in_space(stage, 2, 2))
    assert view.hud.isVisible()
    view.plotter.setFocus()
    strike(stage, Key.Key_3)
    assert not view.hud.isVisible()
    stage.settle()
    assert not view.hud.isVisible()
    # It comes again with the pointer.
    hover(view.plotter, in_space(stage, 2, 2))
    assert view.hud.isVisible()
