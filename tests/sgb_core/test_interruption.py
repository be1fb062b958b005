"""Long computations end at their next checkpoint once they are unwanted."""

import threading

import pytest

from sgb_core.bodies import body_mesh, thickness, vessel
from sgb_core.document import edits
from sgb_core.document.body_state import body_state
from sgb_core.document.model import Document
from sgb_core.interruption import checkpoint, interruptible
from sgb_core.surfaces.variation import Law
from tests.sgb_core.surfaces.chains import chain

FLARED = chain([[(20, 0), (20, 20), (20, 40), (30, 60)]], (1, 3, 1, 1))
LAW = Law("lambda2", "cosine", 2.0, 4.0, count=12)
POT = edits.set_variation(edits.set_solid(Document(FLARED), kind="vessel"), [LAW])


class Unwantedness(Exception):  # noqa: N818 - an outcome, not an error
    pass


class Unwanted:
    """Ends what it is asked about from the moment on at which ``reached`` says so."""

    def __init__(self, reached):
        self.reached = reached

    def __call__(self):
        if self.reached():
            raise Unwantedness


def counted(monkeypatch, module, name):
    """Count the calls of a function of a module."""
    calls, function = [], getattr(module, name)

    def calling(*args, **options):
        calls.append(1)
        return function(*args, **options)

    monkeypatch.setattr(module, name, calling)
    return calls


@pytest.mark.parametrize(
    ("module", "name"),
    [(body_mesh, "section_at"), (vessel, "section_at"), (vessel, "wall_min"), (thickness, "_jet")],
)
def test_an_unwanted_body_makes_no_further_step(monkeypatch, module, name):
    vessel.vessel_measures.cache_clear()
    body_mesh.cross_section.cache_clear()
    calls = counted(monkeypatch, module, name)
    with pytest.raises(Unwantedness), interruptible(Unwanted(lambda: len(calls) == 2)):
        body_state(POT, POT.surface, fine=True)
    assert len(calls) == 2
    # What was left unfinished is made anew when it is wanted after all.
    assert body_state(POT, POT.surface, fine=True).measures is not None
    assert len(calls) > 4


def test_outside_nothing_is_asked():
    checkpoint()
    with interruptible(Unwanted(lambda: True)):
        with pytest.raises(Unwantedness):
            checkpoint()
        other = threading.Thread(target=checkpoint)
        other.start()
        other.join()
    checkpoint()
