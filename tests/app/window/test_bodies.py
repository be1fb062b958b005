"""Bodies in the real window: panel, cut away, fill line, measures, bad input."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest

from app.hand.hit_test import Target
from app.theme import theme
from sgb_core.bodies.solid import BodyKind
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.model import Document
from tests.app import mouse
from tests.app.window_stage import WindowStage

LEFT = Qt.MouseButton.LeftButton
SIDE = Segment(np.linspace((40.0, 0.0), (40.0, 100.0), 4))
CUP = edits.set_solid(Document(Profile.of([SIDE]), name="Cup"), kind="vessel", wall=6.0, base=8.0)


@pytest.fixture
def stage(qtbot):
    stage = WindowStage(qtbot)
    yield stage
    stage.close()


def open_cup(stage, document=CUP):
    stage.presenter.replace_document(document)
    wait_for_body(stage)


def wait_for_body(stage):
    stage.until(lambda: made(stage))
    stage.settle()


def made(stage):
    body = stage.presenter.frame.body
    return body is not None and body.fine and body.document.solid == stage.document.solid


def share_like(pixels, colour, within=40):
    wanted = np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)])
    return float((np.abs(pixels.astype(int) - wanted).max(axis=-1) < within).mean())


def test_a_vessel_by_the_panel(stage):
    window = stage.window
    stage.presenter.replace_document(edits.set_solid(CUP, kind="surface"))
    window.panels.docks["solid"].raise_()
    stage.settle()
    button = window.panels["solid"].kind_buttons[BodyKind.VESSEL]
    QTest.mouseClick(button, LEFT)
    assert stage.document.solid.kind is BodyKind.VESSEL
    assert stage.session.undo_label == "Body: vessel"
    wait_for_body(stage)
    assert stage.presenter.frame.body.mesh.is_watertight
    row = window.panels["solid"].rows["wall"]
    slider = row.slider
    start = slider.handle_centre()
    mouse.drag(slider, start, start + QPointF(30, 0))
    assert stage.document.solid.wall > 6.0
    stage.presenter.undo()
    assert stage.document.solid.wall == 6.0
    assert stage.session.undo_label == "Body: vessel"


def test_cut_away_shows_the_wall_and_the_section_view_only_that(stage):
    open_cup(stage, edits.set_fill(CUP, 60.0))
    for overlay in ("circles", "polygon", "generatrix", "quartic"):
        stage.presenter.set_view(show=stage.presenter.view.show - {overlay})
    stage.settle()
    cut, water = theme.current().cut, theme.current().liquid
    whole = stage.viewport()
    assert share_like(whole, cut) < 1e-4
    stage.window.commands["cut_half"].trigger()
    stage.settle()
    half = stage.viewport()
    assert share_like(half, cut) > 0.005
    assert share_like(half, water, 70) > share_like(whole, water, 70) + 0.02
    stage.window.commands["cut_section"].trigger()
    stage.settle()
    section = stage.viewport()
    assert share_like(section, cut, 12) > 0.01
    assert share_like(section, theme.current().surface, 30) < 1e-3
    stage.window.commands["cut_none"].trigger()
    stage.settle()
    assert share_like(stage.viewport(), cut) < 1e-4


def test_the_fill_line_is_dragged_in_the_editor(stage):
    open_cup(stage, edits.set_fill(CUP, 50.0))
    editor = stage.window.profile_view
    line = editor.transform.map((0.0, 50.0))
    at = QPointF(editor.area.right - 20.0, float(line[1]))
    mouse.hover(editor, at)
    stage.settle()
    assert editor.active.target is Target.LEVEL
    goal = QPointF(at.x(), float(editor.transform.map((0.0, 80.0))[1]))
    mouse.drag(editor, at, goal)
    assert stage.document.manufacture.fill.height == pytest.approx(80.0, abs=1.5)
    assert stage.session.undo_label == "Fill line"
    stage.presenter.undo()
    assert stage.document.manufacture.fill.height == 50.0


def test_measures_and_a_volume_to_hold(stage):
    open_cup(stage)
    window = stage.window
    window.panels.docks["measures"].raise_()
    holds = window.panels["measures"].body_values["To the brim"]
    # π·34²·92 mm³.
    stage.until(lambda: holds.text() == "334.11 ml")
    parts = window.panels["measures"].holding
    parts.target.setFocus()
    parts.target.selectAll()
    QTest.keyClicks(parts.target, "500")
    QTest.keyClick(parts.target, Qt.Key.Key_Return)
    QTest.mouseClick(parts.set_button, LEFT)
    assert stage.session.undo_label == "Hold 500 ml"
    stage.until(lambda: holds.text() == "500.00 ml")
    stage.presenter.undo()
    assert stage.document is CUP


def test_a_wall_thicker_than_the_pot_is_one_line_and_loses_nothing(stage):
    open_cup(stage)
    stage.window.panels.docks["solid"].raise_()
    stage.presenter.do("Wall", lambda document: edits.set_solid(document, wall=50.0))
    stage.until(lambda: bool(stage.window.panels["solid"].findings.text()))
    text = stage.window.panels["solid"].findings.text()
    assert text.startswith("⚠ Wall: ")
    assert len(text.splitlines()) == 1
    stage.presenter.undo()
    wait_for_body(stage)
    assert stage.window.panels["solid"].findings.text() == ""
    assert stage.document is CUP
