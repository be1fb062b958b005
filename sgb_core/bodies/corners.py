"""The corners of an outline: where two exact pieces truly cross, near where samples say they do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely

from sgb_core.arrays import Floats, Ints, Mask
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outline import Line, Piece, Ring, Role, line
from sgb_core.bodies.traces import ValuesOf, ends_of, points_of, velocities_of
from sgb_core.findings.bodies import NoBodyFor
from sgb_core.surfaces.curvature import cross

# A corner is looked for so far, in the pieces' own parameters, around where samples put it.
_REACH = 0.1
_PLACES = 129
# Folds shorter than this part of the size may be lost between samples.
_FOLD = 5e-3
# Ends this near, as a part of the size, meet.
_MET = 1e-10
# So near they are one point: nothing is left to be sought.
_SAME = 1e-14
# Pieces whose ends are farther apart, as a part of the size, bound nothing.
_TORN = 1e-5
# Newton's method: rounds, and the sine below which two curves run alike.
_ROUNDS, _PARALLEL = 12, 1e-9
_PAIR = np.array([0]), np.array([1])


def straightened(pieces: list[Piece]) -> list[Piece]:
    """Return the ring with lines of one role that continue each other made one."""
    result: list[Piece] = []
    for piece in pieces:
        merged = _one_line(result[-1], piece) if result else None
        if merged is None:
            result.append(piece)
        else:
            result[-1] = merged
    if len(result) > 3 and (merged := _one_line(result[-1], result[0])) is not None:
        result = [merged, *result[1:-1]]
    return result


def _one_line(first: Piece, second: Piece) -> Line | None:
    if not (isinstance(first, Line) and isinstance(second, Line)) or first.role != second.role:
        return None
    (a, b), (c, d) = first.ends, second.ends
    before, after = b - a, d - c
    lengths = float(np.hypot(*before) * np.hypot(*after))
    if abs(float(cross(before, after))) > 1e-9 * lengths or float(before @ after) <= 0.0:
        return None
    return replace(line(first.role, a, d), source=first.source)


def joined(pieces: Sequence[Piece], size: float) -> Ring:
    """Return the ring with each corner moved to where the two pieces truly cross, or touch.

    Raises SolidError where they do neither.
    """
    result = _crossed(list(pieces), size)
    if len(result) < 2:
        return tuple(result)
    ends = ends_of(result)
    gaps = ends[:, 0] - np.roll(ends[:, 1], 1, axis=0)
    after = np.flatnonzero(np.hypot(gaps[:, 0], gaps[:, 1]) > _SAME * size)
    pairs = (after - 1) % len(result), after
    starts = np.array([(result[k - 1].end, result[k].start) for k in after.tolist()])
    met, places = _crossings(result, pairs, starts.reshape(-1, 2), size)
    for number, k in enumerate(after.tolist()):
        first, second = result[k - 1], result[k]
        corner = places[number].tolist() if met[number] else _searched(first, second, size)
        corner = _touching(first, second) if corner is None else corner
        result[k - 1] = replace(first, end=corner[0])
        result[k] = replace(result[k], start=corner[1])
    ends = ends_of(result)
    gaps = ends[:, 0] - np.roll(ends[:, 1], 1, axis=0)
    if float(np.hypot(gaps[:, 0], gaps[:, 1]).max()) > _TORN * size:
        raise SolidError(NoBodyFor.NOT_RESOLVED)
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


def _crossings(
    pieces: Sequence[Piece], pairs: tuple[Ints, Ints], starts: Floats, size: float
) -> tuple[Mask, Floats]:
    """Return where pairs of pieces cross near ``starts``, (m, 2), all by Newton's method at once.

    That is whether each does, (m,), and the places on the one and on the other, (m, 2).
    """
    places, met = starts.copy(), np.zeros(len(starts), dtype=bool)
    open_ = np.arange(len(starts))

    def values(of: ValuesOf, k: Ints) -> tuple[Floats, Floats]:
        first, second = (of(pieces, places[k, side], pairs[side][k]) for side in (0, 1))
        return first, second

    for _ in range(_ROUNDS):
        first, second = values(points_of, open_)
        gap = second - first
        near = np.hypot(gap[:, 0], gap[:, 1]) <= _SAME * size
        met[open_[near]] = True
        open_, gap = open_[~near], gap[~near]
        if not len(open_):
            break
        a, b = values(velocities_of, open_)
        det = cross(a, b)
        turned = np.abs(det) > _PARALLEL * np.hypot(a[:, 0], a[:, 1]) * np.hypot(b[:, 0], b[:, 1])
        step = np.stack([cross(gap, b), cross(gap, a)], axis=1)[turned] / det[turned, None]
        open_ = open_[turned]
        places[open_] += step
        open_ = open_[(np.abs(places - starts)[open_] <= _REACH).all(axis=1)]
    first, second = values(points_of, open_)
    met[open_] = np.hypot(*(second - first).T) <= _MET * size
    return met, places


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
        met_there, found = _crossings((first, second), _PAIR, np.array([start]), size)
        if met_there[0]:
            return float(found[0, 0]), float(found[0, 1])
    return None


def _touching(first: Piece, second: Piece) -> tuple[float, float]:
    """Return the places where one piece that does not cross another comes nearest to its end.

    A round rim runs into its wall along the tangent; samples tell that place only along a chord.
    """
    end, start = first.points(np.array([first.end]))[0], second.points(np.array([second.start]))[0]
    places = (
        (first.end, _foot(second, second.start, end)),
        (_foot(first, first.end, start), second.start),
        (first.end, second.start),
    )
    gaps = [
        float(np.hypot(*(second.points(np.array([v])) - first.points(np.array([u])))[0]))
        for u, v in places
    ]
    return places[int(np.argmin(gaps))]


def _foot(piece: Piece, u: float, point: Floats) -> float:
    """Return the place near ``u`` at which a piece is nearest to a point."""
    around = _around(piece, u)
    away = piece.points(around) - point
    at = around[[int(np.argmin(np.hypot(away[:, 0], away[:, 1])))]]
    for _ in range(_ROUNDS):
        way = velocities_of([piece], at, np.array([0]))[0]
        speed = float(way @ way)
        if speed == 0.0:
            break
        at = np.clip(at + (point - piece.points(at)[0]) @ way / speed, around[0], around[-1])
    return float(at[0])


def _around(piece: Piece, u: float) -> Floats:
    return np.linspace(max(0.0, u - _REACH), min(1.0, u + _REACH), _PLACES)
