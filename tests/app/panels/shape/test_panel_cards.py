"""What the shape panel shows: cards, hints, joints, scrolling, names."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QFont, QHelpEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QLineEdit,
    QSlider,
    QToolTip,
)

from app.state.window_reader import told
from sgb_core.curves.profile import JointRule
from sgb_core.curves.segment import PARAMETERS, ShapeParameters
from sgb_core.document import edits
from sgb_core.surfaces.variation import Law
from tests.app.helpers import tower
from tests.app.mouse import LEFT, drag, move, press, release, wheel
from tests.app.panels.shape.helpers import SHAPE, chain, open_panel, row, shape
from tests.app.waiting import let_turn

Key = Qt.Key


@pytest.fixture
def panel(qtbot):
    return open_panel(qtbot, tower(SHAPE, rule="G0"))


@pytest.fixture
def session(panel):
    return panel._presenter.session


def plain(label):
    """Return a label's text with ordinary spaces."""
    return label.text().replace("\u00a0", " ")


def test_hints_say_what_has_no_effect_and_mend_it(qtbot):
    panel = open_panel(qtbot, tower())
    card = panel.cards[0]
    assert card.body.hint.isVisible()
    assert plain(card.body.hint_text) == "Plain cubic: moving a λ sets ω to 1."
    qtbot.mouseClick(card.body.omega_button, LEFT)
    let_turn()
    assert shape(panel._presenter.session, 0).omega == 1.0
    assert plain(card.body.hint_text) == "ω has no effect while λ = 1, 3, 1."
    assert not card.body.omega_button.isVisible()


def test_nothing_jumps_while_a_slider_is_dragged_off_a_hint(qtbot):
    panel = open_panel(qtbot, tower(ShapeParameters(2.0, 3.0, 1.0, 0.0)))
    slider, below = row(panel, 0, "omega").slider, panel.cards[1]
    at = below.pos()
    start = slider.handle_centre()
    press(slider, start)
    move(slider, start + QPointF(40, 0))
    let_turn()
    assert below.pos() == at
    assert panel.cards[0].body.hint_text.text() == ""
    release(slider, start + QPointF(40, 0))
    qtbot.waitUntil(lambda: below.pos().y() < at.y())


@pytest.mark.parametrize("points", [9, 14, 20])
def test_hints_are_not_clipped_whatever_the_size_of_the_text(qtbot, qapp, points):
    font, old = QFont(qapp.font()), qapp.font()
    font.setPointSize(points)
    qapp.setFont(font)
    try:
        panel = open_panel(qtbot, tower(), size=(280, 600))
        let_turn()
        text = panel.cards[0].body.hint_text
        assert text.height() >= text.heightForWidth(text.width())
        gap = panel.cards[1].y() - panel.cards[0].geometry().bottom()
        assert gap < 12
    finally:
        qapp.setFont(old)


def test_help_is_shown_below_the_card_and_covers_no_slider(panel):
    card = panel.cards[0]
    slider = row(panel, 0, "lambda2").slider
    at = slider.rect().center()
    help_event = QHelpEvent(QEvent.Type.ToolTip, at, slider.mapToGlobal(at))
    QApplication.sendEvent(slider, help_event)
    assert QToolTip.text() == slider.toolTip() != ""
    (told,) = (w for w in QApplication.topLevelWidgets() if w.inherits("QTipLabel"))
    assert told.geometry().top() >= card.mapToGlobal(QPoint(0, card.height())).y()
    QToolTip.hideText()


def test_the_rule_of_a_joint_is_chosen_and_what_it_is_shown(qtbot, panel, session):
    card = panel.cards[0]
    before = session.document
    assert card.chip.isVisible()
    card.body.rule.setFocus()
    qtbot.keyClick(card.body.rule, Key.Key_Down)
    assert session.document.profile.rules[0] == JointRule.G1
    assert session.undo_label == told(edits.rule_moves(before, session.document, 0))
    assert session.undo_label == "G1 at joint 1–2 moved nothing"
    let_turn()
    assert card.body.rule.currentData() == "G1"
    assert not panel.cards[2].body.joint.isVisible()
    assert not panel.cards[2].chip.isVisible()


