"""Pictures as arrays of pixels: the program's textures by name, and the user's own by hash."""

from __future__ import annotations

import io
from collections import OrderedDict
from collections.abc import Callable
from math import floor, inf
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from sgb_core.document.appearance.model import Appearance
from sgb_core.document.appearance.picture_file import FORMATS, PictureError, check_picture
from sgb_core.findings.pictures import NoPicture, NoTexture

__all__ = [
    "GREY",
    "PictureError",
    "Pixels",
    "check_picture",
    "decode",
    "encode_png",
    "picture_aspect",
    "picture_named",
    "set_library",
]

Pixels = NDArray[np.uint8]
# Grey of red, green and blue, as ITU-R BT.601 weighs them.
GREY = np.array([0.299, 0.587, 0.114])

# So many bytes of pictures are kept as they were painted last.
_KEPT_BYTES = 96 << 20

_library: list[Callable[[str], bytes]] = []
_kept: OrderedDict[tuple[str, int], Pixels] = OrderedDict()
# The sides of so many pictures, of which a drag asks at each tick.
_KEPT_ASPECTS = 1000
_aspects: dict[str, float] = {}
_keeping = Lock()


def set_library(read: Callable[[str], bytes]) -> None:
    """Say where the program's own textures come from, by their names.

    ``read`` raises FileNotFoundError for a name that it does not know.
    """
    _library[:] = [read]
    with _keeping:
        _kept.clear()
        _aspects.clear()


def decode(data: bytes, wide: float = inf) -> Pixels:
    """Return a picture's rows from the bottom, shape (h, w, 4), RGBA.

    It is halved by averages while it is wider than ``wide``.
    """
    from PIL import Image

    check_picture(data)
    try:
        with Image.open(io.BytesIO(data), formats=FORMATS) as file:
            image: Image.Image = file
            factor, (width, height) = 1, image.size
            while min(width, height) >= 4 and width > wide:
                factor, width, height = 2 * factor, width // 2, height // 2
            if image.mode not in ("L", "RGB", "RGBA"):
                image = image.convert("RGBA")
            if factor > 1:
                image = image.reduce(factor)
            rows = np.asarray(image.convert("RGBA"))
    except (OSError, ValueError, SyntaxError):
        raise PictureError(NoPicture.DAMAGED) from None
    return rows[::-1]


def encode_png(pixels: Pixels) -> bytes:
    """Return a PNG file of pixels of shape (h, w, 3 or 4), rows from the bottom."""
    from PIL import Image

    stream = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(pixels[::-1])).save(stream, "PNG")
    return stream.getvalue()


def _bytes_of(appearance: Appearance, name: str) -> bytes:
    own = appearance.picture(name)
    if own is not None:
        return own.data
    try:
        if _library:
            return _library[0](name)
    except FileNotFoundError:
        pass
    raise PictureError(NoTexture(name))


def picture_named(appearance: Appearance, name: str, wide: float = inf) -> Pixels:
    """Return the pixels of one of the document's pictures, or of a texture of the program.

    Shape (h, w, 4), rows from the bottom, halved while wider than ``wide``. Raises PictureError
    where there is none of that name.
    """
    key = (name, floor(min(wide, 1e9)))
    with _keeping:
        if key in _kept:
            _kept.move_to_end(key)
            return _kept[key]
    pixels = decode(_bytes_of(appearance, name), wide)
    with _keeping:
        _kept[key] = pixels
        while sum(each.nbytes for each in _kept.values()) > _KEPT_BYTES:
            _kept.popitem(last=False)
    return pixels


def picture_aspect(appearance: Appearance, name: str) -> float:
    """Return the height over the width of a picture; raises PictureError as above."""
    known = _aspects.get(name)
    if known is not None:
        return known
    from PIL import Image

    data = _bytes_of(appearance, name)
    check_picture(data)
    with Image.open(io.BytesIO(data), formats=FORMATS) as image:
        aspect = image.size[1] / image.size[0]
    with _keeping:
        if len(_aspects) >= _KEPT_ASPECTS:
            _aspects.clear()
        _aspects[name] = aspect
    return aspect
