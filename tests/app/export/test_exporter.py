"""Exports from the window: what the dialog promises is what the file holds."""

import threading
from math import pi
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PySide6.QtCore import QSettings
from PySide6.QtGui import QDesktopServices, QGuiApplication
from PySide6.QtWidgets import QDialog, QWidget

from app.export.dialog import ExportDialog
from app.export.exporter import Exporting, file_type
from app.export.plan import ExportPlan, examine
from app.state.jobs import Jobs
from app.state.presenter import Presenter
from sgb_core import exchange
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.model import Document, Unit
from sgb_core.document.session import Session
from sgb_core.interruption import checkpoint
from sgb_core.surfaces.revolution import Axis
from tests.sgb_core.exchange.step_files import read_step

SIDE = Segment(np.linspace((20.0, 0.0), (20.0, 60.0), 4))
CUP = edits.set_solid(Document(Profile.of([SIDE]), name="Cup"), kind="vessel", wall=3.0, base=4.0)
MATERIAL = pi * (20.0**2 * 60.0 - 17.0**2 * 56.0)


@pytest.fixture
def presenter(qtbot):
    return Presenter(Session(CUP))


@pytest.fixture
def exporting(qtbot, presenter):
    window = QWidget()
    qtbot.addWidget(window)
    jobs = Jobs()
    yield Exporting(presenter, None, jobs, None, window)
    jobs.wait()


def notices(presenter):
    seen = []
    presenter.noticed.connect(seen.append)
    return seen


@pytest.mark.parametrize("suffix", [".stl", ".obj", ".ply", ".glb", ".3mf"])
@pytest.mark.parametrize("unit", [Unit.MM, Unit.IN])
def test_what_is_promised_is_written(qtbot, exporting, presenter, tmp_path, suffix, unit):
    path = tmp_path / f"cup{suffix}"
    plan = ExportPlan(CUP, suffix, tolerance=0.01, unit=unit, factor=2.0, axis=Axis.Y)
    found = examine(plan)
    seen = notices(presenter)
    exporting.write_plan(path, plan, found)
    qtbot.waitUntil(lambda: bool(seen))
    assert [notice.text for notice in seen] == [f"Wrote {path.name}."]
    assert path.stat().st_size == found.size
    if suffix == ".3mf":
        return
    mesh = trimesh.load(path, force="mesh", process=True)
    mesh.merge_vertices(merge_tex=True, merge_norm=True)
    millimetres = 1000.0 if suffix == ".glb" else unit.millimetres
    assert mesh.is_watertight
    assert mesh.volume * millimetres**3 == pytest.approx(8.0 * MATERIAL, rel=2e-3)
    if suffix != ".glb":
        height = mesh.extents[1] * millimetres
        assert height == pytest.approx(120.0, rel=1e-6)


def test_step_is_written_by_another_process(qtbot, exporting, presenter, tmp_path):
    pytest.importorskip("OCP")
    plan = ExportPlan(CUP, ".step", tolerance=0.01, unit=Unit.IN, factor=2.0)
    found = examine(plan)
    assert found.lines[0].startswith("One solid")
    seen = notices(presenter)
    exporting.write_plan(tmp_path / "cup.step", plan, found)
    qtbot.waitUntil(lambda: bool(seen), timeout=60_000)
    assert [notice.text for notice in seen] == ["Wrote cup.step."]
    assert [path.name for path in tmp_path.iterdir()] == ["cup.step"]
    (tmp_path / "read").mkdir()
    read = read_step((tmp_path / "cup.step").read_bytes(), tmp_path / "read")
    assert read.volume == pytest.approx(8.0 * MATERIAL, rel=1e-6)


def test_what_another_process_writes_can_be_cancelled(qtbot, exporting, presenter, tmp_path):
    pytest.importorskip("OCP")
    path = tmp_path / "cup.step"
    path.write_bytes(b"precious")
    seen = notices(presenter)
    exporting.write_plan(path, ExportPlan(CUP, ".step"))
    # Long before the kernel is even loaded.
    exporting._jobs.cancel_all()
    qtbot.waitUntil(lambda: bool(seen), timeout=60_000)
    assert seen[0].text == "Did not write cup.step: cancelled."
    assert path.read_bytes() == b"precious"


