"""The real window under a hand whose events are timed, up to the picture that is swapped in."""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import time
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QPointF
from PySide6.QtWidgets import QApplication

import resources
from app.hand.coordinates import DesignPoint
from app.viewport.handles import Scenery
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.file import project_file
from tests.app.mouse import NONE, _move, press, release

# A window whose viewport is about 1200×800 with the panels that are there at first.
SIZE = (1590, 960)
# The longest wait for a picture, in seconds.
PATIENCE = 60.0


def preset(name):
    return project_file.loads(resources.load_preset(name))


def chain(count):
    """Return a smooth tower of so many segments."""
    heights = np.linspace(0.0, 200.0, count + 1)
    ends = list(zip(40.0 + 15.0 * np.sin(heights / 12.0), heights, strict=True))
    slopes = 1.25 * np.cos(heights / 12.0)
    segments = []
    for k in range(count):
        (r, h), (far, top) = ends[k], ends[k + 1]
        third = (top - h) / 3.0
        inner = [(r + slopes[k] * third, h + third), (far - slopes[k + 1] * third, top - third)]
        segments.append(Segment([(r, h), *inner, (far, top)], ShapeParameters(1.0, 3.0, 1.0, 0.5)))
    return replace(preset("vase"), profile=Profile.of(segments))


class Watch:
    """Counts pictures that are drawn, and those swapped to the screen, with their times."""

    def __init__(self, stage):
        self.stage = stage
        self.drawn, self.swapped = [], []
        plotter = stage.window.surface_view.plotter
        plotter.ren_win.AddObserver("EndEvent", lambda *_: self.drawn.append(time.perf_counter()))
        plotter.frameSwapped.connect(lambda: self.swapped.append(time.perf_counter()))

    def until_swapped(self, count):
        limit = time.perf_counter() + PATIENCE
        while len(self.swapped) < count:
            QApplication.processEvents()
            assert time.perf_counter() < limit

    def timed(self, act):
        """Return how long, in milliseconds, an act takes until its picture is swapped in."""
        count = len(self.swapped) + 1
        start = time.perf_counter()
        act()
        self.until_swapped(count)
        return 1e3 * (time.perf_counter() - start)


class Hand:
    """Holds something in the window; each step moves it a little, back and forth."""

    def __init__(self, stage, kind):
        self.stage, self.kind, self.step = stage, kind, 0
        self.widget, self.start = getattr(self, f"_{kind}")()
        press(self.widget, self.start)
        for _ in range(4):
            self.move()
        QApplication.processEvents()

    def _slider(self):
        slider = self.stage.slider(1, "lambda2")
        return slider, QPointF(slider.rect().center())

    def _point(self):
        """Return the handle that stands freest: nothing else is grabbed in its place."""
        points = self.stage.document.profile.control_points
        apart = np.linalg.norm(points[:, 1:3, None, None] - points, axis=-1)
        # Each is the nearest to itself.
        room = np.sort(apart.reshape(*apart.shape[:2], -1))[..., 1]
        segment, handle = np.unravel_index(room.argmax(), room.shape)
        return points[segment, 1 + handle]

    def _editor(self):
        view = self.stage.window.profile_view
        at = view.transform.to_screen(DesignPoint.of(self._point()))
        return view, QPointF(at.x, at.y)

    def _space(self):
        view = self.stage.window.surface_view
        scenery = Scenery(self.stage.presenter.frame, view.lens)
        return view.plotter, QPointF(*scenery.paper().map(self._point()).tolist())

    def _orbit(self):
        return self.stage.window.surface_view.plotter, QPointF(30.0, 30.0)

    def move(self):
        """Send one real move of the pointer."""
        from tests.app.mouse import LEFT

        self.step += 1
        way = 5.0 + 9.0 * abs((self.step % 12) - 6)
        _move(self.widget, self.start + QPointF(way, 0.5 * way), LEFT)

    def let_go(self):
        release(self.widget, self.start, NONE)


def stream(watch, hand, seconds, rate=125.0):
    """Send moves at a rate; return pictures a second, and how late they are in milliseconds."""
    first, late = len(watch.swapped), []
    start = time.perf_counter()
    sent, seen = [], first
    while time.perf_counter() - start < seconds:
        if time.perf_counter() - start >= len(sent) / rate:
            hand.move()
            sent.append(time.perf_counter())
        QApplication.processEvents()
        if len(watch.swapped) > seen:
            seen = len(watch.swapped)
            late.append(1e3 * (watch.swapped[-1] - sent[-1]))
    return (seen - first) / seconds, statistics.median(late or [float("inf")])


START = """
import json, sys, time
began = time.perf_counter()
from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QApplication
app = QApplication([])
from app.theme import theme
from app.window.main_window import MainWindow
theme.apply(app, "light")
class Painted(QObject):
    at = None
    def eventFilter(self, watched, event):
        if event.type() == QEvent.Type.Paint and self.at is None:
            self.at = time.perf_counter()
        return False
window, painted = MainWindow(), Painted()
window.installEventFilter(painted)
window.show()
until = began + 120
while painted.at is None or window.surface_view.scene is None:
    app.processEvents()
    assert time.perf_counter() < until
print(json.dumps({"painted": painted.at - began, "3-D": time.perf_counter() - began}))
sys.stdout.flush()
window.presenter.session.mark_saved()
window.close()
"""


def start():
    """Return when a new process' window is painted and when its 3-D part is there, in seconds."""
    done = subprocess.run(
        [sys.executable, "-c", START], capture_output=True, text=True, timeout=300, check=True
    )
    return json.loads(done.stdout.splitlines()[-1])
