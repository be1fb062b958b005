"""The presenter: one frame per event turn, the newest state wins, errors become notices."""

import pytest

from app.state.presenter import Presenter
from sgb_core.document import edits
from sgb_core.document.session import Session
from tests.app.helpers import tower
from tests.app.waiting import let_turn


class Recorder:
    def __init__(self):
        self.frames = []

    def refresh(self, frame):
        self.frames.append(frame)


@pytest.fixture
def presenter(qtbot):
    return Presenter(Session(tower()))


@pytest.fixture
def recorder(qtbot, presenter):
    view = Recorder()
    presenter.add_view(view)
    qtbot.waitUntil(lambda: len(view.frames) == 1)
    return view


def set_omega(value):
    return lambda document: edits.set_shape_parameter(document, 0, "omega", value)


def test_many_changes_in_one_turn_make_one_frame_of_the_newest(qtbot, presenter, recorder):
    presenter.begin("ω of segment 1")
    for step in range(1, 11):
        presenter.apply(set_omega(step / 10))
    let_turn()
    assert len(recorder.frames) == 2
    assert recorder.frames[-1].document.profile.segments[0].shape.omega == 1.0
    assert recorder.frames[-1].dragging
    presenter.commit()
    let_turn()
    assert not recorder.frames[-1].dragging
    assert recorder.frames[-1].document is presenter.document


def test_nothing_changed_draws_nothing(qtbot, presenter, recorder):
    presenter.set_view(segment=presenter.view.segment)
    let_turn()
    assert len(recorder.frames) == 1


def test_an_edit_that_is_not_allowed_is_said_and_changes_nothing(qtbot, presenter, recorder):
    before = presenter.document
    notices = []
    presenter.noticed.connect(notices.append)
    assert not presenter.do("ω", set_omega(2.0))
    assert presenter.document is before
    assert presenter.session.undo_label is None
    assert len(notices) == 1
    assert "0" in notices[0].text
    assert "1" in notices[0].text


def test_a_refused_step_of_a_drag_keeps_the_last_good_one(qtbot, presenter, recorder):
    presenter.begin("ω")
    presenter.apply(set_omega(0.5))
    assert not presenter.apply(set_omega(7.0))
    presenter.commit()
    assert presenter.document.profile.segments[0].shape.omega == 0.5


def test_cancel_restores_the_very_document(qtbot, presenter):
    before = presenter.document
    presenter.begin("ω")
    presenter.apply(set_omega(0.5))
    presenter.cancel()
    assert presenter.document is before
    assert presenter.session.undo_label is None


def test_a_selection_that_no_longer_exists_moves_into_range(qtbot, presenter):
    presenter.select(2, 1)
    presenter.do("Remove", lambda document: edits.remove_segment(document, 2))
    assert presenter.view.segment == 1
    assert presenter.view.points == frozenset()


def test_another_document_has_a_new_generation_and_no_history(qtbot, presenter, recorder):
    presenter.do("ω", set_omega(0.5))
    other = tower()
    presenter.replace_document(other)
    let_turn()
    assert recorder.frames[-1].generation == 1
    assert recorder.frames[-1].document is other
    assert presenter.session.undo_label is None
    assert not presenter.session.is_modified
