"""Where there is room for a label: rectangles and curves to keep clear of, found by place."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from math import floor

import numpy as np
from PySide6.QtCore import QRectF

from sgb_core.arrays import Floats

# The side of the squares, in pixels, by which things are found: about the height of two labels.
CELL = 32.0


class LabelRoom:
    """Knows only its neighbours: a label asks what lies where it would stand, not all there is."""

    def __init__(self) -> None:
        self._taken: defaultdict[tuple[int, int], list[QRectF]] = defaultdict(list)
        self._rows: dict[int, tuple[Floats, Floats]] = {}

    def occupy(self, box: QRectF) -> None:
        """Keep the labels that follow clear of a rectangle."""
        for cell in _cells(box):
            self._taken[cell].append(box)

    def is_free(self, box: QRectF) -> bool:
        """Whether a rectangle meets none of those that are taken."""
        return not any(
            box.intersects(taken) for cell in _cells(box) for taken in self._taken.get(cell, ())
        )

    def lay_curve(self, places: Floats) -> None:
        """Note the places on curves, shape (m, 2), in pixels."""
        places = places[np.isfinite(places).all(axis=1)]
        if len(places) == 0:
            return
        lines = np.floor(places[:, 1] / CELL)
        order = np.lexsort((places[:, 0], lines))
        places, lines = places[order], lines[order]
        numbers, starts = np.unique(lines, return_index=True)
        for number, row in zip(numbers, np.split(places, starts[1:]), strict=True):
            self._rows[int(number)] = (row[:, 0], row[:, 1])

    def covered(self, box: QRectF) -> int:
        """Return how many places of the curves lie inside a rectangle."""
        count = 0
        for line in range(floor(box.top() / CELL), floor(box.bottom() / CELL) + 1):
            row = self._rows.get(line)
            if row is not None:
                first = int(np.searchsorted(row[0], box.left(), side="right"))
                last = int(np.searchsorted(row[0], box.right(), side="left"))
                y = row[1][first:last]
                count += int(np.count_nonzero((y > box.top()) & (y < box.bottom())))
        return count


def _cells(box: QRectF) -> Iterator[tuple[int, int]]:
    for x in range(floor(box.left() / CELL), floor(box.right() / CELL) + 1):
        for y in range(floor(box.top() / CELL), floor(box.bottom() / CELL) + 1):
            yield x, y
