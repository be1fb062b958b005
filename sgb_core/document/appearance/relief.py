"""What paint raises or sinks: heights of the unrolled surface, from the very patterns of the paint.

Heights of several layers add up. A band, a stripe or a segment stands at its full depth but for
its soft edge; a texture and a gradient stand as high as their grey says.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.document.appearance.cover import (
    Edge,
    Ground,
    between,
    cover,
    ground_at,
)
from sgb_core.document.appearance.model import (
    Along,
    Appearance,
    Layer,
    LayerKind,
    Raised,
    Texture,
)
from sgb_core.document.appearance.picture_file import Picture
from sgb_core.document.appearance.pictures import GREY, picture_aspect, picture_named
from sgb_core.document.appearance.texture_painting import gradient_colours, tile_values
from sgb_core.document.appearance.tiling import Tiling, lattice, tilings
from sgb_core.surfaces.relief import smooth
from sgb_core.surfaces.uv import UVMap
from sgb_core.values import dataclass

# A step blurred by a bell of this part of the edge as its deviation rises within the edge.
_BELL = 1.0 / 3.0
# Half of the way along the generatrix over which slopes are told, as a share of it.
_NEAR = 1e-3
# A picture has at most so many times the pixels that the mesh has columns.
_FINER = 2.0


@dataclass(frozen=True, slots=True)
class PaintedRelief:
    """The layers and textures of a look that are more than paint."""

    textures: tuple[Texture, ...] = ()
    layers: tuple[Layer, ...] = ()
    pictures: tuple[Picture, ...] = ()

    @property
    def reach(self) -> tuple[float, float]:
        """How far heights may go down (at most 0) and up (at least 0), in the unit."""
        depths = [each.relief for each in self._each]
        return sum(min(depth, 0.0) for depth in depths), sum(max(depth, 0.0) for depth in depths)

    @property
    def edges(self) -> tuple[float, float]:
        """The narrowest and the widest soft edge, in the unit."""
        widths = [each.edge for each in self._each]
        return min(widths), max(widths)

    @property
    def varies_around(self) -> bool:
        """Whether heights differ from angle to angle."""
        return bool(self.textures) or any(layer.varies_around for layer in self.layers)

    def heights(
        self, uv_map: UVMap, sweep: float, u: Floats, v: Floats, least: float, parts: int = 1
    ) -> Floats:
        """Return the heights at columns ``u`` and rows ``v``, shape (len(v), len(u)), in the unit.

        No edge is narrower than ``least``; the columns fill one of so many ``parts`` of the sweep.
        Raises PictureError where a texture is unknown.
        """
        ground = ground_at(uv_map, u, v, parts)
        found = np.zeros((len(v), len(u)))
        for texture in self.textures:
            _add_texture(found, self._look, texture, ground, uv_map, max(texture.edge, least))
        for layer in self.layers:
            _add_layer(found, layer, ground, uv_map, sweep, max(layer.edge, least))
        return found

    @property
    def _each(self) -> tuple[Texture | Layer, ...]:
        return (*self.textures, *self.layers)

    @property
    def _look(self) -> Appearance:
        return Appearance(textures=self.textures, pictures=self.pictures)


def relief_of(appearance: Appearance) -> PaintedRelief | None:
    """Return the relief of a look, None where all of it is paint; colours play no part in it."""
    textures = tuple(each for each in appearance.textures if each.relief != 0.0)
    layers = tuple(
        each if each.kind is LayerKind.GRADIENT else replace(each, color="#000000")
        for each in appearance.drawing
        if each.relief != 0.0
    )
    if not (textures or layers):
        return None
    used = {texture.image for texture in textures}
    pictures = tuple(each for each in appearance.pictures if each.name in used)
    return PaintedRelief(textures, layers, pictures)


def _add_layer(
    found: Floats, layer: Layer, ground: Ground, uv_map: UVMap, sweep: float, edge: float
) -> None:
    length = uv_map.length or 1.0
    slope = np.full_like(ground.v, 1.0 / length)
    if layer.by is Along.HEIGHT:
        low, high = np.clip(ground.v - _NEAR, 0.0, 1.0), np.clip(ground.v + _NEAR, 0.0, 1.0)
        rise = np.interp(high, uv_map.shares, uv_map.heights)
        rise -= np.interp(low, uv_map.shares, uv_map.heights)
        slope = np.abs(rise) / ((high - low) * length)
    radius = np.abs(np.interp(ground.v, uv_map.shares, np.abs(uv_map.points[:, 0])))
    way = np.maximum(radius * sweep, 1e-9 * length)
    lean = layer.twist * slope / max(abs(layer.end - layer.start), 1e-9)
    around = edge * layer.count * np.hypot(1.0 / way, lean)
    soft = Edge(edge * slope, around[:, None], edge, (uv_map.borders, edge / length))
    covered = smooth(cover(layer, ground, soft))
    if layer.kind is LayerKind.GRADIENT:
        covered = covered * (gradient_colours(layer, ground) @ GREY / 255.0)[:, None]
    found += layer.relief * covered


def _add_texture(
    found: Floats, look: Appearance, texture: Texture, ground: Ground, uv_map: UVMap, edge: float
) -> None:
    repeats = max(map(abs, lattice(texture)))
    wide = _FINER * max(1.0, ground.around / max(1, repeats))
    tile = picture_named(look, texture.image, wide)
    grey = tile[..., :3] @ GREY / 255.0
    if texture.raised is Raised.DARK:
        grey = 1.0 - grey
    grey *= tile[..., 3] / 255.0
    soft = np.array(edge / (uv_map.length or 1.0))
    for tiling in tilings(texture, picture_aspect(look, texture.image), uv_map):
        inside = smooth(between(ground.v, tiling.low, tiling.high, soft))
        rows = np.flatnonzero(inside)
        blurred = _blurred(grey, tiling, uv_map, edge)
        values = tile_values(ground.u, tiling.upwards(ground.v[rows]), tiling, blurred)
        found[rows] += texture.relief * inside[rows, None] * values


def _blurred(grey: Floats, tiling: Tiling, uv_map: UVMap, edge: float) -> Floats:
    """Return a tile blurred by a bell that makes its steps rise within the edge.

    It repeats in both directions, so the blur goes round its borders.
    """
    length = (tiling.high - tiling.low) * uv_map.length
    spread = [
        _BELL * edge * np.hypot(around / uv_map.width, along / length)
        for around, along in zip(tiling.around, tiling.along, strict=True)
    ]
    rows, columns = np.fft.fftfreq(grey.shape[0]), np.fft.rfftfreq(grey.shape[1])
    # The transform of a bell of deviation σ is exp(−2 π² σ² f²).
    up, across = (
        np.exp(-2.0 * (np.pi * share * count * rate) ** 2)
        for share, count, rate in (
            (spread[1], grey.shape[0], rows),
            (spread[0], grey.shape[1], columns),
        )
    )
    kept = np.fft.rfft2(grey) * up[:, None] * across
    return np.asarray(np.fft.irfft2(kept, grey.shape))
