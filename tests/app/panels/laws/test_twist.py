"""The twist in the Vary panel on a real session."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.panels.laws.panel import VariationPanel
from app.panels.laws.pictures import shape_picture
from app.panels.laws.twist import KEPT, NOTHING_SHOWS
from app.state.presenter import Presenter
from sgb_core.curves.segment import ShapeParameters
from sgb_core.document.session import Session
from sgb_core.surfaces.laws.shapes import SHAPES
from sgb_core.surfaces.twist import Ease, Twist
from tests.app.helpers import tower
from tests.app.waiting import let_turn, show


@pytest.fixture
def panel(qtbot):
    presenter = Presenter(Session(tower(ShapeParameters(2.0, 4.0, 1.0, 0.5))))
    widget = VariationPanel(presenter)
    presenter.add_view(widget)
    show(qtbot, widget, 320, 800)
    widget.session = presenter.session
    return widget


def test_keys_on_the_slider_twist_and_undo_takes_it_back(panel):
    slider = panel.twist.turns.slider
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_Right)
    let_turn()
    panel.twist.finish()
    assert panel.session.document.twist.turns > 0.0
    panel.session.undo()
    assert panel.session.document.twist == Twist()


def test_without_laws_it_says_that_nothing_shows_and_offers_lobes(panel):
    assert not panel.twist.note.isVisible()
    panel.twist.turns.changed.emit(0.5)
    panel.twist.turns.ended.emit()
    let_turn()
    assert panel.session.document.twist.turns == 0.5
    assert panel.twist.note.text() == NOTHING_SHOWS
    assert panel.twist.lobes.isVisible()
    panel.twist.lobes.click()
    let_turn()
    (law,) = panel.session.document.variation
    assert (law.parameter, law.kind) == ("radius", "lobes")
    assert panel.twist.note.text() == KEPT
    assert not panel.twist.lobes.isVisible()


def test_the_ease_is_chosen(panel):
    panel.twist.turns.changed.emit(0.5)
    panel.twist.turns.ended.emit()
    let_turn()
    panel.twist.ease.setCurrentIndex(1)
    panel.twist.ease.activated.emit(1)
    let_turn()
    assert panel.session.document.twist.ease is Ease.SMOOTH


@pytest.mark.parametrize("kind", list(SHAPES))
def test_every_shape_has_a_picture_of_its_own(panel, kind):
    mine = shape_picture(SHAPES[kind]).pixmap(22).toImage()
    others = [shape_picture(shape).pixmap(22).toImage() for shape in SHAPES.values()]
    assert sum(mine == other for other in others) == 1
    assert not panel.add_actions[kind].icon().isNull()
