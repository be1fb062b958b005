"""How strong a law of the radius is along the height: a smooth curve through a few keys.

Between two keys a cubic Hermite polynomial with the slopes of Fritsch and Butland (1984), which
stays between the two; level at the first and the last key and constant beyond them, so that it is
C1 at every height.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sgb_core.arrays import Floats, frozen
from sgb_core.surfaces.laws.keyframes import monotone_slopes
from sgb_core.values import dataclass

Key = tuple[float, float]


@dataclass(frozen=True, slots=True, eq=False)
class Strength:
    """A strength k by the height h: ``heights`` (m,) of its keys, increasing, and its cubics.

    ``cubics`` (m + 1, 4) are Taylor coefficients about ``origins`` (m + 1,): of what lies below
    the first key, between each two, and above the last.
    """

    heights: Floats
    origins: Floats
    cubics: Floats

    @classmethod
    def through(cls, keys: Sequence[Key], low: float, high: float) -> Strength:
        """Return the curve through keys (u, k), u = (h − low)/(high − low)."""
        u, k = np.array(sorted(keys)).T
        steps = np.diff(u)
        secants = np.diff(k) / steps
        slopes = np.zeros(len(u))
        slopes[1:-1] = monotone_slopes(steps[:-1], steps[1:], secants[:-1], secants[1:])
        start, end = slopes[:-1], slopes[1:]
        cubics = np.zeros((len(u) + 1, 4))
        cubics[0, 0], cubics[-1, 0] = k[0], k[-1]
        cubics[1:-1] = np.stack(
            [
                k[:-1],
                start,
                (3.0 * secants - 2.0 * start - end) / steps,
                (start + end - 2.0 * secants) / steps**2,
            ],
            axis=1,
        )
        reach = high - low
        heights = low + reach * u
        origins = np.concatenate([heights[:1], heights])
        return cls(frozen(heights), frozen(origins), frozen(cubics / reach ** np.arange(4.0)))

    def jet(self, h: Floats, order: int = 0) -> list[Floats]:
        """Return k and its derivatives by h up to ``order`` (at most 4) at heights of any shape.

        At a key the ones from above; beyond the second they jump there.
        """
        piece = np.searchsorted(self.heights, h, side="right")
        x = h - self.origins[piece]
        c0, c1, c2, c3 = np.moveaxis(self.cubics[piece], -1, 0)
        found = [c0 + x * (c1 + x * (c2 + x * c3))]
        if order > 0:
            found.append(c1 + x * (2.0 * c2 + 3.0 * x * c3))
        if order > 1:
            found.append(2.0 * c2 + 6.0 * x * c3)
        if order > 2:
            found.append(6.0 * c3)
        if order > 3:
            found.append(np.zeros_like(x))
        return found

    def moved(self, scale: float, lift: float) -> Strength:
        """Return the curve of a body ``scale`` times as large, then ``lift`` higher."""
        powers = scale ** np.arange(4.0)
        return Strength(
            frozen(scale * self.heights + lift),
            frozen(scale * self.origins + lift),
            frozen(self.cubics / powers),
        )
