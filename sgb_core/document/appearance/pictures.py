"""Pictures as arrays of pixels: the program's textures by name, and the user's own by hash."""

from __future__ import annotations

import io
from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from sgb_core.document.appearance.model import Appearance
from sgb_core.document.appearance.picture_file import FORMATS, PictureError, check_picture
from sgb_core.findings.pictures import NoPicture, NoTexture

__all__ = [
    "PictureError",
    "Pixels",
    "check_picture",
    "decode",
    "encode_png",
    "picture_named",
    "set_library",
]

Pixels = NDArray[np.uint8]

_library: list[Callable[[str], bytes]] = []


def set_library(read: Callable[[str], bytes]) -> None:
    """Say where the program's own textures come from, by their names.

    ``read`` raises FileNotFoundError for a name that it does not know.
    """
    _library[:] = [read]
    _decoded.cache_clear()


def decode(data: bytes) -> Pixels:
    """Return a picture's rows from the bottom, shape (h, w, 4), RGBA."""
    from PIL import Image

    check_picture(data)
    try:
        with Image.open(io.BytesIO(data), formats=FORMATS) as image:
            rows = np.asarray(image.convert("RGBA"))
    except (OSError, ValueError, SyntaxError):
        raise PictureError(NoPicture.DAMAGED) from None
    return np.ascontiguousarray(rows[::-1])


def encode_png(pixels: Pixels) -> bytes:
    """Return a PNG file of pixels of shape (h, w, 3 or 4), rows from the bottom."""
    from PIL import Image

    stream = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(pixels[::-1])).save(stream, "PNG")
    return stream.getvalue()


@lru_cache(maxsize=16)
def _decoded(data: bytes) -> Pixels:
    return decode(data)


@lru_cache(maxsize=32)
def _of_library(name: str, read: Callable[[str], bytes]) -> Pixels:
    return decode(read(name))


def picture_named(appearance: Appearance, name: str) -> Pixels:
    """Return the pixels of one of the document's pictures, or of a texture of the program.

    Shape (h, w, 4), rows from the bottom. Raises PictureError where there is none of that name.
    """
    own = appearance.picture(name)
    if own is not None:
        return _decoded(own.data)
    try:
        if _library:
            return _of_library(name, _library[0])
    except FileNotFoundError:
        pass
    raise PictureError(NoTexture(name))
