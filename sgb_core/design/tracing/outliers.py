"""Isolated points far from where their neighbours are going."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats

# An outlier is farther than this many tolerances from every way its neighbours may be joined,
FAR = 3.0
# and this many times farther than most points are.
_STANDS_OUT = 6.0
# At most one point in so many is left out.
_ONE_IN = 10


def isolated_outliers(points: Floats, tolerance: float) -> NDArray[np.intp]:
    """Return the numbers of isolated outliers among ordered points, shape (N, 2), ascending.

    A point is one where it is farther than three tolerances from the cubic through its four
    neighbours and from one of the lines that go on from the two on either side (the tip of a
    corner is near both), unless most points are nearly as far. The ends are never left out.
    """
    kept = np.arange(len(points))
    left_out: list[int] = []
    while len(kept) >= 6 and len(left_out) < len(points) // _ONE_IN:
        off = _departures(points[kept], tolerance)
        worst = int(np.argmax(off))
        if off[worst] <= max(FAR * tolerance, _STANDS_OUT * float(np.median(off))):
            break
        left_out.append(int(kept[worst]))
        kept = np.delete(kept, worst)
    return np.array(sorted(left_out), dtype=np.intp)


def _departures(points: Floats, tolerance: float) -> Floats:
    """Return how far each point is from what its neighbours foretell, shape (N,); ends 0."""
    count = len(points)
    off = np.zeros(count)
    inner = np.arange(2, count - 2)
    before, after = points[inner - 1], points[inner + 1]
    here = points[inner]
    # Only what is far from the chord can be far from anything.
    chord = _to_segment(here, before, after)
    look = inner[chord > FAR * tolerance]
    # The last but one on either side has but one neighbour beyond.
    for number in (1, count - 2):
        if (
            count > 4
            and _to_segment(
                points[number : number + 1],
                points[number - 1 : number],
                points[number + 1 : number + 2],
            )
            > FAR * tolerance
        ):
            look = np.append(look, number)
    for i in look:
        # The tip of a corner lies on the lines from both sides.
        tip = max(_line(points, int(i), step, tolerance) for step in (-1, 1))
        off[i] = min(_cubic(points, int(i)), tip)
    return off


def _to_segment(points: Floats, start: Floats, end: Floats) -> Floats:
    chord = end - start
    square = (chord**2).sum(axis=-1)
    part = ((points - start) * chord).sum(axis=-1) / np.where(square > 0.0, square, 1.0)
    foot = start + np.clip(part, 0.0, 1.0)[..., None] * chord
    return np.asarray(np.hypot(*(points - foot).T))


def _cubic(points: Floats, i: int) -> float:
    """Return the distance from the interpolation between the neighbours: a cubic if it can be."""
    count = len(points)
    near = [k for k in (i - 2, i - 1, i + 1, i + 2) if 0 <= k < count]
    steps = np.hypot(*np.diff(points[near], axis=0).T)
    if (steps == 0.0).any():
        return float(_to_segment(points[i : i + 1], points[i - 1], points[i + 1])[0])
    marks = np.append(0.0, np.cumsum(steps))
    middle = near.index(i - 1)
    powers = np.vander(marks, increasing=True)
    coefficients = np.linalg.solve(powers, points[near])
    along = np.linspace(marks[middle], marks[middle + 1], 33)
    curve = np.vander(along, len(near), increasing=True) @ coefficients
    return float(np.hypot(*(curve - points[i]).T).min())


def _line(points: Floats, i: int, step: int, tolerance: float) -> float:
    """Return the distance from the line that goes on from the points on one side."""
    first = i + step
    far = first + step
    # Neighbours closer than the noise give no direction: look back at least some tolerances.
    while 0 <= far < len(points) and (np.hypot(*(points[far] - points[first])) < FAR * tolerance):
        far += step
    if not 0 <= far < len(points):
        return float("inf")
    along = points[first] - points[far]
    length = float(np.hypot(*along))
    off = points[i] - points[first]
    ahead = float(off @ along) / length
    across = abs(float(off[0] * along[1] - off[1] * along[0])) / length
    return across if ahead > 0.0 else float(np.hypot(*off))
