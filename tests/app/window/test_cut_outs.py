"""Holes in the real window: chosen, sized, undone; cut when the hand rests; refused in a line."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.model import Document
from tests.app.window_stage import WindowStage

SIDE = Segment(np.linspace((40.0, 0.0), (40.0, 100.0), 4))
CUP = edits.set_solid(Document(Profile.of([SIDE]), name="Cup"), kind="vessel", wall=4.0, base=5.0)


@pytest.fixture
def stage(qtbot):
    stage = WindowStage(qtbot)
    stage.presenter.replace_document(CUP)
    stage.window.panels.docks["solid"].raise_()
    stage.settle()
    yield stage
    stage.close()


def made(stage):
    body = stage.presenter.frame.body
    return body is not None and body.fine and body.document.cut_outs == stage.document.cut_outs


def choose(stage, text):
    rows = stage.window.panels["solid"].cut_outs
    rows.shape.setFocus()
    place = rows.shape.findText(text)
    assert place >= 0, text
    step = Qt.Key.Key_Down if place > rows.shape.currentIndex() else Qt.Key.Key_Up
    while rows.shape.currentIndex() != place:
        QTest.keyClick(rows.shape, step)
        stage.settle()
    return rows


def test_holes_are_chosen_by_keys_and_cut_when_the_hand_rests(stage):
    rows = stage.window.panels["solid"].cut_outs
    assert not rows.parts.isVisible()
    choose(stage, "Hexagons")
    assert rows.parts.isVisible()
    stage.until(lambda: made(stage))
    body = stage.presenter.frame.body
    assert body.unworked is None
    assert body.mesh.is_watertight
    assert body.measures.vessel.material_volume < CUP.body().material_volume
    assert "36 holes" in rows.told.text()
    rows.counts["around"].enter(8.0)
    assert stage.document.cut_outs[0].around == 8
    stage.presenter.undo()
    assert stage.document.cut_outs[0].around == 12
    choose(stage, "None")
    assert stage.document.cut_outs == ()
    stage.presenter.undo()
    assert stage.document.cut_outs != ()


def test_holes_that_cannot_be_are_one_line_and_the_wall_stays_whole(stage):
    panel = stage.window.panels["solid"]
    rows = choose(stage, "Circles")
    rows.counts["around"].enter(60.0)
    stage.until(lambda: made(stage))
    stage.settle()
    assert stage.presenter.frame.body.mesh.is_watertight
    assert panel.findings.isVisible()
    assert "overlap" in panel.findings.text()
    assert "\n" not in panel.findings.text()
