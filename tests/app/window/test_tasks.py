"""Whole tasks, done as a user does them: the window gets the keys, and who has the focus acts."""

from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QLineEdit, QToolButton

from app.commands.focus_walk import in_reading_order
from app.hand.coordinates import DesignPoint, ScreenPoint
from app.state import preferences
from app.viewport.handles import Scenery
from sgb_core.document.file import project_file
from tests.app.mouse import CTRL, NONE, SHIFT, move, press, release
from tests.app.window_stage import WindowStage

Key = Qt.Key


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot)
    yield made
    made.close()


def strike(stage, *keys, modifiers=NONE):
    """Press keys as the window system hands them in: to the window that is in front."""
    for key in keys:
        popup = QApplication.activePopupWidget()
        QTest.keyClick((popup or stage.window).windowHandle(), key, modifiers)


def tab_until(stage, reached):
    """Walk on with Tab until ``reached(name)`` of the control that has the focus."""
    for _ in range(100):
        part = QApplication.focusWidget()
        if part is not None and reached(part.accessibleName()):
            return part
        strike(stage, Key.Key_Tab)
    raise AssertionError("Tab does not lead there")


def focused_panel(stage):
    part = QApplication.focusWidget()
    for panel in in_reading_order(stage.window.walked()):
        if part is panel or panel.isAncestorOf(part):
            return panel
    return None


def test_a_sculpture_by_keys_alone_saved_and_opened(stage, monkeypatch, tmp_path):
    window, before = stage.window, stage.document
    strike(stage, Key.Key_N, modifiers=CTRL)
    stage.until(window.welcome.gallery.isVisible)
    strike(stage, Key.Key_Right, Key.Key_Right, Key.Key_Return)
    stage.until(lambda: not window.welcome.gallery.isVisible())
    window.welcome.hints.hide()
    assert stage.document.name != before.name
    # To the profile editor, its second point, ten grid steps outwards.
    while focused_panel(stage) is not window.profile_view:
        strike(stage, Key.Key_F6)
    strike(stage, Key.Key_Tab, Key.Key_Tab)
    (segment, index) = next(iter(stage.presenter.view.points))
    r = stage.document.profile.segments[segment].points[index][0]
    strike(stage, Key.Key_Right, modifiers=SHIFT)
    assert stage.document.profile.segments[segment].points[index][0] > r
    # On to a slider of the shape panel.
    while focused_panel(stage) is not window.panels["shape"]:
        strike(stage, Key.Key_F6)
    slider = tab_until(stage, lambda name: name.startswith("λ2"))
    lambda2 = slider.number
    strike(stage, Key.Key_Right, Key.Key_Right)
    assert slider.number > lambda2
    path = tmp_path / "by keys.sgb"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    strike(stage, Key.Key_S, modifiers=CTRL)
    assert project_file.load(path) == stage.document
    assert not stage.session.is_modified


def test_f6_visits_every_panel_once_and_comes_back(stage):
    shown = in_reading_order(stage.window.walked())
    assert stage.window.profile_view in shown
    assert stage.window.surface_view.plotter in shown
    visited = []
    for _ in shown:
        strike(stage, Key.Key_F6)
        visited.append(focused_panel(stage))
    assert sorted(map(id, visited)) == sorted(map(id, shown))
    strike(stage, Key.Key_F6, modifiers=SHIFT)
    assert focused_panel(stage) is visited[-2]


def test_tab_goes_round_through_all_that_is_seen_and_nothing_else(stage):
    window = stage.window
    # The editor walks through its points, the table through its cells: one of each is enough.
    stage.window.files.new_blank()
    stage.settle()
    window.surface_view.plotter.setFocus()
    visited = []
    for _ in range(150):
        strike(stage, Key.Key_Tab)
        visited.append(QApplication.focusWidget())
        if visited[-1] is window.surface_view.plotter:
            break
    assert visited[-1] is window.surface_view.plotter
    buttons = window.surface_view.buttons.findChildren(QToolButton)
    assert visited[: len(buttons)] == buttons
    for part in visited:
        assert not part.visibleRegion().isEmpty(), part.accessibleName()
    for panel in in_reading_order(window.walked()):
        assert any(part is panel or panel.isAncestorOf(part) for part in visited), panel
    # A table is entered at the point that is selected: the two ways meet other cells of it.
    parts = [part for part, after in pairwise(visited) if part is not after]
    for part in reversed(parts):
        left = QApplication.focusWidget()
        for _ in range(20):
            strike(stage, Key.Key_Backtab, modifiers=SHIFT)
            if QApplication.focusWidget() is not left:
                break
        if part is window.profile_view:
            break
        assert QApplication.focusWidget() is part


