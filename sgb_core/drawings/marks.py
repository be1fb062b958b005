"""The parts of drawings: dimension lines with arrows, leaders, hatching, scale bars."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, cos, floor, hypot, radians, sin

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.drawings import fonts
from sgb_core.drawings.page import Anchor, Area, Layer, Mark, Path, Stroke, Words

Point = tuple[float, float]
# Arrows of ISO 129: closed, filled, an angle of 15° and a length of some line widths.
ARROW = 2.5
_ARROW_HALF = ARROW * 0.1317
# How far extension lines are from the shape, and go beyond the line.
GAP, BEYOND = 1.0, 1.5
# Of their height: how far words stand above their line, clear of its arrows.
_ABOVE = 0.4
# The height of the words of a scale bar.
BAR_WORDS = 2.5
_MOST_LINES = 4000


def line(layer: Layer, *points: Point) -> Stroke:
    """Return straight lines from point to point."""
    return Stroke.of(layer, Path.through(points))


def rectangle(layer: Layer, left: float, low: float, right: float, high: float) -> Stroke:
    """Return the outline of a rectangle."""
    corners = ((left, low), (right, low), (right, high), (left, high))
    return Stroke.of(layer, Path.through(corners, closed=True))


def arrow(tip: Point, direction: Point) -> Area:
    """Return an arrowhead at ``tip`` that points along a unit vector."""
    x, y = direction
    back = (tip[0] - ARROW * x, tip[1] - ARROW * y)
    left = (back[0] - _ARROW_HALF * y, back[1] + _ARROW_HALF * x)
    right = (back[0] + _ARROW_HALF * y, back[1] - _ARROW_HALF * x)
    return Area(Layer.DIMENSIONS, (Path.through((tip, left, right), closed=True),))


def level_dimension(
    left: Point, right: Point, level: float, words: str, height: float, clear: float = 0.0
) -> list[Mark]:
    """Return a level dimension line at the height ``level`` between two places of the shape.

    Words that stand beyond its end stand ``clear`` of it, beyond what else is measured there.
    """
    (x0, y0), (x1, y1) = left, right
    sign = 1.0 if level >= max(y0, y1) else -1.0
    marks: list[Mark] = [
        line(Layer.DIMENSIONS, (x, y + sign * GAP), (x, level + sign * BEYOND))
        for x, y in (left, right)
        if abs(level - y) > GAP
    ]
    marks += _measured((x0, level), (x1, level), words, height, clear)
    return marks


def upright_dimension(
    low: Point, high: Point, place: float, words: str, height: float
) -> list[Mark]:
    """Return an upright dimension line at the abscissa ``place`` between two places."""
    marks: list[Mark] = []
    for x, y in (low, high):
        sign = 1.0 if place >= x else -1.0
        if abs(place - x) > GAP:
            marks.append(line(Layer.DIMENSIONS, (x + sign * GAP, y), (place + sign * BEYOND, y)))
    marks += _measured((place, low[1]), (place, high[1]), words, height)
    return marks


def _measured(
    first: Point, last: Point, words: str, height: float, clear: float = 0.0
) -> list[Mark]:
    """Return a dimension line to the right or upwards, with arrows, and words above or left of it.

    Where there is no room between the arrows they come from outside, and the words stand beyond
    the end.
    """
    length = hypot(last[0] - first[0], last[1] - first[1])
    ahead = ((last[0] - first[0]) / length, (last[1] - first[1]) / length)
    behind = (-ahead[0], -ahead[1])
    turn = 90.0 if abs(ahead[1]) > 0.5 else 0.0
    room = fonts.width(words, height)
    inside, fits = _fits(length, room)
    start, end = first, last
    if not inside:
        start = (first[0] - 2.0 * ARROW * ahead[0], first[1] - 2.0 * ARROW * ahead[1])
    beyond = reach_beyond(length, words, height, clear)
    end = (last[0] + beyond * ahead[0], last[1] + beyond * ahead[1])
    along = 0.5 * length if fits else length + beyond - BEYOND - 0.5 * room
    # To the left of the travel is above a level line and left of an upright one.
    aside = (-ahead[1] * _ABOVE * height, ahead[0] * _ABOVE * height)
    at = (first[0] + along * ahead[0] + aside[0], first[1] + along * ahead[1] + aside[1])
    return [
        line(Layer.DIMENSIONS, start, end),
        arrow(first, behind if inside else ahead),
        arrow(last, ahead if inside else behind),
        Words(words, at, height, Anchor.MIDDLE, turn, Layer.DIMENSIONS),
    ]


def _fits(length: float, room: float) -> tuple[bool, bool]:
    """Return whether arrows, and whether words, have room on a dimension line of a length."""
    return length > 2.0 * ARROW + 1.0, room + 1.5 < length


def reach_beyond(length: float, words: str, height: float, clear: float = 0.0) -> float:
    """Return how far a dimension line of a length goes beyond its end for its words."""
    room = fonts.width(words, height)
    inside, fits = _fits(length, room)
    outer = 0.0 if inside else 2.0 * ARROW
    return outer if fits else max(outer, clear) + room + 2.0 * BEYOND


def hatch(paths: Sequence[Path], spacing: float, angle_deg: float = 45.0) -> Stroke | None:
    """Return lines that fill closed paths (even-odd), ``spacing`` apart; None where none fits."""
    c, s = cos(radians(angle_deg)), sin(radians(angle_deg))
    turn = np.array([[c, -s], [s, c]])
    loops = [path.flat() @ turn for path in paths]
    low = min(float(loop[:, 1].min()) for loop in loops)
    high = max(float(loop[:, 1].max()) for loop in loops)
    spacing = max(spacing, (high - low) / _MOST_LINES)
    lines: list[Path] = []
    for number in range(ceil(low / spacing), floor(high / spacing) + 1):
        level = number * spacing
        cuts = np.sort(np.concatenate([_cuts(loop, level) for loop in loops]))
        for start, end in zip(cuts[::2].tolist(), cuts[1::2].tolist(), strict=False):
            if end - start > 0.05:
                ends = np.array([(start, level), (end, level)]) @ turn.T
                lines.append(Path.through([tuple(end) for end in ends.tolist()]))
    return Stroke.of(Layer.HATCH, *lines) if lines else None


def _cuts(loop: Floats, level: float) -> Floats:
    """Return where a closed polyline crosses a height."""
    first, last = loop, np.roll(loop, -1, axis=0)
    crossing = (first[:, 1] <= level) != (last[:, 1] <= level)
    a, b = first[crossing], last[crossing]
    return np.asarray(a[:, 0] + (level - a[:, 1]) * (b[:, 0] - a[:, 0]) / (b[:, 1] - a[:, 1]))


def scale_bar(at: Point, length: float, fields: int, factor: float, end: str) -> list[Mark]:
    """Return a bar of so many fields, every other one black, with 0 and the length in words.

    ``at`` is its lower left corner, ``length`` (mm) what it stands for, ``factor`` the scale.
    """
    x, y = at
    step, high = length * factor / fields, 1.8
    marks: list[Mark] = [rectangle(Layer.SCALE, x, y, x + step * fields, y + high)]
    for number in range(fields):
        left, right = x + step * number, x + step * (number + 1)
        if number % 2 == 0:
            corners = ((left, y), (right, y), (right, y + high), (left, y + high))
            marks.append(Area(Layer.SCALE, (Path.through(corners, closed=True),)))
    for place, words in ((x, "0"), (x + step * fields, end)):
        marks.append(
            Words(words, (place, y + high + 1.0), BAR_WORDS, Anchor.MIDDLE, 0.0, Layer.SCALE)
        )
    return marks
