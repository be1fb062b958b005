"""What one tick of a drag may touch: counted by events, not timed."""

import pytest
from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QApplication

from sgb_core.document import edits
from tests.app.window_stage import WindowStage


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
