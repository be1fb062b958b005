"""A polyline through ordered, noisy points, against whose length they are numbered."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class Guide:
    """Means of neighbouring points and how far along they lie; ``along`` is that of each point.

    ``knots`` has shape (K, 2), ``lengths`` (K,) from 0 to ``length``, ``along`` (N,).
    """

    knots: Floats
    lengths: Floats
    along: Floats

    @property
    def length(self) -> float:
        """The length of the polyline."""
        return float(self.lengths[-1])

    def at(self, length: Floats) -> Floats:
        """Return the places at lengths along the polyline, shape (*length.shape, 2)."""
        return np.stack(
            [np.interp(length, self.lengths, self.knots[:, k]) for k in range(2)], axis=-1
        )


def guide_of(points: Floats, reach: float) -> Guide:
    """Return the guide of points, shape (N, 2), N ≥ 2.

    Neighbours within ``reach`` of the first of them become one knot, their mean: the length of a
    polyline through every noisy point would be that of the noise. The ends stay what they are.
    """
    marks = [0]
    x, y = points[0].tolist()
    limit = reach * reach
    for number, (r, h) in enumerate(points.tolist()):
        if (r - x) ** 2 + (h - y) ** 2 > limit:
            marks.append(number)
            x, y = r, h
    first = np.array(marks)
    many = np.diff(np.append(first, len(points)))
    means = np.add.reduceat(points, first, axis=0) / many[:, None]
    centres = first + 0.5 * (many - 1)
    last = len(points) - 1
    inner = (centres > 0) & (centres < last)
    knots = np.concatenate([points[:1], means[inner], points[-1:]])
    numbers = np.concatenate([[0.0], centres[inner], [float(last)]])
    steps = np.diff(knots, axis=0)
    lengths = np.append(0.0, np.cumsum(np.hypot(steps[:, 0], steps[:, 1])))
    return Guide(knots, lengths, np.interp(np.arange(len(points)), numbers, lengths))
