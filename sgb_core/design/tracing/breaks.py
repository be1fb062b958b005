"""Where to cut a run of points into segments: the best cuts for a rough fit, by programming.

The rough fit of a stretch is the quartic polynomial in the length along it that is nearest in
the least-squares sense. It is a little worse than what a segment can do, everywhere alike; so it
tells well where the cuts belong, and an upper estimate of how many there must be.
"""

from __future__ import annotations

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from sgb_core.arrays import Floats
from sgb_core.design.tracing.guide import Guide

# Stations along the run; stretches begin and end at every second one.
_STATIONS = 97
_STEP = 2
_MOST = 64


class Cuts:
    """The costs of all stretches of one run, and from them the best cuts for any number."""

    def __init__(self, guide: Guide) -> None:
        self._guide = guide
        stations = guide.at(np.linspace(0.0, guide.length, _STATIONS))
        self._squares, self._largest = _stretches(stations)
        nodes = len(self._squares)
        self._best = [np.where(np.arange(nodes) == 0, 0.0, np.inf)]
        self._from: list[np.ndarray] = []

    def enough(self, tolerance: float) -> int:
        """Return how many stretches of the rough fit keep the tolerance, at most 64."""
        nodes = len(self._squares)
        # Greedy is optimal for this question: a part of a good stretch is nearly as good.
        place = count = 0
        while place < nodes - 1 and count < _MOST:
            good = np.flatnonzero(self._largest[place, place + 1 :] <= tolerance)
            place += 1 + (int(good[-1]) if len(good) else 0)
            count += 1
        return max(count, 1)

    def places(self, count: int) -> Floats:
        """Return the lengths at which ``count`` stretches begin and end, shape (count + 1,)."""
        nodes = len(self._squares)
        count = min(count, nodes - 1)
        while len(self._best) <= count:
            total = self._best[-1][:, None] + self._squares
            self._from.append(np.argmin(total, axis=0))
            self._best.append(total.min(axis=0))
        path = [nodes - 1]
        for step in reversed(self._from[:count]):
            path.append(int(step[path[-1]]))
        return np.array(path[::-1]) * (self._guide.length / (nodes - 1))


def _stretches(stations: Floats) -> tuple[Floats, Floats]:
    """Return the sums of squares and largest distances of all stretches, [from, to] each."""
    nodes = (len(stations) - 1) // _STEP + 1
    squares = np.full((nodes, nodes), np.inf)
    largest = np.full((nodes, nodes), np.inf)
    along = np.gradient(stations, axis=0)
    speed = np.hypot(along[:, 0], along[:, 1])
    normals = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.where(speed > 0, speed, 1)[:, None]
    for reach in range(1, nodes):
        size = reach * _STEP + 1
        runs = sliding_window_view(stations, size, axis=0)[::_STEP]
        sides = sliding_window_view(normals, size, axis=0)[::_STEP]
        powers = np.polynomial.legendre.legvander(np.linspace(-1.0, 1.0, size), min(4, size - 1))
        q, _ = np.linalg.qr(powers)
        off = runs - (runs @ q) @ q.T
        distance = (off * sides).sum(axis=1)
        start = np.arange(len(runs))
        squares[start, start + reach] = (distance**2).sum(axis=1)
        largest[start, start + reach] = np.abs(distance).max(axis=1)
    return squares, largest
