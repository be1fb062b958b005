"""Dragging joints: at the axis they stop, and H switches how they take their handles along."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt

from app.state import preferences
from tests.app.profile_editor.bench import CTRL, Bench, vase


@pytest.fixture
def bench(qtbot):
    preferences.change(scale_legs=False, cross_axis=False)
    yield Bench(qtbot, vase("G1"))
    preferences.change(scale_legs=False, cross_axis=False)


def beyond(bench):
    return QPointF(bench.view.transform.x0 - 60.0, bench.place(0, 3).y())


def test_a_drag_stops_at_the_axis_unless_preferred_otherwise(bench):
    bench.drag(bench.place(0, 3), beyond(bench), modifiers=CTRL)
    assert bench.point(0, 3)[0] == 0.0
    assert bench.document.profile.control_points[..., 0].min() >= 0.0
    bench.presenter.undo()
    bench.settle()
    preferences.change(cross_axis=True)
    bench.drag(bench.place(0, 3), beyond(bench), modifiers=CTRL)
    assert bench.point(0, 3)[0] < 0.0


def test_h_switches_the_handles_in_the_middle_of_a_drag(bench):
    start = bench.place(0, 3)
    legs = bench.point(0, 2) - bench.point(0, 3)
    bench.press(start)
    to = start + QPointF(40.0, 60.0)
    bench.move(to)
    carried = bench.point(0, 2) - bench.point(0, 3)
    assert np.allclose(carried, legs)
    bench.key(Qt.Key.Key_H)
    scaled = bench.point(0, 2) - bench.point(0, 3)
    assert not np.allclose(np.hypot(*scaled), np.hypot(*legs), rtol=0.05)
    assert abs(scaled[0] * legs[1] - scaled[1] * legs[0]) < 1e-9 * np.hypot(*legs) ** 2
    bench.key(Qt.Key.Key_H)
    assert np.allclose(bench.point(0, 2) - bench.point(0, 3), legs)
    bench.release(to)
    assert bench.undo_entries == ["Move joint 1–2"]


def test_the_preference_says_which_comes_first(bench):
    preferences.change(scale_legs=True)
    legs = bench.point(0, 2) - bench.point(0, 3)
    bench.drag(bench.place(0, 3), bench.place(0, 3) + QPointF(40.0, 60.0))
    assert not np.allclose(bench.point(0, 2) - bench.point(0, 3), legs)
