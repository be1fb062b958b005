"""The template: the profile at true size as a board to cut, a rib or a gauge for throwing.

Outside, the board lies against the vessel from outside; inside, between the axis and the wall.
Its straight edge is parallel to the axis and has a tick every centimetre.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from math import floor

import numpy as np
import shapely

from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.outline import Piece, Role
from sgb_core.bodies.outline_cubics import outline_cubics
from sgb_core.bodies.solid import BodyKind, WallSide
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.manufacture import Stage
from sgb_core.document.model import Document
from sgb_core.drawings import fonts
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.half_view import drawn_runs
from sgb_core.drawings.marks import line, rectangle
from sgb_core.drawings.page import (
    FINE,
    NARROW,
    Anchor,
    Drawing,
    Layer,
    Mark,
    Page,
    Path,
    Pen,
    Stroke,
    Words,
)
from sgb_core.drawings.scales import Paper, Sheet, sheets_of
from sgb_core.drawings.tiles import Tile, clipped, crosses, tiles_of
from sgb_core.fields.kinds import Choice, Said
from sgb_core.findings.drawings import NoDrawing, TooManyPages
from sgb_core.values import dataclass

PAPERS = (Paper.A4, Paper.A3, Paper.LETTER)
TOLERANCE = 0.001
MOST_PAGES = 100
MARGIN = 10.0
# In mm: how wide the board is at its narrowest, what is left free around it, the strip below the
# tile with the words and the control bar, the bar, and ticks.
_BOARD, _FREE, _STRIP, _BAR = 30.0, 3.0, 20.0, 100.0
_TICK, _LONG_TICK, _TEXT = 4.0, 7.0, 2.5
_CENTIMETRE, _INSET = 10.0, 0.25
_PLACES = np.linspace(0.0, 1.0, 9)
_OUTSIDE = (Role.WALL,)
_INSIDE = (Role.DRAWN, Role.WALL, Role.FLOOR)


@dataclass(frozen=True, slots=True)
class TemplateWanted:
    """Which template: for the clay wet or fired, for the outside or the inside of the wall.

    Raises RefusalError, a ValueError, for a value that is not allowed.
    """

    paper: Paper = Paper.A4
    stage: Stage = Stage.WET
    wall: WallSide = WallSide.OUTSIDE
    day: str = ""

    def __post_init__(self) -> None:
        if self.paper not in PAPERS:
            raise Said('"A4", "A3", "Letter"').refusal(self.paper, ("paper",))
        Choice(Stage).take(self.stage, ("as",))
        Choice(WallSide).take(self.wall, ("wall",))


@dataclass(frozen=True, slots=True, eq=False)
class _Board:
    """The board in mm at the size wanted: what is cut, the straight edge, and its box."""

    cut: tuple[Path, ...]
    around: Path
    edge: float
    inwards: float
    low: tuple[float, float]
    high: tuple[float, float]


def template(document: Document, wanted: TemplateWanted) -> Drawing:
    """Return the pages of a template at true size, tiled where it is larger than the paper.

    Raises DrawingError where there is no such side or the pages are too many, SolidError where
    there is no body.
    """
    factor = document.unit.millimetres * document.manufacture.shrinkage.factor(wanted.stage)
    board = _board(document, wanted, factor)
    sheet, columns, rows, tiles = _tiling(board, wanted.paper)
    if len(tiles) > MOST_PAGES:
        raise DrawingError(TooManyPages(len(tiles), MOST_PAGES))
    drawn = _board_marks(board)
    pages = []
    for number, tile in enumerate(tiles, 1):
        where = f"page {number} of {len(tiles)}"
        if len(tiles) > 1:
            row = f"row {tile.row + 1} of {rows} from below"
            where += f": column {tile.column + 1} of {columns}, {row}"
        words = (_title(document, wanted), f"{where}; {_edge_words(board)}")
        pages.append(_page(drawn, sheet, tile, len(tiles) > 1, words))
    subject = f"Template, {wanted.wall} of the wall, {wanted.stage} size, 1:1 on {sheet}"
    keywords = ("template", "SGB Studio")
    return Drawing(tuple(pages), document.name, subject, TOLERANCE, wanted.day, keywords)


def _title(document: Document, wanted: TemplateWanted) -> str:
    name = " ".join(document.name.split())[:60]
    bare = wanted.wall is WallSide.OUTSIDE and relief_of(document.appearance) is not None
    what = f"{wanted.wall} of the wall{' without its relief' if bare else ''}"
    return f"{name}: {what}, {wanted.stage} size; print at true size (100 %)"


def _edge_words(board: _Board) -> str:
    if board.edge == 0.0:
        return "the straight edge is the axis"
    return f"the straight edge is {board.edge:.2f} mm from the axis"


def _runs(document: Document, wall: WallSide) -> list[list[Piece]]:
    """Return the runs of exact pieces that the board is cut along."""
    solid = document.solid
    if solid.kind is BodyKind.FILLED and wall is WallSide.INSIDE:
        raise DrawingError(NoDrawing.NO_INSIDE)
    drawn = solid.kind is not BodyKind.VESSEL
    if drawn or (wall is WallSide.OUTSIDE and solid.side is WallSide.INSIDE):
        return drawn_runs(document.surface)
    section = cross_section(document.surface, solid)
    if wall is WallSide.INSIDE:
        rings = [outline.exterior for outline in section.hollow]
        roles: tuple[Role, ...] = _INSIDE
    else:
        rings, roles = [outline.exterior for outline in section.outlines], _OUTSIDE
    runs: list[list[Piece]] = []
    for ring in rings:
        kept = [piece.role in roles for piece in ring]
        # Begin where a run begins, not in the middle of one.
        start = next((k for k in range(len(ring)) if kept[k] and not kept[k - 1]), 0)
        for k in range(start, start + len(ring)):
            if not kept[k % len(ring)]:
                continue
            if runs and k > start and kept[(k - 1) % len(ring)]:
                runs[-1].append(ring[k % len(ring)])
            else:
                runs.append([ring[k % len(ring)]])
    if not runs:
        raise DrawingError(NoDrawing.NO_INSIDE)
    return runs


def _without_level_ends(run: list[Piece], size: float) -> list[Piece]:
    """Return a run without the disc it stands on and the lid on top, which no board touches."""
    kept = list(run)
    for end in (0, -1):
        while len(kept) > 1:
            heights = kept[end].points(_PLACES)[:, 1]
            if float(np.ptp(heights)) > 1e-9 * size or kept[end].ends[end, 0] > 1e-9 * size:
                break
            kept.pop(end)
    return kept


def _board(document: Document, wanted: TemplateWanted, factor: float) -> _Board:
    if document.profile.size == 0.0:
        raise DrawingError(NoDrawing.POINT)
    runs = _runs(document, wanted.wall)
    if wanted.wall is WallSide.OUTSIDE:
        runs = [_without_level_ends(run, document.profile.size) for run in runs]
    cut = tuple(
        Path(outline_cubics(run, TOLERANCE / factor)).moved(factor, (0.0, 0.0)) for run in runs
    )
    points = np.concatenate([path.flat() for path in cut])
    (left, low), (right, high) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    outside = wanted.wall is WallSide.OUTSIDE
    edge = right + _BOARD if outside else min(0.0, left)
    first, last = sorted(
        (cut[0].flat()[0].tolist(), cut[-1].flat()[-1].tolist()), key=lambda end: end[1]
    )
    around = Path.through(
        _distinct(
            [tuple(first), (first[0], low), (edge, low), (edge, high), (last[0], high), tuple(last)]
        )
    )
    box = (min(left, edge), low), (max(right, edge), high)
    return _Board(cut, around, edge, -1.0 if outside else 1.0, *box)


def _distinct(points: Sequence[tuple[float, ...]]) -> list[tuple[float, float]]:
    found = [(points[0][0], points[0][1])]
    for before, after in pairwise(points):
        if abs(after[0] - before[0]) + abs(after[1] - before[1]) > 1e-9:
            found.append((after[0], after[1]))
    return found


def _tiling(board: _Board, paper: Paper) -> tuple[Sheet, int, int, list[Tile]]:
    """Return the sheet, upright or lying, that takes fewer pages, and its tiles."""
    low = (board.low[0] - _FREE, board.low[1] - _FREE)
    high = (board.high[0] + _FREE, board.high[1] + _FREE)
    found = []
    for sheet in sheets_of(paper):
        width, height = sheet.size
        room = (width - 2.0 * MARGIN, height - 2.0 * MARGIN - _STRIP)
        pages = [max(1.0, (b - a) / size) for a, b, size in zip(low, high, room, strict=True)]
        if pages[0] * pages[1] > 100.0 * MOST_PAGES:
            raise DrawingError(TooManyPages(round(pages[0] * pages[1]), MOST_PAGES))
        found.append((sheet, *tiles_of(low, high, room)))
    return min(found, key=lambda each: len(each[3]))


def _board_marks(board: _Board) -> list[Mark]:
    """Return the board: the line to cut along, its other edges, ticks with centimetres."""
    made: list[Mark] = [
        Stroke.of(Layer.CUT, *board.cut),
        Stroke.of(Layer.OUTLINE, board.around, pen=Pen(NARROW)),
    ]
    height = board.high[1] - board.low[1]
    lines = shapely.MultiLineString([path.flat() for path in board.cut])
    taken = shapely.buffer(lines, 0.6)
    ticks = []
    for number in range(floor(height / _CENTIMETRE + 1e-9) + 1):
        level = board.low[1] + _CENTIMETRE * number
        length = _LONG_TICK if number % 5 == 0 else _TICK
        ticks.append(
            Path.through(((board.edge, level), (board.edge + board.inwards * length, level)))
        )
        if level + _TEXT + 1.5 <= board.high[1]:
            anchor = Anchor.END if board.inwards < 0.0 else Anchor.START
            x, room = board.edge + board.inwards * 1.5, fonts.width(str(number), _TEXT)
            left, right = sorted((x, x + board.inwards * room))
            low = level + 0.9
            # Beside a curve that comes near the edge there is no room for a number.
            if not taken.intersects(shapely.box(left, low - 0.5, right, low + _TEXT)):
                made.append(Words(str(number), (x, low), _TEXT, anchor, layer=Layer.SCALE))
    made.append(Stroke.of(Layer.SCALE, *ticks, pen=Pen(FINE)))
    return made


def _page(
    drawn: Sequence[Mark], sheet: Sheet, tile: Tile, many: bool, words: tuple[str, str]
) -> Page:
    shift = (MARGIN - tile.left, MARGIN + _STRIP - tile.low)
    # Lines that run along the border have a width too.
    inner = replace(
        tile,
        left=tile.left + _INSET,
        low=tile.low + _INSET,
        right=tile.right - _INSET,
        high=tile.high - _INSET,
    )
    made: list[Mark] = []
    for mark in drawn:
        if isinstance(mark, Stroke):
            paths = clipped(mark.paths, inner)
            if paths:
                moved = tuple(path.moved(1.0, shift) for path in paths)
                made.append(Stroke(mark.layer, moved, mark.pen))
        elif isinstance(mark, Words) and _holds(tile, mark):
            at = (mark.at[0] + shift[0], mark.at[1] + shift[1])
            made.append(Words(mark.text, at, mark.height, mark.anchor, mark.turn_deg, mark.layer))
    if many:
        cross = crosses(tile)
        made.append(Stroke.of(Layer.CROSSES, *(path.moved(1.0, shift) for path in cross.paths)))
    made += _strip(sheet, words)
    width, height = sheet.size
    return Page(width, height, (MARGIN,) * 4, tuple(made), 1.0, shift)


def _holds(tile: Tile, words: Words) -> bool:
    """Whether words lie in a tile, clear of its border and the crosses of its corners."""
    length = fonts.width(words.text, words.height)
    left = words.at[0] - (length if words.anchor is Anchor.END else 0.0)
    inside = tile.left + 0.5 <= left and left + length <= tile.right - 0.5
    if not (inside and tile.low + 1.0 <= words.at[1] <= tile.high - words.height - 0.5):
        return False
    return not any(
        abs(x - left - 0.5 * length) < 0.5 * length + 4.0
        and abs(y - words.at[1] - 0.5 * words.height) < 0.5 * words.height + 4.0
        for x in (tile.left + 5.0, tile.right - 5.0)
        for y in (tile.low + 5.0, tile.high - 5.0)
    )


def _strip(sheet: Sheet, words: tuple[str, str]) -> list[Mark]:
    """Return what stands below the tile: two lines of words and a bar of 100 mm to be measured."""
    room = sheet.size[0] - 2.0 * MARGIN
    made: list[Mark] = [
        Words(fonts.fitted(text, _TEXT, room), (MARGIN, MARGIN + level), _TEXT)
        for text, level in zip(words, (14.0, 9.5), strict=True)
    ]
    # Half a line's width inside the margin.
    left, low = MARGIN + 0.5, MARGIN + 1.0
    made.append(rectangle(Layer.SCALE, left, low, left + _BAR, low + 2.0))
    made += [
        line(Layer.SCALE, (left + step, low), (left + step, low + 2.0))
        for step in np.arange(10.0, _BAR, 10.0).tolist()
    ]
    told = "100 mm: measure this bar on the print"
    made.append(Words(told, (left + _BAR + 3.0, low), _TEXT, layer=Layer.SCALE))
    return made
