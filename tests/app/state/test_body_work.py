"""The body is made aside: the newest wins, coarse first, fine at rest, nothing waits."""

import sys
import threading

import numpy as np
import pytest

from app.state.body_work import BodyWork, same_body
from app.state.presenter import Presenter
from sgb_core.bodies.cut_outs import CutOut
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.appearance.model import Layer, LayerKind
from sgb_core.document.body_state import BodyState
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from sgb_core.findings.bodies import BodyFailure
from sgb_core.interruption import checkpoint
from sgb_core.surfaces.laws.law import Law
from tests.app.waiting import let_turn

WALL = Segment(np.linspace((20.0, 0.0), (20.0, 60.0), 4))
CUP = edits.set_solid(Document(Profile.of([WALL])), kind="vessel")


def stub(document, surface, *, fine):
    return BodyState(document, surface, fine)


class Endless:
    """Makes coarse bodies at once, and goes on for ever, or nearly, with fine ones."""

    def __init__(self):
        self.made = []
        self.begun = threading.Event()
        self.gave_up = threading.Event()

    def __call__(self, document, surface, *, fine):
        self.made.append((document.solid.wall, fine))
        if fine and document is CUP:
            self.begun.set()
            for _ in range(20_000):
                checkpoint()
                threading.Event().wait(0.001)
            self.gave_up.set()
        return stub(document, surface, fine=fine)


@pytest.fixture
def presenter(qtbot):
    return Presenter(Session(CUP))


def test_coarse_first_then_fine(qtbot, presenter):
    made = []
    work = BodyWork(presenter, make=lambda *args, fine: made.append(fine) or stub(*args, fine=fine))
    presenter.add_view(work)
    qtbot.waitUntil(lambda: presenter.frame.body is not None and presenter.frame.body.fine)
    assert made == [False, True]
    qtbot.wait(400)
    assert made == [False, True]
    work.stop()


def test_the_newest_document_is_made_and_those_between_are_left_out(qtbot, presenter):
    gate, made = threading.Event(), []

    def slow(document, surface, *, fine):
        made.append(document.solid.wall)
        gate.wait()
        return stub(document, surface, fine=fine)

    work = BodyWork(presenter, make=slow)
    presenter.add_view(work)
    qtbot.waitUntil(lambda: made == [3.0])
    for wall in (4.0, 5.0, 6.0):
        presenter.do("wall", lambda document, wall=wall: edits.set_solid(document, wall=wall))
        let_turn()
    gate.set()
    qtbot.waitUntil(
        lambda: presenter.frame.body is not None and presenter.frame.body.document.solid.wall == 6.0
    )
    assert made[:2] == [3.0, 6.0]
    work.stop()


def test_another_document_never_shows_the_body_of_the_last_one(qtbot, presenter):
    gate, begun = threading.Event(), threading.Event()

    def slow(document, surface, *, fine):
        begun.set()
        gate.wait()
        return stub(document, surface, fine=fine)

    work = BodyWork(presenter, make=slow)
    presenter.add_view(work)
    qtbot.waitUntil(begun.is_set)
    presenter.replace_document(edits.set_solid(CUP, kind="surface"))
    let_turn()
    gate.set()
    qtbot.waitUntil(lambda: not work.busy)
    assert presenter.frame.body is None
    work.stop()


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (OSError("out of clay"), "out of clay"),
        (RuntimeError("x"), "something went wrong (RuntimeError)"),
    ],
)
def test_a_failure_is_a_line_and_a_mistake_is_told(qtbot, presenter, monkeypatch, error, words):
    def fail(document, surface, *, fine):
        raise error

    told = []
    monkeypatch.setattr(sys, "excepthook", lambda _kind, found, _trace: told.append(found))
    work = BodyWork(presenter, make=fail)
    presenter.add_view(work)
    qtbot.waitUntil(lambda: presenter.frame.body is not None)
    assert presenter.frame.body.findings == (BodyFailure(words),)
    work.stop()
    assert set(told) == ({error} if isinstance(error, RuntimeError) else set())


def test_closing_drops_what_is_under_way(qtbot, presenter):
    endless = Endless()
    work = BodyWork(presenter, make=endless)
    presenter.add_view(work)
    qtbot.waitUntil(endless.begun.is_set)
    work.stop()
    assert not endless.gave_up.is_set()
    let_turn()
    assert endless.made == [(3.0, False), (3.0, True)]
    assert not work.busy
    assert not presenter.frame.body.fine


@pytest.mark.parametrize("change", [{"wall": 4.0}, {"kind": "surface"}])
def test_a_fine_body_outdated_by_a_change_is_dropped(qtbot, presenter, change):
    endless = Endless()
    work = BodyWork(presenter, make=endless)
    presenter.add_view(work)
    qtbot.waitUntil(endless.begun.is_set)
    presenter.do("change", lambda document: edits.set_solid(document, **change))
    qtbot.waitUntil(lambda: not work.busy)
    assert not endless.gave_up.is_set()
    assert endless.made[2:] == ([(4.0, False), (4.0, True)] if "wall" in change else [])
    work.stop()


def test_a_change_that_leaves_the_body_alone_drops_nothing(qtbot, presenter):
    gate, begun, ended = threading.Event(), threading.Event(), []

    def slow(document, surface, *, fine):
        if fine:
            begun.set()
            gate.wait()
            checkpoint()
        ended.append(fine)
        return stub(document, surface, fine=fine)

    work = BodyWork(presenter, make=slow)
    presenter.add_view(work)
    qtbot.waitUntil(begun.is_set)
    presenter.do("name", lambda document: edits.rename(document, "Cup"))
    let_turn()
    gate.set()
    qtbot.waitUntil(lambda: not work.busy)
    assert ended == [False, True]
    work.stop()


@pytest.mark.parametrize(
    "edited",
    [
        edits.set_twist(CUP, turns=0.2),
        edits.set_solid(CUP, wall=2.0),
        edits.add_law(CUP, Law("radius", "lobes", 0.9, 1.1, count=5)),
        edits.add_layer(CUP, Layer(LayerKind.STRIPES, relief=1.0)),
        edits.set_cut_outs(CUP, (CutOut(),)),
    ],
    ids=["twist", "wall", "law", "relief", "holes"],
)
def test_whatever_changes_the_body_makes_another(edited):
    assert same_body(CUP, CUP)
    assert not same_body(CUP, edited)
