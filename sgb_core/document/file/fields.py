"""Read typed values out of a parsed JSON tree, each with its place for the error message."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from math import inf
from types import MappingProxyType
from typing import NoReturn, TypeVar

from sgb_core.curves.segment import NO_EXTRA
from sgb_core.document.errors import FileError
from sgb_core.document.file.json_text import child_path, shown

Choice = TypeVar("Choice", bound=StrEnum)


class _Missing:
    """Stands for a key that the file does not have."""


MISSING = _Missing()


@dataclass(frozen=True, slots=True)
class Node:
    """One value of the file and its path, such as ``profile.segments[2].omega``."""

    value: object
    path: str

    @property
    def is_given(self) -> bool:
        """Whether the file has this value; one that it lacks takes its default."""
        return self.value is not MISSING

    def fail(self, allowed: str) -> NoReturn:
        """Raise FileError: what is there, where, and what is allowed."""
        place = self.path or "the file"
        if not self.is_given:
            raise FileError(f"{place} is missing; allowed is {allowed}")
        raise FileError(f"{place} is {shown(self.value)}; allowed is {allowed}")

    def object(self, allowed: str = "an object {...}") -> Fields:
        """Return an object's fields; a missing one counts as empty."""
        if not self.is_given:
            return Fields({}, self.path)
        if not isinstance(self.value, dict):
            self.fail(allowed)
        return Fields(self.value, self.path)

    def array(self, allowed: str, least: int = 0, most: float = inf) -> list[Node]:
        """Return a list's items, ``least`` to ``most`` of them."""
        if not isinstance(self.value, list) or not least <= len(self.value) <= most:
            self.fail(allowed)
        return [Node(item, f"{self.path}[{k}]") for k, item in enumerate(self.value)]

    def number(
        self, allowed: str, low: float = -inf, high: float = inf, above: float = -inf
    ) -> float:
        """Return a finite number with low ≤ number ≤ high and number > above.

        true and false are no numbers.
        """
        value = self.value
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            self.fail(allowed)
        # Integers compare exactly with floats, so a huge one fails here and never overflows.
        if not (-MAX_DOUBLE <= value <= MAX_DOUBLE and low <= value <= high and value > above):
            self.fail(allowed)
        return float(value)

    def integer(self, allowed: str, low: int, high: int) -> int:
        """Return an integer with low ≤ integer ≤ high; 3.0 is one, as JSON Schema has it."""
        value = self.number(allowed, low, high)
        if not value.is_integer():
            self.fail(allowed)
        return int(value)

    def boolean(self, default: bool) -> bool:
        """Return true or false."""
        if not self.is_given:
            return default
        if not isinstance(self.value, bool):
            self.fail("true or false")
        return self.value

    def text(self, default: str) -> str:
        """Return a string."""
        if not self.is_given:
            return default
        if not isinstance(self.value, str):
            self.fail("a string")
        return self.value

    def choice(self, choices: type[Choice], default: Choice | None = None) -> Choice:
        """Return one of the named choices; without a default it must be given."""
        if not self.is_given and default is not None:
            return default
        if not isinstance(self.value, str) or self.value not in list(choices):
            self.fail(", ".join(f'"{choice}"' for choice in choices))
        return choices(self.value)


MAX_DOUBLE = 1.7976931348623157e308


class Fields:
    """An object of the file: known keys are asked for by name, the rest is kept."""

    def __init__(self, values: dict[str, object], path: str) -> None:
        """Wrap a parsed object that stands at ``path``."""
        self._values = values
        self._path = path
        self._known: set[str] = set()

    def __getitem__(self, key: str) -> Node:
        """Return the value of a key, given or not."""
        self._known.add(key)
        return Node(self._values.get(key, MISSING), child_path(self._path, key))

    def rest(self) -> Mapping[str, object]:
        """Return the keys never asked for, to be kept through load and save."""
        unknown = {k: v for k, v in self._values.items() if k not in self._known}
        return MappingProxyType(unknown) if unknown else NO_EXTRA
