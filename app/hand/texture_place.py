"""Where a texture is grabbed: at the middle of one of its tiles, which moves with the picture."""

from __future__ import annotations

import numpy as np

from app.hand.coordinates import number as number_of
from sgb_core.document import edits
from sgb_core.document.appearance.pictures import PictureError, picture_aspect
from sgb_core.document.appearance.tiling import Tiling, tilings
from sgb_core.document.model import Document
from sgb_core.surfaces.uv import UVMap, uv_map_of

# Steps of s in a segment by which places along the generatrix are found.
STEPS = 48


def unrolled(document: Document) -> UVMap:
    """Return how the document's surface unrolls."""
    return uv_map_of(document.surface, STEPS)


def laid(document: Document, number: int, on: UVMap) -> Tiling | None:
    """Return how a texture lies on the first stretch it covers; None where it covers nothing."""
    # Imported late: only a texture needs the pictures that come with the program.
    import resources.library  # noqa: F401

    texture = document.appearance.textures[number]
    try:
        aspect = picture_aspect(document.appearance, texture.image)
    except PictureError:
        return None
    return next(iter(tilings(texture, aspect, on)), None)


def moved(document: Document, number: int, du: float, dv: float) -> Document:
    """Return the document with a texture moved by shares of the turn and of the length."""
    tiling = laid(document, number, unrolled(document))
    if tiling is None:
        return document
    textures = list(document.appearance.textures)
    textures[number] = tiling.moved(textures[number], du, dv)
    return edits.set_appearance(document, textures=tuple(textures))


def place_at(on: UVMap, v: float) -> tuple[float, float]:
    """Return the (r, h) at a share of the generatrix' length."""
    r, h = (float(np.interp(v, on.shares, column)) for column in on.points.T)
    return r, h


def told(document: Document, number: int) -> list[str]:
    """Return what the heads-up label says of a texture."""
    x, y = document.appearance.textures[number].offset
    return ["Texture", f"shifted {number_of(x, 2)} × {number_of(y, 2)} pictures"]
