"""One view alone, full screen, docks that come back; and the hints that point at real things."""

import pytest
from PySide6.QtCore import QByteArray, QPointF, QRect, QSettings, Qt
from PySide6.QtGui import QScreen
from PySide6.QtTest import QTest

from app.start.hints import KEY
from app.state.stored import faults
from app.widgets.mark_slider import MarkSlider
from app.window.main_window import MainWindow
from tests.app.mouse import drag
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    QSettings().remove(KEY)
    made = WindowStage(qtbot)
    yield made
    made.close()


def test_the_viewport_alone_and_back(stage):
    window = stage.window
    shown = {name: dock.isVisible() for name, dock in window.panels.docks.items()}
    size = window.size()
    QTest.keyClick(window, Qt.Key.Key_F11)
    stage.until(window.isFullScreen)
    stage.until(lambda: window.surface_view.size() == window.size())
    assert window.centralWidget().size() == window.size()
    assert not any(dock.isVisible() for dock in window.panels.docks.values())
    # Keys go on working without a menu bar.
    QTest.keyClick(window, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    assert stage.session.undo_label == "Append segment"
    QTest.keyClick(window, Qt.Key.Key_Escape)
    stage.until(lambda: not window.isFullScreen() and window.size() == size)
    stage.settle()
    assert window.menuBar().isVisible()
    assert {name: dock.isVisible() for name, dock in window.panels.docks.items()} == shown


def test_the_editor_alone_and_back(stage):
    window, editor = stage.window, stage.window.profile_view
    QTest.keyClick(window, Qt.Key.Key_F11, Qt.KeyboardModifier.ShiftModifier)
    stage.until(lambda: editor.isVisible() and editor.size() == window.centralWidget().size())
    assert not window.surface_view.isVisible()
    QTest.keyClick(window, Qt.Key.Key_F11)
    assert window.arrangement.alone == "viewport"
    stage.until(window.surface_view.isVisible)
    QTest.keyClick(window, Qt.Key.Key_F11)
    assert window.arrangement.alone is None
    assert window.panels.docks["profile"].widget() is editor
    stage.until(editor.isVisible)


def test_asking_for_a_panel_beside_the_editor_alone_brings_all_back(stage):
    window, editor = stage.window, stage.window.profile_view
    QTest.keyClick(window, Qt.Key.Key_F11, Qt.KeyboardModifier.ShiftModifier)
    stage.until(lambda: editor.isVisible() and editor.size() == window.centralWidget().size())
    dock = window.panels.docks["profile"]
    dock.toggleViewAction().trigger()
    stage.until(lambda: dock.isVisible() and window.surface_view.isVisible())
    assert dock.widget() is editor
    assert window.arrangement.alone is None


def test_the_first_window_and_its_frame_lie_within_a_small_screen(qtbot, monkeypatch):
    for room in (QRect(0, 0, 1366, 768), QRect(0, 0, 1280, 680), QRect(0, 0, 2560, 1440)):
        monkeypatch.setattr(QScreen, "availableGeometry", lambda _, room=room: room)
        stage = WindowStage(qtbot, size=None, wait_for_scene=False)
        size = stage.window.size()
        assert size.height() + 40 <= room.height()
        assert size.width() <= min(1440, room.width())
        stage.close()
        QSettings().clear()


def test_closing_while_alone_remembers_the_docks(qtbot):
    stage = WindowStage(qtbot, wait_for_scene=False)
    QTest.keyClick(stage.window, Qt.Key.Key_F11)
    stage.close()
    other = WindowStage(qtbot, wait_for_scene=False)
    assert other.window.panels.docks["shape"].isVisible()
    assert other.window.menuBar().isVisible()
    assert not other.window.isFullScreen()
    other.close()


def test_hints_point_at_real_things_and_go_for_good(stage):
    window, hints = stage.window, stage.window.welcome.hints
    hints.show()
    stage.until(lambda: hints.bubbles and all(bubble.isVisible() for bubble in hints.bubbles))
    assert [bubble.hint.name for bubble in hints.bubbles] == ["slider", "point", "orbit"]
    for bubble in hints.bubbles:
        assert window.rect().contains(bubble.geometry())
    slider, point, orbit = hints.bubbles
    # The tip lies at the edge of the panel, level with a slider, and covers no name.
    at = window.panels["shape"].mapFrom(window, slider.hint.target())
    beside = window.panels["shape"].findChildren(MarkSlider)
    levels = [
        s.mapTo(window.panels["shape"], s.rect().center()).y() for s in beside if s.isVisible()
    ]
    assert at.x() == 0
    assert at.y() in levels
    assert window.profile_view.geometry().isValid()
    assert window.surface_view.geometry().contains(
        window.centralWidget().mapFrom(window, orbit.hint.target())
    )
    point.button.click()
    assert [bubble.hint.name for bubble in hints.bubbles] == ["slider", "orbit"]
    orbit.setFocus()
    QTest.keyClick(orbit, Qt.Key.Key_Escape)
    hints.show()
    assert [bubble.hint.name for bubble in hints.bubbles] == ["slider"]
    # Doing what it says is the best way to be rid of it.
    handle = stage.slider(0, "omega")
    drag(handle, handle.handle_centre(), handle.handle_centre() + QPointF(-20, 0))
    stage.until(lambda: hints.bubbles == [])
    hints.show()
    assert hints.bubbles == []
    window.commands["hints"].trigger()
    assert len(hints.bubbles) == 3


def test_opening_another_shape_puts_no_hint_away(stage):
    hints = stage.window.welcome.hints
    hints.show()
    stage.window.files.new_from_preset("bowl")
    stage.settle()
    hints.look()
    assert len(hints.bubbles) == 3


def test_the_first_start_opens_the_gallery_and_then_the_hints(stage):
    QSettings().remove("welcomed")
    welcome = stage.window.welcome
    welcome.at_start()
    assert welcome.gallery.isVisible()
    assert welcome.hints.bubbles == []
    QTest.keyClick(stage.window.focusWidget(), Qt.Key.Key_Escape)
    assert len(welcome.hints.bubbles) == 3
    welcome.at_start()
    assert welcome.gallery.isHidden()


def test_no_panel_makes_the_window_taller_or_wider_than_a_small_screen(stage):
    window = stage.window
    window.resize(1024, 700)
    window.panels.docks["curvature"].show()
    for key in window.panels.docks:
        window.panels.docks[key].raise_()
        stage.settle()
        assert window.size().toTuple() == (1024, 700), key


def test_a_place_kept_on_a_screen_of_another_size_is_no_fault(qtbot, monkeypatch):
    first = WindowStage(qtbot, wait_for_scene=False)
    first.close()
    assert QSettings().contains("geometry")
    # So Qt answers where the screen has become narrower or wider by more than a quarter.
    monkeypatch.setattr(MainWindow, "restoreGeometry", lambda *_: False)
    faults()
    again = WindowStage(qtbot, wait_for_scene=False)
    assert faults() == []
    assert again.window.notice_bar.notice is None
    room = again.window.screen().availableGeometry()
    assert room.contains(again.window.geometry())
    again.close()
    QSettings().setValue("geometry", QByteArray(b"rubbish"))
    broken = WindowStage(qtbot, wait_for_scene=False)
    assert not QSettings().contains("geometry")
    broken.close()
