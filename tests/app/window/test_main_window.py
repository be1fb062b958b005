"""The whole window, driven by real mouse and key events."""

from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDockWidget, QFileDialog, QLabel, QMessageBox

from app.hand.coordinates import DesignPoint
from sgb_core.document.file import project_file
from tests.app.mouse import drag, move, press, release
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot)
    yield made
    made.close()


def answer(monkeypatch, button):
    asked = []

    def box(*args, **_):
        asked.append(args)
        return button

    monkeypatch.setattr(QMessageBox, "warning", box)
    return asked


def choose(monkeypatch, name, path):
    monkeypatch.setattr(QFileDialog, name, lambda *_: (str(path), ""))


def test_it_opens_on_a_shape_and_is_not_modified(stage):
    assert len(stage.document.profile.segments) >= 3
    assert not stage.window.isWindowModified()
    assert "SGB Studio" in stage.window.windowTitle()
    pixels = stage.viewport().astype(int)
    greenish = (pixels[..., 1] > pixels[..., 0] + 12) & (pixels[..., 1] > pixels[..., 2] + 12)
    assert greenish.mean() > 0.05


def test_a_slider_dragged_over_its_whole_range(stage):
    original = stage.document
    slider = stage.slider(1, "lambda2")
    pictures = []
    press(slider, slider.handle_centre())
    for value in (0.0, 2.0, 4.0, 6.0):
        move(slider, slider.handle_centre(value))
        stage.settle()
        pictures.append(stage.viewport())
        shown = stage.document.profile.segments[1].shape.lambda2
        assert shown == pytest.approx(value, abs=0.06)
    beyond = slider.handle_centre(6.0) + QPointF(60, 0)
    move(slider, beyond)
    release(slider, beyond)
    stage.settle()
    assert stage.document.profile.segments[1].shape.lambda2 == 6.0
    for first, second in pairwise(pictures):
        assert np.any(first != second)
    assert stage.session.undo_label == "λ2 of segment 2"
    changed = stage.document
    stage.window.commands["undo"].trigger()
    assert stage.document is original
    assert stage.session.undo_label is None
    stage.settle()
    stage.window.commands["redo"].trigger()
    assert stage.document is changed


def test_escape_during_a_slider_drag_restores(stage):
    original = stage.document
    slider = stage.slider(0, "omega")
    press(slider, slider.handle_centre())
    move(slider, slider.handle_centre(0.2))
    assert stage.document is not original
    QTest.keyClick(slider, Qt.Key.Key_Escape)
    release(slider, slider.handle_centre(0.2))
    stage.settle()
    assert stage.document is original
    assert stage.session.undo_label is None


def test_selecting_in_one_view_shows_in_all(stage):
    stage.presenter.select(2)
    stage.settle()
    assert stage.presenter.view.segment == 2
    before = stage.viewport()
    stage.presenter.select(0)
    stage.settle()
    assert np.any(before != stage.viewport())


def test_save_and_open_again(stage, monkeypatch, tmp_path):
    path = tmp_path / "pot.sgb"
    stage.window.commands["append_segment"].trigger()
    stage.settle()
    assert stage.window.isWindowModified()
    choose(monkeypatch, "getSaveFileName", path)
    stage.window.commands["save"].trigger()
    stage.settle()
    assert not stage.window.isWindowModified()
    assert "pot" in stage.window.windowTitle()
    assert project_file.load(path) == stage.document
    saved = stage.document
    stage.window.files.new_from_preset("tower")
    assert stage.window.files.path is None
    assert stage.window.files.open_path(path)
    assert stage.document == saved
    assert stage.window.files.recent.paths()[0] == path.resolve()


def test_unsaved_work_is_not_thrown_away_without_a_word(stage, monkeypatch):
    stage.window.commands["append_segment"].trigger()
    mine = stage.document
    asked = answer(monkeypatch, QMessageBox.StandardButton.Cancel)
    assert not stage.window.files.new_from_preset("tower")
    assert not stage.window.close()
    assert len(asked) == 2
    assert stage.document is mine
    answer(monkeypatch, QMessageBox.StandardButton.Discard)
    assert stage.window.files.new_from_preset("tower")
    assert stage.document.name != mine.name


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"{", "JSON"),
        (b'{"format": "sgb-document", "version": 1, "profile": {"segments": []}}', "segments"),
        (b'{"format": "sgb-document", "version": 99, "profile": {}}', "version"),
        (None, "bad.sgb"),
    ],
)
def test_a_bad_file_is_one_clear_notice_and_changes_nothing(stage, tmp_path, content, words):
    path = tmp_path / "bad.sgb"
    if content is not None:
        path.write_bytes(content)
    before = stage.document
    assert not stage.window.files.open_path(path)
    assert stage.document is before
    notice = stage.window.notice_bar.notice
    assert notice.level == "error"
    assert words in notice.text
    assert "\n" not in notice.text
    assert stage.window.notice_bar.isVisible()


