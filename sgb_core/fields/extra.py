"""The keys of a project file that this version does not know: kept through load and save."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from math import isfinite

from sgb_core.fields.kinds import Said, check_text
from sgb_core.findings.finding import Path
from sgb_core.findings.refusal import Refusal, RefusalError

_JSON = Said("a plain value: null, true, false, a finite number, a text, a list or an object")
_OWN = Said("a key that the program does not know")


class Extra(Mapping[str, object]):
    """Keys and plain values; frozen, hashable and picklable as a default value must be."""

    __slots__ = ("_values",)

    def __init__(self, values: Mapping[str, object] | None = None) -> None:
        """Keep ``values``, which are known to be what a file can hold."""
        self._values = dict(values or {})

    def __getitem__(self, key: str) -> object:
        return self._values[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __hash__(self) -> int:
        return hash(tuple(self._values))

    def __repr__(self) -> str:
        return f"Extra({self._values!r})"


NO_EXTRA = Extra()


def take_extra(value: object, known: Collection[str], path: Path) -> Extra:
    """Return unknown keys as they are kept.

    Raises RefusalError for ``known`` keys and for values that no file can hold.
    """
    if not isinstance(value, Mapping):
        raise RefusalError(Refusal((*path, "extra"), value, Said("a mapping of keys and values")))
    for key, item in value.items():
        if not isinstance(key, str) or key in known:
            raise RefusalError(Refusal((*path, "extra"), key, _OWN))
        check_text(key, (*path, key))
        if not isinstance(value, Extra):
            _check(item, (*path, key))
    return value if isinstance(value, Extra) else Extra(value)


def _check(value: object, path: Path) -> None:
    if isinstance(value, str):
        check_text(value, path)
    elif isinstance(value, Mapping):
        for key, item in value.items():
            if not isinstance(key, str):
                raise RefusalError(Refusal(path, key, Said("a text as key")))
            check_text(key, (*path, key))
            _check(item, (*path, key))
    elif isinstance(value, list | tuple):
        for place, item in enumerate(value):
            _check(item, (*path, place))
    elif not (value is None or isinstance(value, bool | int) or _is_number(value)):
        raise RefusalError(Refusal(path, value, _JSON))


def _is_number(value: object) -> bool:
    return isinstance(value, float) and isfinite(value)
