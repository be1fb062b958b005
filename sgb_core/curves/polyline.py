"""Distances of points from lines through points."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats

# Points at a time, which bounds the memory.
_AT_ONCE = 128


def farthest(points: Floats, line: Floats) -> float:
    """Return the largest distance of points, shape (m, 2), from a polyline, shape (k, 2)."""
    return float(distances(points, line).max())


def distances(points: Floats, line: Floats) -> Floats:
    """Return the distance of each of the points from the polyline, shape (m,)."""
    parts = range(0, len(points), _AT_ONCE)
    return np.concatenate([_distances(points[k : k + _AT_ONCE], line) for k in parts])


def _distances(points: Floats, line: Floats) -> Floats:
    start, step = line[:-1], np.diff(line, axis=0)
    square = np.einsum("ki,ki->k", step, step)
    offset = points[:, None] - start
    along = np.einsum("mki,ki->mk", offset, step) / np.where(square > 0.0, square, 1.0)
    apart = offset - np.clip(along, 0.0, 1.0)[..., None] * step
    return np.asarray(np.sqrt(np.einsum("mki,mki->mk", apart, apart).min(axis=1)))
