"""Holes in the real window: chosen, sized, undone; cut when the hand rests; refused in a line."""

import numpy as np
import pytest
from PIL import Image
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


def test_a_text_and_a_picture_are_two_patterns_edited_one_by_one(stage, tmp_path):
    rows = choose(stage, "Text")
    assert rows.drawn.text.isVisible()
    assert not rows.lengths["width"].isVisible()
    rows.drawn.text.setFocus()
    rows.drawn.text.selectAll()
    QTest.keyClicks(rows.drawn.text, "Ob")
    QTest.keyClick(rows.drawn.text, Qt.Key.Key_Return)
    assert stage.document.cut_outs[0].text == "Ob"
    rows.counts["around"].enter(2.0)
    stage.until(lambda: made(stage) and "8 holes" in rows.told.text())
    assert stage.presenter.frame.body.mesh.is_watertight
    QTest.mouseClick(rows.pattern.more, Qt.MouseButton.LeftButton)
    assert len(stage.document.cut_outs) == 2
    choose(stage, "Dark parts of a picture")
    picture = tmp_path / "bar.png"
    grey = np.full((30, 60), 255, np.uint8)
    grey[10:20, 15:45] = 0
    Image.fromarray(grey).save(picture)
    rows.drawn.take_picture(picture)
    rows.lengths["width"].field.enter(20.0)
    assert [each.text for each in stage.document.cut_outs] == ["Ob", "LIGHT"]
    assert stage.document.appearance.picture(stage.document.cut_outs[1].picture) is not None
    rows.pattern.which.setFocus()
    QTest.keyClick(rows.pattern.which, Qt.Key.Key_Up)
    assert rows.shape.currentText() == "Text"
    assert rows.drawn.text.text() == "Ob"
    rows.shape.activated.emit(rows.shape.findText("None"))
    (left,) = stage.document.cut_outs
    assert left.width == 20.0
    stage.presenter.undo()
    assert len(stage.document.cut_outs) == 2
    rows.drawn.take_picture(tmp_path / "none.png")
    assert len(stage.document.appearance.pictures) == 1


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
