"""The figure studio and the fit dialog in a window, driven by the mouse."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QCheckBox, QFileDialog, QPushButton

from app.figures.fit_dialog import FitDialog
from app.figures.studio import FigureStudio
from app.widgets.scroll_area import PanelArea
from sgb_core.design.fitting import Freedom, deviation
from sgb_core.document.plates import PlatePart
from tests.app.window_stage import WindowStage

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def stage(qtbot) -> Iterator[WindowStage]:
    stage = WindowStage(qtbot)
    yield stage
    stage.window.jobs.wait()
    stage.close()


def open_studio(stage: WindowStage, qtbot) -> FigureStudio:
    stage.window.commands["figure_studio"].trigger()
    studio = stage.window.findChild(FigureStudio)
    qtbot.waitUntil(lambda: not studio.preview.pixmap().isNull())
    return studio


def click(qtbot, widget) -> None:
    at = QPoint(8, widget.height() // 2) if isinstance(widget, QCheckBox) else None
    qtbot.mouseClick(widget, LEFT, pos=at) if at else qtbot.mouseClick(widget, LEFT)


def button(studio: FigureStudio, text: str) -> QPushButton:
    return next(b for b in studio.findChildren(QPushButton) if b.text() == text)


def test_a_plate_is_made_kept_and_written_by_mouse(
    stage: WindowStage, qtbot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    studio = open_studio(stage, qtbot)
    before = studio.preview.pixmap().toImage()
    click(qtbot, studio.form.parts[PlatePart.CIRCLES])
    qtbot.waitUntil(lambda: studio.preview.pixmap().toImage() != before)
    assert stage.document.plate is None
    out = tmp_path / "plate.svg"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(out), ""))
    click(qtbot, button(studio, "SVG…"))
    qtbot.waitUntil(out.exists)
    assert out.read_text(encoding="utf-8").count("<image") == 4
    # Writing a plate leaves an untouched project untouched, and says that it was written.
    qtbot.waitUntil(lambda: studio.said == "Wrote plate.svg")
    assert not stage.session.is_modified
    assert stage.document.plate is None
    click(qtbot, button(studio, "Keep in project"))
    plate = stage.document.plate
    assert plate is not None
    assert PlatePart.CIRCLES in plate.show
    (vary,) = plate.vary
    assert (vary.parameter, len(vary.values)) == ("omega", 4)
    stage.presenter.undo()
    assert stage.document.plate is None


def test_the_view_of_the_viewport_is_taken(stage: WindowStage, qtbot) -> None:
    stage.window.surface_view.set_view_direction("top")
    stage.settle()
    studio = open_studio(stage, qtbot)
    assert studio.form.settings().camera.elevation_deg == pytest.approx(90.0)
    stage.window.surface_view.set_view_direction("front")
    stage.settle()
    click(qtbot, studio.form.camera)
    assert studio.form.settings().camera.elevation_deg == pytest.approx(0.0)


def test_the_plate_goes_to_the_clipboard(stage: WindowStage, qtbot) -> None:
    studio = open_studio(stage, qtbot)
    QGuiApplication.clipboard().clear()
    studio.form.dpi.enter(60)
    click(qtbot, studio.copy)
    qtbot.waitUntil(lambda: not QGuiApplication.clipboard().image().isNull())
    assert QGuiApplication.clipboard().image().width() == round(175.0 / 25.4 * 60)


def test_states_are_offered_and_faults_are_said(stage: WindowStage, qtbot) -> None:
    from sgb_core.document.edits import store_state

    stage.presenter.do("Store", lambda document: store_state(document, "A"))
    studio = open_studio(stage, qtbot)
    studio.form.kind.setCurrentIndex(1)
    assert studio.form.settings().states == ("", "A")
    studio.form.kind.setCurrentIndex(0)
    studio.form.first.values.setText("0, 2")
    studio.form.first.values.editingFinished.emit()
    refused = "is 2.0; allowed is a value of omega from 0 to 1"
    qtbot.waitUntil(lambda: refused in studio.form.problem.text())
    assert not studio.keep.isEnabled()
    studio.form.first.values.setText("0, one")
    studio.form.first.values.editingFinished.emit()
    qtbot.waitUntil(lambda: "list of numbers" in studio.form.problem.text())


def test_a_kept_plate_is_shown_again(stage: WindowStage, qtbot) -> None:
    studio = open_studio(stage, qtbot)
    studio.form.width_mm.enter(85.0)
    assert studio.form.settings().panel_height_mm is None
    studio.form.height_mm.step_by(1)
    assert studio.form.settings().panel_height_mm == pytest.approx(5.99)
    studio.form.height_mm.enter(40.0)
    studio.form.second.parameter.setCurrentIndex(1)
    click(qtbot, studio.keep)
    kept = stage.document.plate
    assert kept is not None
    assert kept.width_mm == 85.0
    assert kept.panel_height_mm == 40.0
    assert len(kept.vary) == 2
    studio.close()
    studio.form.width_mm.enter(100.0)
    studio.show()
    assert studio.form.settings() == kept


def test_the_studio_fits_a_small_window_and_drops_old_previews(qtbot) -> None:
    stage = WindowStage(qtbot, size=(1024, 700))
    studio = open_studio(stage, qtbot)
    assert studio.width() <= stage.window.width()
    assert studio.height() <= stage.window.height()
    for number in range(3):
        studio.form.columns.enter(number + 1)
        studio._draw()
        qtbot.waitUntil(lambda: studio._waiting is None)
    # Of what waits, all but the last is cancelled.
    waiting = [job for job in stage.window.jobs.running if job.label == "Drawing the preview"]
    assert all(job._stop.is_set() for job in waiting[:-1])
    stage.window.jobs.wait()
    qtbot.waitUntil(lambda: not stage.window.jobs.running)
    assert not studio.preview.pixmap().isNull()
    stage.close()


def test_a_fit_is_one_step_of_undo(stage: WindowStage, qtbot) -> None:
    stage.window.files.new_from_preset("ellipsoid-08")
    stage.settle()
    before = stage.document
    stage.window.commands["fit_ellipse"].trigger()
    dialog = stage.window.findChild(FitDialog)
    assert not dialog.apply_button.isEnabled()
    qtbot.waitUntil(dialog.apply_button.isEnabled)
    dialog.kind.setCurrentIndex(0)
    qtbot.waitUntil(
        lambda: dialog.choices is not None and dialog.choices.target.a == dialog.choices.target.b
    )
    assert "segment 1" in dialog.present.text()
    target = dialog.target
    click(qtbot, dialog.apply_button)
    assert deviation(stage.document.profile, target).largest < 2e-4 * target.size
    assert dialog.radios[Freedom.POLYGON].isChecked()
    stage.presenter.undo()
    assert stage.document is before


def test_no_choice_is_cut_off_in_a_small_window(stage: WindowStage, qtbot) -> None:
    stage.window.resize(1024, 700)
    studio = open_studio(stage, qtbot)
    second = studio.form.second
    second.parameter.setCurrentIndex(second.parameter.findData("lambda2"))
    area = studio.findChild(PanelArea)

    def all_fits() -> bool:
        rows = (studio.form.first, second)
        wide = all(row.segment.width() >= row.segment.sizeHint().width() for row in rows)
        return wide and studio.form.width() <= area.viewport().width()

    qtbot.waitUntil(all_fits)
    assert studio.width() <= 1024
