"""Isolated points far from where their neighbours are going."""

from __future__ import annotations

from heapq import heapify, heappop, heappush

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats

# An outlier is farther than this many tolerances from every way its neighbours may be joined,
FAR = 3.0
# and this many times farther than most points are.
_STANDS_OUT = 6.0
# At most one point in so many is left out.
_ONE_IN = 10
# From this part of the points on outliers are many.
_MANY = 0.02
# Where they are, so many in a row may be some.
_IN_A_ROW = 8
# A point that is left out changes what is foretold of so many neighbours on either side at least.
_BESIDE = 3
# So many points are looked back over at most for the direction of a line.
_BACK = 64
# Places at which the curve between the neighbours is compared.
_PLACES = np.linspace(0.0, 1.0, 33)


def isolated_outliers(points: Floats, tolerance: float) -> NDArray[np.intp]:
    """Return the numbers of isolated outliers among ordered points, shape (N, 2), ascending.

    A point is one where it is farther than three tolerances from the cubic through its four
    neighbours and from one of the lines that go on from the two on either side (the tip of a
    corner is near both), unless most points are nearly as far. So are several in a row, each
    alone, after which the path goes on where it was. Ends are left out only where outliers are
    many: those far from all that follows.
    """
    row = _Row(points, tolerance)
    left_out = _excursions(points, tolerance)[: len(points) // _ONE_IN]
    for number in left_out:
        row.removed(number)
    far = row.suspects()
    queue = [(-off, number) for number, off in far.items()]
    heapify(queue)
    while queue and len(points) - len(left_out) >= 6:
        if len(left_out) >= len(points) // _ONE_IN:
            break
        off, worst = heappop(queue)
        if far.get(worst) != -off:
            # It was judged anew since.
            continue
        staying = len(points) - len(left_out)
        if -off <= max(FAR * tolerance, _STANDS_OUT * _median(far, staying)):
            break
        left_out.append(worst)
        del far[worst]
        for number in row.removed(worst):
            far.pop(number, None)
            departure = row.departure(number)
            if departure > 0.0:
                far[number] = departure
                heappush(queue, (-departure, number))
    if are_many(len(left_out), len(points)):
        left_out += _loose_ends(points, row.left(), tolerance)
        left = np.setdiff1d(row.left(), left_out)
        left_out += left[_detours(points[left], tolerance)].tolist()
    return np.array(sorted(left_out), dtype=np.intp)


def are_many(outliers: int, points: int) -> bool:
    """Whether outliers are so many that what lies alone beside a path is of their kind."""
    return outliers > _MANY * points


def _long_steps(points: Floats, tolerance: float) -> tuple[NDArray[np.bool_], float]:
    """Return which steps from point to point, (N - 1,), are long, and from what length on."""
    steps = np.hypot(*np.diff(points, axis=0).T)
    far = max(FAR * tolerance, _STANDS_OUT * float(np.median(steps)))
    return steps > far, far


def _loose_ends(points: Floats, left: NDArray[np.intp], tolerance: float) -> list[int]:
    """Return the numbers before and after which, at the ends of what is left, all is far."""
    near = np.flatnonzero(~_long_steps(points[left], tolerance)[0])
    if not len(near):
        return []
    return [*left[: near[0]].tolist(), *left[near[-1] + 2 :].tolist()]


def _detours(points: Floats, tolerance: float) -> list[int]:
    """Return the numbers of a few points in a row, far off, that may lie near each other."""
    steps, far = _long_steps(points, tolerance)
    found: list[int] = []
    free = 0
    for out in np.flatnonzero(steps).tolist():
        if out < free:
            continue
        for back in (np.flatnonzero(steps[out + 1 : out + 1 + _IN_A_ROW]) + out + 1).tolist():
            if float(np.hypot(*(points[back + 1] - points[out]))) <= far:
                found += range(out + 1, back + 1)
                free = back + 1
                break
    return found


def _excursions(points: Floats, tolerance: float) -> list[int]:
    """Return the numbers of points, two or more in a row, that lie each far from all beside it.

    The path goes on about where it was before them: what is left out is no part of it.
    """
    steps, far = _long_steps(points, tolerance)
    alone = np.append(False, steps[:-1] & steps[1:])
    edges = np.flatnonzero(np.diff(alone.astype(np.int8), append=0))
    found: list[int] = []
    for before, last in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        gap = float(np.hypot(*(points[last + 1] - points[before])))
        if last - before > 1 and gap <= far:
            found += range(before + 1, last + 1)
    return found


def _median(far: dict[int, float], count: int) -> float:
    """Return the median departure of ``count`` points, of which those not in ``far`` have none."""
    if 2 * len(far) < count:
        return 0.0
    rest = np.zeros(count - len(far))
    return float(np.median(np.concatenate([rest, np.fromiter(far.values(), np.float64)])))


class _Row:
    """Points in their order, from which some are taken out."""

    def __init__(self, points: Floats, tolerance: float) -> None:
        self._places: list[list[float]] = points.tolist()
        self._points, self._reach = points, FAR * tolerance
        self._after = list(range(1, len(points) + 1))
        self._before = list(range(-1, len(points) - 1))

    def suspects(self) -> dict[int, float]:
        """Return the departures of the points left that have any."""
        left = self.left()
        row = self._points[left]
        # Only what is far from the chord can be far from anything.
        look = left[1:-1][_to_segment(row[1:-1], row[:-2], row[2:]) > self._reach]
        found = {int(number): self.departure(int(number)) for number in look}
        return {number: off for number, off in found.items() if off > 0.0}

    def left(self) -> NDArray[np.intp]:
        """Return the numbers of the points not taken out."""
        numbers = [0]
        while (following := self._after[numbers[-1]]) < len(self._after):
            numbers.append(following)
        return np.array(numbers, dtype=np.intp)

    def removed(self, number: int) -> list[int]:
        """Take a point out, and return those for which it counted."""
        first, last = self._before[number], self._after[number]
        self._after[first], self._before[last] = last, first
        found = []
        for start, other, step in ((first, last, self._before), (last, first, self._after)):
            near = start
            for count in range(_BACK):
                if not 0 <= near < len(self._places):
                    break
                found.append(near)
                if count >= _BESIDE and self._apart(near, other) >= self._reach:
                    break
                near = step[near]
        return [near for near in found if 0 < near < len(self._places) - 1]

    def departure(self, number: int) -> float:
        """Return how far a point is from what its neighbours foretell, 0 for what is near."""
        before, after = self._before[number], self._after[number]
        here = self._points[number : number + 1]
        chord = float(_to_segment(here, self._points[before], self._points[after])[0])
        if chord <= self._reach:
            return 0.0
        # The tip of a corner lies on the lines from both sides.
        tip = max(self._line(number, step) for step in (self._before, self._after))
        return min(self._cubic(number, chord), tip)

    def _apart(self, first: int, second: int) -> float:
        (x0, y0), (x1, y1) = self._places[first], self._places[second]
        return float(np.hypot(x1 - x0, y1 - y0))

    def _cubic(self, number: int, chord: float) -> float:
        """Return the distance from the interpolation between the neighbours: a cubic at best."""
        count = len(self._places)
        before, after = self._before[number], self._after[number]
        near = [self._before[before], before, after, self._after[after] if after < count else count]
        middle = 1 if near[0] >= 0 else 0
        known = [k for k in near if 0 <= k < count]
        steps = np.hypot(*np.diff(self._points[known], axis=0).T)
        if (steps == 0.0).any():
            return chord
        marks = np.append(0.0, np.cumsum(steps))
        coefficients = np.linalg.solve(np.vander(marks, increasing=True), self._points[known])
        along = marks[middle] + (marks[middle + 1] - marks[middle]) * _PLACES
        curve = np.vander(along, len(known), increasing=True) @ coefficients
        return float(np.hypot(*(curve - self._points[number]).T).min())

    def _line(self, number: int, step: list[int]) -> float:
        """Return the distance from the line that goes on from the points on one side."""
        count = len(self._places)
        first = step[number]
        far = step[first] if 0 <= first < count else first
        # Neighbours closer than the noise give no direction: look back at least some tolerances.
        for _ in range(_BACK):
            if not 0 <= far < count or self._apart(far, first) >= self._reach:
                break
            far = step[far]
        if not 0 <= far < count:
            return float("inf")
        along = self._points[first] - self._points[far]
        length = float(np.hypot(*along))
        off = self._points[number] - self._points[first]
        if not length > 0.0:
            return float(np.hypot(*off))
        ahead = float(off @ along) / length
        across = abs(float(off[0] * along[1] - off[1] * along[0])) / length
        return across if ahead > 0.0 else float(np.hypot(*off))


def _to_segment(points: Floats, start: Floats, end: Floats) -> Floats:
    chord = end - start
    square = (chord**2).sum(axis=-1)
    part = ((points - start) * chord).sum(axis=-1) / np.where(square > 0.0, square, 1.0)
    foot = start + np.clip(part, 0.0, 1.0)[..., None] * chord
    return np.asarray(np.hypot(*(points - foot).T))
