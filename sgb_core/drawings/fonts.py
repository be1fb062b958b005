"""The letters of drawings: how wide words are, and the part of the font that a file needs."""

from __future__ import annotations

import logging
from functools import lru_cache
from io import BytesIO
from pathlib import Path

from sgb_core.lettering.fonts import font_of

# It has λ, κ, ⌀ and ∞, and may be embedded.
FAMILY = "DejaVu Sans"


@lru_cache(maxsize=1)
def _capitals() -> float:
    """Return how high capitals are, as a part of the em."""
    font = font_of()
    return float(font["glyf"]["H"].yMax / font["head"].unitsPerEm)


@lru_cache(maxsize=4096)
def _advance(letter: str) -> float:
    font = font_of()
    name = font.getBestCmap().get(ord(letter), ".notdef")
    return float(font["hmtx"][name][0] / font["head"].unitsPerEm)


def em(height: float) -> float:
    """Return the size of the font whose capitals have a height, in the same unit."""
    return height / _capitals()


def width(text: str, height: float) -> float:
    """Return how wide a line of words is whose capitals have a height, in the same unit."""
    return em(height) * sum(map(_advance, text))


def fitted(text: str, height: float, room: float) -> str:
    """Return words as they are, or as much of them as there is room for, with an ellipsis."""
    text = " ".join(text.split())
    if width(text, height) <= room:
        return text
    while text and width(f"{text}…", height) > room:
        text = text[:-1]
    return f"{text.rstrip()}…"


def subset(path: Path, letters: str, flavour: str | None = None) -> bytes:
    """Return a font with these letters alone, as TrueType or in another ``flavour`` ("woff")."""
    from fontTools import subset as subsetting
    from fontTools.ttLib import TTFont

    # It tells of every table that a text on a page does not need.
    logging.getLogger("fontTools").setLevel(logging.ERROR)
    options = subsetting.Options(layout_features=[], notdef_outline=True, flavor=flavour)
    font = TTFont(path, recalcTimestamp=False)
    maker = subsetting.Subsetter(options)
    maker.populate(text=letters)
    maker.subset(font)
    font.flavor = flavour
    stream = BytesIO()
    font.save(stream)
    return stream.getvalue()
