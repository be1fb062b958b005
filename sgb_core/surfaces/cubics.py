"""The generatrix as plain cubic Bézier curves, as SVG and font outlines know them."""

from __future__ import annotations

from math import ceil

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.fineness import check_tolerance

# A single quartic needs this many cubics only for tolerances near rounding.
_MOST_PIECES = 256


def cubic_pieces(quartic: Floats, tolerance: float) -> Floats:
    """Return cubics, shape (n, 4, 2), that stay within ``tolerance`` of a quartic Bézier curve.

    Each cubic keeps its piece's ends and end derivatives; the difference is a₄ s²(1−s)² with a₄
    the quartic's leading coefficient, so at most |a₄|/16, and cutting into n pieces divides it
    by n⁴. Where a₄ = 0 the one cubic is exact. Raises FindingError, a
    ValueError, unless the tolerance is finite and above 0.
    """
    check_tolerance(tolerance)
    leading = quartic[0] - 4 * quartic[1] + 6 * quartic[2] - 4 * quartic[3] + quartic[4]
    error = float(np.hypot(leading[0], leading[1])) / 16.0
    count = min(max(1, ceil((error / tolerance) ** 0.25)), _MOST_PIECES)
    pieces = []
    rest = quartic
    for k in range(count):
        left, rest = _cut(rest, 1.0 / (count - k))
        pieces.append(
            [
                left[0],
                left[0] + (left[1] - left[0]) * (4.0 / 3.0),
                left[4] + (left[3] - left[4]) * (4.0 / 3.0),
                left[4],
            ]
        )
    return np.array(pieces)


def stretch(quartic: Floats, start: float, end: float) -> Floats:
    """Return the quartic points (5, 2) of a curve from s = ``start`` to s = ``end``, either way."""
    low, high = min(start, end), max(start, end)
    part = _cut(quartic, high)[0] if high < 1.0 else quartic
    if low > 0.0:
        part = _cut(part, low / high)[1]
    return part if end >= start else part[::-1]


def _cut(points: Floats, s: float) -> tuple[Floats, Floats]:
    """De Casteljau: the quartic points before and after ``s``."""
    left, right, row = [points[0]], [points[-1]], points
    while len(row) > 1:
        row = (1.0 - s) * row[:-1] + s * row[1:]
        left.append(row[0])
        right.append(row[-1])
    return np.array(left), np.array(right[::-1])
