"""The frame of a window: seen first, filled behind what is seen, without a jump."""

from PySide6.QtCore import QTimer
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QApplication

from app.theme import theme
from app.window.frame import MENUS
from app.window.main_window import MainWindow
from tests.app.waiting import let_turn


def places(window):
    parts = {"centre": window.centralWidget(), "bar": window.toolbar, "foot": window.statusBar()}
    for key in ("profile", "points", "shape"):
        parts[key] = window.docks[key]
    return {name: part.geometry() for name, part in parts.items()}


def test_a_bare_frame_is_painted_and_what_fills_it_takes_its_places(qtbot):
    # As the program dresses it.
    theme.apply(QApplication.instance(), "light")
    window = MainWindow(furnished=False)
    window.show_frame()
    assert window not in MainWindow.windows
    assert not window.grab().isNull()
    titles = [action.text().replace("&", "") for action in window.menuBar().actions()]
    assert titles == list(MENUS)
    before = places(window)
    window.furnish()
    qtbot.waitUntil(lambda: window.surface_view.scene is not None)
    let_turn()
    assert places(window) == before
    titles = [action.text().replace("&", "") for action in window.menuBar().actions()]
    assert titles == list(MENUS)
    assert all(action.menu().actions() for action in window.menuBar().actions())
    for key in ("profile", "points", "shape"):
        assert window.docks[key].widget().isVisible()
    assert window.docks["turn"].widget() is None
    assert window.surface_view.isVisible()
    window.presenter.session.mark_saved()
    window.close()
    let_turn()


def test_what_happens_to_a_bare_frame_finds_nothing_to_ask(qtbot):
    window = MainWindow(furnished=False)
    window.show_frame()
    window.showMinimized()
    window.hide()
    window.showNormal()
    QApplication.sendEvent(window, QCloseEvent())
    assert window.isVisible()
    window.furnish()
    window.presenter.session.mark_saved()
    window.close()
    let_turn()


def test_a_window_that_is_never_seen_does_not_hold_the_start_up(qtbot, monkeypatch):
    monkeypatch.setattr("app.window.frame.PATIENCE", 30)
    window = MainWindow(furnished=False)
    # Nothing of a window that is not mapped is painted.
    monkeypatch.setattr(window, "show", lambda: None)
    late = []
    QTimer.singleShot(20_000, lambda: late.append(True))
    window.show_frame()
    assert not late
    window.furnish()
    window.presenter.session.mark_saved()
    window.close()
    let_turn()
