"""The sheet of variants in a real window: keys, ghost, taking, undo, caption."""

import os
import sys

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.commands.variants_dialog import VariantsDialog, changed
from sgb_core.document.dimensions import missed_locks
from tests.app import mouse
from tests.app.window_stage import WindowStage
from tests.sgb_core.design.locks.samples import locked, pot

pytestmark = pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)
Key = Qt.Key
BOTH = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    made.presenter.replace_document(locked(pot(3), "capacity", "rim_diameter"))
    made.settle()
    yield made
    made.close()


def opened(stage):
    view = stage.window.profile_view
    view.setFocus()
    QTest.keyClick(view, Key.Key_V, BOTH)
    dialog = stage.window.findChild(VariantsDialog)
    found(stage, dialog)
    return dialog


def found(stage, dialog):
    stage.until(lambda: dialog._job is None)
    stage.settle()


def test_the_keyboard_alone_shows_ghosts_and_takes_in_one_step(stage):
    document = stage.document
    dialog = opened(stage)
    tiles = dialog.tiles
    assert len(tiles.tiles) == len(dialog.variants) == 12
    assert dialog.told.text().startswith("All keep Capacity ")
    assert "Rim diameter " in dialog.told.text()
    tiles.setFocus()
    QTest.keyClick(tiles, Key.Key_Right)
    stage.settle()
    assert stage.presenter.frame.compared.document is dialog.variants[1].document
    assert stage.document is document
    QTest.keyClick(tiles, Key.Key_Return)
    stage.settle()
    assert stage.document is dialog.variants[1].document
    assert missed_locks(stage.document) == ()
    assert len(dialog.variants) == 12
    stage.presenter.undo()
    stage.settle()
    assert stage.document is document
    assert not stage.session.undo()
    QTest.keyClick(dialog, Key.Key_Escape)
    stage.settle()
    assert stage.presenter.view.ghost is None
    assert stage.window.findChild(VariantsDialog) is None


def test_a_click_takes_and_another_takes_another(stage):
    dialog = opened(stage)
    for row in (3, 0):
        dialog.tiles.scrollToItem(dialog.tiles.item(row))
        place = dialog.tiles.visualItemRect(dialog.tiles.item(row)).center()
        mouse.press(dialog.tiles.viewport(), place)
        mouse.release(dialog.tiles.viewport(), place)
        stage.settle()
        assert stage.document is dialog.variants[row].document
    assert len(stage.session.history) == 3


def test_parameters_are_chosen_and_other_edits_are_followed(stage):
    dialog = opened(stage)
    dialog.way.setCurrentIndex(3)
    found(stage, dialog)
    titles = [tile.title for tile in dialog.tiles.tiles]
    assert titles
    assert all("λ2 " in title for title in titles)
    before = dialog.variants
    stage.presenter.replace_document(pot(2))
    stage.settle()
    found(stage, dialog)
    assert dialog.variants != before
    assert "Capacity" not in dialog.told.text()
    assert all(len(each.document.profile) == 2 for each in dialog.variants)


@pytest.mark.parametrize(
    ("percent", "words"),
    [(0.004, "as now"), (-0.3, "−0.3 %"), (0.3, "+0.3 %"), (-12.4, "−12 %"), (9.96, "+10 %")],
)
def test_small_changes_are_told_in_tenths_and_none_is_none(percent, words):
    assert changed(percent) == words
