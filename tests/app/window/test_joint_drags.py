"""Legs dragged across joints by a real hand, and which side yields to a slider."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF

from sgb_core.curves.continuity import measure_joint
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.model import Document
from tests.app.panels.shape.helpers import open_panel
from tests.app.profile_editor.bench import Bench
from tests.app.waiting import let_turn

SHAPE = ShapeParameters(1.4, 2.6, 1.3, 0.9)


def smooth(rule):
    """Two segments whose joint truly keeps a rule."""
    document = Document(
        Profile.of(
            [
                Segment([(20, 0), (52, 8), (55, 40), (40, 62)], SHAPE),
                Segment([(40, 62), (28, 84), (18, 92), (32, 118)], SHAPE),
            ],
            ["G0"],
        )
    )
    document = edits.set_rule(document, 0, rule)
    assert measure_joint(document.profile, 0).holds
    return document


@pytest.mark.parametrize("leg", [(0, 2), (1, 1)])
@pytest.mark.parametrize("rule", ["G1", "C1", "G2"])
def test_a_leg_dragged_across_a_joint_takes_the_other_side_with_it(qtbot, rule, leg):
    bench = Bench(qtbot, smooth(rule))
    before = bench.document
    other = (1, 1) if leg == (0, 2) else (0, 2)
    bench.drag(bench.place(*leg), bench.place(*leg) + QPointF(9.0, 7.0))
    after = bench.document
    assert not np.array_equal(bench.point(*leg), before.profile.segments[leg[0]].points[leg[1]])
    assert not np.array_equal(
        bench.point(*other), before.profile.segments[other[0]].points[other[1]]
    )
    report = measure_joint(after.profile, 0)
    assert report.holds, report
    assert report.kink_deg < 1e-6
    assert len(bench.undo_entries) == 1
    bench.presenter.undo()
    assert bench.document is before


@pytest.mark.parametrize("rule", ["G1", "C1", "G2"])
def test_a_double_click_splits_and_every_joint_is_smooth(qtbot, rule):
    bench = Bench(qtbot, smooth(rule))
    before = bench.document.profile
    at = bench.screen(before.segments[0].point(0.35))
    bench.click(at)
    bench.mouse(QEvent.Type.MouseButtonDblClick, at)
    bench.release(at)
    after = bench.document.profile
    assert len(after) == 3
    assert all(measure_joint(after, joint).kink_deg < 1e-6 for joint in after.joints)
    fine = before.sample(400).reshape(-1, 2)
    apart = np.linalg.norm(after.sample(9).reshape(-1, 1, 2) - fine, axis=-1).min(axis=1)
    assert apart.max() < 0.2


def test_the_joint_row_chooses_who_yields(qtbot):
    panel = open_panel(qtbot, smooth("C1"))
    session = panel._presenter.session
    card = panel.cards[0]
    assert card.body.yielding.isVisible()
    assert card.body.yielding.text() == "2 yields"
    card.body.yielding.click()
    let_turn()
    assert card.body.yielding.text() == "1 yields"
    held = session.document.profile.segments[1]
    assert held.holds_start
    row = card.rows["lambda3"]
    row.field.enter(2.5)
    let_turn()
    assert np.array_equal(session.document.profile.segments[1].points, held.points)
    assert measure_joint(session.document.profile, 0).holds
    card.body.yielding.click()
    let_turn()
    assert not session.document.profile.segments[1].holds_start


def test_the_card_says_why_a_rule_is_not_kept(qtbot):
    panel = open_panel(qtbot, smooth("C1"))
    card = panel.cards[0]
    assert not card.body.unmet.isVisible()
    card.rows["omega"].field.enter(1.0)
    let_turn()
    card.rows["lambda3"].field.enter(4.0)
    let_turn()
    assert card.body.unmet.isVisible()
    assert "end derivative vanishes" in card.body.unmet.text()
    card.rows["lambda3"].field.enter(1.0)
    let_turn()
    assert not card.body.unmet.isVisible()
