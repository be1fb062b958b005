"""The dialog of the picture behind: each control one step of undo, and the way to the sheet."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from app.intake.commands import Importer
from app.intake.reference_dialog import ReferenceDialog
from app.intake.sheet import ImportSheet
from app.state.presenter import Presenter
from sgb_core.document import edits
from sgb_core.document.session import Session
from tests.app.helpers import tower
from tests.app.profile_editor.test_reference import source
from tests.app.waiting import let_turn, show


def test_it_shows_fades_locks_scales_removes_and_leads_back_to_the_sheet(qtbot):
    presenter = Presenter(Session(edits.set_reference(tower(), source())))
    window = QWidget()
    show(qtbot, window, 1000, 700)
    importer = Importer(presenter, window)
    importer.place()
    dialog = window.findChild(ReferenceDialog)
    let_turn()

    def labels():
        return [entry.label for entry in presenter.session.history[1:]]

    dialog.opacity.setFocus()
    QTest.keyClick(dialog.opacity, Qt.Key.Key_End)
    dialog.opacity.finish()
    assert presenter.document.reference.opacity == 1.0
    dialog.locked.click()
    assert not presenter.document.reference.locked
    dialog.shown.click()
    assert not presenter.document.reference.shown
    dialog.scale.enter(0.5)
    dialog.turn.enter(3.0)
    reference = presenter.document.reference
    assert (reference.scale, reference.turn_deg) == (0.5, 3.0)
    assert labels() == [
        "Opacity of the picture",
        "Lock the picture",
        "Show the picture",
        "Scale the picture",
        "Turn the picture",
    ]
    dialog.retrace.click()
    sheet = window.findChild(ImportSheet)
    qtbot.waitUntil(lambda: not sheet.intake.busy)
    assert sheet.intake.source.data == reference.picture.data
    assert sheet.into.findData("behind") >= 0
    dialog.remove.click()
    let_turn()
    assert presenter.document.reference is None
    assert not dialog.opacity.isEnabled()
    presenter.undo()
    assert presenter.document.reference == reference
    sheet.intake.close()
    assert pytest.approx(0.5) == presenter.document.reference.scale
