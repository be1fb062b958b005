"""Reach targets in a real window: typed, seen at once, taken, refused with the nearest, undone."""

import os
import sys
from math import inf

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.commands import targets
from app.commands.targets_dialog import TargetsDialog
from sgb_core.curves.segment import ShapeParameters
from sgb_core.design.fairing.findings import Keep
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.solving.goals import Goal
from sgb_core.design.solving.ways import Way
from sgb_core.document import edits
from sgb_core.document.dimensions import missed_locks
from sgb_core.document.edits.reach import goal_value
from tests.app.helpers import tower
from tests.app.window_stage import WindowStage

pytestmark = pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)
Key = Qt.Key


@pytest.fixture(autouse=True)
def patience(monkeypatch):
    """Nothing here hangs on how fast the machine is."""
    monkeypatch.setattr(targets, "PATIENCE", inf)


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    plain = edits.scale(edits.reverse_profile(tower(ShapeParameters(omega=1.0))), 5.0)
    made.presenter.replace_document(edits.set_solid(plain, kind="vessel", wall=2.0, base=3.0))
    made.settle()
    yield made
    made.close()


@pytest.fixture
def dialog(stage):
    modifiers = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    stage.window.profile_view.setFocus()
    QTest.keyClick(stage.window.profile_view, Key.Key_T, modifiers)
    made = stage.window.findChild(TargetsDialog)
    # Without a window manager nobody else does: keys are then those of the window behind.
    made.activateWindow()
    stage.until(made.isActiveWindow)
    return made


def line(dialog, words):
    return next(each for each in dialog.lines if each.line.words == words)


def enter(stage, field, text):
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Key.Key_Return)
    stage.until(lambda: not stage.window.jobs.running)
    stage.settle()


def test_what_is_typed_is_seen_at_once_and_is_one_step_of_undo(stage, dialog):
    before, steps = stage.document, stage.presenter.session.position
    enter(stage, line(dialog, "Capacity").field, "0.12l + 30ml")
    assert line(dialog, "Capacity").check.isChecked()
    assert goal_value(stage.document, Goal.CAPACITY) == pytest.approx(150_000.0, rel=1e-9)
    enter(stage, line(dialog, "Rim diameter").field, "5.2cm")
    assert goal_value(stage.document, Goal.CAPACITY) == pytest.approx(150_000.0, rel=1e-9)
    assert goal_value(stage.document, Goal.RIM_DIAMETER) == pytest.approx(52.0, rel=1e-9)
    assert stage.presenter.session.position == steps
    assert "Reached" in dialog.told.text()
    # With nothing left to enter, Enter is the dialog's own key.
    QTest.keyClick(line(dialog, "Rim diameter").field, Key.Key_Return)
    assert stage.presenter.session.position == steps + 1
    stage.presenter.undo()
    assert stage.document is before


def test_a_tick_keeps_what_is_and_a_mass_is_the_materials(stage, dialog):
    before = stage.document
    line(dialog, "Height").check.setChecked(True)
    line(dialog, "Material").check.setChecked(True)
    enter(stage, line(dialog, "Mass").field, "0.21kg")
    assert not line(dialog, "Material").check.isChecked()
    after = stage.document
    height = goal_value(before, Goal.HEIGHT)
    assert goal_value(after, Goal.HEIGHT) == pytest.approx(height, rel=1e-9)
    density = after.manufacture.material.density
    grams = goal_value(after, Goal.MATERIAL) / 1000.0 * density
    assert grams == pytest.approx(210.0, rel=1e-9)
    # Without a wish all is as it was; Escape leaves nothing behind either.
    for each in dialog.lines:
        each.check.setChecked(False)
    assert stage.document is before
    enter(stage, line(dialog, "Height").field, "61mm")
    QTest.keyClick(dialog, Key.Key_Escape)
    assert stage.document is before
    assert not stage.presenter.session.in_gesture


def test_by_one_slider_and_out_of_reach_the_nearest_is_shown(stage, dialog):
    before = stage.document
    dialog.way.setCurrentIndex(dialog.way.count() - 1)
    dialog.parameter.setCurrentIndex(1)
    assert dialog.segment.isEnabled()
    enter(stage, dialog.segment, "2")
    enter(stage, line(dialog, "Volume").field, "9 l")
    assert "out of reach" in dialog.told.text()
    assert "9000 ml" in dialog.told.text()
    assert "lambda2 of segment 2" in dialog.told.text()
    after = stage.document
    assert after.profile.segments[1].shape.lambda2 in (0.0, 6.0)
    assert after.profile.segments[0] == before.profile.segments[0]
    assert goal_value(after, Goal.VOLUME) > goal_value(before, Goal.VOLUME)


def test_locks_hold_and_another_hand_begins_anew(stage, dialog):
    presenter = stage.presenter
    dimension = Dimension(DimensionKind.RIM_DIAMETER)
    presenter.do("lock", lambda d: edits.set_lock(edits.add_dimension(d, dimension), 0, True))
    stage.settle()
    dialog.keeps[Keep.TANGENTS].setChecked(True)
    enter(stage, line(dialog, "Capacity").field, "150")
    assert missed_locks(stage.document) == ()
    assert goal_value(stage.document, Goal.CAPACITY) == pytest.approx(150_000.0, rel=1e-9)
    # Something else that is done keeps what is seen, and the search goes on from there.
    presenter.do("taller", lambda d: edits.scale(d, 1.1))
    stage.until(lambda: not stage.window.jobs.running)
    stage.settle()
    dialog.way.setCurrentIndex(dialog.way.findData(Way.POINTS))
    stage.until(lambda: not stage.window.jobs.running)
    stage.settle()
    assert goal_value(stage.document, Goal.CAPACITY) == pytest.approx(150_000.0, rel=1e-9)
    assert missed_locks(stage.document) == ()


def test_who_waits_too_long_sees_the_nearest_so_far_and_may_look_longer(stage, dialog, monkeypatch):
    monkeypatch.setattr(targets, "PATIENCE", 1e-6)
    before = goal_value(stage.document, Goal.CAPACITY)
    assert not dialog.longer.isEnabled()
    enter(stage, line(dialog, "Capacity").field, "150")
    assert "is not reached so far, the nearest is" in dialog.told.text()
    assert goal_value(stage.document, Goal.CAPACITY) == pytest.approx(before)
    assert dialog.longer.isEnabled()
    dialog.longer.setFocus()
    QTest.keyClick(dialog.longer, Key.Key_Space)
    stage.until(lambda: not stage.window.jobs.running)
    stage.settle()
    assert dialog.told.text().startswith("Reached")
    assert not dialog.longer.isEnabled()
    assert goal_value(stage.document, Goal.CAPACITY) == pytest.approx(150_000.0, rel=1e-9)


def test_a_search_that_is_cancelled_below_says_so(stage, dialog):
    field = line(dialog, "Capacity").field
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "151")
    QTest.keyClick(field, Key.Key_Return)
    stage.window.jobs.cancel_all()
    stage.until(lambda: not stage.window.jobs.running)
    assert dialog.told.text().startswith("Stopped")
    assert dialog.longer.isEnabled()
