"""What window tests need between them."""

import gc
import os
import sys

import pytest
from PySide6.QtGui import QCursor, QGuiApplication

from tests.app.waiting import PatientBot

VIEWPORTS = {"WindowStage", "Stage", "SurfaceView", "MainWindow"}


@pytest.fixture(scope="session")
def qapp_args(qapp_args):
    """Skip what needs a screen where there is none; Qt would end the whole run."""
    if sys.platform == "linux" and not os.environ.get("DISPLAY"):
        pytest.skip("needs a screen")
    return qapp_args


@pytest.fixture
def qtbot(qapp, request):
    """Park the screen's own pointer where no window will be, and wait patiently."""
    QCursor.setPos(QGuiApplication.primaryScreen().geometry().bottomRight())
    return PatientBot(request)


@pytest.fixture(autouse=True)
def _no_wrappers_of_closed_windows(request):
    """Free closed viewports at once, in the modules that open any.

    A Python wrapper of a closed viewport's surface that outlives it would be taken for the
    next object that Qt makes at the same address, a menu's action say.
    """
    yield
    if VIEWPORTS & vars(request.module).keys():
        gc.collect()
