"""The presenter: one frame per event turn, the newest state wins, errors become notices."""

import time

import pytest
from PySide6.QtCore import QTimer

from app.state import presenter as state
from app.state.presenter import Presenter
from sgb_core.document import edits
from sgb_core.document.evaluation import prepared
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


class Slow(Recorder):
    """Takes longer than a turn may, and notes the turn of each frame."""

    def __init__(self, turns):
        super().__init__()
        self._turns = turns
        self.seen = []

    def refresh(self, frame):
        super().refresh(frame)
        self.seen.append(self._turns[0])
        time.sleep(state.TURN_SECONDS)


@pytest.fixture
def turns(qtbot, monkeypatch):
    monkeypatch.setattr(state, "LONG", 2)
    count, timer = [0], QTimer(interval=0)
    timer.timeout.connect(lambda: count.__setitem__(0, count[0] + 1))
    timer.start()
    yield count
    timer.stop()


def slow_views(qtbot, presenter, turns):
    views = [Slow(turns) for _ in range(3)]
    for view in views:
        presenter.add_view(view)
    qtbot.waitUntil(lambda: all(view.frames for view in views))
    for view in views:
        view.frames, view.seen = [], []
    return views


def test_a_long_document_is_shown_in_several_turns_when_it_is_opened(qtbot, presenter, turns):
    views, whole = slow_views(qtbot, presenter, turns), []
    presenter.refreshed.connect(whole.append)
    presenter.replace_document(tower())
    qtbot.waitUntil(lambda: bool(whole))
    assert len({view.seen[0] for view in views}) == 3
    assert [len(view.frames) for view in views] == [1, 1, 1]
    # An edit is shown by all at once.
    assert presenter.do("ω", set_omega(0.5))
    qtbot.waitUntil(lambda: len(whole) == 2)
    assert len({view.seen[-1] for view in views}) == 1


def test_what_changes_while_views_wait_reaches_all_of_them(qtbot, presenter, turns):
    views, whole = slow_views(qtbot, presenter, turns), []
    presenter.refreshed.connect(whole.append)
    presenter.replace_document(tower())
    qtbot.waitUntil(lambda: bool(views[0].frames))
    assert presenter.do("ω", set_omega(0.5))
    qtbot.waitUntil(lambda: bool(whole) and all(v.frames[-1] is whole[-1] for v in views))
    assert all(view.frames[-1].document is presenter.document for view in views)
    presenter.replace_document(tower())
    qtbot.waitUntil(lambda: views[0].frames[-1].document is presenter.document)
    presenter.refresh_now()
    assert all(view.frames[-1].document is presenter.document for view in views)


def test_what_was_computed_aside_is_not_computed_again(qtbot, presenter, recorder):
    found = prepared(tower())
    presenter.replace_document(found.document, evaluation=found)
    qtbot.waitUntil(lambda: len(recorder.frames) == 2)
    assert recorder.frames[-1].evaluation is found
