"""Live fair in a real window: the switch, sliders that move by themselves, one step of undo."""

import os
import sys

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

import sgb_core as sgb
from sgb_core.document.dimensions import missed_locks
from sgb_core.surfaces.measures import bending_energy
from tests.app import mouse
from tests.app.window_stage import WindowStage
from tests.sgb_core.design.locks.samples import locked, pot, wavy

pytestmark = pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)
BOTH = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    made.presenter.replace_document(sgb.Document(wavy(3)))
    made.settle()
    yield made
    made.close()


def place(stage, design):
    x, y = stage.window.profile_view.transform.map(np.array(design)).tolist()
    return QPoint(round(x), round(y))


def sliders(stage):
    """The values of all sliders as the Shape panel shows them."""
    panel = stage.window.panels["shape"]
    return [tuple(row.slider.number for row in card.rows.values()) for card in panel.cards]


def toggle(stage):
    view = stage.window.profile_view
    view.setFocus()
    QTest.keyClick(view, Qt.Key.Key_L, BOTH)
    stage.settle()


def test_key_menu_and_button_say_the_same(stage):
    button = stage.window.profile_view._buttons.switches["live_fair"]
    action = stage.window.commands["live_fair"]
    assert not button.isChecked()
    toggle(stage)
    assert button.isChecked()
    assert action.isChecked()
    assert "Ctrl+Alt+L" in button.toolTip()
    button.click()
    stage.settle()
    assert not action.isChecked()
    assert stage.presenter.view.live_fair is None


def test_sliders_are_seen_moving_and_all_is_one_step_of_undo(stage):
    document = stage.document
    toggle(stage)
    view, start = stage.window.profile_view, place(stage, document.profile[1].points[0])
    before = sliders(stage)
    mouse.press(view, start)
    for step in (5, 12, 20):
        mouse.move(view, start + QPoint(step, 4))
        stage.settle()
    during = sliders(stage)
    mouse.release(view, start + QPoint(20, 4))
    stage.settle()
    assert during[0] != before[0]
    assert during[1] != before[1]
    assert during[2] == before[2]
    moved = stage.document
    stage.presenter.undo()
    assert stage.document is document
    toggle(stage)
    mouse.drag(view, start, start + QPoint(20, 4))
    stage.settle()
    plain = stage.document
    assert plain.profile.control_points.tobytes() == moved.profile.control_points.tobytes()
    assert bending_energy(moved.profile) < bending_energy(plain.profile)


def test_arrows_and_typed_numbers_are_followed_too(stage):
    toggle(stage)
    before = sliders(stage)
    view = stage.window.profile_view
    stage.presenter.select(1, 0)
    stage.settle()
    view.setFocus()
    QTest.keyClick(view, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    stage.settle()
    nudged = sliders(stage)
    assert nudged[0] != before[0]
    start = place(stage, stage.document.profile[1].points[0])
    mouse.press(view, start)
    mouse.move(view, start + QPoint(9, 0))
    QTest.keyClicks(view, "52")
    stage.settle()
    mouse.release(view, start + QPoint(9, 0))
    stage.settle()
    assert stage.document.profile[1].points[0][0] == 52.0
    assert sliders(stage)[0] != nudged[0]


def test_locks_hold_and_escape_restores(stage):
    document = locked(pot(4), "capacity", "rim_diameter")
    stage.presenter.replace_document(document)
    stage.settle()
    toggle(stage)
    view, start = stage.window.profile_view, place(stage, document.profile[2].points[0])
    mouse.press(view, start)
    mouse.move(view, start + QPoint(10, 3))
    stage.settle()
    assert stage.document is not document
    QTest.keyClick(view, Qt.Key.Key_Escape)
    mouse.release(view, start + QPoint(10, 3))
    stage.settle()
    assert stage.document is document
    mouse.drag(view, start, start + QPoint(10, 3))
    stage.settle()
    assert missed_locks(stage.document) == ()
