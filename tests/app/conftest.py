"""What window tests need between them."""

import gc
import os
import sys

import pytest
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QCursor, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from app.window.garbage_collector import collect_due
from tests.app.waiting import PatientBot

# Before any of them is read: the settings of a program without a name are all programs' fallback.
QCoreApplication.setApplicationName("sgb-studio-tests")
BUTTONS = (Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton, Qt.MouseButton.RightButton)
VIEWPORTS = {"WindowStage", "Stage", "SurfaceView", "MainWindow"}


@pytest.fixture(scope="session")
def qapp_args(qapp_args):
    """Skip what needs a screen where there is none; Qt would end the whole run."""
    if sys.platform == "linux" and not os.environ.get("DISPLAY"):
        pytest.skip("needs a screen")
    return qapp_args


@pytest.fixture
def faults_are_for_the_tests(monkeypatch):
    """Leave what Python does with a fault of this process to whoever runs the tests."""
    for name in ("enable", "disable"):
        monkeypatch.setattr(f"app.state.log.faulthandler.{name}", lambda *_: None)


@pytest.fixture
def qtbot(qapp, request):
    """Park the screen's own pointer where no window will be, and wait patiently.

    Who leaves a mouse button down fails: all that follow would wait for its release.
    """
    QCursor.setPos(QGuiApplication.primaryScreen().geometry().bottomRight())
    yield PatientBot(request)
    down = [button for button in BUTTONS if button & QGuiApplication.mouseButtons()]
    for button in down:
        QTest.mouseRelease(QWidget(), button)
    assert not down, "the test leaves mouse buttons down"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item):
    """Collect cyclic garbage after a test, never on a worker thread or while a window draws.

    Closed viewports are freed at once, in the modules that open any: a Python wrapper of its
    surface that outlives one would be taken for the next object that Qt makes at the same
    address, a menu's action say. No fixture could do it: pytest keeps a test's windows until
    all fixtures are torn down.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        if VIEWPORTS & vars(item.module).keys():
            gc.collect()
        else:
            collect_due()
        gc.enable()
