"""Strict JSON in, readable JSON out: the text layer under the project file.

Reading takes any bytes and either gives a tree that is safe to walk and to write again or
raises FileError with one line. The standard library's parser is used because it alone lets
repeated keys and NaN literals be seen and tells line and column.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from json.encoder import encode_basestring
from math import isfinite

from sgb_core.document.errors import FileError
from sgb_core.findings.files import (
    GivenTwice,
    HalfCharacterName,
    NotFinite,
    NotJson,
    NotReopened,
    NotText,
    TooDeep,
    TooManyBytes,
    TooManyValues,
)
from sgb_core.findings.finding import Path
from sgb_core.findings.refusal import HalfCharacter, shown

# What bounds the time and memory that reading any file may take: some 2 s and 350 MB.
MAX_BYTES = 32 * 1024 * 1024
MAX_VALUES = 500_000
MAX_DEPTH = 64
# A line of output is broken only where it would grow longer than this.
WIDTH = 100


class _Repeated(dict[str, object]):
    """An object of the file that names ``key`` twice; told apart to report its place."""

    def __init__(self, pairs: list[tuple[str, object]], key: str) -> None:
        super().__init__(pairs)
        self.key = key


def _object(pairs: list[tuple[str, object]]) -> dict[str, object]:
    found = dict(pairs)
    if len(found) == len(pairs):
        return found
    seen: set[str] = set()
    for key, _ in pairs:
        if key in seen:
            return _Repeated(pairs, key)
        seen.add(key)
    return found


def parse(data: bytes, *, bounded: bool = True) -> object:
    """Return the JSON value in ``data`` as plain Python values.

    Raises FileError on anything but strict UTF-8 JSON: NaN and infinity, numbers beyond double
    precision, repeated keys, nesting beyond MAX_DEPTH, more than MAX_BYTES or MAX_VALUES; of the
    last two not where the bytes are known to be the program's own, ``bounded`` off.
    """
    if bounded:
        check_size(data)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise FileError(NotText(error.start)) from None
    try:
        tree: object = json.loads(text, object_pairs_hook=_object, parse_int=_integer)
    except json.JSONDecodeError as error:
        raise FileError(NotJson(error.lineno, error.colno, error.msg)) from None
    except RecursionError:
        raise FileError(TooDeep(MAX_DEPTH)) from None
    _check(tree)
    return tree


def check_size(data: bytes) -> None:
    """Raise FileError for more bytes or values than are read."""
    if len(data) > MAX_BYTES:
        raise FileError(TooManyBytes(MAX_BYTES))
    if data.count(b",") + data.count(b"[") + data.count(b"{") > MAX_VALUES:
        raise FileError(TooManyValues(MAX_VALUES))


def _integer(digits: str) -> int | float:
    # Beyond this a double overflows too; longer ones may not even be converted.
    return int(digits) if len(digits) <= 309 else float(digits)


def _check(tree: object) -> None:
    """Refuse what plain JSON parsing lets through. Not recursive: depth is what it measures."""
    if not isinstance(tree, (dict, list)):
        _check_leaf(tree, ())
        return
    waiting: list[tuple[Iterator[tuple[str | int, object]], Path]] = [(_parts(tree, ()), ())]
    while waiting:
        parts, parent = waiting[-1]
        for key, value in parts:
            if isinstance(value, (dict, list)):
                path = (*parent, key)
                if len(waiting) >= MAX_DEPTH:
                    raise FileError(TooDeep(MAX_DEPTH, path))
                waiting.append((_parts(value, path), path))
                break
            if isinstance(value, (float, str)):
                _check_leaf(value, (*parent, key))
        else:
            waiting.pop()


def _check_leaf(value: object, path: Path) -> None:
    if isinstance(value, float) and not isfinite(value):
        raise FileError(NotFinite(path, shown(value)))
    if isinstance(value, str) and not _is_text(value):
        raise FileError(HalfCharacter(path))


def _parts(
    value: dict[str, object] | list[object], path: Path
) -> Iterator[tuple[str | int, object]]:
    if isinstance(value, list):
        return enumerate(value)
    if isinstance(value, _Repeated):
        raise FileError(GivenTwice((*path, value.key)))
    for key in value:
        if not _is_text(key):
            raise FileError(HalfCharacterName((*path, key)))
    return iter(value.items())


def _is_text(value: str) -> bool:
    if value.isascii():
        return True
    try:
        value.encode()
    except UnicodeEncodeError:
        return False
    return True


def dump(tree: object) -> bytes:
    """Return a tree as readable UTF-8 JSON that parses back to the same values.

    What fits into a line stays on one; integral floats are written as integers. Raises
    ValueError where a number is not finite, TypeError on what JSON has no word for, FileError
    where :func:`parse` would refuse what is too large or nested too deep.
    """
    data = (_text(tree, 0) + "\n").encode()
    try:
        check_size(data)
    except FileError as error:
        raise FileError(NotReopened(error.finding)) from None
    return data


def _text(value: object, indent: int) -> str:
    # Asking for the exact type takes least time, and nearly all have one of these.
    kind = type(value)
    if kind is float:
        return _number(value)  # type: ignore[arg-type]
    if kind is str:
        return encode_basestring(value)  # type: ignore[arg-type]
    if kind is dict or isinstance(value, Mapping):
        _check_depth(indent)
        inner = [
            f"{encode_basestring(k)}: {_text(v, indent + 2)}"
            for k, v in value.items()  # type: ignore[attr-defined]
        ]
        return _bracketed("{", inner, "}", indent)
    if kind is list or (isinstance(value, Sequence) and not isinstance(value, str)):
        _check_depth(indent)
        inner = [_text(v, indent + 2) for v in value]  # type: ignore[attr-defined]
        return _bracketed("[", inner, "]", indent)
    if isinstance(value, float) and not isinstance(value, bool):
        return _number(value)
    return json.dumps(value, ensure_ascii=False)


def _check_depth(indent: int) -> None:
    if indent >= 2 * MAX_DEPTH:
        raise FileError(NotReopened(TooDeep(MAX_DEPTH)))


def _bracketed(opening: str, inner: list[str], closing: str, indent: int) -> str:
    line = f"{opening}{', '.join(inner)}{closing}"
    if indent > 0 and len(line) <= WIDTH - indent and "\n" not in line:
        return line
    if not inner:
        return opening + closing
    margin = "\n" + " " * (indent + 2)
    return f"{opening}{margin}{f',{margin}'.join(inner)}\n{' ' * indent}{closing}"


def _number(value: float) -> str:
    if not isfinite(value):
        raise ValueError(f"JSON has no number {value!r}")
    # Integers up to 2^53 are exact both ways; -0.0 is not the integer 0.
    if value.is_integer() and abs(value) < 2.0**53 and str(value)[0:2] != "-0":
        return str(int(value))
    return repr(float(value))
