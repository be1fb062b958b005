"""Locks and dimensions in a real window: the panel, lines in the editor, what stops the hand."""

import os
import sys

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QFocusEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

import sgb_core as sgb
from app.hand.coordinates import ScreenPoint
from app.hand.dimension_lines import dimension_lines
from app.hand.features import edge_places
from app.hand.handle_field import HandleField
from sgb_core.document.appearance.model import Along, Layer, LayerKind
from sgb_core.document.dimensions import dimension_value, missed_locks
from tests.app import mouse
from tests.app.window_stage import WindowStage
from tests.sgb_core.design.locks.samples import locked, pot

pytestmark = pytest.mark.skipif(
    sys.platform == "linux" and not os.environ.get("DISPLAY"), reason="needs a screen"
)


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    yield made
    made.close()


def show(stage, document):
    stage.presenter.replace_document(document)
    stage.window.panels.docks["locks"].raise_()
    stage.settle()
    return stage.window.panels["locks"]


def place(stage, design, aside=(0, 0)):
    """Where a design point lies in the editor."""
    x, y = stage.window.profile_view.transform.map(np.array(design)).tolist()
    return QPoint(round(x + aside[0]), round(y + aside[1]))


def typed(field, text):
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key.Key_Return)


def test_a_dimension_is_added_typed_locked_and_removed(stage):
    panel = show(stage, pot(4))
    menu = panel.add_button.menu()
    menu.aboutToShow.emit()
    texts = [action.text() for action in menu.actions()]
    assert {"Height", "Rim diameter", "Capacity", "Wall", "Neck diameter"} <= set(texts)
    next(a for a in menu.actions() if a.text() == "Rim diameter").trigger()
    stage.settle()
    (row,) = panel.rows
    typed(row.field, "5.5cm")
    stage.settle()
    rim = sgb.Dimension("rim_diameter")
    assert dimension_value(stage.document, rim) == pytest.approx(55.0, abs=1e-9)
    assert stage.window.notice_bar.notice.text.startswith("Rim diameter: ")
    mouse.press(row.padlock, row.padlock.rect().center())
    mouse.release(row.padlock, row.padlock.rect().center())
    stage.settle()
    assert stage.document.dimensions[0].locked
    assert stage.document.dimensions[0].value == pytest.approx(55.0, abs=1e-9)
    row.remove.click()
    stage.settle()
    assert stage.document.dimensions == ()
    for _ in range(4):
        stage.presenter.undo()
    stage.settle()
    assert stage.document.dimensions == ()
    assert not stage.session.undo()


def test_a_drag_holds_the_locks_and_is_one_step_of_undo(stage):
    document = locked(pot(4), "capacity", "height")
    show(stage, document)
    view = stage.window.profile_view
    start = place(stage, document.profile[2].points[1])
    mouse.drag(view, start, start + QPoint(14, 6))
    stage.settle()
    assert not np.array_equal(
        stage.document.profile.control_points, document.profile.control_points
    )
    assert missed_locks(stage.document) == ()
    stage.presenter.undo()
    assert stage.document is document


def test_the_lock_in_the_way_is_named_and_lights_up(stage):
    document = locked(pot(4), "rim_diameter")
    panel = show(stage, document)
    view = stage.window.profile_view
    start = place(stage, document.profile[3].points[3])
    mouse.drag(view, start, start + QPoint(30, 0))
    stage.settle()
    assert stage.window.notice_bar.notice.text.startswith("Stopped by a lock: Rim diameter")
    assert panel.rows[0].label.property("role") == "warning"
    assert missed_locks(stage.document) == ()
    # It leaves with its cause.
    stage.presenter.undo()
    stage.settle()
    assert stage.window.notice_bar.notice is None
    assert panel.rows[0].label.property("role") is None


def test_a_dimension_line_is_dragged_and_typed_into(stage):
    document = sgb.edits.add_dimension(locked(pot(4), "capacity"), sgb.Dimension("max_diameter"))
    show(stage, document)
    view = stage.window.profile_view
    widest = dimension_value(document, sgb.Dimension("max_diameter"))
    level = dimension_value(document, sgb.Dimension("max_diameter_height"))
    at = place(stage, (0.25 * widest, level))
    mouse.drag(view, at, at + QPoint(8, 0))
    stage.settle()
    wider = dimension_value(stage.document, sgb.Dimension("max_diameter"))
    assert wider == pytest.approx(widest + 16.0 / view.transform.scale, abs=2.0)
    assert missed_locks(stage.document) == ()
    assert stage.session.undo_label == "Greatest diameter"
    stage.presenter.undo()
    stage.settle()
    mouse.press(view, at)
    mouse.release(view, at)
    (field,) = view.findChildren(HandleField)
    assert field.isVisible()
    typed(field, "115")
    stage.settle()
    found = dimension_value(stage.document, sgb.Dimension("max_diameter"))
    assert found == pytest.approx(115.0, abs=1e-6)
    assert missed_locks(stage.document) == ()


