"""Textures run on over both halves of a divided segment, as they lay on the whole."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.curves.nearest import arc_length
from sgb_core.document.appearance.model import Texture
from sgb_core.document.appearance.pictures import PictureError, picture_aspect
from sgb_core.document.appearance.tiling import lattice
from sgb_core.document.model import Document
from sgb_core.surfaces.uv import uv_map_of

# Steps of s in a segment with which the widest place is found.
_STEPS = 64


def texture_halves(document: Document, index: int) -> Document:
    """Return a document whose segments ``index`` and the next were one until now.

    Each half takes its part of the tiles that lay on the whole, and begins where the other ends.
    Where the heights turn back between the halves, the lower side of each picture is down, as
    everywhere.
    """
    look = document.appearance
    textures = tuple(each for old in look.textures for each in _halves(document, old, index))
    if textures == look.textures:
        return document
    return replace(document, appearance=replace(look, textures=textures))


def _halves(document: Document, texture: Texture, index: int) -> list[Texture]:
    if texture.segments is None or index not in texture.segments:
        return [texture]
    first, second = document.profile.segments[index : index + 2]
    lengths = [arc_length(first), arc_length(second)]
    whole = sum(lengths)
    if whole == 0.0:
        return [texture]
    aspect = _aspect(document, texture)
    around, along = texture.repeat
    if along == 0.0:
        width = uv_map_of(document.surface, _STEPS).width
        along = around * whole / (max(width, 1e-300) * aspect)
    # Pictures stand upright: they begin at the lower end.
    downward = second.points[3, 1] < first.points[0, 1]
    begins = (lengths[1], 0.0) if downward else (0.0, lengths[0])
    others = tuple(k for k in texture.segments if k not in (index, index + 1))
    parts = [replace(texture, segments=others)] if others else []
    for half, (length, begin) in enumerate(zip(lengths, begins, strict=True)):
        tiles = along * begin / whole
        parts.append(
            replace(
                texture,
                segments=(index + half,),
                repeat=(around, texture.repeat[1] * length / whole),
                offset=_moved(texture, tiles, aspect),
            )
        )
    return parts


def _moved(texture: Texture, tiles: float, aspect: float) -> tuple[float, float]:
    """Return the offset of a texture that begins so many tiles farther along."""
    a, b = lattice(texture)
    if b == 0:
        step = (0.0, tiles if a > 0 else -tiles)
    elif a == 0:
        step = (-aspect * (tiles if b > 0 else -tiles), 0.0)
    else:
        step = (-b * aspect * tiles / texture.repeat[0], a * tiles / texture.repeat[0])
    x, y = (round((old + by) % 1.0, 9) for old, by in zip(texture.offset, step, strict=True))
    return x, y


def _aspect(document: Document, texture: Texture) -> float:
    """Return the height of a texture's tile over its width; those of the program are square."""
    try:
        return picture_aspect(document.appearance, texture.image)
    except PictureError:
        return 1.0
