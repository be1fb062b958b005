"""The paint of a document as one picture of the unrolled surface.

Column k of w stands at the angle u = (k + ½)/w of the sweep, row j of h (from the bottom) at the
share v = (j + ½)/h of the generatrix' length, so the very same picture serves the screen, GLB
and OBJ. A texture's lattice is turned only by angles at which it closes around without a seam.
"""

from __future__ import annotations

from collections.abc import Callable
from math import gcd

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.document.appearance.cover import (
    Ground,
    cover,
    ground_at,
    pixel_edge,
    share_between,
)
from sgb_core.document.appearance.finishes import FINISHES, base_color
from sgb_core.document.appearance.model import Along, Appearance, Layer, LayerKind, Texture
from sgb_core.document.appearance.pictures import Pixels, picture_aspect, picture_named
from sgb_core.document.appearance.tiling import Tiling, lattice, tilings
from sgb_core.surfaces.uv import UVMap
from sgb_core.values import dataclass

Singles = NDArray[np.float32]
# A picture has at most so many times the pixels across that it is painted with.
_FINER = 1.5
# So many rows are painted at a time, which bounds the memory.
_STRIP = 128


@dataclass(frozen=True, slots=True, eq=False)
class _Canvas:
    """The picture being painted, and where its columns and rows lie on the surface."""

    pixels: Singles
    ground: Ground


def is_painted(appearance: Appearance) -> bool:
    """Whether a picture is needed: one colour alone needs none."""
    return bool(textures_of(appearance) or (appearance.paint and appearance.drawing))


def textures_of(appearance: Appearance) -> tuple[Texture, ...]:
    """Return the textures laid on; a material such as wood brings one of its own."""
    own = FINISHES[appearance.material].texture
    laid = appearance.textures if appearance.paint else ()
    if own is None or any(texture.segments is None for texture in laid):
        return laid
    return (Texture(own, repeat=(3.0, 0.0)), *laid)


def varies_around(appearance: Appearance) -> bool:
    """Whether the paint differs from angle to angle; else one column of it says all."""
    around = any(layer.varies_around for layer in appearance.drawing)
    return (around and appearance.paint) or bool(textures_of(appearance))


def parts_alike(appearance: Appearance) -> int:
    """Return into how many parts of the sweep the paint and its relief divide, all of them alike.

    That is 1 where nothing differs from angle to angle.
    """
    textures = {*textures_of(appearance), *(each for each in appearance.textures if each.relief)}
    counts = [count for texture in textures for count in lattice(texture)]
    counts += [
        layer.count
        for layer in appearance.drawing
        if layer.varies_around and (appearance.paint or layer.relief)
    ]
    return max(1, gcd(*counts))


def follows_shape(appearance: Appearance) -> bool:
    """Whether the picture changes when the profile does.

    Textures over everything with both repeats given, and paint by length, do not.
    """
    textures = textures_of(appearance)
    if any(each.segments is not None or each.repeat[1] == 0.0 for each in textures):
        return True
    return any(
        layer.by is Along.HEIGHT or layer.kind is LayerKind.SEGMENTS for layer in appearance.drawing
    )


def paint(appearance: Appearance, uv_map: UVMap, size: tuple[int, int], parts: int = 1) -> Pixels:
    """Return the painted picture, rows from the bottom, shape (height, width, 3).

    ``size`` is (width, height) in pixels. Only the first of so many ``parts`` of the sweep is
    painted, see :func:`parts_alike`. Raises PictureError where a texture is unknown.
    """
    width, height = size
    v = (np.arange(height) + 0.5) / height
    u = (np.arange(width) + 0.5) / (width * parts)
    ground = ground_at(uv_map, u, v, parts)
    canvas = _Canvas(np.empty((height, width, 3), np.float32), ground)
    canvas.pixels[:] = _rgb(base_color(appearance))
    for texture in textures_of(appearance):
        repeats = max(map(abs, lattice(texture)))
        wide = _FINER * max(1.0, ground.around / max(1, repeats))
        tile = picture_named(appearance, texture.image, wide)
        _lay(canvas, texture, tile, picture_aspect(appearance, texture.image), uv_map)
    for layer in appearance.drawing if appearance.paint else ():
        _draw(canvas, layer)
    return np.asarray(np.rint(canvas.pixels), dtype=np.uint8)


def sample(picture: Pixels, uv: Floats) -> Pixels:
    """Return the colours of a painted picture at (u, v), shape (k, 2): shape (k, 3)."""
    height, width = picture.shape[:2]
    columns = np.clip((uv[:, 0] * width).astype(np.intp), 0, width - 1)
    rows = np.clip((uv[:, 1] * height).astype(np.intp), 0, height - 1)
    return np.asarray(picture[rows, columns])


def _rgb(colour: str) -> Singles:
    return np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)], dtype=np.float32)


# Textures.


