"""Drags land under the cursor on a screen of another scale factor; a process of its own."""

import os
import subprocess
import sys

import pytest

pytestmark = pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)

SCRIPT = """
import sys
import time
from PySide6.QtCore import QPoint, QPointF
from PySide6.QtWidgets import QApplication
app = QApplication([])
from app.window.main_window import MainWindow
from app.hand.coordinates import DesignPoint
from app.viewport.handles import Scenery
from tests.app.mouse import move, press, release
from tests.app.waiting import is_drawn, let_turn
window = MainWindow()
window.resize(1000, 640)
window.show()
window.files.new_from_preset("vase")
view = window.surface_view
until = time.monotonic() + 120
while view.scene is None or not is_drawn(view):
    assert time.monotonic() < until
    let_turn()
assert view.devicePixelRatioF() == 1.5, view.devicePixelRatioF()

def point():
    return window.presenter.document.profile.segments[2].points[2]

def in_space():
    scenery = Scenery(window.presenter.frame, view.lens)
    return QPointF(*scenery.paper().map(point()).tolist())

def in_editor():
    at = window.profile_view.transform.to_screen(DesignPoint.of(point()))
    return QPointF(at.x, at.y)

for widget, where in ((view.plotter, in_space), (window.profile_view, in_editor)):
    start = where()
    goal = QPointF(start.toPoint() + QPoint(14, -11))
    press(widget, start)
    move(widget, start + QPointF(6, -4))
    move(widget, goal)
    release(widget, goal)
    let_turn()
    away = where() - goal
    print(type(widget).__name__, away.x(), away.y())
    assert max(abs(away.x()), abs(away.y())) < 0.7
# What is computed is what is drawn: the picture's pixels, at the scale of the screen.
while not is_drawn(view):
    assert time.monotonic() < until
    let_turn()
size = view.plotter.ren_win.GetSize()
assert abs(size[0] - 1.5 * view.plotter.width()) <= 1.5, (size, view.plotter.width())
print("landed")
sys.stdout.flush()
window.presenter.session.mark_saved()
window.close()
"""


def test_drags_land_at_one_and_a_half():
    environment = {**os.environ, "QT_SCALE_FACTOR": "1.5"}
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT],
        env=environment,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert "landed" in done.stdout, done.stdout + done.stderr
