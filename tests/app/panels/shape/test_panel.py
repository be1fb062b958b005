"""The shape panel, moved by real mouse and key events against a real session."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent, QEnterEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.state.view_state import Hover
from sgb_core.curves.segment import PARAMETER_RANGES, PARAMETERS
from tests.app.helpers import tower
from tests.app.mouse import LEFT, double_click, drag, move, press, release, wheel
from tests.app.panels.shape.helpers import SHAPE, open_panel, row, shape
from tests.app.waiting import let_turn

Key = Qt.Key


@pytest.fixture
def panel(qtbot):
    return open_panel(qtbot, tower(SHAPE, rule="G0"))


@pytest.fixture
def session(panel):
    return panel._presenter.session


@pytest.mark.parametrize("parameter", PARAMETERS)
def test_a_drag_over_the_whole_range_is_one_undo_entry_that_comes_back(
    qtbot, panel, session, parameter
):
    before = session.document
    slider = row(panel, 1, parameter).slider
    low, high = PARAMETER_RANGES[parameter]
    seen = []
    session.subscribe(
        lambda _old, new: seen.append(getattr(new.profile.segments[1].shape, parameter))
    )
    middle = slider.height() / 2
    drag(slider, slider.handle_centre(), QPointF(slider.width() + 30, middle), steps=20)
    assert getattr(shape(session, 1), parameter) == high
    assert len(set(seen)) > 8
    drag(slider, slider.handle_centre(), QPointF(-30, middle), steps=20)
    assert getattr(shape(session, 1), parameter) == low
    after = session.document
    labels = [entry.label for entry in session.history[1:]]
    symbol = {"lambda1": "λ1", "lambda2": "λ2", "lambda3": "λ3", "omega": "ω"}[parameter]
    assert labels == [f"{symbol} of segment 2"] * 2
    session.undo()
    session.undo()
    assert session.document is before
    session.redo()
    session.redo()
    assert session.document is after
    let_turn()
    assert row(panel, 1, parameter).number == low
    assert row(panel, 1, parameter).field.value == low


def test_the_document_follows_while_the_mouse_moves(qtbot, panel, session):
    slider = row(panel, 0, "lambda1").slider
    start = slider.handle_centre()
    press(slider, start)
    assert session.in_gesture
    move(slider, start + QPointF(20, 0))
    first = shape(session, 0).lambda1
    move(slider, start + QPointF(30, 0))
    let_turn()
    assert shape(session, 0).lambda1 > first > 1.5
    assert row(panel, 0, "lambda1").field.value == shape(session, 0).lambda1
    release(slider, start + QPointF(30, 0))
    assert not session.in_gesture


def test_escape_in_a_drag_restores_the_very_document(qtbot, panel, session):
    before = session.document
    slider = row(panel, 0, "omega").slider
    start = slider.handle_centre()
    press(slider, start)
    move(slider, start + QPointF(25, 0))
    assert session.document is not before
    qtbot.keyClick(slider, Key.Key_Escape)
    assert session.document is before
    release(slider, start + QPointF(25, 0))
    let_turn()
    assert len(session.history) == 1
    assert row(panel, 0, "omega").number == 0.5


def test_a_click_that_moves_nothing_leaves_no_entry(qtbot, panel, session):
    slider = row(panel, 0, "lambda1").slider
    qtbot.mouseClick(slider, LEFT, pos=slider.handle_centre().toPoint())
    assert len(session.history) == 1


def test_a_run_of_wheel_steps_is_one_entry(qtbot, panel, session):
    part = row(panel, 2, "lambda2")
    for _ in range(4):
        wheel(part.slider)
        panel._presenter.refresh_now()
    assert shape(session, 2).lambda2 == pytest.approx(2.9)
    qtbot.waitUntil(lambda: not session.in_gesture)
    assert [entry.label for entry in session.history[1:]] == ["λ2 of segment 3"]


def test_undo_in_the_middle_of_a_run_begins_a_new_entry(qtbot, panel, session):
    part = row(panel, 0, "lambda1")
    wheel(part.field)
    session.undo()
    let_turn()
    assert part.number == 1.5
    wheel(part.field, 2)
    assert shape(session, 0).lambda1 == pytest.approx(1.7)
    part.finish()
    assert not session.in_gesture
    assert len(session.history) == 2


def test_arrow_keys_on_the_slider(qtbot, panel, session):
    slider = row(panel, 0, "lambda3").slider
    slider.setFocus()
    for _ in range(3):
        qtbot.keyClick(slider, Key.Key_Right)
    qtbot.keyClick(slider, Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    slider.finish()
    assert shape(session, 0).lambda3 == pytest.approx(1.79)
    assert len(session.history) == 2


def test_a_typed_sum_is_one_entry(qtbot, panel, session):
    field = row(panel, 0, "lambda1").field
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "7/2")
    qtbot.keyClick(field, Key.Key_Return)
    assert shape(session, 0).lambda1 == 3.5
    let_turn()
    assert row(panel, 0, "lambda1").slider.number == 3.5
    assert len(session.history) == 2


def test_a_number_out_of_range_is_said_and_not_applied(qtbot, panel, session):
    notices = []
    panel._presenter.noticed.connect(notices.append)
    field = row(panel, 0, "omega").field
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "2")
    qtbot.keyClick(field, Key.Key_Return)
    assert len(session.history) == 1
    assert "0 to 1" in notices[0].text


def test_double_click_on_the_label_and_the_button_reset(qtbot, panel, session):
    part = row(panel, 0, "lambda2")
    assert part.reset_button.isVisible()
    double_click(part.label, part.label.rect().center())
    assert shape(session, 0).lambda2 == 3.0
    let_turn()
    assert not part.reset_button.isVisible()
    other = row(panel, 0, "omega")
    qtbot.mouseClick(other.reset_button, LEFT)
    assert shape(session, 0).omega == 0.0
    assert [entry.label for entry in session.history[1:]] == ["λ2 of segment 1", "ω of segment 1"]


def test_all_segments_together(qtbot, panel, session):
    before = session.document
    qtbot.mouseClick(panel.all_segments, LEFT, pos=QPoint(12, panel.all_segments.height() // 2))
    let_turn()
    assert panel._presenter.view.all_segments
    slider = row(panel, 1, "lambda2").slider
    drag(slider, slider.handle_centre(), QPointF(slider.width(), slider.height() / 2))
    assert [segment.shape.lambda2 for segment in session.document.profile.segments] == [6.0] * 3
    assert [entry.label for entry in session.history[1:]] == ["λ2 of all segments"]
    assert all(row(panel, k, "lambda2").number == 6.0 for k in range(3))
    session.undo()
    assert session.document is before


def test_apply_to_all_from_the_menu(qtbot, panel, session):
    part = row(panel, 0, "lambda1")
    part.field.enter(2.25)
    let_turn()
    part.apply_to_all.emit()
    assert [segment.shape.lambda1 for segment in session.document.profile.segments] == [2.25] * 3
    texts = [action.text() for action in part.field.menu(part).actions()]
    assert "Apply to all segments" in texts


def test_the_right_button_opens_the_menu_on_every_part_of_a_row(qtbot, panel):
    part = row(panel, 0, "lambda1")
    for widget in (part.slider, part.label, part.field):
        at = QPoint(4, 4)
        reason = QContextMenuEvent.Reason.Mouse
        event = QContextMenuEvent(reason, at, widget.mapToGlobal(at))
        QApplication.sendEvent(widget, event)
        menu = QApplication.activePopupWidget()
        assert [action.text() for action in menu.actions() if action.text()] == [
            "Reset to 1",
            "Copy value",
            "Paste value",
            "Apply to all segments",
            "Animate",
        ]
        menu.close()


def test_using_a_card_selects_its_segment(qtbot, panel):
    presenter = panel._presenter
    slider = row(panel, 2, "omega").slider
    qtbot.mouseClick(slider, LEFT, pos=slider.handle_centre().toPoint())
    assert presenter.view.segment == 2
    qtbot.mouseClick(panel.cards[1].title, LEFT)
    assert presenter.view.segment == 1
    let_turn()
    selected = [card.property("selected") for card in panel.cards]
    assert selected == ["false", "true", "false"]


def test_hovering_a_row_is_told_and_untold(qtbot, panel):
    presenter = panel._presenter
    part = row(panel, 1, "lambda3")
    part.hovered.emit(True)
    assert presenter.view.hover == Hover("lambda3", 1)
    part.hovered.emit(False)
    assert presenter.view.hover is None
    presenter.set_view(all_segments=True)
    part.hovered.emit(True)
    assert presenter.view.hover == Hover("lambda3", None)


def test_the_pointer_lights_a_row_again_that_the_keyboard_left(qtbot, panel):
    part = row(panel, 0, "lambda2")
    presenter = panel._presenter
    part.hovered.emit(True)
    # The keyboard walks over another slider and on, the pointer stays in the row.
    row(panel, 0, "lambda3").slider.setFocus()
    assert presenter.view.hover == Hover("lambda3", 0)
    row(panel, 0, "lambda3").field.setFocus()
    assert presenter.view.hover is None
    middle = QPointF(part.slider.rect().center())
    there = QPointF(part.slider.mapToGlobal(middle))
    QApplication.sendEvent(part.slider, QEnterEvent(middle, middle, there))
    assert presenter.view.hover == Hover("lambda2", 0)
    presenter.set_view(hover=None)


def test_the_keyboard_hovers_too(qtbot, panel):
    row(panel, 0, "lambda2").slider.setFocus(Qt.FocusReason.TabFocusReason)
    assert panel._presenter.view.hover == Hover("lambda2", 0)
    panel.all_segments.setFocus(Qt.FocusReason.TabFocusReason)
    assert panel._presenter.view.hover is None


def test_the_pointer_over_a_row_hovers(qtbot, panel):
    slider = row(panel, 0, "lambda1").slider
    other = row(panel, 0, "lambda2").slider
    QTest.mouseMove(panel.window(), QPoint(2, 2))
    QTest.mouseMove(slider, QPoint(20, 8))
    qtbot.waitUntil(lambda: panel._presenter.view.hover == Hover("lambda1", 0))
    QTest.mouseMove(other, QPoint(20, 8))
    qtbot.waitUntil(lambda: panel._presenter.view.hover == Hover("lambda2", 0))
