"""The fonts that text is set in, and where their files lie."""

from __future__ import annotations

from enum import StrEnum
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

# They come with matplotlib, hold Latin, Greek and Cyrillic letters, and may be embedded.
_FOLDER = "mpl-data/fonts/ttf"


class FontName(StrEnum):
    """A font that every copy of the program has."""

    SANS = "sans"
    SANS_BOLD = "sans-bold"
    SERIF = "serif"
    SERIF_BOLD = "serif-bold"
    SERIF_ITALIC = "serif-italic"
    BOOK = "book"
    BOOK_BOLD = "book-bold"
    MONO_BOLD = "mono-bold"


TITLES = {
    FontName.SANS: "Sans",
    FontName.SANS_BOLD: "Sans bold",
    FontName.SERIF: "Serif",
    FontName.SERIF_BOLD: "Serif bold",
    FontName.SERIF_ITALIC: "Serif italic",
    FontName.BOOK: "Book",
    FontName.BOOK_BOLD: "Book bold",
    FontName.MONO_BOLD: "Typewriter bold",
}
_FILES = {
    FontName.SANS: "DejaVuSans.ttf",
    FontName.SANS_BOLD: "DejaVuSans-Bold.ttf",
    FontName.SERIF: "DejaVuSerif.ttf",
    FontName.SERIF_BOLD: "DejaVuSerif-Bold.ttf",
    FontName.SERIF_ITALIC: "DejaVuSerif-Italic.ttf",
    FontName.BOOK: "STIXGeneral.ttf",
    FontName.BOOK_BOLD: "STIXGeneralBol.ttf",
    FontName.MONO_BOLD: "DejaVuSansMono-Bold.ttf",
}


def font_path(name: FontName = FontName.SANS) -> Path:
    """Return the file of a font, found without loading what it comes with."""
    found = find_spec("matplotlib")
    if found is None or found.origin is None:
        raise FileNotFoundError(_FILES[name])
    return Path(found.origin).parent / _FOLDER / _FILES[name]


@lru_cache(maxsize=len(_FILES))
def font_of(name: FontName = FontName.SANS) -> Any:
    """Return a font as fontTools reads it."""
    from fontTools.ttLib import TTFont

    # Read whole and closed: a lazy font keeps its file open.
    return TTFont(font_path(name))