def test_saving_where_one_may_not_says_so_and_loses_nothing(stage, tmp_path):
    stage.window.commands["append_segment"].trigger()
    stage.window.files.path = tmp_path / "no such folder" / "pot.sgb"
    assert not stage.window.files.save()
    assert stage.session.is_modified
    assert stage.window.notice_bar.notice.level == "error"


def test_a_project_dropped_on_the_window_opens(stage, tmp_path):
    path = tmp_path / "dropped.sgb"
    project_file.save(stage.document, path)
    mime = QMimeData()
    mime.setUrls([QUrl.fromLocalFile(str(path))])
    event = QDropEvent(
        QPointF(20, 20),
        Qt.DropAction.CopyAction,
        mime,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
    )
    stage.window.dropEvent(event)
    assert stage.window.files.path == path


def test_export_runs_aside_and_says_how_it_went(stage, tmp_path):
    path = tmp_path / "pot.stl"
    bar = stage.window.notice_bar
    stage.window.exporting.write(path, lambda _: path.write_bytes(b"solid"))
    stage.until(lambda: bar.notice is not None)
    assert bar.notice.text == "Wrote pot.stl."

    def fail(_report):
        raise OSError("no space left on device")

    stage.window.exporting.write(path, fail)
    stage.until(lambda: bar.notice.level == "error")
    assert "no space left" in bar.notice.text
    assert not stage.window.jobs.running


def test_a_picture_goes_to_the_clipboard(stage):
    stage.window.exporting.copy_picture((640, 480), transparent=True)
    image = QGuiApplication.clipboard().image()
    assert (image.width(), image.height()) == (640, 480)
    assert image.pixelColor(2, 2).alpha() == 0
    assert image.pixelColor(320, 240).alpha() > 200


def test_segments_by_menu(stage):
    count = len(stage.document.profile.segments)
    for name, change in (("append_segment", 1), ("split_segment", 1), ("merge_segment", -1)):
        stage.window.commands[name].trigger()
        count += change
        assert len(stage.document.profile.segments) == count, name
    stage.window.commands["remove_segment"].trigger()
    assert len(stage.document.profile.segments) == count - 1
    before = stage.document
    stage.window.commands["reverse_profile"].trigger()
    stage.window.commands["reverse_profile"].trigger()
    assert np.allclose(
        stage.document.profile.control_points, before.profile.control_points, atol=1e-12
    )


def test_a_point_dragged_in_the_editor_moves_the_surface(stage):
    editor = stage.window.profile_view
    before, original = stage.viewport(), stage.document
    r, h = original.profile.segments[2].points[1]
    at = editor.transform.to_screen(DesignPoint(r, h))
    start = QPointF(at.x, at.y)
    drag(editor, start, start + QPointF(18, 0))
    stage.settle()
    moved = stage.document.profile.segments[2].points[1]
    assert moved[0] > r
    assert np.any(before != stage.viewport())
    QTest.keyClick(stage.window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    stage.settle()
    assert stage.document is original


def test_overlays_and_projection_by_key(stage):
    before = stage.viewport()
    QTest.keyClick(stage.window, Qt.Key.Key_4, Qt.KeyboardModifier.AltModifier)
    stage.settle()
    assert "circles" not in stage.presenter.view.show
    assert np.any(before != stage.viewport())
    assert not stage.window.commands["show_circles"].isChecked()


@pytest.mark.parametrize("size", [(1024, 700), (1500, 940)])
def test_nothing_is_cut_off(qtbot, size):
    stage = WindowStage(qtbot, size)
    window = stage.window
    assert (window.width(), window.height()) == size
    assert window.surface_view.width() >= 0.38 * size[0]
    for label in window.status.findChildren(QLabel):
        if label.isVisible():
            assert label.width() >= label.sizeHint().width(), label.text()
    for dock in window.findChildren(QDockWidget):
        inner = dock.widget()
        if dock.isVisible() and not dock.visibleRegion().isEmpty():
            assert inner.width() >= inner.minimumSizeHint().width(), dock.objectName()
            corner = dock.mapTo(window, QPoint(dock.width(), dock.height()))
            assert corner.x() <= window.width()
            assert corner.y() <= window.height()
    stage.close()


def test_two_windows_have_documents_of_their_own(stage, qtbot):
    other = WindowStage(qtbot, wait_for_scene=False)
    other.window.commands["append_segment"].trigger()
    assert other.session.is_modified
    assert not stage.session.is_modified
    other.close()
