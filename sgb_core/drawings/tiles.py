"""A drawing larger than the paper, cut into tiles that overlap, with crosses to lay them by."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil

import numpy as np

from sgb_core.arrays import Floats, frozen
from sgb_core.drawings.page import Layer, Path, Stroke
from sgb_core.values import dataclass

OVERLAP = 10.0
_CROSS = 3.0
# A piece that crosses the border is halved until it is shorter than this, in mm.
_SHORTEST = 0.002
_ON_BORDER = 1e-9


@dataclass(frozen=True, slots=True)
class Tile:
    """The part of a drawing on one page: column and row from the lower left, and its box (mm)."""

    column: int
    row: int
    left: float
    low: float
    right: float
    high: float


def tiles_of(
    low: tuple[float, float], high: tuple[float, float], room: tuple[float, float]
) -> tuple[int, int, list[Tile]]:
    """Return how many columns and rows cover a box, and its tiles, from the lower left.

    Neighbours overlap by 10 mm; what is left over is shared out around the box.
    """
    counts = [
        max(1, ceil((b - a - OVERLAP) / (size - OVERLAP) - _ON_BORDER))
        for a, b, size in zip(low, high, room, strict=True)
    ]
    columns, rows = counts
    starts = [
        0.5 * (a + b - (count * (size - OVERLAP) + OVERLAP))
        for a, b, count, size in zip(low, high, counts, room, strict=True)
    ]
    tiles = []
    for row in range(rows):
        for column in range(columns):
            left = starts[0] + column * (room[0] - OVERLAP)
            base = starts[1] + row * (room[1] - OVERLAP)
            tiles.append(Tile(column, row, left, base, left + room[0], base + room[1]))
    return columns, rows, tiles


def clipped(paths: Sequence[Path], tile: Tile) -> tuple[Path, ...]:
    """Return the parts of paths within a tile, their curves kept as they are."""
    runs: list[list[Floats]] = []
    for path in paths:
        joined = False
        for piece in path.pieces:
            for part, inside in _parts(piece, tile):
                if inside and joined:
                    runs[-1].append(part)
                elif inside:
                    runs.append([part])
                joined = inside
    return tuple(Path(tuple(frozen(part) for part in run)) for run in runs)


def _parts(piece: Floats, tile: Tile) -> list[tuple[Floats, bool]]:
    """Return a piece cut at the borders of a tile, each part with whether it lies inside."""
    low, high = piece.min(axis=0), piece.max(axis=0)
    corner, far = np.array([tile.left, tile.low]), np.array([tile.right, tile.high])
    if (low >= corner - _ON_BORDER).all() and (high <= far + _ON_BORDER).all():
        return [(piece, True)]
    if (high < corner).any() or (low > far).any():
        return [(piece, False)]
    if float(np.hypot(*(high - low))) <= _SHORTEST:
        return [(piece, False)]
    first, last = _halves(piece)
    return [*_parts(first, tile), *_parts(last, tile)]


def _halves(piece: Floats) -> tuple[Floats, Floats]:
    """De Casteljau at the middle, for lines and curves alike."""
    first, last, row = [piece[0]], [piece[-1]], piece
    while len(row) > 1:
        row = 0.5 * (row[:-1] + row[1:])
        first.append(row[0])
        last.append(row[-1])
    return np.array(first), np.array(last[::-1])


def crosses(tile: Tile) -> Stroke:
    """Return four crosses, in the middle of the overlaps, at the same places on neighbours."""
    inset = 0.5 * OVERLAP
    paths = []
    for x in (tile.left + inset, tile.right - inset):
        for y in (tile.low + inset, tile.high - inset):
            paths.append(Path.through(((x - _CROSS, y), (x + _CROSS, y))))
            paths.append(Path.through(((x, y - _CROSS), (x, y + _CROSS))))
    return Stroke.of(Layer.CROSSES, *paths)
