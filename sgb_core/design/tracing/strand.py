"""The strand that many unordered points lie along, and their order along it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

# Neighbourhoods of so many points are looked at, in circles from so many neighbours' reach on,
_LOOKED_AT, _NEIGHBOURS = 200, 8
# each so much wider than the last, up to this part of the size, until most are this thin.
_WIDER, _WIDEST, _THIN = 1.5, 0.05, 0.25
# Places of the strand are so many of these reaches apart, and at most so many.
_APART, _MOST = 1.5, 2000
# A place with fewer points about it than this part of what is usual is off the strand.
_FEW = 0.15


def strand_places(points: Floats) -> tuple[Floats, float]:
    """Return places along the strand that most points make, (M, 2), in no order, and their reach.

    ``points`` has shape (N, 2). Each place is the mean of the points about it, wide enough that
    the scatter across the strand does not count; where few points lie there is none.
    """
    from scipy.spatial import cKDTree

    tree = cKDTree(points)
    reach = _APART * _reach(points, tree)
    while True:
        places, counts = _gathered(points, tree, reach)
        if len(places) <= _MOST:
            break
        reach *= _WIDER
    # What most points see about them: there may be more places beside the strand than on it.
    usual = float(np.median(np.repeat(counts, counts)))
    kept: Floats = places[counts >= _FEW * usual]
    return kept, reach


def along_strand(
    points: Floats, strand: Floats, reach: float
) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
    """Return the order of points by their feet on a path, and which are within a reach of it.

    ``strand`` has shape (M, 2), M ≥ 2; beyond its ends it goes straight on. What lies out there
    and beside that belongs nowhere; it is spread over the path, to stand alone.
    """
    from scipy.spatial import cKDTree

    start, step = strand[:-1], np.diff(strand, axis=0)
    length = np.hypot(step[:, 0], step[:, 1])
    before = np.append(0.0, np.cumsum(length))
    near = cKDTree(strand).query(points)[1]
    # The foot lies on one of the two pieces at the nearest place.
    pieces = np.stack([np.maximum(near - 1, 0), np.minimum(near, len(step) - 1)])
    from_start = points - start[pieces]
    part = (from_start * step[pieces]).sum(axis=2) / np.maximum(length[pieces] ** 2, 1e-300)
    low = np.where(pieces == 0, -np.inf, 0.0)
    high = np.where(pieces == len(step) - 1, np.inf, 1.0)
    part = np.clip(part, low, high)
    away = np.hypot(*np.moveaxis(from_start - part[..., None] * step[pieces], 2, 0))
    chosen = away.argmin(axis=0)
    rows = np.arange(len(points))
    own = pieces[chosen, rows]
    along = before[own] + part[chosen, rows] * length[own]
    off = away[chosen, rows]
    astray = np.flatnonzero((off > reach) & ((along < 0.0) | (along > before[-1])))
    along[astray] = before[-1] * (np.arange(len(astray)) + 0.5) / max(len(astray), 1)
    return np.argsort(along, kind="stable"), off <= reach


def _reach(points: Floats, tree: cKDTree) -> float:
    """Return the radius from which on most neighbourhoods are longer than they are wide."""
    size = float(np.hypot(*np.ptp(points, axis=0)))
    looked_at = points[np.linspace(0, len(points) - 1, _LOOKED_AT).astype(np.intp)]
    first = tree.query(looked_at, min(_NEIGHBOURS + 1, len(points)))[0][:, -1]
    reach = max(float(np.median(first)), 1e-6 * size)
    while reach < _WIDEST * size:
        thin = [_thinness(points[near]) for near in tree.query_ball_point(looked_at, reach)]
        if float(np.median(thin)) <= _THIN:
            break
        reach *= _WIDER
    return reach


def _thinness(points: Floats) -> float:
    """Return how wide a neighbourhood is in parts of its length, 1 for one of few points."""
    if len(points) < _NEIGHBOURS // 2:
        return 1.0
    off = points - points.mean(axis=0)
    small, large = np.linalg.eigvalsh(off.T @ off).tolist()
    return float(np.sqrt(max(small, 0.0) / large)) if large > 0.0 else 1.0


def _gathered(points: Floats, tree: cKDTree, reach: float) -> tuple[Floats, NDArray[np.intp]]:
    """Return the means of what lies within a reach of places so far apart, and how many it was."""
    free = np.ones(len(points), dtype=bool)
    places, counts = [], []
    for number in range(len(points)):
        if not free[number]:
            continue
        near = np.array(tree.query_ball_point(points[number], reach))
        own = near[free[near]]
        free[own] = False
        places.append(points[near].mean(axis=0))
        counts.append(len(near))
    return np.array(places), np.array(counts, dtype=np.intp)
