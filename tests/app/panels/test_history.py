"""The history: every step by its name and its values, a click goes there."""

from dataclasses import replace

import pytest

from app.panels.history import HistoryPanel
from app.state.presenter import Presenter
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.appearance.model import Appearance, Texture
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from tests.app.waiting import let_turn, show


@pytest.fixture
def presenter():
    return Presenter(Session(Document(Profile.of([line((20, 0), (20, 60))]))))


@pytest.fixture
def panel(qtbot, presenter):
    made = HistoryPanel(presenter)
    qtbot.addWidget(made)
    presenter.add_view(made)
    show(qtbot, made)
    return made


def texts(panel):
    let_turn()
    return [panel.list.item(row).text() for row in range(panel.list.count())]


def test_a_step_says_its_values(panel, presenter):
    presenter.do("Wall", lambda d: edits.set_solid(d, wall=4.5))
    presenter.do("Kind", lambda d: edits.set_solid(d, kind="vessel"))
    presenter.do("Sweep", lambda d: edits.set_revolution(d, sweep_deg=90.0))
    presenter.do("Move P1", lambda d: edits.move_point(d, 0, 1, (22.0, 21.5)))
    presenter.do("Everything", lambda d: edits.set_solid(d, wall=2.0, base=1.0))
    steps = texts(panel)
    assert steps == [
        "As opened",
        "Wall 3 → 4.5 mm",
        "Kind Surface → Vessel",
        "Sweep 360 → 90°",
        "Move P1 (20, 20) → (22, 21.5) mm",
        "Everything",
    ]


def test_only_what_followed_is_written_anew(panel, presenter):
    for wall in (4.0, 5.0, 6.0):
        presenter.do("Wall", lambda d, wall=wall: edits.set_solid(d, wall=wall))
    assert texts(panel)[-1] == "Wall 5 → 6 mm"
    kept = panel.list.item(1)
    panel.list.setCurrentRow(1)
    assert presenter.document.solid.wall == 4.0
    presenter.do("Wall", lambda d: edits.set_solid(d, wall=1.0))
    assert texts(panel) == ["As opened", "Wall 3 → 4 mm", "Wall 4 → 1 mm"]
    assert panel.list.item(1) is kept


def test_nothing_done_says_how_it_begins(panel, presenter):
    let_turn()
    assert panel.empty.isVisible()
    assert not panel.list.isVisible()
    presenter.do("Wall", lambda d: edits.set_solid(d, wall=4.5))
    let_turn()
    assert panel.list.isVisible()
    assert not panel.empty.isVisible()
    presenter.undo()
    let_turn()
    # The step can still be brought back, by a click.
    assert panel.list.isVisible()


def test_a_shift_of_a_texture_says_both_its_numbers(panel, presenter):
    lotus = Texture("lotus", offset=(0.0, 0.5))
    presenter.replace_document(
        replace(presenter.document, appearance=Appearance(textures=(lotus,)))
    )
    shifted = replace(lotus, offset=(0.25, 0.25))
    presenter.do("Shift", lambda d: edits.set_appearance(d, textures=(shifted,)))
    assert texts(panel)[-1] == "Shift (0, 0.5) → (0.25, 0.25)"
