"""The corners of an outline: where two exact pieces truly cross, near where samples say they do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.bodies.outline import Line, Piece, Ring, Role
from sgb_core.surfaces.curvature import cross

# A corner is looked for so far, in the pieces' own parameters, around where samples put it.
_REACH = 0.1
_PLACES = 129
# Folds shorter than this part of the size may be lost between samples.
_FOLD = 5e-3
# Ends this near, as a part of the size, meet.
_MET = 1e-10


def joined(pieces: Sequence[Piece], size: float) -> Ring:
    """Return the ring with each corner moved to where the two pieces truly cross."""
    result = _crossed(list(pieces), size)
    if len(result) < 2:
        return tuple(result)
    for k in range(len(result)):
        first, second = result[k - 1], result[k]
        corner = _crossing(first, second, (first.end, second.start), size)
        if corner is None:
            corner = _searched(first, second, size)
        if corner is not None:
            result[k - 1] = replace(first, end=corner[0])
            result[k] = replace(result[k], start=corner[1])
    return tuple(result)


def _crossed(pieces: list[Piece], size: float) -> list[Piece]:
    """Return the ring without short lines at kinks on whose two sides the moved curves cross.

    Samples do not resolve the fold that such a line closes.
    """
    if len(pieces) < 4:
        return pieces
    kept = []
    for k, piece in enumerate(pieces):
        before, after = pieces[k - 1], pieces[(k + 1) % len(pieces)]
        short = isinstance(piece, Line) and np.hypot(*np.diff(piece.ends, axis=0)[0]) < _FOLD * size
        if not (short and piece.role is before.role is after.role is Role.WALL):
            kept.append(piece)
            continue
        met = _searched(before, after, size)
        # Beyond their ends the curves may cross without a fold.
        if met is None or not (_within(before, met[0]) and _within(after, met[1])):
            kept.append(piece)
    return kept


def _within(piece: Piece, u: float) -> bool:
    return min(piece.start, piece.end) < u < max(piece.start, piece.end)


def _crossing(
    first: Piece, second: Piece, start: tuple[float, float], size: float
) -> tuple[float, float] | None:
    """Return (u, v) with first(u) = second(v) near a ``start``, by Newton's method."""
    u, v = start
    for _ in range(12):
        gap = second.points(np.array([v]))[0] - first.points(np.array([u]))[0]
        if np.hypot(gap[0], gap[1]) <= 1e-14 * size:
            return u, v
        a = first.velocity(np.array([u]))[0]
        b = second.velocity(np.array([v]))[0]
        det = float(cross(a, b))
        if abs(det) <= 1e-9 * float(np.hypot(*a) * np.hypot(*b)):
            return None
        u += float(cross(gap, b)) / det
        v += float(cross(gap, a)) / det
        if abs(u - start[0]) > _REACH or abs(v - start[1]) > _REACH:
            return None
    gap = second.points(np.array([v]))[0] - first.points(np.array([u]))[0]
    return (u, v) if np.hypot(gap[0], gap[1]) <= _MET * size else None


def _searched(first: Piece, second: Piece, size: float) -> tuple[float, float] | None:
    """Return the crossing nearest to where one piece ends and the other starts, from samples.

    Newton's method fails from there where a moved curve turns back close to a corner, or where it
    begins at a standstill.
    """
    end = first.points(np.array([first.end]))[0]
    gap = np.hypot(*(second.points(np.array([second.start]))[0] - end))
    if gap <= _MET * size:
        return None
    u, v = _around(first, first.end), _around(second, second.start)
    lines = [shapely.LineString(piece.points(at)) for piece, at in ((first, u), (second, v))]
    met = shapely.get_coordinates(shapely.intersection(*lines))
    if len(met) == 0:
        return None
    places = met[np.argsort(np.hypot(*(met - end).T))]
    for place in places:
        start = tuple(
            float(at[np.argmin(np.hypot(*(piece.points(at) - place).T))])
            for piece, at in ((first, u), (second, v))
        )
        found = _crossing(first, second, (start[0], start[1]), size)
        if found is not None:
            return found
    return None


def _around(piece: Piece, u: float) -> Floats:
    return np.linspace(max(0.0, u - _REACH), min(1.0, u + _REACH), _PLACES)
