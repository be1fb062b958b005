"""The fit dialog as a guest of the window: it takes its work with it when it goes."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.figures.fit_dialog import FitDialog
from tests.app.window_stage import WindowStage


def test_closing_the_dialog_stops_the_search(qtbot):
    stage = WindowStage(qtbot, wait_for_scene=False)
    stage.window.commands["fit_ellipse"].trigger()
    dialog, jobs = stage.window.findChild(FitDialog), stage.window.jobs
    # The best polygon of the vase's six segments takes a while.
    qtbot.waitUntil(lambda: bool(jobs.running))
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: not jobs.running)
    assert not dialog.isVisible()
    assert dialog.choices is None
    stage.close()
