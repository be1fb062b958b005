from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, rule

from sgb_core.document import edits
from sgb_core.document.edits import EditError
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from tests.sgb_core.document import samples
from tests.sgb_core.document.strategies import random_edits

START = samples.document()


def named(name: str):
    return lambda document: replace(document, name=name)


def longer(text: str):
    return lambda document: replace(document, name=document.name + text)


def refuses(document: Document) -> Document:
    raise EditError("no")


def test_a_gesture_is_computed_from_its_start_and_makes_one_entry() -> None:
    session = Session(START)
    session.begin("drag")
    for step in "abc":
        session.apply(longer(step))
    assert session.in_gesture
    assert session.document.name == START.name + "c"
    assert session.undo_label is None
    session.commit()
    assert session.undo_label == "drag"
    assert session.undo()
    assert session.document is START
    assert session.redo_label == "drag"
    assert session.redo()
    assert session.document.name == START.name + "c"
    assert not session.redo()


def test_a_gesture_that_changes_nothing_makes_no_entry_and_keeps_the_saved_mark() -> None:
    session = Session(START)
    session.begin("drag")
    session.apply(named("other"))
    session.apply(named(START.name))
    session.commit()
    assert session.document is START
    assert not session.is_modified
    assert len(session.history) == 1


def test_cancel_goes_back_to_the_start() -> None:
    session = Session(START)
    session.begin("drag")
    session.apply(named("other"))
    assert session.is_modified
    session.cancel()
    assert session.document is START
    assert not session.is_modified
    session.cancel()
    session.commit()


def test_a_refused_edit_leaves_the_last_shown_document() -> None:
    session = Session(START)
    session.begin("drag")
    session.apply(named("a"))
    with pytest.raises(EditError):
        session.apply(refuses)
    assert session.document.name == "a"
    session.commit()
    with pytest.raises(EditError):
        session.do("step", refuses)
    assert session.document.name == "a"
    assert not session.in_gesture
    assert session.undo_label == "drag"


def test_apply_needs_a_gesture() -> None:
    with pytest.raises(RuntimeError, match="begin"):
        Session(START).apply(named("a"))


def test_a_gesture_left_open_is_committed_by_the_next() -> None:
    session = Session(START)
    session.begin("first")
    session.apply(named("a"))
    session.begin("second")
    session.apply(longer("b"))
    session.undo()
    assert session.document.name == "a"
    assert [entry.label for entry in session.history] == ["", "first", "second"]


def test_undoing_to_what_was_saved_makes_it_unmodified_again() -> None:
    session = Session(START, saved=False)
    assert session.is_modified
    session.do("a", named("a"))
    session.mark_saved()
    assert not session.is_modified
    session.do("b", named("b"))
    assert session.is_modified
    session.undo()
    assert not session.is_modified
    session.undo()
    assert session.is_modified


def test_a_save_that_ends_later_marks_what_it_saved() -> None:
    session = Session(START)
    session.do("a", named("a"))
    being_saved = session.document
    session.do("b", named("b"))
    session.mark_saved(being_saved)
    assert session.is_modified
    session.undo()
    assert not session.is_modified


def test_a_new_step_drops_what_was_undone() -> None:
    session = Session(START)
    session.do("a", named("a"))
    session.undo()
    session.do("b", named("b"))
    assert session.redo_label is None
    assert [entry.label for entry in session.history] == ["", "b"]


def test_history_can_be_jumped_in() -> None:
    session = Session(START)
    for name in "abc":
        session.do(name, named(name))
    session.jump_to(1)
    assert (session.position, session.document.name) == (1, "a")
    session.jump_to(3)
    assert session.document.name == "c"
    with pytest.raises(IndexError, match="0 to 3"):
        session.jump_to(4)
    with pytest.raises(IndexError):
        session.jump_to(-1)


def test_replacing_the_document_starts_afresh() -> None:
    session = Session(START)
    session.do("a", named("a"))
    session.begin("b")
    other = samples.document(samples.HALVES[:1])
    session.replace(other)
    assert (session.document, session.in_gesture, session.undo_label) == (other, False, None)
    assert not session.is_modified
    session.replace(START, saved=False)
    assert session.is_modified


def test_subscribers_hear_old_and_new_until_they_leave() -> None:
    session = Session(START)
    heard: list[tuple[str, str]] = []
    leave = session.subscribe(lambda old, new: heard.append((old.name, new.name)))
    session.begin("drag")
    session.apply(named("a"))
    session.apply(named("b"))
    session.commit()
    session.mark_saved()
    session.undo()
    first = START.name
    assert heard == [(first, "a"), ("a", "b"), ("b", "b"), ("b", "b"), ("b", first)]
    leave()
    leave()
    session.redo()
    assert len(heard) == 5


class Sessions(RuleBasedStateMachine):
    """Whatever is done, undo leads back through the very documents that there were."""

    def __init__(self) -> None:
        super().__init__()
        self.session = Session(START)
        self.states = [START]
        self.at = 0

    def step(self, document: Document) -> None:
        if document != self.states[self.at]:
            self.states[self.at + 1 :] = [document]
            self.at += 1

    @rule(edit=random_edits())
    def do(self, edit) -> None:
        try:
            self.session.do("step", edit)
        except EditError:
            return
        self.step(self.session.document)

    @rule(edits=st.lists(random_edits(), max_size=3), ends=st.sampled_from(["commit", "cancel"]))
    def gesture(self, edits, ends: str) -> None:
        self.session.begin("drag")
        for edit in edits:
            try:
                self.session.apply(edit)
            except EditError:
                continue
        if ends == "commit":
            self.step(self.session.document)
        getattr(self.session, ends)()

    @rule()
    def undo(self) -> None:
        assert self.session.undo() == (self.at > 0)
        self.at = max(self.at - 1, 0)

    @rule()
    def redo(self) -> None:
        assert self.session.redo() == (self.at + 1 < len(self.states))
        self.at = min(self.at + 1, len(self.states) - 1)

    @invariant()
    def the_document_is_the_very_one(self) -> None:
        assert self.session.document == self.states[self.at]
        self.states[self.at] = self.session.document
        found = [entry.document for entry in self.session.history]
        assert len(found) == len(self.states)
        assert self.session.position == self.at
        assert self.session.is_modified == (self.at != 0)
        assert found[0] is START
        assert found[self.at] is self.session.document

    def teardown(self) -> None:
        before = [entry.document for entry in self.session.history]
        while self.session.undo():
            pass
        assert self.session.document is START
        walked = [self.session.document]
        while self.session.redo():
            walked.append(self.session.document)
        assert all(a is b for a, b in zip(walked, before, strict=True))


Sessions.TestCase.settings = settings(deadline=None, max_examples=40, stateful_step_count=20)
TestSessions = Sessions.TestCase


@pytest.mark.parametrize(
    "end",
    [
        lambda session: session.commit(),
        lambda session: session.cancel(),
        lambda session: session.begin("another"),
        lambda session: session.undo(),
        lambda session: session.jump_to(0),
    ],
)
def test_a_passing_gesture_leaves_no_trace(end) -> None:  # type: ignore[no-untyped-def]
    start = samples.document()
    session = Session(start)
    session.begin("look", passing=True)
    session.apply(edits.mirror_height)
    assert session.document != start
    assert session.in_passing_gesture
    assert not session.is_modified
    end(session)
    assert session.document is start
    assert not session.in_passing_gesture
    assert len(session.history) == 1
    session.do("real", edits.mirror_height)
    assert session.is_modified
    assert len(session.history) == 2