def test_the_line_of_an_angle_turns_under_the_hand_and_takes_a_number(stage):
    angle = sgb.Dimension("angle", points=((0, 0), (3, 3)))
    document = sgb.edits.add_dimension(locked(pot(4), "height"), angle)
    show(stage, document)
    view = stage.window.profile_view
    (line,) = [each for each in dimension_lines(document, view.transform) if each.arc is not None]
    x, y = (0.7 * line.start + 0.3 * line.end).tolist()
    at = QPoint(round(x), round(y))
    before = dimension_value(document, angle)
    mouse.drag(view, at, at + QPoint(9, 0))
    stage.settle()
    turned = dimension_value(stage.document, angle)
    assert turned < before - 1.0
    assert missed_locks(stage.document) == ()
    stage.presenter.undo()
    stage.settle()
    mouse.press(view, at)
    mouse.release(view, at)
    (field,) = view.findChildren(HandleField)
    typed(field, "90-5")
    stage.settle()
    assert dimension_value(stage.document, angle) == pytest.approx(85.0, abs=1e-6)


def test_escape_leaves_a_dimension_as_it_is(stage):
    document = sgb.edits.add_dimension(pot(4), sgb.Dimension("foot_diameter"))
    show(stage, document)
    view = stage.window.profile_view
    at = place(stage, (20.0, 0.0), (0, 15))
    mouse.press(view, at)
    mouse.release(view, at)
    (field,) = view.findChildren(HandleField)
    QTest.keyClicks(field, "90")
    QTest.keyClick(field, Qt.Key.Key_Escape)
    stage.settle()
    assert stage.document is document


@pytest.mark.parametrize(
    ("kind", "text", "value"),
    [("wall", "4.5", 4.5), ("base", "0.7cm", 7.0), ("fill_line", "88", 88)],
)
def test_wall_floor_and_fill_line_are_dimensions_to_type_and_to_drag(stage, kind, text, value):
    document = sgb.edits.add_dimension(sgb.edits.set_fill(pot(4), 90.0), sgb.Dimension(kind))
    show(stage, document)
    view = stage.window.profile_view
    (line,) = dimension_lines(document, view.transform)
    # A short line's arrows stand outside, and are part of it.
    outer = 0.6 * line.drawn[1] + 0.4 * line.end
    at = outer if line.is_short else (line.start + line.end) / 2.0
    middle = QPoint(*np.round(at).astype(int).tolist())
    mouse.press(view, middle)
    mouse.release(view, middle)
    (field,) = view.findChildren(HandleField)
    typed(field, text)
    stage.settle()
    assert dimension_value(stage.document, document.dimensions[0]) == pytest.approx(value)
    stage.presenter.undo()
    stage.settle()
    along = line.end - line.start
    step = QPoint(*np.round(12.0 * along / np.hypot(*along)).astype(int).tolist())
    mouse.press(view, middle)
    mouse.move(view, middle + step / 2)
    mouse.move(view, middle + step)
    stage.settle()
    before = dimension_value(document, document.dimensions[0])
    assert dimension_value(stage.document, document.dimensions[0]) > before
    QTest.keyClicks(view, text)
    mouse.release(view, middle + step)
    stage.settle()
    assert dimension_value(stage.document, document.dimensions[0]) == pytest.approx(value)
    assert stage.session.undo_label == document.dimensions[0].label


def test_the_field_stays_for_its_own_menu_and_for_another_window(stage):
    document = sgb.edits.set_fill(pot(4), 90.0)
    show(stage, document)
    view = stage.window.profile_view
    mouse.press(view, place(stage, (4.0, 90.0)))
    mouse.release(view, place(stage, (4.0, 90.0)))
    (field,) = view.findChildren(HandleField)
    for reason in (Qt.FocusReason.PopupFocusReason, Qt.FocusReason.ActiveWindowFocusReason):
        QApplication.sendEvent(field, QFocusEvent(QEvent.Type.FocusOut, reason))
        stage.settle()
        assert view.findChildren(HandleField) == [field]
    typed(field, "64")
    stage.settle()
    assert stage.document.fill_height == 64.0


def test_a_click_on_the_fill_line_and_on_a_painted_edge_takes_a_number(stage):
    band = Layer(LayerKind.BAND, start=0.28, end=0.54, by=Along.HEIGHT)
    document = sgb.edits.set_fill(pot(4), 90.0)
    show(stage, sgb.edits.set_appearance(document, drawing=(band,)))
    view = stage.window.profile_view
    edge = edge_places(stage.document.profile, band, upper=False)[0]
    # So near that no mark of the curve comes before the edge.
    view.zoom(1.6, ScreenPoint(*view.transform.map(np.array(edge)).tolist()))
    for design, text in (((20.0, 90.0), "71"), (edge, "35")):
        at = place(stage, design)
        mouse.hover(view, at)
        mouse.press(view, at)
        mouse.release(view, at)
        field = next(f for f in view.findChildren(HandleField) if f.isVisible())
        typed(field, text)
        stage.settle()
    assert stage.document.fill_height == 71.0
    assert stage.document.appearance.drawing[0].start == pytest.approx(0.35)
