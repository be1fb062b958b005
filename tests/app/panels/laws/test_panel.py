"""The Vary panel on a real session."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.panels.laws.panel import VariationPanel
from app.state.presenter import Presenter
from sgb_core.curves.segment import PARAMETERS, ShapeParameters
from sgb_core.document.session import Session
from sgb_core.surfaces.laws.shapes import SHAPES
from sgb_core.surfaces.variation import Law
from tests.app.helpers import tower
from tests.app.mouse import LEFT, drag, move, press, release
from tests.app.waiting import let_turn, show

SHAPE = ShapeParameters(2.0, 4.0, 1.0, 0.5)


@pytest.fixture
def panel(qtbot):
    presenter = Presenter(Session(tower(SHAPE)))
    widget = VariationPanel(presenter)
    presenter.add_view(widget)
    show(qtbot, widget, 320, 700)
    widget.session, widget.presenter = presenter.session, presenter
    return widget


def laws(panel):
    return panel.session.document.variation


def add(panel, kind):
    panel.add_actions[kind].trigger()
    let_turn()


def choose(panel, combo, line):
    combo.setCurrentIndex(line)
    combo.activated.emit(line)
    let_turn()


def test_it_is_empty_at_first_and_says_what_it_is_for(panel):
    assert panel.empty.isVisible()
    assert not panel.form.isVisible()
    assert not panel.remove_button.isEnabled()


@pytest.mark.parametrize("kind", list(SHAPES))
def test_a_law_is_added_for_the_selected_segment(panel, kind):
    panel.presenter.select(1)
    add(panel, kind)
    (law,) = laws(panel)
    # The radius of one segment alone would tear it off its neighbours.
    expected = (None, "radius") if SHAPES[kind].of_radius else ((1,), "omega")
    assert (law.kind, law.segments, law.parameter) == (kind, *expected)
    assert law.start != law.end
    assert panel.form.isVisible()
    assert "crease" in panel.form.hint.text() or kind != "paper"
    panel.presenter.undo()
    let_turn()
    assert laws(panel) == ()
    assert panel.empty.isVisible()


def test_all_segments_together(panel):
    panel.presenter.set_view(all_segments=True)
    add(panel, "cosine")
    assert laws(panel)[0].segments is None
    assert laws(panel)[0].count == 5


def test_a_key_dragged_in_the_panel_changes_the_surface_at_once_and_is_one_step(panel):
    add(panel, "keyframes")
    before = panel.session.document
    steps = len(panel.session.history)
    curve = panel.form.curve
    degrees, value = laws(panel)[0].keyframes[1]
    start = curve.place(degrees, value)
    press(curve, start)
    move(curve, curve.place(degrees + 20.0, 0.5))
    let_turn()
    assert panel.session.in_gesture
    assert laws(panel) != before.variation
    assert panel.presenter.frame.evaluation.surface.laws == laws(panel)
    release(curve, curve.place(degrees + 20.0, 0.5))
    assert len(panel.session.history) == steps + 1
    panel.presenter.undo()
    assert panel.session.document is before


def test_sliders_set_both_ends(panel):
    add(panel, "raised-cosine")
    row = panel.form.rows["omega", "end"]
    assert row.isVisible()
    drag(row.slider, row.slider.handle_centre(), row.slider.handle_centre(0.4))
    assert laws(panel)[0].end == pytest.approx(0.4, abs=0.02)
    assert panel.session.undo_label == "To of ω"
    assert not panel.form.rows["lambda1", "end"].isVisible()


def test_the_kind_and_the_parameter_are_chosen(panel):
    add(panel, "raised-cosine")
    form = panel.form
    choose(panel, form.parameter, PARAMETERS.index("lambda2"))
    assert (laws(panel)[0].parameter, laws(panel)[0].end) == ("lambda2", 6.0)
    choose(panel, form.kind, form.kind.findData("cosine"))
    assert form.numbers["count"].isVisible()
    form.numbers["count"].enter(7.0)
    let_turn()
    assert laws(panel)[0].count == 7
    choose(panel, form.kind, form.kind.findData("keyframes"))
    assert len(laws(panel)[0].keyframes) == 56
    choose(panel, form.kind, 0)
    assert laws(panel) == ()


def test_segments_are_ticked(panel):
    add(panel, "paper")
    form = panel.form
    form.fill_segments()
    entries = form.segments.menu().actions()
    entries[-1].trigger()
    let_turn()
    assert laws(panel)[0].segments == (0, 2)
    assert form.segments.text() == "Segments 1, 3"
    form.fill_segments()
    form.segments.menu().actions()[0].trigger()
    assert laws(panel)[0].segments is None


def test_order_selection_and_removal(panel):
    add(panel, "paper")
    add(panel, "cosine")
    assert panel.list.currentRow() == 1
    first = panel.list.visualItemRect(panel.list.item(0)).center()
    QTest.mouseClick(panel.list.viewport(), LEFT, Qt.KeyboardModifier.NoModifier, first)
    let_turn()
    assert panel.form.hint.text().startswith("Not used")
    panel.down_button.click()
    let_turn()
    assert [law.kind for law in laws(panel)] == ["cosine", "paper"]
    panel.remove_button.click()
    let_turn()
    assert [law.kind for law in laws(panel)] == ["cosine"]


def test_a_law_without_effect_is_mended_with_one_click(panel):
    plain = tower(ShapeParameters())
    panel.presenter.replace_document(plain)
    let_turn()
    add(panel, "raised-cosine")
    assert laws(panel)[0].parameter == "lambda2"
    assert "ω = 0" in panel.form.hint.text()
    panel.form.mend.click()
    let_turn()
    assert panel.session.document.profile.segments[0].shape.omega == 1.0
    assert not panel.form.mend.isVisible()


def test_every_part_has_a_name(panel):
    add(panel, "cosine")
    form = panel.form
    for part in (
        form.parameter,
        form.kind,
        form.numbers["count"],
        form.curve,
        panel.list,
        form.segments,
    ):
        assert part.accessibleName()
    assert isinstance(laws(panel)[0], Law)
