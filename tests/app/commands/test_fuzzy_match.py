"""Fuzzy matching: in order, words' beginnings first, nothing that does not match."""

from hypothesis import given
from hypothesis import strategies as st

from app.commands.fuzzy_match import ranked, score


def test_beginnings_of_words_and_runs_come_first():
    names = ["Reset shape parameters", "Split in the middle", "Snap to grid", "Export…"]
    assert names[ranked("sp", names)[0]] == "Split in the middle"
    assert names[ranked("stg", names)[0]] == "Snap to grid"
    assert ranked("zzz", names) == []
    assert ranked("", names) == [0, 1, 2, 3]


@given(st.text(alphabet="abc ", max_size=5), st.text(alphabet="abc ", max_size=12))
def test_it_matches_exactly_the_subsequences(query, text):
    rest = iter(text)
    is_subsequence = all(c in rest for c in query.replace(" ", ""))
    assert (score(query, text) is not None) == is_subsequence


def test_a_whole_other_word_comes_before_the_beginning_of_one():
    texts, also = ["Measure tool", "Panel: Solid", "Thick lines"], ["thickness", "thick wall", ""]
    assert ranked("thick", texts, also) == [2, 1, 0]
    assert ranked("thickness", texts, also) == [0]
