"""A moving picture is drawn in as many pixels as the machine can draw in time."""

import pytest
from PySide6.QtCore import QObject, QSize, Signal

from app.viewport import drag_resolution
from app.viewport.drag_resolution import BUDGET, DragResolution


class Window:
    """A render window that notes its size and calls its observers when it draws."""

    def __init__(self, clock):
        self.clock, self.observers, self.size = clock, {}, (800, 600)

    def AddObserver(self, name, call):  # noqa: N802
        self.observers[name] = call

    def GetSize(self):  # noqa: N802
        return self.size

    def SetSize(self, *size):  # noqa: N802
        self.size = size

    def draw(self, seconds):
        self.observers["StartEvent"]()
        self.clock.now += seconds
        self.observers["EndEvent"]()


class Plotter(QObject):
    resized = Signal()

    def __init__(self, window):
        super().__init__()
        self.ren_win, self.area = window, QSize(800, 600)

    def size(self):
        return self.area

    def devicePixelRatioF(self):  # noqa: N802
        return 1.0


class Scene:
    ratio = None

    def set_pixel_ratio(self, ratio):
        self.ratio = ratio


class Clock:
    now = 0.0

    def __call__(self):
        return self.now


@pytest.fixture
def drawn(qapp, monkeypatch):
    clock = Clock()
    monkeypatch.setattr(drag_resolution, "perf_counter", clock)
    plotter = Plotter(Window(clock))
    scene = Scene()
    return DragResolution(plotter, scene), plotter, scene


def test_what_is_drawn_quickly_is_always_drawn_in_full(drawn):
    resolution, plotter, scene = drawn
    for _ in range(9):
        resolution.move()
        plotter.ren_win.draw(0.9 * BUDGET)
    assert plotter.ren_win.size == (800, 600)
    assert scene.ratio == 1.0


def test_where_drawing_holds_up_the_hand_half_is_drawn_and_the_rest_is_in_full(drawn):
    resolution, plotter, scene = drawn
    # One slow picture, as of a new shader, tells nothing.
    for seconds in (50 * BUDGET, 0.1 * BUDGET, 0.1 * BUDGET, 3 * BUDGET, 3 * BUDGET):
        resolution.move()
        assert plotter.ren_win.size == (800, 600)
        plotter.ren_win.draw(seconds)
    resolution.move()
    assert plotter.ren_win.size == (400, 300)
    # As wide on the screen as before.
    assert scene.ratio == 0.5
    resolution.rest()
    assert (plotter.ren_win.size, scene.ratio) == ((800, 600), 1.0)
    # A refined picture is slow everywhere and says nothing about moving ones.
    for _ in range(5):
        plotter.ren_win.draw(0.001 * BUDGET)
    resolution.move()
    assert plotter.ren_win.size == (400, 300)


def test_it_is_drawn_in_full_again_where_that_has_become_quick(drawn):
    resolution, plotter, _ = drawn
    for seconds in (2 * BUDGET,) * 3 + (BUDGET / 4,) * 3:
        resolution.move()
        plotter.ren_win.draw(seconds)
    resolution.move()
    assert plotter.ren_win.size == (400, 300)
    for _ in range(3):
        plotter.ren_win.draw(BUDGET / 10)
    resolution.move()
    assert plotter.ren_win.size == (800, 600)


def test_another_size_of_the_widget_is_followed_in_the_middle_of_a_drag(drawn):
    resolution, plotter, _ = drawn
    for _ in range(3):
        resolution.move()
        plotter.ren_win.draw(2 * BUDGET)
    resolution.move()
    plotter.area = QSize(1000, 500)
    plotter.ren_win.SetSize(1000, 500)
    plotter.resized.emit()
    assert plotter.ren_win.size == (500, 250)
