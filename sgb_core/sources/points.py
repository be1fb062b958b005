"""Points as text: CSV of any program, tables pasted from a spreadsheet, a digitiser's file."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.tracing.ordering import ordered
from sgb_core.fields.kinds import MAX_COORDINATE
from sgb_core.findings.sources import NoNumbers, NoSource, TooMuch
from sgb_core.sources.errors import SourceError
from sgb_core.sources.options import Options
from sgb_core.sources.reading import Frame, Half, Reading

_MOST_POINTS = 100_000
_DECIMAL_COMMA = re.compile(r"^[-+]?\d*,\d+(?:[eE][-+]?\d+)?$")
_NUMBER = re.compile(r"^[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$")
# Column names that say which two columns are meant.
_NAMES = (("r", "h"), ("x", "y"), ("radius", "height"))
# A side counts as one where at least this part of the points lies on it.
_SIDE = 0.2


def read_points(table: Floats, options: Options) -> Reading:
    """Return the profile or the two sides that a table of points, shape (N, 2), holds."""
    axis = options.upright_axis()
    place = 0.0 if axis is None else axis
    points = table - np.array([place, 0.0])
    frame = Frame((place, 0.0))
    right, left = points[:, 0] >= 0.0, points[:, 0] < 0.0
    if axis is not None and min(right.mean(), left.mean()) >= _SIDE:
        mirrored = points[left] * np.array([-1.0, 1.0])
        return Reading(_half(points[right]), _half(mirrored), (place,), frame=frame)
    if axis is not None and left.mean() > right.mean():
        return Reading(None, _half(points * np.array([-1.0, 1.0])), (place,), frame=frame)
    return Reading(_half(points), None, (place,), frame=frame)


def parse_points(data: bytes) -> Floats:
    """Return the points of a table, shape (N, 2), in its own order.

    Semicolons, tabs, commas or blanks separate; the decimal mark is a point or a comma; a header
    and lines that begin with # are passed over. Raises SourceError, naming the line at fault.
    """
    rows: list[tuple[float, float]] = []
    columns: tuple[int, int] = (0, 1)
    for number, line in enumerate(_text(data).splitlines(), 1):
        words = _words(line)
        if not words:
            continue
        values = [_value(words[k]) if k < len(words) else None for k in columns]
        if values[0] is not None and values[1] is not None:
            rows.append((values[0], values[1]))
            if len(rows) > _MOST_POINTS:
                raise SourceError(TooMuch("points", _MOST_POINTS))
        elif rows:
            raise SourceError(NoNumbers(number, line.strip()))
        else:
            columns = _named(words) or columns
            if number > 20:
                break
    if not rows:
        raise SourceError(NoSource.NO_COLUMNS)
    points = np.array(rows)
    if not (np.abs(points) <= MAX_COORDINATE).all():
        raise SourceError(NoSource.NOT_FINITE)
    apart = np.append(True, (np.diff(points, axis=0) != 0.0).any(axis=1))
    return np.asarray(points[apart])


def _half(points: Floats) -> Half:
    if len(points) < 2:
        raise SourceError(NoSource.ONE_PLACE)
    points = points[ordered(points)]
    upwards = points[0, 1] <= points[-1, 1]
    return Half(points if upwards else points[::-1])


def _text(data: bytes) -> str:
    encodings: Sequence[str] = ("utf-8-sig", "latin-1")
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        encodings = ("utf-16",)
    for encoding in encodings:
        try:
            return data.decode(encoding)
        except UnicodeDecodeError:
            continue
    raise SourceError(NoSource.NOT_TEXT)


def _words(line: str) -> list[str]:
    """Return the fields of a line; a comma separates where nothing else does."""
    line = line.strip().replace('"', "").replace("\u2212", "-")
    if not line or line.startswith("#"):
        return []
    for mark in (";", "\t"):
        if mark in line:
            return [word.strip() for word in line.split(mark)]
    blanks = line.split()
    if len(blanks) > 1 and all(
        _NUMBER.match(word) or _DECIMAL_COMMA.match(word) for word in blanks
    ):
        return blanks
    return [word.strip() for word in (line.split(",") if "," in line else blanks)]


def _value(word: str) -> float | None:
    if _DECIMAL_COMMA.match(word):
        return float(word.replace(",", "."))
    return float(word) if _NUMBER.match(word) else None


def _named(words: Sequence[str]) -> tuple[int, int] | None:
    names = [word.lower() for word in words]
    for first, second in _NAMES:
        if first in names and second in names:
            return names.index(first), names.index(second)
    return None
