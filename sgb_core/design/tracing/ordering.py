"""An order for points that come without one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.design.tracing.strand import along_strand, strand_places

# A path in the given order that is no longer than this many times the shortest known is an order.
_ORDERED = 1.3
# Single-valued in height: the path by height is not longer than this many times the other.
_BY_HEIGHT = 1.5
# How far from its place by height a point may belong.
_NEAR = 6
_ROUNDS = 20
# More points than this are ordered along the strand that most of them make: their scatter across
# it and what lies beside it would lead from neighbour to neighbour, and back along a second one.
_MANY = 500


def ordered(points: Floats) -> NDArray[np.intp]:
    """Return the numbers of points, shape (N, 2), in an order in which they make a path.

    The given order where it makes one; by height where the profile is single-valued in it, and
    points of nearly the same height in the order that makes the path shorter; else each point's
    nearest neighbour follows, from the end that lies farthest out. Many points come in the order
    of places along their strand, ordered in the same way. From the lower end upwards, unless the
    given order is kept.
    """
    count = len(points)
    given = np.arange(count)
    if count < 3:
        return given
    best, counted = _along(points) if count > _MANY else (_shortest(points), given)
    asked = np.isin(best, counted)
    if _length(points, counted) <= _ORDERED * _length(points, best[asked]):
        return given
    return best if points[best[0], 1] <= points[best[-1], 1] else best[::-1]


def _along(points: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the order of points along the strand that most make, and the numbers of those."""
    places, reach = strand_places(points)
    if len(places) < 2:
        return np.lexsort((points[:, 0], points[:, 1])), np.arange(len(points))
    order, near = along_strand(points, places[_shortest(places)], reach)
    return order, np.flatnonzero(near)


def _shortest(points: Floats) -> NDArray[np.intp]:
    """Return the order by height, or from neighbour to neighbour where that is much shorter."""
    by_height = _shortened(points, np.lexsort((points[:, 0], points[:, 1])))
    chained = _chained(points)
    much_shorter = _length(points, by_height) > _BY_HEIGHT * _length(points, chained)
    return chained if much_shorter else by_height


def _length(points: Floats, order: NDArray[np.intp]) -> float:
    return float(np.hypot(*np.diff(points[order], axis=0).T).sum())


def _shortened(points: Floats, order: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return an order in which no point lies better a few places away."""
    places = order.tolist()
    xy = points.tolist()

    def gap(a: int, b: int) -> float:
        if a < 0 or b < 0:
            return 0.0
        (x1, y1), (x2, y2) = xy[a], xy[b]
        return float(((x1 - x2) ** 2 + (y1 - y2) ** 2) ** 0.5)

    count = len(places)
    for _ in range(_ROUNDS):
        moved = False
        for i in range(count):
            own = places[i]
            before = places[i - 1] if i > 0 else -1
            after = places[i + 1] if i + 1 < count else -1
            freed = gap(before, own) + gap(own, after) - gap(before, after)
            best, to = -1e-12 * freed, i
            for j in range(max(i - _NEAR, 0), min(i + _NEAR, count - 1) + 1):
                if j == i:
                    continue
                # Between the two that will be on either side of place j.
                low = j - 1 if j < i else j
                first = places[low] if low >= 0 else -1
                second = places[low + 1] if low + 1 < count else -1
                change = gap(first, own) + gap(own, second) - gap(first, second) - freed
                if change < best:
                    best, to = change, j
            if to != i:
                places.insert(to, places.pop(i))
                moved = True
        if not moved:
            break
    return np.array(places, dtype=np.intp)


def _chained(points: Floats) -> NDArray[np.intp]:
    """Return the order in which each point's nearest neighbour of those left follows."""
    squares = ((points[:, None, :] - points[None, :, :]) ** 2).sum(axis=2)
    # An end of the path is far from everything on average; start at each of the two farthest.
    far = np.unravel_index(int(np.argmax(squares)), squares.shape)
    best: NDArray[np.intp] | None = None
    for start in far:
        left = squares.copy()
        order = [int(start)]
        left[:, start] = np.inf
        for _ in range(len(points) - 1):
            following = int(np.argmin(left[order[-1]]))
            order.append(following)
            left[:, following] = np.inf
        found = _shortened(points, np.array(order, dtype=np.intp))
        if best is None or _length(points, found) < _length(points, best):
            best = found
    assert best is not None  # There are two starts.
    return best
