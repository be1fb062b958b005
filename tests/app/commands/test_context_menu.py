import numpy as np
import pytest
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QWidget

from app.commands import context_menu
from app.hand.hit_test import Handle, Target
from app.state.presenter import Presenter
from app.state.window_reader import sentence, told
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.document.session import Session


@pytest.fixture
def presenter(qtbot):
    shape = ShapeParameters(2.0, 3.0, 1.0, 1.0)
    segments = [
        Segment(np.array([(20.0, 0), (45, 10), (52, 40), (38, 60)]), shape),
        Segment(np.array([(38.0, 60), (24, 80), (14, 95), (15, 112)])),
    ]
    return Presenter(Session(Document(Profile.of(segments))))


@pytest.fixture
def menu_for(qtbot, presenter):
    parent = QWidget()
    qtbot.addWidget(parent)
    return lambda handle: context_menu.build(parent, presenter, handle, QAction("Fit", parent))


def action(menu, text):
    for found in menu.actions():
        if found.text().replace("&", "").startswith(text):
            return found
    raise LookupError(text)


def labels(presenter):
    return [entry.label for entry in presenter.session.history[1:]]


def test_a_curve_is_split_where_it_was_pressed(presenter, menu_for):
    at = presenter.document.profile.point(0, 0.25)
    action(menu_for(Handle(Target.CURVE, 0, s=0.25)), "Split segment 1 here").trigger()
    assert len(presenter.document.profile) == 3
    assert presenter.document.profile.segments[0].points[3] == pytest.approx(at)
    assert labels(presenter) == ["Split segment 1"]


@pytest.mark.parametrize(
    ("text", "count"),
    [("Insert", 3), ("Reverse", 2), ("Remove", 1), ("Append", 3), ("Close", 2)],
)
def test_each_entry_does_its_edit_as_one_undo_entry(presenter, menu_for, text, count):
    before = presenter.document
    found = action(menu_for(Handle(Target.POINT, 0, 1)), text)
    found.trigger()
    if text == "Close":
        assert presenter.document.profile.closed
    else:
        assert len(presenter.document.profile) == count
    assert len(labels(presenter)) == 1
    presenter.undo()
    assert presenter.document is before


def test_a_merge_that_moves_the_curve_is_offered_first(presenter, menu_for):
    before, notices = presenter.document, []
    presenter.noticed.connect(notices.append)
    action(menu_for(Handle(Target.POINT, 0, 1)), "Merge").trigger()
    assert presenter.document is before
    notices[-1].callback()
    assert len(presenter.document.profile) == 1
    assert labels(presenter) == ["Merge segment 1 with the next"]


def test_which_side_yields_is_chosen_at_a_smooth_joint(presenter, menu_for):
    presenter.do("G1", lambda d: edits.set_rule(d, 0, "G1"))
    action(menu_for(Handle(Target.POINT, 1, 0)), "Let segment 1 yield").trigger()
    assert presenter.document.profile.segments[1].holds_start
    action(menu_for(Handle(Target.POINT, 1, 0)), "Let segment 2 yield").trigger()
    assert not presenter.document.profile.segments[1].holds_start


def test_the_rule_of_a_joint_is_shown_and_set(presenter, menu_for):
    rules = action(menu_for(Handle(Target.POINT, 1, 0)), "Rule of joint 1–2").menu()
    assert action(rules, "G0").isChecked()
    notices = []
    presenter.noticed.connect(notices.append)
    action(rules, "G1").trigger()
    assert presenter.document.profile.rules == (JointRule.G1,)
    assert (labels(presenter), notices) == (["G1 at joint 1–2 moved nothing"], [])


def test_a_rule_says_what_it_moved(presenter, menu_for):
    bent = edits.move_point(presenter.document, 1, 1, (25.0, 85.0), keep_rules=False)
    presenter.replace_document(bent)
    before, notices = presenter.document, []
    presenter.noticed.connect(notices.append)
    action(action(menu_for(Handle(Target.POINT, 1, 0)), "Rule").menu(), "G1").trigger()
    moves = edits.rule_moves(before, presenter.document, 0)
    assert [(each.segment, each.what) for each in moves.moved] == [(1, "P1")]
    assert labels(presenter) == [told(moves)]
    assert [notice.text for notice in notices] == [sentence(moves)]
    notices[0].callback()
    assert presenter.document is before


def test_a_rule_that_cannot_be_kept_moves_nothing_and_says_why(presenter, menu_for):
    notices = []
    presenter.noticed.connect(notices.append)
    fast = edits.set_shape_parameter(presenter.document, 0, "lambda3", 4.0)
    presenter.replace_document(fast)
    action(action(menu_for(Handle(Target.POINT, 1, 0)), "Rule").menu(), "G2").trigger()
    assert presenter.document.profile.segments == fast.profile.segments
    assert labels(presenter) == ["G2 at joint 1–2 moved nothing"]
    assert "not G2" in notices[-1].text
    assert notices[-1].level == "warning"


def test_an_end_has_no_rule_and_a_quartic_point_resets_its_parameter(presenter, menu_for):
    with pytest.raises(LookupError):
        action(menu_for(Handle(Target.POINT, 0, 0)), "Rule")
    action(menu_for(Handle(Target.QUARTIC, 0, 0)), "Reset λ1").trigger()
    assert presenter.document.profile.segments[0].shape.lambda1 == 1.0


def test_the_last_segment_cannot_be_removed(presenter, menu_for):
    action(menu_for(Handle(Target.CURVE, 1)), "Remove").trigger()
    assert not action(menu_for(Handle(Target.CURVE, 0)), "Remove").isEnabled()


def test_empty_paper_offers_snapping(presenter, menu_for):
    action(menu_for(None), "Snap").trigger()
    assert presenter.view.snap
    assert action(menu_for(None), "Snap").isChecked()
