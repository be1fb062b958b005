from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given

from sgb_core.document import edits
from sgb_core.document.edits.states import free_state_name, present_state, state, state_in_unit
from sgb_core.document.errors import EditError, FileError
from sgb_core.document.file import project_file
from sgb_core.document.model import MAX_STATE_NAME, MAX_STATES, Document, Unit
from sgb_core.document.session import Session
from tests.sgb_core.document import samples
from tests.sgb_core.document.strategies import documents


def vase() -> Document:
    return project_file.loads(samples.data(samples.tree()))


def fuller(document: Document) -> Document:
    return edits.set_shape_parameter(document, 0, "lambda2", 6.0)


@given(documents())
def test_storing_changes_nothing_but_the_states(document: Document) -> None:
    name = free_state_name(document)
    stored = edits.store_state(document, name)
    assert replace(stored, states=document.states) == document
    assert state(stored, name).profile is document.profile
    assert edits.store_state(stored, name) is stored
    assert edits.switch_state(stored, name) is stored
    assert project_file.loads(project_file.dumps(stored)) == stored


def test_switching_goes_there_and_back_and_is_undone() -> None:
    first = edits.store_state(vase(), "A")
    both = edits.store_state(fuller(first), "B")
    assert [each.name for each in both.states] == ["A", "B"]
    assert present_state(both) == "B"
    session = Session(both)
    session.do("Show state A", lambda d: edits.switch_state(d, "A"))
    assert session.document.profile == vase().profile
    assert session.document.states == both.states
    assert session.document.name == both.name
    assert present_state(session.document) == "A"
    session.undo()
    assert session.document is both
    assert present_state(fuller(first)) is None


def test_a_state_is_replaced_renamed_copied_and_thrown_away() -> None:
    document = edits.store_state(vase(), "A")
    document = edits.store_state(fuller(document), "A")
    assert len(document.states) == 1
    assert state(document, "A").profile == document.profile
    document = edits.duplicate_state(document, "A", "A, slim")
    document = edits.store_state(document, "Z")
    document = edits.rename_state(document, "A", "fuller")
    assert [each.name for each in document.states] == ["fuller", "A, slim", "Z"]
    assert edits.rename_state(document, "Z", "Z") is document
    document = edits.delete_state(document, "A, slim")
    assert [each.name for each in document.states] == ["fuller", "Z"]


@pytest.mark.parametrize(
    "act",
    [
        lambda d: edits.switch_state(d, "nowhere"),
        lambda d: edits.rename_state(d, "A", "B"),
        lambda d: edits.duplicate_state(d, "A", "B"),
        lambda d: edits.store_state(d, ""),
        lambda d: edits.store_state(d, "x" * (MAX_STATE_NAME + 1)),
        lambda d: edits.store_state(d, "\ud800"),
        lambda d: edits.delete_state(d, "nowhere"),
    ],
)
def test_what_is_not_allowed(act) -> None:  # type: ignore[no-untyped-def]
    document = edits.store_state(edits.store_state(vase(), "A"), "B")
    with pytest.raises(EditError):
        act(document)


def test_there_is_a_most() -> None:
    document = vase()
    for _ in range(MAX_STATES):
        document = edits.store_state(document, free_state_name(document))
    assert document.states[26].name == "A2"
    with pytest.raises(EditError, match="most"):
        edits.store_state(document, "one more")
    with pytest.raises(EditError, match="most"):
        edits.duplicate_state(document, "A", "one more")
    assert edits.store_state(fuller(document), "A") != document


def test_a_ghost_has_its_true_size() -> None:
    document = edits.set_unit(edits.store_state(vase(), "A"), Unit.IN, convert=True)
    ghost = state_in_unit(document, "A")
    assert ghost.unit is Unit.IN
    assert ghost.profile.size == pytest.approx(document.profile.size)


@pytest.mark.parametrize(
    ("states", "words"),
    [
        ({}, "states is an object; allowed is a list of at most 50 states"),
        ([3], "states[0] is 3"),
        ([{"profile": samples.tree()["profile"]}], "states[0].name is missing"),
        ([{"name": "A"}], "states[0].profile is missing"),
        ([{"name": "A", "profile": {"segments": []}}], "states[0].profile.segments"),
        ([{"name": "A", "profile": samples.tree()["profile"]}] * 2, "states[1].name"),
    ],
)
def test_a_bad_file_says_where(states: object, words: str) -> None:
    with pytest.raises(FileError) as caught:
        project_file.loads(samples.data({**samples.tree(), "states": states}))
    assert words in str(caught.value)
