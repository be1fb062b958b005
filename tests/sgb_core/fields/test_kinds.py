"""Each kind against its own JSON Schema, as an independent judge of what is allowed."""

from __future__ import annotations

from enum import StrEnum

import jsonschema
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.fields.kinds import (
    COORDINATE,
    FINITE,
    LENGTH,
    POSITIVE_LENGTH,
    SHARE,
    Choice,
    Chosen,
    Colour,
    Flag,
    Kind,
    Range,
    Text,
)
from sgb_core.fields.lists import Fixed, OrNone, Several
from sgb_core.findings.refusal import Refusal, RefusalError
from tests.sgb_core.document.strategies import json_values


class Metal(StrEnum):
    TIN = "tin"
    GOLD = "gold"


KINDS: list[Kind] = [
    Range(0.0, 4.0),
    Range(above=0.0, high=360.0),
    Range(low=-2.5),
    Range(1, 9, whole=True),
    FINITE,
    COORDINATE,
    LENGTH,
    POSITIVE_LENGTH,
    SHARE,
    Choice(Metal),
    Choice({"a": 1, "b": 2}),
    Chosen(Metal, "metals"),
    Flag(),
    Text(),
    Text(1, 3),
    Text(pattern="[a-c]+"),
    Colour(),
    OrNone(SHARE),
    OrNone(Several(SHARE, "shares", 2), "all"),
    OrNone(Colour(), absent=True),
    Several(Flag(), "flags", 2, 1),
    Several(SHARE, "shares", 2, 2),
    Fixed((FINITE, Colour()), "a pair"),
]
near = (
    st.sampled_from([0, 1, 2, 3, 9, 10, 0.5, 1.5, -1, 4.0, 360, 1e9, 1e10, 5e-324])
    | st.sampled_from(["tin", "a", "abc", "all", "#00ff00", "#00FF0g"])
    | st.booleans()
    | st.none()
)
values = near | st.lists(near, max_size=3) | json_values


def refused(kind: Kind, value: object) -> bool:
    try:
        kind.take(kind.from_plain(value, ("here",)), ("here",))
    except RefusalError as error:
        found = error
    else:
        return False
    assert isinstance(found.finding, Refusal)
    assert found.finding.path[0] == "here"
    assert str(found).startswith("here")
    return True


@given(st.sampled_from(KINDS), values)
def test_a_value_is_taken_exactly_where_the_schema_allows_it(kind: Kind, value: object) -> None:
    validator = jsonschema.Draft202012Validator(kind.schema({}))
    assert refused(kind, value) is not validator.is_valid(value)


@given(st.sampled_from(KINDS), values)
def test_what_is_taken_is_kept_as_it_is_and_comes_back_from_a_file(
    kind: Kind, value: object
) -> None:
    if refused(kind, value):
        return
    kept = kind.take(kind.from_plain(value, ()), ())
    assert kind.take(kept, ()) == kept
    if kept is not None or not isinstance(kind, OrNone) or not kind.absent:
        assert kind.take(kind.from_plain(kind.to_plain(kept), ()), ()) == kept


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        (Range(0.0, 4.0), "a number from 0 to 4"),
        (Range(above=0.0, high=360.0), "a number above 0 and at most 360"),
        (Range(above=0.0), "a number above 0"),
        (Range(1, 1000, whole=True), "a whole number from 1 to 1000"),
        (FINITE, "a finite number"),
        (COORDINATE, "a number from -1e9 to 1e9"),
        (Choice(Metal), '"tin", "gold"'),
        (OrNone(SHARE), "null or a number from 0 to 1"),
        (OrNone(SHARE, "all"), '"all" or a number from 0 to 1'),
        (Several(SHARE, "shares", 3), "a list of at most 3 shares"),
        (Several(SHARE, "shares", 3, 1), "a list of 1 to 3 shares"),
        (Several(SHARE, "shares", 3, 3), "a list of 3 shares"),
        (Text(most=5), "a text of at most 5 characters"),
    ],
)
def test_what_is_allowed_is_said(kind: Kind, words: str) -> None:
    assert kind.words == words


def test_numbers_of_numpy_are_numbers_and_become_plain_ones() -> None:
    assert type(Range(0, 5).take(np.float32(2.5), ())) is float
    assert type(Range(0, 5, whole=True).take(np.int16(3), ())) is int
    assert type(Flag().take(np.bool_(True), ())) is bool
    taken = Several(FINITE, "numbers", 3).take(np.arange(3.0), ())
    assert taken == (0.0, 1.0, 2.0)


@pytest.mark.parametrize("value", [float("nan"), float("inf"), 10**400])
def test_no_range_takes_what_is_not_finite(value: float) -> None:
    for kind in KINDS:
        assert refused(kind, value)


def test_half_a_character_is_no_text() -> None:
    with pytest.raises(RefusalError, match="name holds half a character"):
        Text().take("\ud800", ("name",))


def test_a_list_says_which_of_its_items_is_wrong() -> None:
    with pytest.raises(
        RefusalError, match=r"^all\[1\]\[0\] is 2; allowed is a number from 0 to 1$"
    ):
        Several(Several(SHARE, "shares", 2), "lists", 2).take([[1], [2]], ("all",))
