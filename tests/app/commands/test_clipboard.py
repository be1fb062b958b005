"""Copy, cut, paste, duplicate, scale and mirror, by keys in the real window."""

import json

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest

from app.commands.clipboard import POINTS, SEGMENTS
from app.commands.scale_dialog import ScaleDialog
from tests.app.window_stage import WindowStage

CTRL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    made.window.files.new_from_preset("vase")
    made.window.profile_view.setFocus()
    made.settle()
    yield made
    made.close()


def key(stage, letter, modifiers=CTRL):
    QTest.keyClick(stage.window.profile_view, getattr(Qt.Key, f"Key_{letter}"), modifiers)
    stage.settle()


def test_a_segment_is_copied_cut_pasted_and_duplicated(stage):
    original = stage.document
    count = len(original.profile)
    stage.presenter.select(2)
    key(stage, "C")
    mime = QGuiApplication.clipboard().mimeData()
    assert mime.hasFormat(SEGMENTS)
    assert json.loads(mime.text())["format"] == "sgb-segments"
    stage.presenter.select(count - 1)
    key(stage, "V")
    pasted = stage.document.profile
    assert len(pasted) == count + 1
    assert np.diff(pasted.control_points[-1], axis=0) == pytest.approx(
        np.diff(original.profile.control_points[2], axis=0)
    )
    assert stage.presenter.view.segment == count
    assert stage.session.undo_label == "Paste 1 segment"
    stage.presenter.undo()
    stage.presenter.select(1)
    key(stage, "X")
    assert len(stage.document.profile) == count - 1
    stage.presenter.undo()
    key(stage, "D")
    assert len(stage.document.profile) == count + 1
    stage.presenter.undo()
    assert stage.document is original


def test_copied_points_say_where_selected_ones_go(stage):
    points = stage.document.profile.control_points
    stage.presenter.set_view(points=frozenset({(2, 1), (2, 2)}))
    key(stage, "C")
    mime = QGuiApplication.clipboard().mimeData()
    assert mime.hasFormat(POINTS)
    assert mime.text().split() == [repr(float(x)) for x in points[2, 1:3].ravel()]
    stage.presenter.set_view(points=frozenset({(3, 1), (3, 2)}))
    key(stage, "V")
    assert stage.document.profile.control_points[3, 1:3] == pytest.approx(points[2, 1:3])
    stage.presenter.undo()
    stage.presenter.set_view(points=frozenset({(3, 1)}))
    key(stage, "V")
    assert "select as many" in stage.window.notice_bar.notice.text


def test_nothing_to_paste_is_said(stage):
    QGuiApplication.clipboard().setText("hello")
    before = stage.document
    key(stage, "V")
    assert stage.document is before
    assert "Nothing to paste" in stage.window.notice_bar.notice.text


def test_scaling_by_numbers_is_seen_at_once_and_one_undo_entry(stage):
    original = stage.document
    stage.presenter.set_view(points=frozenset({(2, 1), (2, 2)}))
    key(stage, "T")
    dialog = stage.window.findChild(ScaleDialog)
    assert dialog.isVisible()
    assert not dialog.isModal()
    dialog.radius_factor.setFocus()
    dialog.radius_factor.selectAll()
    QTest.keyClicks(dialog.radius_factor, "1.5")
    QTest.keyClick(dialog.radius_factor, Qt.Key.Key_Return)
    assert dialog.isVisible()
    old, new = (d.profile.control_points[2, 1:3] for d in (original, stage.document))
    assert new[1] - new[0] == pytest.approx(1.5 * (old[1] - old[0]))
    dialog.accept()
    assert stage.session.undo_label == "Scale 2 points"
    stage.presenter.undo()
    assert stage.document is original
    key(stage, "T")
    dialog = [d for d in stage.window.findChildren(ScaleDialog) if d.isVisible()][-1]
    dialog.together.setChecked(False)
    dialog.radius_factor.set_value(0.5)
    dialog.radius_factor.changed.emit(0.5)
    assert stage.document is not original
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert stage.document is original


def test_mirroring_twice_gives_the_points_back(stage):
    original = stage.document.profile.control_points
    stage.presenter.set_view(points=frozenset({(2, 1), (2, 2)}))
    both = CTRL | Qt.KeyboardModifier.ShiftModifier
    key(stage, "H", both)
    changed = stage.document.profile.control_points
    assert changed[2, 1, 1] == pytest.approx(original[2, 2, 1])
    key(stage, "H", both)
    assert stage.document.profile.control_points[2, 1:3] == pytest.approx(original[2, 1:3])
    key(stage, "J", both)
    assert stage.document.profile.control_points[2, 1, 0] == pytest.approx(original[2, 2, 0])
