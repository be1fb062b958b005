"""What the value of one field may be: a number in a range, one of some names, a text, ...

Each kind says it in words, takes values as they are kept or refuses them, and knows how they
stand in a file: as the plain values of JSON, and as a JSON Schema.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from enum import StrEnum
from math import inf, isfinite
from typing import Any

import numpy as np

from sgb_core.findings.finding import Path
from sgb_core.findings.refusal import HalfCharacter, Refusal, RefusalError
from sgb_core.values import dataclass

Schema = dict[str, Any]
# No coordinate and no length is larger: a profile of that size still has eight digits below it.
MAX_COORDINATE = 1e9
_MAX_DOUBLE = 1.7976931348623157e308


class Kind:
    """Base of the kinds."""

    __slots__ = ()

    @property
    def words(self) -> str:
        """What is allowed, as a file's reader is told."""
        raise NotImplementedError

    @property
    def brief(self) -> str:
        """What is allowed, as whoever calls a function is told."""
        return self.words

    @property
    def exact(self) -> type | None:
        """The type all of whose values are allowed and kept as they are, where there is one."""
        return None

    def take(self, value: object, path: Path) -> Any:
        """Return a value as it is kept; raises RefusalError where it is not allowed."""
        raise NotImplementedError

    def from_plain(self, value: object, path: Path) -> Any:
        """Return what :meth:`take` is given for a plain value that a file has at ``path``."""
        return value

    def to_plain(self, value: Any) -> object:
        """Return a value as the plain ones that a file holds."""
        return value

    def schema(self, shared: Schema) -> Schema:
        """Return the JSON Schema; what it refers to by name is put into ``shared``."""
        raise NotImplementedError

    def refusal(self, value: object, path: Path) -> RefusalError:
        """Return the error that this value is not allowed there."""
        return RefusalError(Refusal(path, value, self))


@dataclass(frozen=True, slots=True)
class Said(Kind):
    """What is allowed in words alone, for rules between fields."""

    text: str

    @property
    def words(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True)
class Range(Kind):
    """A finite number with low ≤ number ≤ high and number > above, whole or not.

    true and false are no numbers; 3.0 is a whole one. A ``length`` is in the document's unit.
    ``said`` replaces the usual words.
    """

    low: float = -inf
    high: float = inf
    above: float = -inf
    whole: bool = False
    length: bool = False
    said: str = ""

    @property
    def words(self) -> str:
        if self.said:
            return self.said
        number = "a whole number" if self.whole else "a number"
        if self.above > -inf:
            most = f" and at most {_short(self.high)}" if self.high < inf else ""
            return f"{number} above {_short(self.above)}{most}"
        if self.low == -inf:
            return f"{number} of at most {_short(self.high)}" if self.high < inf else _FINITE
        if self.high == inf:
            return f"{number} of at least {_short(self.low)}"
        return f"{number} from {_short(self.low)} to {_short(self.high)}"

    @property
    def brief(self) -> str:
        if self.said or self.above > -inf or not (isfinite(self.low) and isfinite(self.high)):
            return self.words
        return f"{_short(self.low)} to {_short(self.high)}"

    def take(self, value: object, path: Path) -> float:
        number = value.item() if isinstance(value, np.generic) else value
        if type(number) is not float:
            if isinstance(number, bool) or not isinstance(number, int | float):
                raise self.refusal(value, path)
            # Integers compare exactly with floats, so a huge one fails here and never overflows.
            if not -_MAX_DOUBLE <= number <= _MAX_DOUBLE:
                raise FINITE.refusal(value, path)
            number = float(number)
        if not (self.low <= number <= self.high and number > self.above):
            if not isfinite(number):
                raise FINITE.refusal(value, path)
            raise self.refusal(value, path)
        if self.whole:
            if not number.is_integer():
                raise self.refusal(value, path)
            return int(number)
        if not isfinite(number):
            raise FINITE.refusal(value, path)
        return number

    def schema(self, shared: Schema) -> Schema:
        limits = {
            "minimum": self.low,
            "maximum": self.high,
            "exclusiveMinimum": self.above,
        }
        return {
            "type": "integer" if self.whole else "number",
            **{key: limit for key, limit in limits.items() if isfinite(limit)},
        }


def _short(number: float) -> str:
    return f"{number:g}".replace("e+0", "e").replace("e+", "e")


_FINITE = "a finite number"
FINITE = Range()
COORDINATE = Range(-MAX_COORDINATE, MAX_COORDINATE, length=True)
LENGTH = Range(0.0, MAX_COORDINATE, length=True, said="a number of at least 0, at most 1e9")
POSITIVE_LENGTH = Range(
    0.0, MAX_COORDINATE, above=0.0, length=True, said="a positive number, at most 1e9"
)
SHARE = Range(0.0, 1.0)


