"""Relief in the real window: set by keys, paint while the hand moves, geometry when it rests."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.appearance.model import Layer, LayerKind, Raised, Texture
from sgb_core.document.model import Document
from tests.app.window_stage import WindowStage

SIDE = Segment(np.linspace((40.0, 0.0), (40.0, 100.0), 4))
TUBE = edits.set_appearance(
    Document(Profile.of([SIDE]), name="Cup"),
    drawing=(
        Layer(LayerKind.BAND, start=0.3, end=0.5),
        Layer(LayerKind.BAND, start=0.6, end=0.7),
    ),
)
PICTURED = edits.set_appearance(
    Document(Profile.of([SIDE])), textures=(Texture("lotus", repeat=(2.0, 0.0), edge=8.0),)
)
CUP = edits.set_solid(TUBE, kind="vessel", wall=4.0, base=5.0)


@pytest.fixture
def stage(qtbot):
    stage = WindowStage(qtbot)
    stage.window.panels.docks["look"].raise_()
    yield stage
    stage.close()


def show(stage, document):
    stage.presenter.replace_document(document)
    stage.settle()
    return stage.window.panels["look"]


def typed(stage, field, text):
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key.Key_Return)
    stage.settle()


def made(stage):
    body = stage.presenter.frame.body
    same = body is not None and body.document.appearance == stage.document.appearance
    return same and body.fine


def widest(stage):
    positions = stage.presenter.frame.body.mesh.positions
    return float(np.hypot(positions[:, 0], positions[:, 1]).max())


@pytest.mark.parametrize("document", [TUBE, CUP], ids=["bare", "vessel"])
def test_the_chosen_layer_is_raised_and_lowered_again(stage, document):
    part = show(stage, document).drawing
    part.layers.setCurrentRow(1)
    stage.settle()
    assert not part.edge.isVisible()
    before = stage.presenter.frame.body
    assert before is None or before.mesh is not None
    typed(stage, part.relief, "2.5")
    layers = stage.document.appearance.drawing
    assert [layer.relief for layer in layers] == [0.0, 2.5]
    assert part.edge.isVisible()
    typed(stage, part.edge, "4")
    assert [layer.edge for layer in stage.document.appearance.drawing] == [1.0, 4.0]
    stage.until(lambda: made(stage))
    assert widest(stage) == pytest.approx(42.5, abs=0.05)
    assert stage.presenter.frame.body.findings == ()
    stage.presenter.undo()
    stage.presenter.undo()
    stage.settle()
    assert stage.document.appearance == document.appearance
    stage.until(
        lambda: stage.presenter.frame.body is None if document is TUBE else widest(stage) < 40.1
    )


def test_a_picture_is_raised_by_what_is_chosen(stage):
    part = show(stage, PICTURED).texture
    assert not part.raised.isVisible()
    typed(stage, part.relief, "1")
    place = part.raised.findData(Raised.DARK)
    part.raised.setFocus()
    while part.raised.currentIndex() != place:
        QTest.keyClick(part.raised, Qt.Key.Key_Down)
        stage.settle()
    found = stage.document.appearance.textures[0]
    assert (found.relief, found.raised) == (1.0, Raised.DARK)
    stage.until(lambda: made(stage))
    assert widest(stage) > 40.5


def test_a_wall_that_would_be_pierced_is_one_line_and_stays_whole(stage):
    part = show(stage, CUP).drawing
    part.layers.setCurrentRow(0)
    typed(stage, part.relief, "-4")
    stage.until(lambda: made(stage))
    stage.settle()
    told = stage.window.panels["solid"].findings.text()
    assert "pierces the wall of 4" in told
    assert "\n" not in told
    assert stage.presenter.frame.body.mesh.is_watertight
    typed(stage, part.relief, "-3")
    stage.until(lambda: made(stage))
    stage.settle()
    assert stage.presenter.frame.body.measures.vessel.wall_min == pytest.approx(1.0, abs=1e-6)
    assert "leaves only 1 of the wall of 4" in stage.window.panels["solid"].findings.text()


def test_a_raised_band_is_seen_when_the_hand_rests(stage):
    part = show(stage, CUP).drawing
    part.layers.setCurrentRow(0)
    stage.until(lambda: made(stage))
    stage.settle()
    flat = stage.viewport().astype(int)
    typed(stage, part.relief, "6")
    stage.until(lambda: made(stage))
    stage.settle()
    changed = np.abs(stage.viewport().astype(int) - flat).max(axis=2) > 24
    # The band's sides stand out on both sides of the vessel.
    columns = np.flatnonzero(changed.any(axis=0))
    assert changed.sum() > 500
    assert columns[0] < changed.shape[1] / 2 < columns[-1]
