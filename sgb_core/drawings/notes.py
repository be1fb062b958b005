"""Words in a column beside a drawing, each with a line that leads to its place."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, hypot, pi, sin

from sgb_core.drawings import marks
from sgb_core.drawings.dimensioning import Note
from sgb_core.drawings.page import Anchor, Area, Layer, Mark, Path, Words

# Of the words' height: from line to line; how long the level part of a leader is, in mm.
_PITCH, _LEVEL = 1.9, 3.0
_DOT = 0.45


def column_places(
    notes: Sequence[Note], base: float, factor: float, text: float, limits: tuple[float, float]
) -> tuple[list[tuple[Note, float]], int]:
    """Return the notes with the heights at which their words stand, and how many are left out.

    They stand as near to the heights of their places as they can without overlapping; where there
    is no room for all, every so many are kept.
    """
    ordered = sorted(notes, key=lambda note: note.at[1])
    pitch = _PITCH * text
    most = max(1, int((limits[1] - limits[0]) / pitch) + 1)
    kept = ordered
    if len(ordered) > most:
        kept = [ordered[round(k * (len(ordered) - 1) / max(1, most - 1))] for k in range(most)]
    levels: list[float] = []
    for note in kept:
        level = max(base + note.at[1] * factor, limits[0])
        levels.append(max(level, levels[-1] + pitch) if levels else level)
    ceiling = limits[1]
    for number in reversed(range(len(levels))):
        levels[number] = min(levels[number], ceiling)
        ceiling = levels[number] - pitch
    return list(zip(kept, levels, strict=True)), len(ordered) - len(kept)


def note_marks(
    note: Note,
    origin: tuple[float, float],
    factor: float,
    mirror: float,
    column: float,
    level: float,
    text: float,
) -> list[Mark]:
    """Return the words of a note at the height ``level``, its leader and what it measures."""

    def placed(point: tuple[float, float]) -> marks.Point:
        return origin[0] + mirror * point[0] * factor, origin[1] + point[1] * factor

    tip = placed(note.at)
    edge = origin[0] + mirror * column
    knee, end = (edge - mirror * (_LEVEL + 1.0), level), (edge - mirror, level)
    made: list[Mark] = [marks.line(Layer.DIMENSIONS, tip, knee, end)]
    if note.along is not None:
        made += _measured_line(placed(note.along[0]), placed(note.along[1]))
    elif note.inside:
        made.append(_dot(tip))
    else:
        length = hypot(knee[0] - tip[0], knee[1] - tip[1])
        made.append(marks.arrow(tip, ((tip[0] - knee[0]) / length, (tip[1] - knee[1]) / length)))
    anchor = Anchor.START if mirror > 0.0 else Anchor.END
    at = (edge, level - 0.5 * text)
    made.append(Words(note.words, at, text, anchor, layer=Layer.DIMENSIONS))
    return made


def _measured_line(first: marks.Point, last: marks.Point) -> list[Mark]:
    length = hypot(last[0] - first[0], last[1] - first[1])
    made: list[Mark] = [marks.line(Layer.DIMENSIONS, first, last)]
    if length > 2.0 * marks.ARROW:
        ahead = ((last[0] - first[0]) / length, (last[1] - first[1]) / length)
        made += [marks.arrow(first, (-ahead[0], -ahead[1])), marks.arrow(last, ahead)]
    return made


def _dot(at: marks.Point) -> Area:
    corners = [
        (at[0] + _DOT * cos(k * pi / 8.0), at[1] + _DOT * sin(k * pi / 8.0)) for k in range(16)
    ]
    return Area(Layer.DIMENSIONS, (Path.through(corners, closed=True),))
