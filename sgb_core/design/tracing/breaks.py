"""Where to cut a run of points into segments: the best cuts for a rough fit, by programming.

The rough fit of a stretch is the quartic nearest to it across the path: distances along the path
count little, as they do for a segment, whose parameter is free. It has a few freedoms more than a
segment of a smooth chain; so it tells well where the cuts belong, and about how many there must be.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.design.tracing.feet import weights
from sgb_core.design.tracing.guide import Guide

# Places at which stretches may begin and end, and samples of each stretch.
_NODES, _SAMPLES = 49, 33
# How much squares along the path count, those across it counting 1.
_ALONG = 0.01
_MOST = 64
_BASIS = weights(np.linspace(0.0, 1.0, _SAMPLES))


class Cuts:
    """The costs of all stretches of one run, and from them the best cuts for any number.

    ``crowding`` is the part of the places that crowd where the run bends, as the corners of a
    polygon within the tolerance do; the others are evenly spread.
    """

    def __init__(self, guide: Guide, tolerance: float, crowding: float) -> None:
        bends = guide.lengths[_polygon(guide.knots, tolerance)]
        even = np.linspace(0.0, guide.length, 8 * _NODES + 1)
        share = crowding * np.interp(even, bends, np.linspace(0.0, 1.0, len(bends)))
        share += (1.0 - crowding) * even / guide.length
        self._marks = np.interp(np.linspace(0.0, 1.0, _NODES), share, even)
        first, last = np.triu_indices(_NODES, 1)
        distances = near_quartics(guide, self._marks[first], self._marks[last])[1]
        lengths = self._marks[last] - self._marks[first]
        self._squares = np.full((_NODES, _NODES), np.inf)
        self._largest = self._squares.copy()
        self._squares[first, last] = (distances**2).mean(axis=1) * lengths
        self._largest[first, last] = np.abs(distances).max(axis=1)
        self._best = [np.where(np.arange(_NODES) == 0, 0.0, np.inf)]
        self._from: list[NDArray[np.intp]] = []

    def enough(self, tolerance: float) -> int:
        """Return how many stretches of the rough fit keep the tolerance, at most 64."""
        # Greedy is optimal for this question: a part of a good stretch is nearly as good.
        place = count = 0
        while place < _NODES - 1 and count < _MOST:
            good = np.flatnonzero(self._largest[place, place + 1 :] <= tolerance)
            place += 1 + (int(good[-1]) if len(good) else 0)
            count += 1
        return max(count, 1)

    def places(self, count: int) -> Floats:
        """Return the lengths at which ``count`` stretches begin and end, shape (count + 1,)."""
        count = min(count, _NODES - 1)
        while len(self._best) <= count:
            total = self._best[-1][:, None] + self._squares
            self._from.append(np.argmin(total, axis=0))
            self._best.append(total.min(axis=0))
        path = [_NODES - 1]
        for step in reversed(self._from[:count]):
            path.append(int(step[path[-1]]))
        return np.asarray(self._marks[path[::-1]])


def near_quartics(guide: Guide, start: Floats, end: Floats) -> tuple[Floats, Floats]:
    """Return the quartics (C, 5, 2) nearest to stretches, and their distances (C, samples).

    The stretches run from the lengths ``start`` to ``end``, shape (C,) each. Least squares of the
    distances along the normals of the guide, and a little of those along its tangents.
    """
    part = np.linspace(0.0, 1.0, _SAMPLES)
    places = guide.at(start[:, None] + (end - start)[:, None] * part)
    middle = places.mean(axis=1, keepdims=True)
    places -= middle
    slope = np.gradient(places, axis=1)
    speed = np.hypot(slope[..., 0], slope[..., 1])
    normals = np.stack([slope[..., 1], -slope[..., 0]], axis=-1)
    normals /= np.where(speed > 0.0, speed, 1.0)[..., None]
    heights = (places * normals).sum(axis=-1)
    rows = (_BASIS[:, :, None] * normals[:, :, None, :]).reshape(len(start), _SAMPLES, 10)
    turned = rows.transpose(0, 2, 1)
    matrix = (1.0 - _ALONG) * (turned @ rows)
    matrix += _ALONG * np.kron(_BASIS.T @ _BASIS, np.eye(2))
    values = (1.0 - _ALONG) * (turned @ heights[:, :, None])
    values += _ALONG * (_BASIS.T @ places).reshape(len(start), 10, 1)
    found = np.linalg.solve(matrix, values)
    distances = (rows @ found)[..., 0] - heights
    return found.reshape(len(start), 5, 2) + middle, distances


def _polygon(points: Floats, tolerance: float) -> NDArray[np.intp]:
    """Return the numbers of points whose polygon keeps the tolerance: Douglas and Peucker."""
    kept, stretches = [0, len(points) - 1], [(0, len(points) - 1)]
    while stretches:
        first, last = stretches.pop()
        if last - first < 2:
            continue
        chord, off = points[last] - points[first], points[first + 1 : last] - points[first]
        length = float(np.hypot(*chord))
        away = np.abs(off[:, 0] * chord[1] - off[:, 1] * chord[0])
        away = away / length if length > 0.0 else np.hypot(off[:, 0], off[:, 1])
        farthest = int(away.argmax())
        if away[farthest] > tolerance:
            middle = first + 1 + farthest
            kept.append(middle)
            stretches += [(first, middle), (middle, last)]
    return np.array(sorted(set(kept)), dtype=np.intp)
