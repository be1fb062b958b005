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


def _answers(query, text):
    """Whether the query can be cut into beginnings of words of the text, in order; or is in it."""
    words = "".join(query.split())

    def fits(rest, at):
        if not rest:
            return True
        starts = [k for k in range(at, len(text)) if k == 0 or not text[k - 1].isalnum()]
        return any(
            text.startswith(rest[:length], start) and fits(rest[length:], start + length)
            for start in starts
            for length in range(1, len(rest) + 1)
        )

    return fits(words, 0) or query.strip() in text


@given(st.text(alphabet="abc ", max_size=5), st.text(alphabet="abc ", max_size=12))
def test_it_matches_beginnings_of_words_and_what_stands_in_a_name(query, text):
    assert (score(query, text) is not None) == _answers(query, text)


def test_letters_strewn_over_a_name_are_no_match():
    names = ["Upright guide through the point", "Picture…"]
    assert ranked("photo", names, ["", "photo image"]) == [1]
    assert ranked("photo", names) == []


def test_several_words_are_looked_for_each_and_little_ones_pass():
    names = ["Panel: Solid", "Panel: Look", "Export…"]
    also = ["thick wall vessel", "photo around", "print"]
    assert ranked("a photo around the belly", names, also) == [1]
    assert ranked("wall thick", names, also) == [0]
    assert ranked("panel", names, also) == [1, 0]


def test_a_letter_wrong_or_an_ending_more_is_forgiven_where_nothing_else_is_meant():
    names, also = ["Height", "Weight", "Panel: Solid"], ["tall", "mass", "thick"]
    assert ranked("heigth", names, also) == [0]
    assert ranked("hight", names, also) == [0]
    assert ranked("heught", names, also) == [0]
    assert ranked("heeight", names, also) == [0]
    assert ranked("make it thicker", names, also) == [2]
    # What is known exactly keeps out what is only like it.
    assert ranked("tall", ["Tail", "Height"], ["", "tall"]) == [1]
    assert ranked("xyzzy plugh", names, also) == []


def test_a_whole_other_word_comes_before_the_beginning_of_one():
    texts, also = ["Measure tool", "Panel: Solid", "Thick lines"], ["thickness", "thick wall", ""]
    assert ranked("thick", texts, also) == [2, 1, 0]
    assert ranked("thickness", texts, also) == [0]
