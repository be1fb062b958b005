"""Frozen dataclasses whose fields say what they may be: the table behind a section of a file.

A field is declared with ``metadata=says(kind, ...)`` and its class with a ``RECORD``; from them
come the checks of the constructor, the section read and written, its JSON Schema, and the words
of the controls in a panel.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator, Mapping
from dataclasses import field, replace
from operator import attrgetter
from types import MappingProxyType
from typing import Any

from sgb_core.fields.extra import NO_EXTRA, Extra, take_extra
from sgb_core.fields.kinds import Kind, Range, Said, Schema
from sgb_core.fields.lists import OrNone, Several
from sgb_core.findings.finding import Path
from sgb_core.findings.refusal import MISSING, Refusal, RefusalError, moved
from sgb_core.values import dataclass

_NO_WORDS: Mapping[Any, str] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Record:
    """What a class says of itself: where its values stand, and what they are.

    ``place`` is the path of a value that stands alone, such as ``solid``. Where ``brief``, a file
    leaves out fields that have their defaults; it writes the keys ``first`` before the others,
    and no unknown key is one of those ``reserved``. ``rules`` adds to the schema what lies
    between fields.
    """

    place: str
    about: str = ""
    brief: bool = False
    first: tuple[str, ...] = ()
    reserved: tuple[str, ...] = ()
    rules: Callable[[], Schema] = dict


@dataclass(frozen=True, slots=True)
class Row:
    """What is said of one field.

    ``key`` is its name in the file, ``label`` and ``tip`` that of its control and what it tells;
    ``titles`` and ``tips`` are those of its choices. A slider reaches to the part ``reach`` of
    the object's size. A ``brief`` field is written only where it differs from its default.
    """

    kind: Kind
    key: str = ""
    label: str = ""
    tip: str = ""
    titles: Mapping[Any, str] = field(default_factory=lambda: _NO_WORDS)
    tips: Mapping[Any, str] = field(default_factory=lambda: _NO_WORDS)
    reach: float = 0.0
    brief: bool = False
    name: str = ""
    default: object = MISSING


def says(kind: Kind, **words: Any) -> Mapping[str, Row]:
    """Return the metadata of a dataclass field of this kind; ``words`` are those of Row."""
    return {"row": Row(kind, **words)}


class Codec:
    """How the values of a class stand in a file."""

    def from_plain(self, plain: object, path: Path) -> Any:
        """Return the value of a section that stands at ``path``; raises RefusalError."""
        raise NotImplementedError

    def to_plain(self, value: Any) -> dict[str, object]:
        """Return the section of a value."""
        raise NotImplementedError

    def schema(self, shared: Schema) -> Schema:
        """Return the JSON Schema of the section."""
        raise NotImplementedError


class Table(Codec):
    """The rows of a class, and the codec that they make."""

    def __init__(self, cls: type) -> None:
        """Read the fields of a dataclass with a ``RECORD``."""
        self.cls = cls
        self.record: Record = getattr(cls, "RECORD")  # noqa: B009
        self.place: Path = (self.record.place,) if self.record.place else ()
        self.rows = tuple(
            _completed(each, self.record) for each in dataclasses.fields(cls) if each.metadata
        )
        self.written = tuple(sorted(self.rows, key=lambda row: row.key not in self.record.first))
        self.has_extra = "extra" in cls.__dataclass_fields__  # type: ignore[attr-defined]
        self.keys: frozenset[str] = frozenset((*self._keys(), *self.record.reserved))
        self.values_of = _getter([row.name for row in self.rows])
        self.checks = tuple(
            (row.name, row.default, row.kind.exact, row.kind.take, (*self.place, row.key))
            for row in self.rows
        )

    def _keys(self) -> Iterator[str]:
        for row in self.rows:
            if isinstance(row.kind, Flat):
                yield from table_of(row.kind.cls).keys
            else:
                yield row.key

    @property
    def lengths(self) -> tuple[Row, ...]:
        """The rows of lengths, which grow with the object."""
        return tuple(row for row in self.rows if isinstance(row.kind, Range) and row.kind.length)

    def row(self, name: str) -> Row:
        """Return the row of a field by its name."""
        return next(row for row in self.rows if row.name == name)

    def from_plain(self, plain: object, path: Path) -> Any:
        if not isinstance(plain, Mapping):
            raise RefusalError(Refusal(path, plain, self._object()))
        rest = {key: value for key, value in plain.items() if key not in self.keys}
        return self.made(plain, path, extra=Extra(rest) if rest else NO_EXTRA)

    def _object(self) -> Said:
        required = [f'"{row.key}": ...' for row in self.rows if row.default is MISSING]
        return Said(f"an object {{{', '.join(required) or '...'}}}")

    def made(self, plain: Mapping[str, object], path: Path, **more: object) -> Any:
        """Return the value of the keys of the table, and ``more`` fields as they are kept."""
        values = dict(more) if self.has_extra else {}
        for row in self.rows:
            if isinstance(row.kind, Flat):
                values[row.name] = table_of(row.kind.cls).made(plain, path)
            elif row.key in plain:
                values[row.name] = row.kind.from_plain(plain[row.key], (*path, row.key))
            elif row.default is MISSING:
                raise RefusalError(Refusal((*path, row.key), MISSING, row.kind))
        return self.construct(values, plain, path)

    def construct(self, values: dict[str, Any], plain: Mapping[str, object], path: Path) -> Any:
        """Return the value of these fields, refused where they stand in the file."""
        try:
            return self.cls(**values)
        except RefusalError as error:
            found = moved(error.finding, path, len(self.place))
            written = _is_written(plain, found.path[len(path) :])
            raise RefusalError(found if written else found.unwritten()) from None

    def to_plain(self, value: Any) -> dict[str, object]:
        tree: dict[str, object] = {}
        for row in self.written:
            tree.update(self.part(value, row))
        return {**tree, **value.extra} if self.has_extra else tree

    def part(self, value: Any, row: Row) -> dict[str, object]:
        """Return what one field puts into the section of a value."""
        own = getattr(value, row.name)
        if isinstance(row.kind, Flat):
            return table_of(row.kind.cls).to_plain(own)
        return {} if row.brief and own == row.default else {row.key: row.kind.to_plain(own)}

    def schema(self, shared: Schema) -> Schema:
        about = {"description": self.record.about} if self.record.about else {}
        required = [row.key for row in self.rows if row.default is MISSING]
        return {
            **about,
            "type": "object",
            **({"required": required} if required else {}),
            "properties": self.properties(shared),
            **self.record.rules(),
        }

    def properties(self, shared: Schema, without: tuple[str, ...] = ()) -> Schema:
        """Return the schema of each key, but for those ``without``."""
        found: Schema = {}
        for row in self.written:
            if row.key in without:
                continue
            if isinstance(row.kind, Flat):
                found.update(table_of(row.kind.cls).properties(shared))
                continue
            found[row.key] = row.kind.schema(shared)
            if row.tip:
                found[row.key]["description"] = row.tip
            absent = isinstance(row.kind, OrNone) and row.kind.absent and row.default is None
            if row.default is not MISSING and not absent and not isinstance(row.kind, Part):
                found[row.key]["default"] = row.kind.to_plain(row.default)
        return found


def _getter(names: list[str]) -> Callable[[Any], tuple[Any, ...]]:
    """Return what gets several fields of a value at once."""
    if len(names) > 1:
        return attrgetter(*names)
    return lambda value: tuple(getattr(value, name) for name in names)


def _completed(each: dataclasses.Field[Any], record: Record) -> Row:
    row: Row = each.metadata["row"]
    default: object = MISSING
    if each.default is not dataclasses.MISSING:
        default = each.default
    elif each.default_factory is not dataclasses.MISSING:
        default = each.default_factory()
    return replace(
        row,
        name=each.name,
        key=row.key or each.name,
        default=default,
        brief=row.brief or record.brief,
    )


def _is_written(plain: object, steps: Path) -> bool:
    """Return whether a file's value has a part there."""
    for step in steps:
        if isinstance(plain, list):
            plain = dict(enumerate(plain))
        if not isinstance(plain, Mapping) or step not in plain:
            return False
        plain = plain[step]
    return True


