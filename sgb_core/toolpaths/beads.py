"""What a path lays down, as it is seen: beads with a width and a height, and the bed below them."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.toolpaths.printer import Bed, BedShape
from sgb_core.toolpaths.strand import Part
from sgb_core.toolpaths.toolpath import Toolpath
from sgb_core.values import dataclass

# However many points are left out, no more than this is turned from one to the next, in radians.
_LARGEST_TURN = 0.25
# The corners of a bead's section: how many half widths aside and how many layers below the tip,
# and which way each faces, aside and up, so that a bead is shaded as if it were round.
_SECTION = np.array([(-1.0, -1.0), (-1.0, 0.0), (1.0, 0.0), (1.0, -1.0)])
_FACING = np.array([(-0.86, -0.5), (-0.71, 0.71), (0.71, 0.71), (0.86, -0.5)])


@dataclass(frozen=True, slots=True, eq=False)
class Beads:
    """Beads without their undersides, in mm in the coordinates of their path.

    ``kept`` (k,) are the numbers of the path's points that have a section of four corners;
    ``corners`` and ``normals`` have the shape (k, 4, 3), ``quads`` the shape (m, 3, 4): of each
    move that is printed, in their order, one side, the top and the other side, as numbers of
    corners; ``moves`` (m,) are the numbers in ``kept`` of the points that they lead to.
    """

    kept: np.ndarray
    corners: Floats
    normals: Floats
    quads: np.ndarray
    moves: np.ndarray


def beads(path: Toolpath, most: int) -> Beads:
    """Return what is printed, of about ``most`` points where the path has more.

    Where that is not enough every so many layers of the wall are drawn, so much higher.
    """
    kept, starts, every = _kept(path, most)
    points, own = path.points[kept], np.arange(len(kept))
    ends = np.append(starts[1:], True)
    before, after = np.where(starts, own, own - 1), np.where(ends, own, own + 1)
    ahead = points[after, :2] - points[before, :2]
    length = np.hypot(*ahead.T)
    ahead /= np.where(length > 0.0, length, 1.0)[:, None]
    aside = np.column_stack([-ahead[:, 1], ahead[:, 0]])
    half = max(path.plan.bead, 0.2 * path.plan.layer) / 2.0
    corners = np.empty((len(kept), 4, 3))
    corners[..., :2] = points[:, None, :2] + half * _SECTION[:, :1] * aside[:, None]
    high = path.plan.layer * np.where(path.parts[kept] == Part.WALL, every, 1)
    # The wall begins on the bed, where no bead has its height yet.
    corners[..., 2] = np.maximum(points[:, None, 2] + high[:, None] * _SECTION[:, 1], 0.0)
    normals = np.empty_like(corners)
    normals[..., :2] = _FACING[:, :1] * aside[:, None]
    normals[..., 2] = _FACING[:, 1]
    moves = np.flatnonzero(~starts)
    first = (4 * moves[:, None] - 4) + np.arange(3)
    quads = np.stack([first, first + 4, first + 5, first + 1], axis=-1)
    return Beads(kept, corners, normals, quads, moves)


def _kept(path: Toolpath, most: int) -> tuple[np.ndarray, np.ndarray, int]:
    """Return which points are drawn, which of these begin a piece, both (k,), and of how many.

    The last number says of how many layers of the wall one is drawn.
    """
    numbers, every = np.arange(len(path.points)), 1
    starts = path.parts == Part.TRAVEL
    starts[0] = True
    if len(numbers) <= most:
        return numbers, starts, every
    turned = _turned(path.points)
    every = max(1, round(float(turned[-1]) / _LARGEST_TURN / most))
    if every > 1:
        left_out = (path.layers % every != every - 1) & (path.layers != path.layers.max())
        drawn = ~(left_out & (path.parts == Part.WALL))
        # A run of layers begins where the move before it, not drawn, has led to.
        begins = np.append(drawn[1:] & ~drawn[:-1], False)
        numbers = np.flatnonzero(drawn | begins)
        starts = (starts | begins)[numbers]
        turned = _turned(path.points[numbers])
    each = min(float(turned[-1]) / most, _LARGEST_TURN) or 1.0
    wanted = starts | np.append(starts[1:], True)
    wanted[1:] |= np.diff(np.floor(turned / each)) > 0.0
    return numbers[wanted], starts[wanted], every


def _turned(points: Floats) -> Floats:
    """Return by how much a path has turned, seen from above, up to each point, shape (k,)."""
    ahead = np.diff(points[:, :2], axis=0)
    heading = np.arctan2(ahead[:, 1], ahead[:, 0])
    turn = np.abs(np.mod(np.diff(heading) + np.pi, 2.0 * np.pi) - np.pi)
    return np.concatenate([[0.0], np.cumsum(turn), [float(turn.sum())]])


def bed_lines(bed: Bed) -> list[Floats]:
    """Return a bed's outline and the lines on it, around its middle: each (k, 3), in mm.

    The first is the outline, closed. The lines are 10 mm apart, on large beds 50 mm.
    """
    width, depth = bed.width / 2.0, bed.depth / 2.0
    if bed.shape is BedShape.CIRCLE:
        depth = width
        angle = np.linspace(0.0, 2.0 * np.pi, 97)
        outline = width * np.column_stack([np.cos(angle), np.sin(angle)])
    else:
        outline = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]) * [width, depth]
    apart = 10.0 if max(width, depth) <= 160.0 else 50.0
    lines = [outline]
    for axis, (reach, across) in enumerate(((width, depth), (depth, width))):
        for k in range(-int(reach / apart), int(reach / apart) + 1):
            at = k * apart
            half = across
            if bed.shape is BedShape.CIRCLE:
                half = float(np.sqrt(max(width * width - at * at, 0.0)))
            line = np.array([(at, -half), (at, half)])
            lines.append(line if axis == 0 else line[:, ::-1])
    return [np.column_stack([line, np.zeros(len(line))]) for line in lines]
