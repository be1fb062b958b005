"""A twisted end face: a triangulated section whose slices are turned, finer where it bends."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.surfaces.twist import Twisting

# Halvings of edges at most; each quarters how far they lie off.
_ROUNDS = 14


def on_helicoid(
    points: Floats, triangles: Ints, twisting: Twisting, turn: float, near: float
) -> tuple[Floats, Ints]:
    """Return points (k, 2) in (r, h) and triangles of a section that a twist bends.

    Edges inside the section that are turned by more than ``turn`` radians from end to end are
    halved, those at its border stay: they belong to what is beside them. Near the axis, where
    all lies within ``near`` of it, nothing bends.
    """
    for _ in range(_ROUNDS):
        edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        unique, number, shared = np.unique(edges, axis=0, return_inverse=True, return_counts=True)
        number = number.reshape(-1, 3)
        ends = points[unique]
        step = np.abs(np.diff(twisting.angle(ends[..., 1]), axis=1))[:, 0]
        wide = np.abs(ends[..., 0]).max(axis=1)
        halved = (shared == 2) & (step > turn) & (wide > near)
        if not halved.any():
            break
        middle = np.full(len(unique), -1)
        middle[halved] = len(points) + np.arange(int(halved.sum()))
        points = np.concatenate([points, ends[halved].mean(axis=1)])
        triangles = _split(triangles, middle[number])
    return points, triangles


def _split(triangles: Ints, middles: Ints) -> Ints:
    """Return triangles divided at the middles of their edges, −1 where an edge stays whole.

    ``middles`` (T, 3) belong to the edges from corner 0, 1 and 2 to the next.
    """
    cut = middles >= 0
    count = cut.sum(axis=1)
    found = [triangles[count == 0]]
    for k in range(3):
        # Turned so that edge k is the first.
        t, m = np.roll(triangles, -k, axis=1), np.roll(middles, -k, axis=1)
        one = (count == 1) & (m[:, 0] >= 0)
        (a, b, c), p = t[one].T, m[one, 0]
        found += [np.stack([a, p, c], axis=1), np.stack([p, b, c], axis=1)]
        two = (count == 2) & (m[:, 2] < 0)
        (a, b, c), (p, q, _) = t[two].T, m[two].T
        found += [
            np.stack([p, b, q], axis=1),
            np.stack([a, p, q], axis=1),
            np.stack([a, q, c], axis=1),
        ]
    (a, b, c), (p, q, r) = triangles[count == 3].T, middles[count == 3].T
    found += [np.stack(part, axis=1) for part in ((a, p, r), (p, b, q), (r, q, c), (p, q, r))]
    return np.concatenate(found)