def test_the_folder_is_known_on_the_disk_before_anything_is_written(qtbot, exporting, tmp_path):
    known = []

    def work(_report):
        known.append(str(tmp_path) in Path(QSettings().fileName()).read_text())

    exporting.write(tmp_path / "cup.stl", work)
    qtbot.waitUntil(lambda: bool(known))
    assert known == [True]


def test_a_cancelled_export_keeps_the_old_file(qtbot, exporting, presenter, tmp_path):
    path = tmp_path / "cup.stl"
    path.write_bytes(b"precious")
    seen = notices(presenter)
    gate = threading.Event()

    def work(report):
        gate.wait()
        exchange.write(CUP, path, samples=(8, 64), report=report)

    exporting.write(path, work)
    exporting._jobs.cancel_all()
    gate.set()
    qtbot.waitUntil(lambda: bool(seen))
    assert seen[0].text == "Did not write cup.stl: cancelled."
    assert path.read_bytes() == b"precious"
    assert [p.name for p in tmp_path.iterdir()] == ["cup.stl"]


def test_what_cannot_be_written_is_one_line(qtbot, exporting, presenter, tmp_path):
    seen = notices(presenter)
    full = tmp_path / "cup.stl"
    full.symlink_to("/dev/full" if Path("/dev/full").exists() else tmp_path / "no" / "cup.stl")
    exporting.write_plan(full, ExportPlan(CUP, ".stl", samples=(8, 64)))
    exporting.write_plan(tmp_path / "no" / "cup.stl", ExportPlan(CUP, ".stl"))
    thick = edits.set_solid(CUP, wall=30.0)
    exporting.write_plan(tmp_path / "thick.stl", ExportPlan(thick, ".stl"))
    qtbot.waitUntil(lambda: len(seen) == 3)
    assert all(notice.level == "error" and "\n" not in notice.text for notice in seen)
    assert seen[0].text.startswith("Could not write cup.stl: cannot write")
    assert "there is no folder" in seen[1].text
    assert "30" in seen[2].text
    assert not (tmp_path / "thick.stl").exists()


def test_the_dialog_says_what_the_file_will_hold(qtbot):
    document = edits.set_shrinkage(CUP, percent=12.0)
    dialog = ExportDialog(document, exchange.suffixes())
    qtbot.addWidget(dialog)
    dialog.show()
    qtbot.waitUntil(lambda: dialog.result_shown is not None)
    first = dialog.result_shown
    assert first.mesh.is_watertight
    assert not dialog._preview.pixmap().isNull()
    # It begins with the size that goes to the kiln, and says so.
    assert dialog.scale.currentText() == "Wet size, for the kiln: × 1.1364"
    assert dialog.plan.factor == pytest.approx(1.0 / 0.88)
    assert "68.18 mm" in dialog._summary.text()
    dialog.scale.setCurrentIndex(1)
    qtbot.waitUntil(lambda: dialog.result_shown is not None)
    assert dialog.scale.currentText() == "Fired size: as drawn"
    assert dialog.plan.factor == 1.0
    dialog.format.setCurrentIndex(dialog.format.findData(".csv"))
    qtbot.waitUntil(lambda: dialog.result_shown is not None)
    assert dialog.result_shown.mesh is None
    assert not dialog.tolerance_field.isEnabled()
    dialog.reject()
    assert dialog.result() == QDialog.DialogCode.Rejected


