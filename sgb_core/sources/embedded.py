"""A picture made fit to be kept in a project: within its limits, with its places following."""

from __future__ import annotations

import io
from dataclasses import replace
from math import sqrt

from sgb_core.document.appearance.picture_file import (
    MAX_PICTURE_BYTES,
    MAX_PIXELS,
    Picture,
    PictureError,
    check_picture,
)
from sgb_core.document.reference import Reference

# How a larger picture is kept: as JPEG of this quality, made smaller until it fits.
_QUALITY, _SMALLER = 85, 0.7
# The tag that tells how a camera was held.
_ORIENTATION = 0x0112


def embedded(source: Reference, data: bytes) -> Reference:
    """Return a reference with its picture, the bytes of a PNG or JPEG file that can be read.

    One beyond the limits of a project is kept smaller, and one that a camera took askew upright;
    places in it count its own pixels.
    """
    try:
        check_picture(data)
        fits = _lies_upright(data)
    except PictureError:
        fits = False
    if not fits:
        data, factor = _smaller(data)
        # A pixel's middle is a whole number: edges lie half a pixel before.
        x, y = (factor * (place + 0.5) - 0.5 for place in source.origin)
        axis = tuple(factor * (place + 0.5) - 0.5 for place in source.axis)
        source = replace(source, origin=(x, y), axis=axis, scale=source.scale / factor)
    return replace(source, picture=Picture(data))


def _lies_upright(data: bytes) -> bool:
    from PIL import Image

    with Image.open(io.BytesIO(data), formats=["PNG", "JPEG"]) as picture:
        return int(picture.getexif().get(_ORIENTATION, 1)) == 1


def _smaller(data: bytes) -> tuple[bytes, float]:
    """Return a picture within the limits, and how many times as wide as before it is."""
    from PIL import Image, ImageOps

    with Image.open(io.BytesIO(data), formats=["PNG", "JPEG"]) as picture:
        whole = ImageOps.exif_transpose(picture).convert("RGB")
    factor = min(1.0, sqrt(MAX_PIXELS / (whole.width * whole.height)))
    while True:
        size = (max(1, int(whole.width * factor)), max(1, int(whole.height * factor)))
        stream = io.BytesIO()
        whole.resize(size, Image.Resampling.LANCZOS).save(stream, "JPEG", quality=_QUALITY)
        if len(stream.getvalue()) <= MAX_PICTURE_BYTES:
            return stream.getvalue(), size[0] / whole.width
        factor *= _SMALLER
