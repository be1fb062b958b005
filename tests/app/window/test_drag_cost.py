"""What one tick of a drag may touch: counted by events, not timed."""

import sys

import pytest
from PySide6.QtCore import QEvent, QObject, QSettings
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from sgb_core.curves.profile import Profile
from sgb_core.document import edits, evaluation
from sgb_core.surfaces.grid import SweepGrid
from tests.app.window_stage import WindowStage
from tests.benchmarks.window import Watch, chain, preset


class Layouts(QObject):
    """Who was asked to lay itself out."""

    def __init__(self):
        super().__init__()
        self.seen = []

    def eventFilter(self, watched, event):  # noqa: N802
        if event.type() == QEvent.Type.LayoutRequest:
            self.seen.append(watched)
        return False


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot)
    yield made
    made.presenter.cancel()
    made.close()


def ticks(stage, count):
    for k in range(count):
        value = 0.30 + 0.02 * k
        stage.presenter.apply(lambda d, v=value: edits.set_shape_parameter(d, 1, "omega", v))
        stage.settle()


def test_a_tick_does_not_lay_out_the_window(stage):
    # If it did, the window and the viewport's picture with it would be composed twice a tick.
    stage.presenter.begin("ω of segment 2")
    ticks(stage, 3)
    layouts = Layouts()
    QApplication.instance().installEventFilter(layouts)
    try:
        ticks(stage, 6)
    finally:
        QApplication.instance().removeEventFilter(layouts)
    assert stage.window not in layouts.seen


def test_the_table_is_left_alone_while_no_point_moves(stage):
    stage.presenter.begin("ω of segment 2")
    ticks(stage, 2)
    changes = []
    stage.window.panels["points"].model.dataChanged.connect(lambda *_: changes.append(None))
    points = stage.document.profile.control_points.copy()
    ticks(stage, 3)
    moved = (stage.document.profile.control_points != points).any()
    assert bool(changes) == bool(moved)
    stage.presenter.apply(lambda d: edits.move_point(d, 1, 1, (31.0, 40.0)))
    stage.settle()
    assert changes


def test_a_picture_is_drawn_once_for_each_that_is_shown(stage):
    watch = Watch(stage)
    stage.presenter.begin("ω of segment 2")
    for k in range(4):
        count = len(watch.swapped)
        stage.presenter.apply(lambda d, k=k: edits.set_shape_parameter(d, 1, "omega", 0.3 + k / 50))
        watch.until_swapped(count + 1)
    stage.settle()
    assert len(watch.drawn) == len(watch.swapped) == 4


@pytest.mark.parametrize("name", ["vase", "ceramic-pot", "melon-jar", "bowl"])
def test_a_window_left_alone_draws_nothing(stage, name):
    stage.presenter.replace_document(preset(name))
    stage.settle()
    watch = Watch(stage)
    QTest.qWait(400)
    assert watch.drawn == []
    assert watch.swapped == []


def test_panels_that_nobody_sees_do_nothing_and_show_the_newest_when_they_are_seen(stage):
    window, told = stage.window, []
    hidden = [slot for slot in window.panels if slot.made and slot._made.visibleRegion().isEmpty()]
    assert len(hidden) >= 7
    for slot in hidden:
        slot._made.refresh = lambda frame, slot=slot: told.append(slot)
    stage.presenter.begin("ω of segment 2")
    ticks(stage, 3)
    stage.presenter.commit()
    stage.settle()
    assert told == []
    window.panels.docks["turn"].raise_()
    stage.settle()
    assert [slot._made for slot in told] == [window.panels["turn"]]


def test_a_panel_is_made_when_it_is_first_seen(qtbot):
    stage = WindowStage(qtbot, make_panels=False)
    try:
        made = {key for key, slot in stage.window.panels._slots.items() if slot.made}
        assert made == {"profile", "points", "shape"}
        stage.window.panels.docks["look"].raise_()
        stage.until(lambda: stage.window.panels._slots["look"].made)
        assert stage.window.panels["look"].isVisible()
    finally:
        stage.close()


@pytest.mark.parametrize("name", ["vase", "ceramic-pot", "melon-jar"])
def test_nothing_dear_is_done_twice_for_one_move(stage, monkeypatch, name):
    stage.presenter.replace_document(preset(name))
    stage.settle()
    stage.presenter.begin("ω of segment 1")
    ticks(stage, 2)
    calls = []

    def count(owner, attribute):
        real = getattr(owner, attribute)

        def counted(*args, **more):
            calls.append(attribute)
            return real(*args, **more)

        monkeypatch.setattr(owner, attribute, counted)

    count(SweepGrid, "write")
    count(Profile, "bounds")
    for function in ("measure_joints", "measure_turning_joints", "self_intersections"):
        count(evaluation, function)
    stage.presenter.apply(lambda d: edits.set_shape_parameter(d, 0, "omega", 0.77))
    stage.presenter.refresh_now()
    QApplication.processEvents()
    assert calls.count("write") == 1
    assert len(calls) == len(set(calls)), calls


def test_a_hand_that_drags_reads_no_settings(stage, monkeypatch):
    stage.presenter.begin("ω of segment 2")
    ticks(stage, 2)
    asked, real = [], QSettings.contains
    monkeypatch.setattr(
        QSettings, "contains", lambda settings, key: asked.append(key) or real(settings, key)
    )
    for k in range(3):
        value = 0.5 + 0.02 * k
        stage.presenter.apply(lambda d, v=value: edits.set_shape_parameter(d, 1, "omega", v))
        stage.presenter.refresh_now()
    assert asked == []
    stage.presenter.commit()
    stage.settle()
    assert "measures/liquid" in asked


def python_calls(action):
    """Return how many calls an action makes, of Python functions and of others from Python."""
    count = 0

    def note(_frame, event, _arg):
        nonlocal count
        count += event in ("call", "c_call")

    sys.setprofile(note)
    try:
        action()
    finally:
        sys.setprofile(None)
    return count


def test_work_grows_with_the_number_of_segments_and_no_faster(stage):
    presenter, opened, moved = stage.presenter, {}, {}
    panel = stage.window.panels["shape"]
    # The first is not judged: the cards that are made for the others double, too.
    for count in (16, 32, 64, 128):
        document = chain(count)

        def show(document=document):
            presenter.replace_document(document)
            presenter.refresh_now()
            # What some turns of the event loop would do, without all else that they do.
            while len(panel.cards) < len(document.profile):
                panel._show_more()

        opened[count] = python_calls(show)
        stage.settle()
        presenter.begin("ω")
        ticks(stage, 2)

        def move():
            presenter.apply(lambda d: edits.set_shape_parameter(d, 5, "omega", 0.77))
            presenter.refresh_now()

        moved[count] = python_calls(move)
        presenter.cancel()
        stage.settle()
    for found in (opened, moved):
        # Linear work grows twice as much at each doubling, quadratic four times.
        assert found[128] - found[64] < 2.8 * (found[64] - found[32]), found