def test_the_look_can_stay_behind(qtbot, tmp_path):
    """Only formats that hold one offer it; what is promised counts the files beside it."""
    document = edits.set_appearance(CUP, material="celadon")
    dialog = ExportDialog(document, exchange.suffixes())
    qtbot.addWidget(dialog)
    offered = {}
    for k in range(dialog.format.count()):
        dialog.format.setCurrentIndex(k)
        offered[dialog.suffix] = dialog.form.isRowVisible(dialog.look)
    assert {suffix for suffix, shown in offered.items() if shown} == {".obj", ".ply", ".glb"}
    dialog.format.setCurrentIndex(dialog.format.findData(".obj"))
    dialog.by_samples.setChecked(True)
    sizes = []
    for wanted in (True, False):
        dialog.look.setChecked(wanted)
        found = examine(dialog.plan)
        path = tmp_path / f"{wanted}.obj"
        exchange.write(found.plan.exported, path, samples=found.plan.samples, mesh=found.mesh)
        files = sorted(tmp_path.glob(f"{wanted}.*"))
        assert [file.suffix for file in files] == ([".mtl", ".obj"] if wanted else [".obj"])
        sizes.append(found.size)
        assert (
            any("; material, in an .mtl file beside it" in each for each in found.lines) == wanted
        )
        length = sum(file.stat().st_size for file in files)
        # Names of files are part of what is written.
        assert length == pytest.approx(found.size, abs=20)
    assert sizes[0] > sizes[1]
    dialog.reject()


@pytest.mark.parametrize("wanted", [2_000, 40_000, 400_000])
def test_a_number_of_triangles(wanted):
    found = examine(ExportPlan(CUP, ".stl", triangles=wanted))
    assert len(found.mesh.triangles) == pytest.approx(wanted, rel=0.2)
    assert found.plan.tolerance is not None
    assert found.size == 84 + 50 * len(found.mesh.triangles)


def test_the_dialog_offers_nothing_that_cannot_be_written(qtbot):
    dialog = ExportDialog(edits.set_solid(CUP, wall=30.0), exchange.suffixes())
    qtbot.addWidget(dialog)
    dialog.show()
    qtbot.waitUntil(lambda: dialog._summary.text().startswith("⚠"))
    assert dialog._summary.text().startswith("⚠ Wall: ")
    assert not dialog._ok.isEnabled()
    dialog.reject()


@pytest.mark.parametrize("closing", [True, False])
def test_what_is_no_longer_asked_for_is_examined_no_further(qtbot, monkeypatch, closing):
    begun, ended = threading.Event(), []

    def endless(plan):
        if plan.tolerance == first:
            begun.set()
            for _ in range(20_000):
                checkpoint()
                threading.Event().wait(0.001)
        ended.append(plan)
        return examine(plan)

    monkeypatch.setattr("app.export.dialog.examine", endless)
    dialog = ExportDialog(CUP, exchange.suffixes())
    first = dialog.plan.tolerance
    qtbot.addWidget(dialog)
    dialog.show()
    qtbot.waitUntil(begun.is_set)
    if closing:
        dialog.reject()
        assert not ended
    else:
        dialog.tolerance_field.set_value(2.0 * first)
        dialog.tolerance_field.changed.emit(2.0 * first)
        qtbot.waitUntil(lambda: dialog.result_shown is not None)
        assert ended == [dialog.plan]
        dialog.reject()


def test_a_file_dialog_names_what_it_writes():
    assert file_type(".stl") == f"{exchange.FORMATS['.stl'].title} (*.stl)"
    assert file_type(".gcode") == "G-code (*.gcode)"
    assert file_type(".xyz") == "*.xyz"


@pytest.mark.parametrize("answers", [True, False])
def test_where_no_file_manager_answers_the_path_is_told(
    exporting, presenter, monkeypatch, tmp_path, answers
):
    asked = []
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: asked.append(url) or answers)
    seen = notices(presenter)
    path = tmp_path / "cup.stl"
    exporting.tell_written(path)
    assert seen[0].action == "Show in folder"
    seen[0].callback()
    assert [Path(url.toLocalFile()) for url in asked] == [tmp_path]
    assert len(seen) == (1 if answers else 2)
    if not answers:
        assert str(path) in seen[1].text
        seen[1].callback()
        assert QGuiApplication.clipboard().text() == str(path)
