"""The mean of both sides of a profile, and how they differ."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.sources.reading import Half

_PLACES = 1000
# Of the size: sides that differ by less are the same.
_EQUAL = 1e-9


def mean_of_sides(right: Half, left: Half) -> tuple[Half, float]:
    """Return the mean of two sides and the root mean square of their difference.

    At equal heights where both are single-valued in height, over the heights that both have;
    else at equal parts of their lengths. Sides that are equal stay as they are, pieces and all.
    """
    size = float(np.hypot(*np.ptp(np.concatenate([right.points, left.points]), axis=0)))
    first, second = _matched(right.points, left.points)
    difference = np.hypot(*(first - second).T)
    rms = float(np.sqrt((difference**2).mean()))
    if rms <= _EQUAL * size:
        return right, rms
    return Half((first + second) / 2.0), rms


def _matched(right: Floats, left: Floats) -> tuple[Floats, Floats]:
    count = int(np.clip(max(len(right), len(left)), 50, _PLACES))
    if _is_single_valued(right) and _is_single_valued(left):
        low = max(right[0, 1], left[0, 1])
        high = min(right[-1, 1], left[-1, 1])
        heights = np.linspace(low, high, count)
        return _at_heights(right, heights), _at_heights(left, heights)
    return _at_parts(right, count), _at_parts(left, count)


def _is_single_valued(points: Floats) -> bool:
    return bool((np.diff(points[:, 1]) > 0.0).all())


def _at_heights(points: Floats, heights: Floats) -> Floats:
    return np.stack([np.interp(heights, points[:, 1], points[:, 0]), heights], axis=1)


def _at_parts(points: Floats, count: int) -> Floats:
    lengths = np.append(0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T)))
    marks = np.linspace(0.0, lengths[-1], count)
    return np.stack([np.interp(marks, lengths, points[:, k]) for k in range(2)], axis=1)
