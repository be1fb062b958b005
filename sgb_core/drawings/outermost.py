"""Where a line reaches farthest from the axis: at an end, or where a cubic runs upright."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.basis import bernstein
from sgb_core.drawings.page import Path

# Between which heights it is looked for besides exactly: bounds cut a cubic at no known place.
_PLACES = np.linspace(0.0, 1.0, 33)


def outermost(paths: Sequence[Path], low: float, high: float) -> tuple[float, float] | None:
    """Return the place (|r|, h) farthest out at heights from low to high, None where there is none.

    Where a cubic is cut by a bound its place is found to a thirty-second of its parameter.
    """
    found = [_candidates(piece) for path in paths for piece in path.pieces]
    if not found:
        return None
    points = np.concatenate(found)
    points = points[(points[:, 1] >= low) & (points[:, 1] <= high)]
    if len(points) == 0:
        return None
    r, h = points[int(np.abs(points[:, 0]).argmax())].tolist()
    return abs(r), h


def _candidates(piece: Floats) -> Floats:
    if len(piece) == 2:
        return np.asarray(piece[0] + _PLACES[:, None] * (piece[1] - piece[0]))
    a, b, c = np.diff(piece[:, 0])
    # r'(t)/3 = a(1−t)² + 2b(1−t)t + ct².
    roots = np.roots([a - 2.0 * b + c, 2.0 * (b - a), a])
    turns = roots[np.isreal(roots)].real
    t = np.concatenate([_PLACES, turns[(turns > 0.0) & (turns < 1.0)]])
    return np.asarray(bernstein(3, t) @ piece)
