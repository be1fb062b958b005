"""Values made late are those of the standard decorator."""

from __future__ import annotations

import copy
import dataclasses
import inspect
import pickle
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core import values

Made = Callable[..., Any]
OPTIONS = [{}, {"eq": False}]


def plain() -> type:
    class Plain:
        """Fields of every kind."""

        first: int
        second: tuple[int, ...] = (1, 2)
        third: list[int] = dataclasses.field(default_factory=list, hash=False)
        fourth: str = dataclasses.field(default="quiet", repr=False, compare=False)
        fifth: float = dataclasses.field(default=0.5, kw_only=True)
        sixth: int = dataclasses.field(init=False, repr=False, compare=False)
        seventh: list[int] = dataclasses.field(init=False, default_factory=list, hash=False)

        def __post_init__(self) -> None:
            object.__setattr__(self, "sixth", 2 * self.first)

    return Plain


def both(make: Callable[[], type], **options: bool) -> tuple[Made, Made]:
    """Return the class as it is made here, and as the standard library makes it."""
    ways = (values.dataclass, dataclasses.dataclass)
    ours, standard = (way(frozen=True, slots=True, **options)(make()) for way in ways)
    return ours, standard


def outcome(action: Callable[[], object]) -> object:
    """Return what an action gives, or of what kind its error is."""
    try:
        return action()
    except (TypeError, AttributeError) as error:
        return type(error)


ARGUMENTS = st.lists(st.integers(0, 2), max_size=4)
NAMED = st.dictionaries(
    st.sampled_from(["first", "second", "third", "fourth", "fifth", "sixth", "other"]),
    st.integers(0, 2),
    max_size=4,
)


@pytest.mark.parametrize("options", OPTIONS)
@given(first=ARGUMENTS, named=NAMED, second=ARGUMENTS)
def test_a_value_is_made_shown_compared_and_hashed_as_the_standard_one(
    options, first, named, second
):
    found = []
    for cls in both(plain, **options):
        one = outcome(lambda cls=cls: cls(*first, **named))
        other = outcome(lambda cls=cls: cls(*second))
        if isinstance(one, type):
            found.append(one)
            continue
        hashed = hash(one) if options == {} else hash(one) == object.__hash__(one)
        parts = [getattr(one, each.name) for each in dataclasses.fields(cls)]
        found.append((repr(one), parts, hashed, one == other, one != 1, dataclasses.asdict(one)))
    assert found[0] == found[1]


def test_what_is_asked_of_the_class_is_the_same():
    ours, standard = both(plain)
    assert str(inspect.signature(ours)) == str(inspect.signature(standard))
    assert ours.__slots__ == standard.__slots__
    assert ours.__match_args__ == standard.__match_args__
    assert dataclasses.replace(ours(1), first=3) == ours(3)
    assert ours.__init__.__qualname__ == standard.__init__.__qualname__


def test_a_value_never_changes():
    ours, _ = both(plain)
    value = ours(1)
    for name in ("first", "sixth", "other"):
        with pytest.raises(dataclasses.FrozenInstanceError, match=name):
            setattr(value, name, 2)
        with pytest.raises(dataclasses.FrozenInstanceError, match=name):
            delattr(value, name)


@values.dataclass(frozen=True, slots=True)
class Base:
    """A value others build upon; a module's, so that it can be pickled."""

    first: int


@values.dataclass(frozen=True, slots=True)
class Below(Base):
    """One more field."""

    second: object = None

    def __repr__(self) -> str:
        return "below"

    def __hash__(self) -> int:
        return 7


@values.dataclass(frozen=True, slots=True)
class Same(Base):
    first: int = 4


def test_heirs_have_their_own_methods_and_what_they_say_themselves_counts():
    below = Below(1, (2,))
    assert (below.first, below.second, repr(below), hash(below)) == (1, (2,), "below", 7)
    assert below != Base(1)
    assert Base(1) != below
    assert (Same().first, repr(Same()), Same.__doc__) == (4, "Same(first=4)", "Same")
    assert not hasattr(below, "__dict__")


@pytest.mark.parametrize(
    "again", [copy.copy, copy.deepcopy, lambda v: pickle.loads(pickle.dumps(v))]
)
def test_a_value_is_copied_and_pickled(again):
    value = Below(1, (2, [3]))
    assert again(value) == value
    assert type(again(value)) is Below


def test_a_value_that_holds_itself_can_be_shown():
    around: list[object] = []
    value = Base(around)  # type: ignore[arg-type]
    around.append(value)
    assert repr(value) == "Base(first=[...])"


def test_what_is_not_frozen_is_the_standard_one():
    @values.dataclass(slots=True)
    class Open:
        """May change."""

        first: int

    value = Open(1)
    value.first = 2
    assert value == Open(2)
    assert "<locals>" in repr(value)


def test_methods_are_compiled_once_and_not_before_they_are_needed(monkeypatch):
    compiled = []

    def counted(text: str, names: dict[str, object]) -> None:
        compiled.append(text)
        exec(text, names)

    monkeypatch.setattr(values, "exec", counted, raising=False)
    ours = values.dataclass(frozen=True, slots=True)(plain())
    assert compiled == []
    assert ours(1) == ours(1)
    assert len(compiled) == 1
