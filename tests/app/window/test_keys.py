"""The viewport's keys from every part of the window; layouts that outlive it; two windows."""

import os
import sys

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QShortcut
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QDockWidget

from app.hand.coordinates import ScreenPoint
from app.scene.standard_views import STANDARD_VIEWS
from app.state import preferences
from app.window.main_window import MainWindow
from tests.app.window_stage import WindowStage

pytestmark = pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)
Key = Qt.Key
DIRECTIONS = ((Key.Key_1, "front"), (Key.Key_3, "right"), (Key.Key_7, "top"))


@pytest.fixture
def stage(qtbot):
    preferences.change(animate_views=False)
    made = WindowStage(qtbot)
    yield made
    made.close()


def press(key):
    QTest.keyClick(QApplication.focusWidget(), key)
    QApplication.processEvents()


@pytest.mark.parametrize("place", ["viewport", "editor", "slider"])
def test_the_viewports_keys_work_from(stage, qtbot, place):
    window, view = stage.window, stage.window.surface_view
    row = window.panels["shape"].cards[0].rows["omega"]
    part = {"viewport": view, "editor": window.profile_view, "slider": row.slider}[place]
    part.setFocus()
    qtbot.waitUntil(lambda: QApplication.focusWidget() in (part, view.plotter))
    for key, name in DIRECTIONS:
        press(key)
        assert (view.pose.azimuth, view.pose.elevation) == pytest.approx(
            STANDARD_VIEWS[name].direction
        )
    press(Key.Key_P)
    # In the editor it is the pen's.
    assert (stage.presenter.view.projection == "parallel") == (place != "editor")
    assert (stage.presenter.view.tool == "pen") == (place == "editor")
    fitted, editor = view.pose, window.profile_view
    view.move_camera(fitted.zoomed(2.0, 0.0, 0.0))
    editor.zoom(1.5, ScreenPoint(60.0, 60.0))
    zoomed, paper = view.pose, editor.transform
    press(Key.Key_F)
    # What has the focus is fitted; from a panel it is the surface.
    assert (view.pose == zoomed) == (place == "editor")
    assert (editor.transform == paper) == (place != "editor")
    # A number takes its digits for itself.
    row.field.setFocus()
    qtbot.waitUntil(row.field.hasFocus)
    before = view.pose
    press(Key.Key_3)
    assert view.pose == before
    press(Key.Key_Escape)


def test_a_changed_layout_is_there_again_after_a_restart(qtbot):
    stage = WindowStage(qtbot, wait_for_scene=False)
    docks = stage.window.panels.docks
    docks["points"].hide()
    stage.window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, docks["look"])
    stage.window.addDockWidget(Qt.DockWidgetArea.BottomDockWidgetArea, docks["measures"])
    stage.settle()
    stage.close()
    again = WindowStage(qtbot, wait_for_scene=False)
    docks = again.window.panels.docks
    assert not docks["points"].isVisible()
    area = again.window.dockWidgetArea
    assert area(docks["look"]) is Qt.DockWidgetArea.LeftDockWidgetArea
    assert area(docks["measures"]) is Qt.DockWidgetArea.BottomDockWidgetArea
    again.window.arrangement.reset()
    assert docks["points"].isVisible()
    assert docks["look"] in again.window.tabifiedDockWidgets(docks["shape"])
    again.close()


def test_two_windows_have_documents_and_full_screens_of_their_own(stage, qtbot):
    first = stage.window
    first.new_window()
    assert MainWindow.windows[:-1] == [first]
    second = MainWindow.windows[-1]
    qtbot.waitUntil(second.isVisible)
    before = second.presenter.document
    first.files.new_from_preset("bowl")
    assert second.presenter.document is before
    second.arrangement.toggle_alone("editor")
    assert not any(dock.isVisible() for dock in second.findChildren(QDockWidget))
    assert first.panels.docks["shape"].isVisible()
    second.arrangement.leave_alone()
    second.close()
    assert MainWindow.windows == [first]


def test_no_two_things_of_the_window_answer_to_one_key(stage):
    window, holders = stage.window, {}
    wide = (Qt.ShortcutContext.WindowShortcut, Qt.ShortcutContext.ApplicationShortcut)
    for action in window.findChildren(QAction):
        if action.shortcutContext() in wide:
            for key in action.shortcuts():
                holders.setdefault(key.toString(), []).append(action.text())
    for shortcut in window.findChildren(QShortcut):
        if shortcut.context() in wide:
            keys = shortcut.keys()
            for key in keys:
                holders.setdefault(key.toString(), []).append(shortcut.objectName())
    for button in window.findChildren(QAbstractButton):
        if not button.shortcut().isEmpty():
            holders.setdefault(button.shortcut().toString(), []).append(button.toolTip())
    assert len(holders) > 60
    assert {key: found for key, found in holders.items() if len(found) > 1} == {}
