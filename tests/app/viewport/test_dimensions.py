"""Dimensions over the viewport: on wish, seen, lit, dragged, typed, one step of undo."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest

import sgb_core as sgb
from app.hand.coordinates import DesignPoint
from app.hand.dimension_lines import dimension_lines
from app.hand.handle_field import HandleField
from app.hand.hit_test import Target
from app.viewport.handles import Scenery
from sgb_core.document.dimensions import dimension_value, missed_locks
from tests.app.mouse import hover, move, press, release
from tests.app.profile_editor.bench import vase
from tests.app.window_stage import WindowStage
from tests.sgb_core.design.locks.samples import locked, pot

WIDEST = sgb.Dimension("max_diameter")


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot)
    document = sgb.edits.add_dimension(locked(pot(3), "capacity"), WIDEST)
    made.presenter.replace_document(document)
    made.settle()
    yield made
    made.close()


def toggle(stage):
    view = stage.window.profile_view
    view.setFocus()
    both = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
    QTest.keyClick(view, Qt.Key.Key_D, both)
    stage.settle()


def on_line(stage, part=0.2):
    """A place on the line of the greatest diameter, towards its outer end."""
    view, document = stage.window.surface_view, stage.document
    paper = Scenery(stage.presenter.frame, view.lens).paper_at(DesignPoint(0.0, 0.0))
    (line,) = dimension_lines(document, paper)
    return QPointF(*(line.end + part * (line.start - line.end)).tolist()), line


def test_they_are_shown_on_wish_and_hidden_again(stage):
    layer = stage.window.surface_view.hand._dimensions
    assert not layer.isVisible()
    before = layer.parentWidget().grab().toImage()
    toggle(stage)
    assert layer.isVisible()
    place, _ = on_line(stage)
    ink = layer.grab().toImage()
    around = [
        ink.pixelColor(round(place.x()) + dx, round(place.y()) + dy).alpha()
        for dx in range(-2, 3)
        for dy in range(-2, 3)
    ]
    assert max(around) > 100
    assert before.size() == layer.parentWidget().grab().toImage().size()
    toggle(stage)
    assert not layer.isVisible()


def test_the_lines_follow_the_camera(stage):
    toggle(stage)
    first, _ = on_line(stage)
    stage.window.surface_view.set_view_direction("front")
    stage.settle()
    stage.until(lambda: not stage.window.surface_view._glide.active)
    stage.settle()
    second, line = on_line(stage)
    assert (first - second).manhattanLength() > 5.0
    assert abs(line.start[1] - line.end[1]) < 2.0
    shown = stage.window.surface_view.hand._dimensions._shown
    assert shown[1].pose == stage.window.surface_view.lens.pose


def test_a_line_is_dragged_and_the_lock_holds(stage):
    toggle(stage)
    document = stage.document
    place, line = on_line(stage)
    canvas = stage.window.surface_view.plotter
    hover(canvas, place)
    stage.settle()
    held = stage.window.surface_view.hand.active
    assert (held.target, held.index) == (Target.DIMENSION, line.number)
    way = line.end - line.start
    step = QPointF(*(12.0 * way / np.hypot(*way)).tolist())
    press(canvas, place)
    move(canvas, place + step / 2)
    move(canvas, place + step)
    release(canvas, place + step)
    stage.settle()
    assert dimension_value(stage.document, WIDEST) > dimension_value(document, WIDEST) + 1.0
    assert missed_locks(stage.document) == ()
    assert stage.session.undo_label == "Greatest diameter"
    stage.presenter.undo()
    assert stage.document is document


def test_without_the_wish_the_line_is_not_grabbed(stage):
    place, _ = on_line(stage)
    hover(stage.window.surface_view.plotter, place)
    stage.settle()
    held = stage.window.surface_view.hand.active
    assert getattr(held, "target", None) is not Target.DIMENSION


def test_a_click_on_a_line_opens_a_field_at_it(stage):
    toggle(stage)
    place, _ = on_line(stage)
    canvas = stage.window.surface_view.plotter
    hover(canvas, place)
    stage.settle()
    press(canvas, place)
    release(canvas, place)
    (field,) = stage.window.surface_view.findChildren(HandleField)
    assert field.isVisible()
    assert field.hasFocus()
    there = field.mapTo(stage.window.surface_view, field.rect().center())
    assert abs(there.y() - place.y()) < 30.0
    QTest.keyClicks(field, "11.5cm")
    QTest.keyClick(field, Qt.Key.Key_Return)
    stage.settle()
    assert dimension_value(stage.document, WIDEST) == pytest.approx(115.0, abs=1e-6)
    assert missed_locks(stage.document) == ()
    assert canvas.hasFocus()


def test_escape_and_a_click_elsewhere_leave_the_field(stage):
    toggle(stage)
    document = stage.document
    place, _ = on_line(stage)
    canvas = stage.window.surface_view.plotter
    for leave in (
        lambda field: QTest.keyClick(field, Qt.Key.Key_Escape),
        lambda _: press(canvas, QPointF(12.0, 12.0)),
    ):
        hover(canvas, place)
        press(canvas, place)
        release(canvas, place)
        field = next(
            f for f in stage.window.surface_view.findChildren(HandleField) if f.isVisible()
        )
        QTest.keyClicks(field, "90")
        leave(field)
        release(canvas, QPointF(12.0, 12.0))
        stage.settle()
        assert stage.document is document


def test_a_number_typed_in_the_middle_of_a_drag_of_a_line(stage):
    toggle(stage)
    place, line = on_line(stage)
    canvas = stage.window.surface_view.plotter
    way = line.end - line.start
    step = QPointF(*(12.0 * way / np.hypot(*way)).tolist())
    hover(canvas, place)
    stage.settle()
    press(canvas, place)
    move(canvas, place + step / 2)
    move(canvas, place + step)
    QTest.keyClicks(canvas, "113.5")
    release(canvas, place + step)
    stage.settle()
    assert dimension_value(stage.document, WIDEST) == pytest.approx(113.5, abs=1e-6)
    assert missed_locks(stage.document) == ()
    assert stage.session.undo_label == "Greatest diameter"


def test_a_point_dragged_here_takes_r_and_then_h(stage):
    """Tab goes from r to h, as in the profile editor."""
    stage.presenter.replace_document(vase())
    stage.settle()
    scenery = Scenery(stage.presenter.frame, stage.window.surface_view.lens)
    place = QPointF(*scenery.paper().map(stage.document.profile[0].points[1]).tolist())
    canvas = stage.window.surface_view.plotter
    hover(canvas, place)
    stage.settle()
    press(canvas, place)
    move(canvas, place + QPointF(6.0, 3.0))
    QTest.keyClicks(canvas, "31")
    QTest.keyClick(canvas, Qt.Key.Key_Tab)
    QTest.keyClicks(canvas, "1.2cm")
    release(canvas, place + QPointF(6.0, 3.0))
    stage.settle()
    assert stage.document.profile[0].points[1].tolist() == [31.0, 12.0]
