"""Segments added, merged with a word before, put head to tail on opening; notices of joints."""

from dataclasses import replace

import numpy as np
import pytest

from app.commands.segment import merge, split
from app.commands.segment_kinds import append_kind, more_segment_commands, offer_head_to_tail
from app.state.joint_findings import JointFindings
from app.state.presenter import Presenter
from app.window.notice_bar import NoticeBar
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.edits.segments import Kind
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from sgb_core.surfaces.laws.law import Law
from tests.app.helpers import tower

SHAPE = ShapeParameters(2.0, 4.0, 1.0, 0.5)
HALVES = Document(
    Profile.of(
        [Segment([(3, 0), (5, 1), (5, 3), (3, 4)]), Segment([(3, 0), (2, 1), (2, 3), (3, 4)])],
        ["free"],
    )
)


class Stage:
    def __init__(self, qtbot, document):
        self.presenter = Presenter(Session(document))
        self.bar = NoticeBar(self.presenter)
        qtbot.addWidget(self.bar)
        self.presenter.add_view(JointFindings(self.presenter))
        self.presenter.refresh_now()

    @property
    def document(self):
        return self.presenter.document

    @property
    def said(self):
        return self.bar.notice.text if self.bar.notice else None

    def press_button(self):
        self.bar._button.click()


@pytest.fixture
def stage(qtbot):
    return Stage(qtbot, tower(SHAPE))


@pytest.mark.parametrize("kind", list(Kind))
def test_a_segment_of_a_kind_is_added_and_selected(stage, kind):
    append_kind(stage.presenter, kind)
    assert len(stage.document.profile) == 4
    assert stage.presenter.view.segment == 3
    assert (stage.said is not None) == (kind is Kind.ARC)


def test_a_merge_that_moves_the_curve_asks_first(stage):
    before = stage.document
    merge(stage.presenter)
    assert stage.document is before
    assert "moves the curve by up to" in stage.said
    assert len(stage.presenter.view.preview) == 2
    stage.press_button()
    assert len(stage.document.profile) == 2
    assert stage.presenter.view.preview is None
    stage.presenter.undo()
    merge(stage.presenter)
    stage.bar.dismiss()
    assert stage.document is before
    assert stage.presenter.view.preview is None


def test_a_split_under_a_law_that_moves_the_curve_asks_first(stage):
    law = Law("omega", "raised-cosine", 0.0, 1.0)
    bent = ShapeParameters(0.0, 6.0, 0.0, 0.5)
    profile = stage.document.profile
    profile = profile.with_segments(part.with_shape(bent) for part in profile.segments)
    before = replace(stage.document, profile=profile, variation=(law,))
    stage.presenter.replace_document(before)
    _, deviation = edits.split_segment(before, 0, 0.5)
    split(stage.presenter, 0, 0.5)
    assert stage.document is before
    assert f"moves the curve by up to {deviation:.3g} mm" in stage.said
    stage.press_button()
    assert len(stage.document.profile) == 4
    assert stage.presenter.session.undo_label == "Split segment 1"
    stage.presenter.undo()
    assert stage.document is before


def test_another_edit_withdraws_the_preview(stage):
    merge(stage.presenter)
    stage.presenter.do("ω", lambda d: edits.set_shape_parameter(d, 0, "omega", 1.0))
    assert stage.presenter.view.preview is None


def test_a_merge_that_moves_nothing_is_done_at_once(stage):
    before = stage.document
    split(stage.presenter, 0, 0.4)
    merge(stage.presenter)
    assert len(stage.document.profile) == 3
    assert np.abs(stage.document.profile.sample(33) - before.profile.sample(33)).max() < 1e-7
    assert stage.said is None


def test_the_last_segment_has_none_to_merge_with(stage):
    stage.presenter.select(2)
    merge(stage.presenter)
    assert "last" in stage.said


def test_halves_given_in_one_direction_are_offered_to_be_joined(qtbot):
    stage = Stage(qtbot, HALVES)
    assert offer_head_to_tail(stage.presenter)
    assert "opposite directions" in stage.said
    stage.press_button()
    assert stage.document.profile.closed
    assert not offer_head_to_tail(stage.presenter)


def test_the_order_is_changed_by_command_and_the_segment_stays_selected(stage):
    commands = {c.name: c for c in more_segment_commands(stage.presenter)}
    first = stage.document.profile.segments[0]
    commands["move_later"].run()
    assert stage.presenter.view.segment == 1
    now = stage.document.profile.segments[1]
    assert np.diff(now.points, axis=0) == pytest.approx(np.diff(first.points, axis=0))
    commands["mirror_segment"].run()
    assert stage.presenter.session.undo_label == "Mirror segment 2"
    commands["mirror_image"].run()
    assert len(stage.document.profile) == 6
    assert not commands["move_earlier"].enabled(Stage.frame_of(stage, 0))


def _frame_of(stage, segment):
    stage.presenter.select(segment)
    return stage.presenter.frame


Stage.frame_of = staticmethod(_frame_of)


def test_a_rule_that_gives_way_is_told_once_a_gesture(stage):
    presenter, told = stage.presenter, []
    presenter.do("C1", lambda d: edits.set_rule(edits.set_rule(d, 0, "C1"), 1, "C1"))
    presenter.refresh_now()
    presenter.noticed.connect(lambda notice: told.append(notice.text))
    presenter.begin("λ3")
    for value in (3.0, 3.9, 4.0, 3.99, 4.0):
        presenter.apply(
            lambda d, value=value: edits.set_shape_parameter(
                edits.set_shape_parameter(d, 0, "omega", 1.0), 0, "lambda3", value
            )
        )
        presenter.refresh_now()
    presenter.commit()
    presenter.refresh_now()
    assert len(told) == 1
    assert told[0].startswith("Joint 1–2 is ")
    presenter.undo()
    presenter.refresh_now()
    assert len(told) == 1