@dataclass(frozen=True, slots=True)
class Choice(Kind):
    """One of some names: the members of a StrEnum, or the keys of a table that may grow."""

    names: Collection[str] | type[StrEnum]

    @property
    def exact(self) -> type | None:
        return self.names if isinstance(self.names, type) else None

    @property
    def words(self) -> str:
        return ", ".join(f'"{name}"' for name in self.names)

    @property
    def brief(self) -> str:
        return ", ".join(self.names)

    def take(self, value: object, path: Path) -> str:
        if isinstance(self.names, type):
            if isinstance(value, str) and value in self.names.__members__.values():
                return self.names(value)
        elif isinstance(value, str) and value in self.names:
            return str(value)
        raise self.refusal(value, path)

    def to_plain(self, value: Any) -> object:
        return str(value)

    def schema(self, shared: Schema) -> Schema:
        return {"enum": [str(name) for name in self.names]}


@dataclass(frozen=True, slots=True)
class Chosen(Kind):
    """Some of the members of a StrEnum, as a set."""

    names: type[StrEnum]
    what: str

    @property
    def words(self) -> str:
        return f"a list of {self.what}"

    def take(self, value: object, path: Path) -> frozenset[str]:
        if isinstance(value, str | bytes | Mapping) or not isinstance(value, Collection):
            raise self.refusal(value, path)
        one = Choice(self.names)
        return frozenset(one.take(item, (*path, place)) for place, item in enumerate(value))

    def to_plain(self, value: Any) -> object:
        return [str(name) for name in self.names if name in value]

    def schema(self, shared: Schema) -> Schema:
        return {"type": "array", "items": Choice(self.names).schema(shared)}


@dataclass(frozen=True, slots=True)
class Flag(Kind):
    """True or false."""

    @property
    def exact(self) -> type:
        return bool

    @property
    def words(self) -> str:
        return "true or false"

    def take(self, value: object, path: Path) -> bool:
        if isinstance(value, bool | np.bool_):
            return bool(value)
        raise self.refusal(value, path)

    def schema(self, shared: Schema) -> Schema:
        return {"type": "boolean"}


@dataclass(frozen=True, slots=True)
class Text(Kind):
    """A text of ``least`` to ``most`` characters that matches ``pattern`` as a whole."""

    least: int = 0
    most: int | None = None
    pattern: str = ""
    said: str = ""

    @property
    def words(self) -> str:
        if self.said or self.most is None:
            return self.said or "a string"
        if self.least:
            return f"a text of {self.least} to {self.most} characters"
        return f"a text of at most {self.most} characters"

    def take(self, value: object, path: Path) -> str:
        if not isinstance(value, str) or len(value) < self.least:
            raise self.refusal(value, path)
        if self.most is not None and len(value) > self.most:
            raise self.refusal(value, path)
        if self.pattern and not re.fullmatch(self.pattern, value):
            raise self.refusal(value, path)
        check_text(value, path)
        return value

    def schema(self, shared: Schema) -> Schema:
        found: Schema = {"type": "string"}
        if self.least:
            found["minLength"] = self.least
        if self.most is not None:
            found["maxLength"] = self.most
        if self.pattern:
            found["pattern"] = f"^({self.pattern})$"
        return found


IMAGE = Text(
    pattern="[a-z][a-z0-9-]{0,39}|[0-9a-f]{64}",
    said="the name of a texture, or the SHA-256 of a picture in this file",
)
LONGEST_LINE = 60
LINE = Text(
    1,
    LONGEST_LINE,
    pattern="[^\\x00-\\x1f\\x7f]*",
    said=f"a text of 1 to {LONGEST_LINE} characters in one line",
)


def check_text(value: str, path: Path) -> None:
    """Raise RefusalError for half a character, which no file can hold."""
    if not value.isascii():
        try:
            value.encode()
        except UnicodeEncodeError:
            raise RefusalError(HalfCharacter(path)) from None


@dataclass(frozen=True, slots=True)
class Colour(Kind):
    """A colour ``#rrggbb``, kept in small letters."""

    @property
    def words(self) -> str:
        return 'a colour "#rrggbb"'

    def take(self, value: object, path: Path) -> str:
        if not isinstance(value, str) or not re.fullmatch("#[0-9a-fA-F]{6}", value):
            raise self.refusal(value, path)
        return value.lower()

    def schema(self, shared: Schema) -> Schema:
        return {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$"}
