"""How a texture's tiles lie on what they cover: where a tile is, and moving them on the surface.

A tile is counted by x to its right and y upwards, both affine in the share u of the turn and in
the share w of the covered length, which runs upwards whichever way the profile was drawn.
"""

from __future__ import annotations

from dataclasses import replace
from math import cos, floor, radians, sin

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.document.appearance.model import MAX_REPEATS, Texture
from sgb_core.surfaces.uv import UVMap
from sgb_core.values import dataclass

# Where the middle of a tile lies outside of what is covered, it is taken to be this far inside.
_INSIDE = 0.05


def lattice(texture: Texture) -> tuple[int, int]:
    """Return how many tiles lie once around, in both directions of the lattice: no seam."""
    around, turn = texture.repeat[0], radians(texture.rotate_deg)
    a, b = round(around * cos(turn)), round(around * sin(turn))
    return (max(1, round(around)), 0) if a == b == 0 else (a, b)


@dataclass(frozen=True, slots=True)
class Tiling:
    """A texture on one stretch of the generatrix, from the share ``low`` of its length to ``high``.

    ``falls`` says that the profile runs downwards there. Tiles are at
    x = ``around``[0] u + ``along``[0] w + offset, y = ``around``[1] u + ``along``[1] w + offset.
    """

    low: float
    high: float
    falls: bool
    around: tuple[float, float]
    along: tuple[float, float]
    offset: tuple[float, float]

    def upwards(self, v: Floats) -> Floats:
        """Return w at shares v of the generatrix' length."""
        share = (v - self.low) / (self.high - self.low)
        return 1.0 - share if self.falls else share

    def centre(self, u: float) -> tuple[float, float]:
        """Return (u, v) of the middle of the tile that lies at ``u``, halfway along."""
        columns = np.array((self.around, self.along)).T
        here = columns @ (u, 0.5) + self.offset
        inside = np.array([floor(part) + 0.5 for part in here])
        around, w = np.linalg.solve(columns, inside - self.offset).tolist()
        w = min(max(w, _INSIDE), 1.0 - _INSIDE)
        share = 1.0 - w if self.falls else w
        return around, self.low + share * (self.high - self.low)

    def moved(self, texture: Texture, du: float, dv: float) -> Texture:
        """Return the texture with what is seen moved by ``du`` around and ``dv`` along."""
        dw = (-dv if self.falls else dv) / (self.high - self.low)
        shifts = [
            old - (around * du + along * dw)
            for old, around, along in zip(texture.offset, self.around, self.along, strict=True)
        ]
        # Whole tiles show no difference.
        x, y = (each % 1.0 if abs(each) > MAX_REPEATS else each for each in shifts)
        return replace(texture, offset=(x, y))


def tilings(texture: Texture, aspect: float, uv_map: UVMap) -> list[Tiling]:
    """Return how a texture lies on each stretch that it covers, empty ones left out.

    ``aspect`` is the height of its picture over the width.
    """
    borders = uv_map.borders
    ranges = [(0.0, 1.0)]
    if texture.segments is not None:
        known = [k for k in texture.segments if k < len(borders) - 1]
        ranges = [(float(borders[k]), float(borders[k + 1])) for k in known]
    return [_tiling(texture, aspect, uv_map, *ends) for ends in ranges if ends[1] > ends[0]]


def _tiling(texture: Texture, aspect: float, uv_map: UVMap, low: float, high: float) -> Tiling:
    # Pictures stand upright, whichever way the profile was drawn.
    first, last = np.interp((low, high), uv_map.shares, uv_map.heights)
    repeats, along = texture.repeat
    if along == 0.0:
        along = repeats * (high - low) * uv_map.length / (uv_map.width * aspect)
    a, b = lattice(texture)
    # Rotation in the plane of the tiles, whose sides need not be equally long.
    stretch = along / repeats
    if b == 0:
        way = (0.0, along if a > 0 else -along)
    elif a == 0:
        way = ((-along if b > 0 else along) * aspect, 0.0)
    else:
        way = (-b * stretch * aspect, a * stretch)
    return Tiling(low, high, bool(last < first), (float(a), float(b)), way, texture.offset)
