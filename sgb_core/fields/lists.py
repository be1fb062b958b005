"""Kinds made of other kinds: a value or none, lists, and lists of fixed length."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeGuard

import numpy as np

from sgb_core.fields.kinds import Kind, Schema
from sgb_core.findings.finding import Path
from sgb_core.findings.refusal import Refusal, RefusalError
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class OrNone(Kind):
    """A value of a kind, or None, which is written as ``null`` or as the word given.

    With ``absent`` it is not written at all, and a file has no word for it.
    """

    inner: Kind
    word: str | None = None
    absent: bool = False

    @property
    def words(self) -> str:
        if self.absent:
            return self.inner.words
        none = "null" if self.word is None else f'"{self.word}"'
        return f"{none} or {self.inner.words}"

    @property
    def brief(self) -> str:
        return self.words

    def take(self, value: object, path: Path) -> Any:
        return None if value is None else self._inside(self.inner.take, value, path)

    def from_plain(self, value: object, path: Path) -> Any:
        if not self.absent and (value is None if self.word is None else value == self.word):
            return None
        if value is None:
            raise self.refusal(value, path)
        return self._inside(self.inner.from_plain, value, path)

    def _inside(self, take: Any, value: object, path: Path) -> Any:
        try:
            return take(value, path)
        except RefusalError as error:
            found = error.finding
            if isinstance(found, Refusal) and found.allowed is self.inner and found.path == path:
                raise self.refusal(value, path) from None
            raise

    def to_plain(self, value: Any) -> object:
        return self.word if value is None else self.inner.to_plain(value)

    def schema(self, shared: Schema) -> Schema:
        inner = self.inner.schema(shared)
        if self.absent:
            return inner
        none = {"type": "null"} if self.word is None else {"const": self.word}
        return {"oneOf": [none, inner]}


@dataclass(frozen=True, slots=True)
class Several(Kind):
    """A list of ``least`` to ``most`` values of a kind, kept as a tuple; ``what`` names them."""

    inner: Kind
    what: str
    most: int
    least: int = 0

    @property
    def words(self) -> str:
        if self.least == self.most:
            return f"a list of {self.most} {self.what}"
        if self.least == 0:
            return f"a list of at most {self.most} {self.what}"
        return f"a list of {self.least} to {self.most} {self.what}"

    def take(self, value: object, path: Path) -> tuple[Any, ...]:
        items = self._items(value, path)
        # What most lists are, told fast.
        if type(value) is tuple and {self.inner.exact}.issuperset(map(type, value)):
            return value
        return _kept(
            value, tuple(self.inner.take(item, (*path, k)) for k, item in enumerate(items))
        )

    def from_plain(self, value: object, path: Path) -> Any:
        items = self._items(value, path)
        return tuple(self.inner.from_plain(item, (*path, k)) for k, item in enumerate(items))

    def _items(self, value: object, path: Path) -> Sequence[Any]:
        if not is_list(value) or not self.least <= len(value) <= self.most:
            raise self.refusal(value, path)
        return value

    def to_plain(self, value: Any) -> object:
        return [self.inner.to_plain(item) for item in value]

    def schema(self, shared: Schema) -> Schema:
        least = {"minItems": self.least} if self.least else {}
        items = self.inner.schema(shared)
        return {"type": "array", **least, "maxItems": self.most, "items": items}


@dataclass(frozen=True, slots=True)
class Fixed(Kind):
    """A list with a kind for each place, kept as a tuple."""

    inner: tuple[Kind, ...]
    said: str

    @property
    def words(self) -> str:
        return self.said

    def take(self, value: object, path: Path) -> tuple[Any, ...]:
        if not is_list(value) or len(value) != len(self.inner):
            raise self.refusal(value, path)
        return _kept(
            value,
            tuple(
                kind.take(item, (*path, k))
                for k, (kind, item) in enumerate(zip(self.inner, value, strict=True))
            ),
        )

    def to_plain(self, value: Any) -> object:
        return [kind.to_plain(item) for kind, item in zip(self.inner, value, strict=True)]

    def schema(self, shared: Schema) -> Schema:
        count = len(self.inner)
        same = all(kind == self.inner[0] for kind in self.inner)
        each = (
            {"items": self.inner[0].schema(shared)}
            if same
            else {"prefixItems": [kind.schema(shared) for kind in self.inner]}
        )
        return {"type": "array", "minItems": count, "maxItems": count, **each}


def is_list(value: object) -> TypeGuard[Sequence[Any]]:
    """Return whether a value counts as a list: a list, a tuple, an array; no text."""
    return isinstance(value, list | tuple | np.ndarray)


def _kept(given: object, taken: tuple[Any, ...]) -> tuple[Any, ...]:
    """Return the very tuple that was given where all its items are kept as they are."""
    if isinstance(given, tuple) and all(map(_is, taken, given)):
        return given
    return taken


def _is(one: object, other: object) -> bool:
    return one is other