def test_buttons_change_the_chain(qtbot, panel, session):
    qtbot.mouseClick(panel.buttons["append_segment"], LEFT)
    let_turn()
    assert len(session.document.profile) == 4
    assert panel.cards[3].isVisible()
    assert panel._presenter.view.segment == 3
    qtbot.mouseClick(panel.buttons["remove_segment"], LEFT)
    let_turn()
    assert len(session.document.profile) == 3
    assert not panel.cards[3].isVisible()
    for name in ("insert_segment", "split_segment"):
        qtbot.mouseClick(panel.buttons[name], LEFT)
    let_turn()
    assert len(session.document.profile) == 5


def test_the_last_segment_cannot_be_removed(qtbot):
    panel = open_panel(qtbot, chain(1))
    assert not panel.buttons["remove_segment"].isEnabled()


def test_a_dozen_segments_scroll_to_the_selected_one(qtbot):
    panel = open_panel(qtbot, chain(12), size=(260, 420))
    assert [card.is_expanded for card in panel.cards] == [True] + [False] * 11
    panel._presenter.select(10)
    let_turn(10)
    card = panel.cards[10]
    assert [k for k, c in enumerate(panel.cards) if c.is_expanded] == [10]
    top = card.mapTo(panel, QPoint(0, 0)).y()
    assert top >= 0
    assert top + card.height() <= panel.height()


def test_a_card_unfolded_by_hand_stays_so(qtbot):
    panel = open_panel(qtbot, chain(12))
    qtbot.mouseClick(panel.cards[5].chevron, LEFT)
    assert panel.cards[5].is_expanded
    panel._presenter.select(8)
    let_turn()
    assert [k for k, c in enumerate(panel.cards) if c.is_expanded] == [5, 8]
    qtbot.mouseClick(panel.cards[5].chevron, LEFT)
    assert not panel.cards[5].is_expanded


def test_the_wheel_scrolls_on_when_a_slider_comes_under_it(qtbot):
    panel = open_panel(qtbot, chain(12), size=(260, 420))
    for card in panel.cards:
        card.toggled.emit(True)
    let_turn()
    bar = panel._area.verticalScrollBar()
    wheel(panel.cards[1].title, -1)
    first = bar.value()
    assert first > 0
    wheel(row(panel, 1, "lambda1").slider, -1)
    assert bar.value() > first
    assert len(panel._presenter.session.history) == 1


def test_the_wheel_over_a_rule_scrolls_and_changes_nothing(qtbot):
    panel = open_panel(qtbot, chain(12), size=(260, 300))
    bar = panel._area.verticalScrollBar()
    qtbot.waitUntil(lambda: bar.maximum() > 0 and panel.cards[0].body.rule.isVisible())
    wheel(panel.cards[0].body.rule, -1)
    assert bar.value() > 0
    assert len(panel._presenter.session.history) == 1


def test_cards_are_reused_and_untouched_ones_left_alone(qtbot, panel, session, monkeypatch):
    cards = list(panel.cards)
    shown = []
    for index, card in enumerate(cards):
        monkeypatch.setattr(card.body, "_show_values", lambda _c, index=index: shown.append(index))
    row(panel, 1, "omega").field.enter(0.75)
    let_turn()
    assert set(shown) == {1}
    shown.clear()
    panel._presenter.set_view(snap=True)
    let_turn()
    assert shown == []
    panel._presenter.replace_document(tower())
    let_turn()
    assert panel.cards == cards


def test_values_from_elsewhere_arrive_without_an_edit(qtbot, panel, session):
    segment = session.document.profile.segments[0].with_shape(ShapeParameters(3, 4, 2, 1))
    changed = session.document.profile.with_segment(0, segment)
    session.do("elsewhere", lambda document: replace(document, profile=changed))
    let_turn()
    numbers = [row(panel, 0, parameter).number for parameter in PARAMETERS]
    assert numbers == [3.0, 4.0, 2.0, 1.0]
    assert len(session.history) == 2


