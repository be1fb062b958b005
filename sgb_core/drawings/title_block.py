"""The frame of a sheet and its title block (ISO 5457, ISO 7200): cells with a label and a value."""

from __future__ import annotations

from collections.abc import Sequence

from sgb_core.drawings import fonts
from sgb_core.drawings.marks import line, rectangle
from sgb_core.drawings.page import Layer, Mark, Path, Pen, Stroke, Words
from sgb_core.values import dataclass

# Left (to be bound), right, bottom and top.
MARGINS = (20.0, 10.0, 10.0, 10.0)
WIDTH, ROW = 180.0, 9.0
_LABEL, _VALUE, _INSET = 1.8, 2.5, 1.2
_FRAME_PEN = Pen(0.7)


@dataclass(frozen=True, slots=True)
class Cell:
    """A cell of the title block and the part of the row that it takes."""

    label: str
    value: str
    part: float


def block_height(rows: Sequence[Sequence[Cell]]) -> float:
    """Return how high a title block of so many rows is."""
    return ROW * len(rows)


def frame(size: tuple[float, float]) -> Stroke:
    """Return the frame of a sheet, within which all is drawn."""
    left, right, bottom, top = MARGINS
    corners = (
        (left, bottom),
        (size[0] - right, bottom),
        (size[0] - right, size[1] - top),
        (left, size[1] - top),
    )
    return Stroke.of(Layer.FRAME, Path.through(corners, closed=True), pen=_FRAME_PEN)


def title_block(size: tuple[float, float], rows: Sequence[Sequence[Cell]]) -> list[Mark]:
    """Return the block in the lower right corner of a sheet; values are cut to their cells."""
    right, low = size[0] - MARGINS[1], MARGINS[2]
    left, high = right - WIDTH, low + block_height(rows)
    marks: list[Mark] = [rectangle(Layer.FRAME, left, low, right, high)]
    for number, row in enumerate(rows):
        top = high - ROW * number
        if number:
            marks.append(line(Layer.FRAME, (left, top), (right, top)))
        whole, x = sum(cell.part for cell in row), left
        for place, cell in enumerate(row):
            width = WIDTH * cell.part / whole
            if place:
                marks.append(line(Layer.FRAME, (x, top), (x, top - ROW)))
            room = width - 2.0 * _INSET
            label = fonts.fitted(cell.label, _LABEL, room)
            value = fonts.fitted(cell.value, _VALUE, room)
            marks.append(Words(label, (x + _INSET, top - _LABEL - 1.1), _LABEL))
            marks.append(Words(value, (x + _INSET, top - ROW + 1.6), _VALUE))
            x += width
    return marks
