"""The corners of rings: where one exact piece truly ends and the next begins."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats, Ints, Mask
from sgb_core.bodies.outline import Line, Piece, Ring, line
from sgb_core.bodies.traces import ends_of, points_of, velocities_of
from sgb_core.surfaces.curvature import cross

# Ends as near as this part of the size have met.
_MET, _MET_AT_LAST = 1e-14, 1e-10
# Newton's method: rounds, how far a place may move, and the sine below which two curves run alike.
_ROUNDS, _NEARBY, _PARALLEL = 12, 0.1, 1e-9


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


def joined(pieces: list[Piece], size: float) -> Ring:
    """Return the ring with each corner moved to where the two pieces truly cross."""
    result = list(pieces)
    if len(result) < 2:
        return tuple(result)
    ends = ends_of(result)
    gaps = ends[:, 0] - np.roll(ends[:, 1], 1, axis=0)
    corners = np.flatnonzero(np.hypot(gaps[:, 0], gaps[:, 1]) > _MET * size)
    met, u, v = _crossings(result, corners, size)
    for k, end, start in zip(corners[met].tolist(), u[met].tolist(), v[met].tolist(), strict=True):
        result[k - 1] = replace(result[k - 1], end=end)
        result[k] = replace(result[k], start=start)
    return tuple(result)


def _crossings(pieces: Sequence[Piece], after: Ints, size: float) -> tuple[Mask, Floats, Floats]:
    """Return where pieces ``after`` truly cross those before them, by Newton's method.

    For each whether they do near where the one ends and the other starts, and the places u on the
    one and v on the other, each (m,).
    """
    before = (after - 1) % len(pieces)
    ends = np.array([pieces[k].end for k in before.tolist()])
    starts = np.array([pieces[k].start for k in after.tolist()])
    u, v, met, open_ = ends.copy(), starts.copy(), np.zeros(len(after), bool), np.arange(len(after))

    def gaps(k: Ints) -> Floats:
        return points_of(pieces, v[k], after[k]) - points_of(pieces, u[k], before[k])

    for _ in range(_ROUNDS):
        gap = gaps(open_)
        near = np.hypot(gap[:, 0], gap[:, 1]) <= _MET * size
        met[open_[near]] = True
        open_, gap = open_[~near], gap[~near]
        along = velocities_of(pieces, u[open_], before[open_])
        across = velocities_of(pieces, v[open_], after[open_])
        det = cross(along, across)
        paces = np.hypot(along[:, 0], along[:, 1]) * np.hypot(across[:, 0], across[:, 1])
        turned = np.abs(det) > _PARALLEL * paces
        open_, gap, det = open_[turned], gap[turned], det[turned]
        u[open_] += cross(gap, across[turned]) / det
        v[open_] += cross(gap, along[turned]) / det
        strayed = np.maximum(np.abs(u - ends), np.abs(v - starts))[open_] > _NEARBY
        open_ = open_[~strayed]
        if not len(open_):
            break
    gap = gaps(open_)
    met[open_] = np.hypot(gap[:, 0], gap[:, 1]) <= _MET_AT_LAST * size
    return met, u, v