def test_every_control_has_a_name_and_is_reached_by_tab(qtbot, panel):
    kinds = (QSlider, QLineEdit, QAbstractButton, QComboBox)
    controls = [
        widget
        for kind in kinds
        for widget in panel.findChildren(kind)
        if widget.isVisible() and widget.isEnabled()
    ]
    nameless = [w for w in controls if not (w.accessibleName() or getattr(w, "text", str)())]
    assert nameless == []
    panel.all_segments.setFocus()
    reached = set()
    for _ in range(3 * len(controls)):
        reached.add(QApplication.focusWidget())
        qtbot.keyClick(QApplication.focusWidget(), Key.Key_Tab)
    assert [w for w in controls if w not in reached] == []


@pytest.mark.parametrize("width", [240, 260, 340])
def test_nothing_is_wider_than_the_panel(qtbot, width):
    panel = open_panel(qtbot, chain(12), size=(width, 500))
    assert panel.width() == width
    assert panel._area.widget().width() <= panel._area.viewport().width()
    assert row(panel, 0, "lambda1").slider.width() >= 60


def test_a_lambda_dragged_at_omega_0_shows_at_once_as_one_step(qtbot):
    panel = open_panel(qtbot, tower(ShapeParameters(2.0, 5.0, 3.0, 0.0)))
    session = panel._presenter.session
    before = session.document.profile
    slider = row(panel, 1, "lambda2").slider
    drag(slider, slider.handle_centre(), slider.handle_centre(4.5))
    let_turn()
    moved = shape(session, 1)
    assert moved == ShapeParameters(1.0, moved.lambda2, 1.0, 1.0)
    assert moved.lambda2 == pytest.approx(4.5, abs=0.1)
    assert shape(session, 0) == before[0].shape
    assert not np.allclose(session.document.profile[1].quartic, before[1].quartic)
    assert session.undo_label == "λ2 of segment 2, ω → 1"
    panel._presenter.undo()
    assert session.document.profile == before


def test_a_law_on_omega_stays_and_is_said(qtbot):
    panel = open_panel(qtbot, tower(ShapeParameters(2.0, 5.0, 3.0, 0.0)))
    presenter = panel._presenter
    law = Law("omega", "raised-cosine", 0.0, 1.0, segments=(1,))
    presenter.do("Law", lambda document: edits.add_law(document, law))
    notices = []
    presenter.noticed.connect(notices.append)
    let_turn()
    slider = row(panel, 1, "lambda2").slider
    drag(slider, slider.handle_centre(), slider.handle_centre(4.0))
    moved = shape(presenter.session, 1)
    assert (moved.lambda1, moved.lambda3, moved.omega) == (2.0, 3.0, 0.0)
    assert moved.lambda2 == pytest.approx(4.0, abs=0.1)
    assert [each.text for each in notices] == [
        "ω of segment 2 follows a law: λ2 shows where that is above 0."
    ]


def test_every_slider_says_in_words_what_it_does(qtbot):
    panel = open_panel(qtbot, tower())
    captions = [each.caption.text() for each in panel.cards[1].rows.values()]
    assert captions == [
        "Upper end: to its handle or its point",
        "Belly: to the lower or the upper handle",
        "Lower end: to its handle or its point",
        "Strength: none to full effect of the λ",
    ]


def test_the_cards_of_a_long_chain_wait_while_the_hand_moves(qtbot):
    panel = open_panel(qtbot, tower())
    presenter = panel._presenter
    presenter.replace_document(chain(90))
    presenter.begin("λ2 of segment 1")
    presenter.refresh_now()
    made = len(panel.cards)
    assert made < 90
    for value in (3.5, 4.0, 4.5):
        presenter.apply(lambda d, v=value: edits.set_shape_parameter(d, 0, "lambda2", v))
        let_turn()
    assert len(panel.cards) == made
    presenter.commit()
    qtbot.waitUntil(lambda: len(panel.cards) == 90)
    assert panel.cards[0].rows["lambda2"].number == 4.5