_tables: dict[type, Table] = {}


def table_of(cls: type) -> Table:
    """Return the table of a class with a ``RECORD``."""
    table = _tables.get(cls)
    if table is None:
        table = _tables[cls] = Table(cls)
    return table


def check(value: Any) -> None:
    """Take the fields of a value that is being made; raises RefusalError for one not allowed.

    For ``__post_init__``: what is kept may differ from what was given, a tuple from a list.
    """
    table = table_of(type(value))
    # What most values are is told fast: a slider makes documents at each tick.
    for given, (name, default, exact, take, path) in zip(
        table.values_of(value), table.checks, strict=True
    ):
        if given is default or type(given) is exact:
            continue
        taken = take(given, path)
        if taken is not given:
            object.__setattr__(value, name, taken)
    if table.has_extra and value.extra is not NO_EXTRA:
        object.__setattr__(value, "extra", take_extra(value.extra, table.keys, table.place))


def labels(cls: type, place: str = "") -> dict[str, str]:
    """Return the names of the controls of all fields, by their paths with numbers left out."""
    found: dict[str, str] = {}
    for row in table_of(cls).rows:
        kind, path = row.kind, place if isinstance(row.kind, Flat) else f"{place}{row.key}"
        if row.label:
            found[path] = row.label
        while isinstance(kind, OrNone | Several):
            if isinstance(kind, Several):
                path += "[]"
                found |= {path: row.label} if row.label else {}
            kind = kind.inner
        if isinstance(kind, Part) and hasattr(kind.cls, "RECORD"):
            found |= labels(kind.cls, path if isinstance(kind, Flat) else f"{path}.")
    return found


_codecs: dict[type, Codec] = {}


def register(cls: type, codec: Codec) -> None:
    """Say how the values of a class stand in a file, where its table cannot."""
    _codecs[cls] = codec


def codec_of(cls: type) -> Codec:
    """Return how the values of a class stand in a file."""
    return _codecs.get(cls) or table_of(cls)


@dataclass(frozen=True, slots=True)
class Part(Kind):
    """A value of a class with a ``RECORD``; an object in the file."""

    cls: type

    @property
    def words(self) -> str:
        return "an object {...}"

    @property
    def exact(self) -> type:
        return self.cls

    def take(self, value: object, path: Path) -> Any:
        if isinstance(value, self.cls):
            return value
        raise RefusalError(Refusal(path, value, Said(f"a {self.cls.__name__}")))

    def from_plain(self, value: object, path: Path) -> Any:
        return codec_of(self.cls).from_plain(value, path)

    def to_plain(self, value: Any) -> object:
        return codec_of(self.cls).to_plain(value)

    def schema(self, shared: Schema) -> Schema:
        record: Record | None = getattr(self.cls, "RECORD", None)
        name = record.place if record else self.cls.__name__.lower()
        if name not in shared:
            shared[name] = {}
            shared[name] = codec_of(self.cls).schema(shared)
        return {"$ref": f"#/$defs/{name}"}


@dataclass(frozen=True, slots=True)
class Flat(Part):
    """A value of a class whose keys stand in the file beside those of the value that has it."""
