"""Laws in words, and a law's shape put into the table from outside: offered like the others."""

import pytest
from PySide6.QtWidgets import QApplication

from app.__main__ import main
from app.panels.laws.panel import VariationPanel
from app.panels.laws.words import offered, row_text, segments_text
from app.state.presenter import Presenter
from app.theme import theme
from sgb_core.document.session import Session
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.laws.shape import LawShape
from sgb_core.surfaces.laws.shapes import add_shape
from tests.app.helpers import tower
from tests.app.waiting import let_turn, show

TENT = LawShape("tent", "Tent", "Up and down", lambda law, t: t, lambda law, t, side: side)


@pytest.fixture
def tent():
    remove = add_shape(TENT)
    yield TENT
    remove()


def test_the_panel_offers_it_adds_it_and_lists_it(tent, qtbot):
    theme.apply(QApplication.instance(), "light")
    presenter = Presenter(Session(tower()))
    panel = VariationPanel(presenter)
    presenter.add_view(panel)
    show(qtbot, panel, 320, 700)
    action = panel.add_actions["tent"]
    assert action.text() == "Tent"
    action.trigger()
    let_turn()
    (law,) = presenter.document.variation
    assert law.shape is tent
    assert "tent" in row_text(law).lower()
    assert tent.title in [panel.form.kind.itemText(k) for k in range(panel.form.kind.count())]


def test_the_command_line_names_it(tent, capsys):
    assert main(["check", "--help"]) == 0
    assert "tent" in capsys.readouterr().out


def test_gone_again_nothing_offers_it(capsys):
    assert "tent" not in [shape.name for shape in offered()]
    assert main(["check", "--help"]) == 0
    assert "tent" not in capsys.readouterr().out


def test_segments_count_from_one():
    assert segments_text(Law("omega", "cosine")) == "all segments"
    assert segments_text(Law("omega", "cosine", 0.0, 1.0, (0,))) == "segment 1"
    assert segments_text(Law("omega", "cosine", 0.0, 1.0, (0, 2))) == "segments 1, 3"
