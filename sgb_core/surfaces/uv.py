"""Texture coordinates of a surface: u by the angle, v by the arc length along the generatrix.

Lengths are honoured: a tile that is square at one place is, along the profile, as long
everywhere. Around it narrows with the radius, as every texture on a turned form must.
"""

from __future__ import annotations

from functools import lru_cache
from math import tau

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.nodes import gauss
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# Nodes of the rule that measures each interval of a row; exact to 1e-9 on the presets.
_NODES = 4


@dataclass(frozen=True, slots=True, eq=False)
class UVMap:
    """Where on the unrolled surface each row of a grid lies.

    ``lengths`` (rows,) is the arc length from the start of the generatrix, gaps not counted;
    ``points`` (rows, 2) its (r, h); ``per_segment`` rows less one belong to each segment.
    ``width`` is the way around at the widest place.
    """

    lengths: Floats
    points: Floats
    per_segment: int
    width: float

    @property
    def length(self) -> float:
        """The length of the generatrix."""
        return float(self.lengths[-1])

    @property
    def shares(self) -> Floats:
        """The lengths as shares of the whole, from 0 to 1, shape (rows,)."""
        return self.lengths / self.length if self.length > 0.0 else self.lengths

    @property
    def borders(self) -> Floats:
        """The shares at which segments begin, and 1, shape (n + 1,)."""
        return np.append(self.shares[:: self.per_segment + 1], 1.0)

    def share(self, segment: int, s: Floats) -> Floats:
        """Return the shares of the length at parameters of a segment."""
        own = self.shares.reshape(-1, self.per_segment + 1)[segment]
        return np.asarray(np.interp(s, np.linspace(0.0, 1.0, self.per_segment + 1), own))

    @property
    def heights(self) -> Floats:
        """The rows' heights as shares of the whole height, lowest 0, shape (rows,)."""
        h = self.points[:, 1]
        reach = np.ptp(h)
        return np.asarray((h - h.min()) / reach) if reach > 0.0 else np.zeros_like(h)


def uv_map_of(surface: RevolutionSurface, per_segment: int) -> UVMap:
    """Return the UV map of a surface with ``per_segment`` equal steps of s in each segment.

    Where laws hold it is that of the section at the start angle.
    """
    section = surface.section
    places, inner, weights = _nodes(per_segment)
    points = section.on(places).reshape(-1, 2)
    speed = section.on(inner, 1)
    steps = np.hypot(speed[..., 0], speed[..., 1]).reshape(len(section), per_segment, -1)
    lengths = np.zeros((len(section), per_segment + 1))
    np.cumsum(steps @ weights, axis=1, out=lengths[:, 1:])
    lengths[1:] += np.cumsum(lengths[:-1, -1])[:, None]
    width = float(np.abs(points[:, 0]).max()) * min(surface.sweep, tau)
    return UVMap(lengths.ravel(), points, per_segment, width)


@lru_cache(maxsize=16)
def _nodes(per_segment: int) -> tuple[Floats, Floats, Floats]:
    s = np.linspace(0.0, 1.0, per_segment + 1)
    nodes, weights = gauss(_NODES)
    inner = (s[:-1, None] + nodes / per_segment).ravel()
    return s, inner, np.asarray(weights / per_segment)