def test_in_a_style_with_f6_of_its_own_the_viewport_keeps_it(stage):
    viewport = stage.window.surface_view
    preferences.change(navigation_style="fusion")
    viewport.plotter.setFocus()
    viewport.move_camera(viewport.pose.zoomed(0.5, 0.0, 0.0))
    near = viewport.pose.distance
    strike(stage, Key.Key_F6)
    assert focused_panel(stage) is viewport.plotter
    assert viewport.pose.distance > near


def test_the_palette_is_typed_into_as_soon_as_it_opens(stage):
    before = stage.document
    strike(stage, Key.Key_P, modifiers=CTRL | SHIFT)
    stage.until(lambda: QApplication.activePopupWidget() is not None)
    strike(stage, Key.Key_M, Key.Key_I, Key.Key_R, Key.Key_U, Key.Key_P, Key.Key_S)
    assert QApplication.activePopupWidget().findChild(QLineEdit).text() == "mirups"
    strike(stage, Key.Key_Return)
    assert stage.session.undo_label == "Mirror upside down"
    strike(stage, Key.Key_Z, modifiers=CTRL)
    assert stage.document is before


def test_escape_takes_a_drag_back_before_it_dismisses_a_notice(stage):
    viewport, before = stage.window.surface_view, stage.document
    stage.presenter.notify("Something is wrong.", "error")
    stage.settle()
    pair = before.profile.segments[1].points[3]
    at = QPointF(*Scenery(stage.presenter.frame, viewport.lens).paper().map(pair).tolist())
    press(viewport.plotter, at)
    move(viewport.plotter, at + QPointF(12, 8))
    move(viewport.plotter, at + QPointF(25, 14))
    assert stage.document is not before
    strike(stage, Key.Key_Escape)
    assert stage.document is before
    assert stage.window.notice_bar.isVisible()
    release(viewport.plotter, at + QPointF(25, 14))
    strike(stage, Key.Key_Escape)
    stage.until(stage.window.notice_bar.isHidden)


def test_a_broken_file_is_named_once_and_a_number_by_its_field(stage, tmp_path):
    path = tmp_path / "broken.sgb"
    path.write_text("{")
    stage.window.files.open_path(path)
    text = stage.window.notice_bar.notice.text
    assert text.count("broken.sgb") == 1
    assert str(tmp_path) not in text
    field = stage.window.panels["turn"].height_field
    stage.window.panels.docks["turn"].raise_()
    field.setFocus()
    field.selectAll()
    strike(stage, Key.Key_Minus, Key.Key_3, Key.Key_Return)
    assert stage.window.notice_bar.notice.text.startswith("Height: ")


def test_a_point_follows_the_cursor_in_both_views_however_near(stage):
    viewport, editor = stage.window.surface_view, stage.window.profile_view
    stage.presenter.set_view(snap=False)

    def pair():
        return stage.document.profile.segments[2].points[2]

    def in_editor():
        at = editor.transform.to_screen(DesignPoint.of(pair()))
        return QPointF(at.x, at.y)

    def in_space():
        paper = Scenery(stage.presenter.frame, viewport.lens).paper()
        return QPointF(*paper.map(pair()).tolist())

    def dragged(widget, place):
        start = place()
        goal = QPointF(start.toPoint()) + QPointF(17, -12)
        press(widget, start)
        move(widget, start + QPointF(6, -4))
        move(widget, goal)
        release(widget, goal)
        away = place() - goal
        return max(abs(away.x()), abs(away.y()))

    for factor in (1.0, 3.0):
        at = in_editor()
        editor.zoom(factor, editor.transform.to_screen(DesignPoint.of(pair())))
        assert (in_editor() - at).manhattanLength() < 0.1
        assert dragged(editor, in_editor) < 1.0
        viewport.move_camera(viewport.pose.zoomed(1.0 / factor, 0.3, -0.2))
        stage.settle()
        assert dragged(viewport.plotter, in_space) < 1.0


def test_both_views_follow_a_typed_size_until_the_user_chooses_one(stage):
    viewport, editor = stage.window.surface_view, stage.window.profile_view

    def typed(words):
        strike(stage, Key.Key_P, modifiers=CTRL | SHIFT)
        stage.until(lambda: QApplication.activePopupWidget() is not None)
        QTest.keyClicks(QApplication.activePopupWidget().findChild(QLineEdit), words)
        strike(stage, Key.Key_Return)
        stage.settle()

    def seen():
        corners = editor.transform.map(np.stack(stage.document.profile.bounds())).tolist()
        whole = viewport.pose.holds(viewport.scene.points_to_fit(), viewport._aspect)
        return whole, all(editor.area.contains(ScreenPoint(*corner)) for corner in corners)

    typed("height 900")
    assert stage.document.height == pytest.approx(900.0)
    assert seen() == (True, True)
    viewport.move_camera(viewport.pose.zoomed(0.5, 0.0, 0.0))
    editor.zoom(2.0, ScreenPoint(100.0, 100.0))
    pose, transform = viewport.pose, editor.transform
    typed("height 2000")
    assert (viewport.pose, editor.transform) == (pose, transform)
