"""The print dialog: from a printer to a path seen, told and written."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QFileDialog

import resources
from app.printing import print_path
from app.printing.dialog import PrintDialog
from app.state import printers, user_folders
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document.model import Document

CUP = Document(Profile.of([line((25.0, 0.0), (30.0, 24.0))]), name="Cup")


@pytest.fixture(autouse=True)
def _own_folder(monkeypatch, tmp_path):
    monkeypatch.setattr(user_folders, "printers", lambda: tmp_path / "printers")


@pytest.fixture
def dialog(qtbot):
    found = PrintDialog(CUP)
    qtbot.addWidget(found, before_close_func=lambda each: each.done(0))
    found.show()
    return found


def choose(qtbot, dialog, name: str) -> None:
    names = [printer.name for printer in printers.known()]
    dialog.printer.setCurrentIndex(names.index(name))
    qtbot.waitUntil(lambda: dialog.path is not None)


def painted(dialog) -> np.ndarray:
    image = (
        dialog.view.grab()
        .toImage()
        .convertToFormat(dialog.view.grab().toImage().Format.Format_RGB32)
    )
    width, height = image.width(), image.height()
    return np.frombuffer(image.constBits(), np.uint8).reshape(height, width, 4)[..., :3].copy()


def test_a_path_is_made_seen_and_told_for_the_printer_chosen(qtbot, dialog) -> None:
    choose(qtbot, dialog, "generic-clay")
    assert dialog.layer.value == 1.5
    assert dialog.write.isEnabled()
    assert "layers" in dialog.totals.text()
    assert "g as printed" in dialog.totals.text()
    whole = painted(dialog)
    dialog.moment.setValue(100)
    begun = painted(dialog)
    assert (np.abs(whole.astype(int) - begun).max(axis=2) > 40).sum() > 2_000


def test_the_printer_and_its_layer_are_those_of_the_last_time(qtbot, dialog) -> None:
    choose(qtbot, dialog, "generic-clay")
    dialog.layer.enter(2.0)
    qtbot.waitUntil(lambda: dialog.path is not None)
    again = PrintDialog(CUP)
    qtbot.addWidget(again, before_close_func=lambda each: each.done(0))
    assert (again.machine.name, again.layer.value) == ("generic-clay", 2.0)
    again.printer.setCurrentIndex(0)
    assert again.layer.value == again.machine.layer.usual


def test_settings_lead_to_another_path_and_nonsense_to_a_line(qtbot, dialog) -> None:
    choose(qtbot, dialog, "generic-clay")
    layers = dialog.path.layer_count
    dialog.layer.enter(3.0)
    assert not dialog.write.isEnabled()
    qtbot.waitUntil(lambda: dialog.path is not None)
    assert dialog.path.layer_count < layers
    dialog.floors.enter(200.0)
    qtbot.waitUntil(lambda: "lower than one layer" in dialog.totals.text())
    assert not dialog.write.isEnabled()
    assert dialog.totals.text()[0].isupper()


def test_the_view_turns_by_mouse_and_keys_and_is_coloured_by_choice(qtbot, dialog) -> None:
    choose(qtbot, dialog, "generic-clay")
    before = painted(dialog)
    QTest.mousePress(dialog.view, Qt.MouseButton.LeftButton, pos=QPoint(100, 100))
    QTest.mouseMove(dialog.view, QPoint(220, 100))
    QTest.mouseRelease(dialog.view, Qt.MouseButton.LeftButton, pos=QPoint(220, 100))
    turned = painted(dialog)
    assert (before != turned).any()
    QTest.keyClick(dialog.view, Qt.Key.Key_Left)
    assert (painted(dialog) != turned).any()
    told = dialog.range.text()
    dialog.colouring.setCurrentIndex(2)
    assert "mm/s" in dialog.range.text()
    assert dialog.range.text() != told


def test_a_vessels_wall_is_divided_into_beads(qtbot) -> None:
    vessel = replace(CUP, solid=Solid(BodyKind.VESSEL, wall=3.0, base=2.0))
    found = PrintDialog(vessel)
    qtbot.addWidget(found, before_close_func=lambda each: each.done(0))
    assert (found.walls.value, found.bead.value) == (4.0, 0.75)
    assert found.floors.value == 10.0
    found.walls.enter(5.0)
    assert found.bead.value == pytest.approx(0.6)


def test_a_printer_of_ones_own_is_added_and_a_wrong_file_is_named(
    qtbot, dialog, tmp_path, monkeypatch
) -> None:
    own = json.loads(resources.printers()[0].read_bytes()) | {"name": "mine", "title": "My own"}
    path = tmp_path / "mine.json"
    path.write_text(json.dumps(own))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    qtbot.mouseClick(dialog.add_printer, Qt.MouseButton.LeftButton)
    assert dialog.machine.title == "My own"
    assert [printer.name for printer in printers.known()][-1] == "mine"
    path.write_text(json.dumps(own | {"nozzle": -1}))
    qtbot.mouseClick(dialog.add_printer, Qt.MouseButton.LeftButton)
    assert "nozzle is -1" in dialog.totals.text()
    (user_folders.printers() / "broken.json").write_text("{")
    assert [printer.name for printer in printers.known()][-1] == "mine"


class _Exporting:
    """Takes what is to be written, and writes it at once."""

    def __init__(self, path) -> None:
        self.path = path

    def ask_path(self, title, suffix):
        assert suffix == ".gcode"
        return self.path

    def write(self, path, work) -> None:
        work(lambda _: None)


def test_what_was_seen_is_what_is_written(qtbot, tmp_path, monkeypatch) -> None:
    made = []

    def run(dialog):
        qtbot.waitUntil(lambda: dialog.path is not None)
        made.append(dialog.path)
        dialog.done(QDialog.DialogCode.Accepted)
        return QDialog.DialogCode.Accepted

    monkeypatch.setattr(PrintDialog, "exec", run)
    target = tmp_path / "cup.gcode"
    presenter = type("Presenter", (), {"document": CUP})()
    print_path.print_path(_Exporting(target), presenter, None)
    text = target.read_text()
    assert text.startswith("; Cup: a continuous path")
    assert text.count(";LAYER:") == made[0].layer_count