def _lay(canvas: _Canvas, texture: Texture, tile: Pixels, aspect: float, uv_map: UVMap) -> None:
    height = len(canvas.ground.v)
    opaque = bool(tile[..., 3].min() == 255)
    if opaque:
        tile = tile[..., :3]
    for tiling in tilings(texture, aspect, uv_map):
        rows = slice(round(tiling.low * height), round(tiling.high * height))
        across = tiling.upwards(canvas.ground.v[rows])
        rows_at = _laid(canvas.ground.u, tiling, tile)
        for begin in range(0, len(across), _STRIP):
            strip = slice(begin, begin + _STRIP)
            pixels = canvas.pixels[rows][strip]
            found = rows_at(across[strip])
            if opaque:
                pixels[:] = found
            else:
                pixels += (found[..., :3] - pixels) * (found[..., 3:] / 255.0)


def tile_values(u: Floats, v: Floats, tiling: Tiling, values: Floats) -> Floats:
    """Return values of a tile's pixels, shape (h, w), as a tiling lays them: (len(v), len(u))."""
    return np.asarray(_laid(u, tiling, values[..., None])(v)[..., 0], dtype=np.float64)


def _laid(u: Floats, tiling: Tiling, tile: Pixels | Floats) -> Callable[[Floats], Singles]:
    """Return what gives the colours (len(v), len(u), channels) of rows v as a tiling lays a tile.

    Where its sides lie along rows and columns, columns are read once for all rows.
    """
    (a, b), (right, up), offset = tiling.around, tiling.along, tiling.offset
    if b == 0.0:
        columns = _columns(tile, a * u + offset[0])
        return lambda v: _read(columns, up * v + offset[1], axis=0)
    if a == 0.0:
        turned = _columns(np.swapaxes(tile, 0, 1), b * u + offset[1])
        return lambda v: _read(turned, right * v + offset[0], axis=0)

    def rows(v: Floats) -> Singles:
        x = a * u + (right * v)[:, None] + offset[0]
        y = b * u + (up * v)[:, None] + offset[1]
        return _bilinear(tile, x, y)

    return rows


def _columns(tile: Pixels | Floats, places: Floats) -> Singles:
    """Return all rows of a tile at places across it, counted in tiles: (h, k, channels)."""
    found = np.empty((len(tile), len(places), tile.shape[2]), np.float32)
    for begin in range(0, len(tile), _STRIP):
        strip = slice(begin, begin + _STRIP)
        found[strip] = _read(tile[strip], places, axis=1)
    return found


def _read(tile: Pixels | Floats | Singles, places: Floats, axis: int) -> Singles:
    """Return a tile's colours at places along one axis, counted in tiles."""
    count = tile.shape[axis]
    pixel = places * count - 0.5
    low = np.floor(pixel)
    first = low.astype(np.intp) % count
    part = (pixel - low).astype(np.float32)
    part = part[:, None, None] if axis == 0 else part[:, None]
    found = tile.take(first, axis).astype(np.float32)
    found += (tile.take((first + 1) % count, axis) - found) * part
    return np.asarray(found)


def _bilinear(tile: Pixels | Floats, x: Floats, y: Floats) -> Singles:
    """Return the tile's colours at places counted in tiles; it repeats in both directions."""
    height, width = tile.shape[:2]
    column, row = x * width - 0.5, y * height - 0.5
    left, low = np.floor(column), np.floor(row)
    right_part = (column - left).astype(np.float32)[..., None]
    upper_part = (row - low).astype(np.float32)[..., None]
    first, below = left.astype(np.intp) % width, low.astype(np.intp) % height
    second, above = (first + 1) % width, (below + 1) % height
    lower = tile[below, first].astype(np.float32)
    lower += (tile[below, second] - lower) * right_part
    upper = tile[above, first].astype(np.float32)
    upper += (tile[above, second] - upper) * right_part
    lower += (upper - lower) * upper_part
    return np.asarray(lower)


# The drawing.


def _draw(canvas: _Canvas, layer: Layer) -> None:
    ground = canvas.ground
    if layer.kind is LayerKind.GRADIENT:
        colour = gradient_colours(layer, ground)[:, None]
    else:
        colour = _rgb(layer.color)
    covered = np.asarray(cover(layer, ground, pixel_edge(layer, ground)), dtype=np.float32)
    canvas.pixels[...] += (colour - canvas.pixels) * covered[..., None]


def gradient_colours(layer: Layer, ground: Ground) -> Singles:
    """Return the colours of a gradient at each row, shape (h, 3), 0 to 255."""
    return mixed_colours(layer, share_between(layer, ground)).astype(np.float32)


def mixed_colours(layer: Layer, part: Floats) -> Floats:
    """Return the colours of a gradient at parts (n,) of its way, shape (n, 3), 0 to 255."""
    stops = np.array([stop[0] for stop in layer.stops])
    colours = np.stack([_rgb(stop[1]) for stop in layer.stops])
    mixed = [np.interp(part, stops, channel) for channel in colours.T]
    return np.stack(mixed, axis=-1)
