"""What window tests need between them."""

import gc

import pytest
from PySide6.QtGui import QCursor, QGuiApplication

from tests.app.waiting import PatientBot

VIEWPORTS = {"WindowStage", "SurfaceView", "MainWindow"}


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
