"""Laws over the angle, edited one at a time."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.edits.blend import blend
from sgb_core.document.errors import EditError
from sgb_core.document.file.project_file import dumps, loads
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from sgb_core.surfaces.variation import Law
from tests.sgb_core.document.strategies import documents, laws

WAVE = Law("lambda2", "cosine", 1.0, 5.0, None, 3)
KEYS = Law("omega", "keyframes", 0.0, 1.0, keyframes=((10.0, 0.0), (120.0, 1.0), (300.0, 0.5)))


@given(documents(), st.data())
def test_every_edit_can_be_saved_and_undone(document, data):
    session = Session(document)
    law = data.draw(laws(len(document.profile)))
    session.do("add", lambda d: edits.add_law(d, law))
    added = session.document
    index = data.draw(st.integers(0, len(added.variation) - 1))
    place = data.draw(st.integers(0, len(added.variation) - 1))
    session.do("move", lambda d: edits.move_law(d, index, place))
    assert session.document.variation[place] == added.variation[index]
    other = data.draw(laws(len(document.profile)))
    session.do("replace", lambda d: edits.replace_law(d, index, other))
    assert loads(dumps(session.document)) == session.document
    session.do("remove", lambda d: edits.remove_law(d, index))
    assert len(session.document.variation) == len(document.variation)
    assert loads(dumps(session.document)) == session.document
    while session.undo():
        pass
    assert session.document is document


def test_a_law_that_is_not_there(document_of_one):
    for edit in (
        lambda d: edits.remove_law(d, 1),
        lambda d: edits.replace_law(d, 1, WAVE),
        lambda d: edits.move_law(d, 0, 1),
    ):
        with pytest.raises(EditError, match="there is no law 1"):
            edit(edits.add_law(document_of_one, WAVE))
    with pytest.raises(EditError, match="has no laws"):
        edits.remove_law(document_of_one, 0)


@pytest.fixture
def document_of_one():
    return loads(
        b'{"format": "sgb-document", "version": 1, "profile": {"segments": '
        b'[{"points": [[1, 0], [2, 1], [2, 2], [1, 3]]}]}}'
    )


def test_a_key_is_added_in_order_or_changed_in_place():
    assert edits.with_key(KEYS, 200.0, 0.25).keyframes == (
        (10.0, 0.0),
        (120.0, 1.0),
        (200.0, 0.25),
        (300.0, 0.5),
    )
    assert edits.with_key(KEYS, 480.0, 0.25).keyframes == ((10.0, 0.0), (120.0, 0.25), (300.0, 0.5))
    with pytest.raises(EditError, match="f is 2"):
        edits.with_key(KEYS, 0.0, 2.0)


def test_the_last_key_stays():
    one = edits.without_key(edits.without_key(KEYS, 0), 0)
    assert one.keyframes == ((300.0, 0.5),)
    with pytest.raises(EditError, match="only key"):
        edits.without_key(one, 0)
    with pytest.raises(EditError, match="there is no key 3"):
        edits.without_key(KEYS, 3)


@given(
    st.integers(0, 2),
    st.floats(-1000.0, 1000.0) | st.sampled_from([10.0, 120.0, 300.0]),
    st.floats(-1, 2),
)
def test_a_moved_key_never_lands_on_another(index, degrees, value):
    moved = edits.with_key_moved(KEYS, index, degrees, value)
    turns = [key[0] for key in moved.keyframes]
    assert len(set(turns)) == 3
    assert all(0.0 <= turn < 360.0 for turn in turns)
    assert moved.keyframes[index][1] == min(max(value, 0.0), 1.0)
    apart = abs((turns[index] - degrees + 180.0) % 360.0 - 180.0)
    assert apart <= 0.011
    others = [k for k in range(3) if k != index]
    assert [moved.keyframes[k] for k in others] == [KEYS.keyframes[k] for k in others]


@pytest.mark.parametrize(
    ("law", "tolerance"),
    [
        (Law("omega", "paper", 0.0, 1.0), 0.04),
        (Law("omega", "raised-cosine", 0.0, 1.0), 0.03),
        (WAVE, 0.03),
        (KEYS, 0.0),
    ],
)
def test_keyframes_in_place_of_a_law_follow_its_curve(law, tolerance):
    keys = edits.as_keyframes(law)
    theta = np.linspace(0.0, 2 * np.pi, 721)
    assert keys.kind == "keyframes"
    assert np.abs(keys.fraction(theta) - law.fraction(theta)).max() <= tolerance
    assert keys.fraction(theta).max() == pytest.approx(law.fraction(theta).max(), abs=1e-9)


def test_more_waves_than_keys():
    with pytest.raises(EditError, match="400 waves"):
        edits.as_keyframes(Law("omega", "cosine", 0.0, 1.0, None, 400))


def test_strengths_along_the_height_are_keys_in_order_and_follow_the_edits() -> None:
    law = Law("radius", "lobes", 0.9, 1.1, count=5)
    keyed = edits.with_strength(edits.with_strength(law, 1.0, 0.2), 0.25, 1.0)
    assert keyed.along == ((0.25, 1.0), (1.0, 0.2))
    assert edits.with_strength(keyed, 0.25, 0.5).along[0] == (0.25, 0.5)
    # A key stays between its neighbours.
    assert edits.with_strength_moved(keyed, 0, 2.0, 0.0).along[0] == (0.999, 0.0)
    assert edits.without_strength(keyed, 1).along == ((0.25, 1.0),)
    with pytest.raises(EditError):
        edits.without_strength(keyed, 2)
    # Of what is no radius there is no strength; upside down foot and rim change places.
    assert edits.with_parameter(keyed, "omega").along == ()
    document = edits.add_law(Document(Profile.of([line((20.0, 0.0), (20.0, 60.0))])), keyed)
    assert edits.mirror_height(document).variation[0].along == ((0.0, 0.2), (0.75, 1.0))
    other = edits.replace_law(document, 0, edits.with_strength(keyed, 0.25, 0.0))
    assert blend(document, other, 0.5).variation[0].along == ((0.25, 0.5), (1.0, 0.2))
    # What a file says it keeps.
    again = loads(dumps(document))
    assert again.variation == document.variation
