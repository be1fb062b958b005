"""The colours of the maps: tables from low to high, by name, and which of them a map takes."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.document.appearance.colour_maps import is_diverging
from sgb_core.document.appearance.model import ColourMap, Scale
from sgb_core.document.appearance.pictures import Pixels

_library: list[Callable[[str], bytes]] = []


def set_tables(read: Callable[[str], bytes]) -> None:
    """Say where the tables come from: by name, text of one #rrggbb a line, from low to high."""
    _library[:] = [read]
    table.cache_clear()


def scale_of(shown: ColourMap, low: float, high: float) -> str:
    """Return the name of the colour table of a map with these limits."""
    if shown.scale is not Scale.AUTO:
        return shown.scale.value
    return "diverging" if is_diverging(shown, low, high) else "viridis"


@cache
def table(name: str) -> Pixels:
    """Return a colour table, shape (k, 3), from low to high; greys where none are known."""
    if not _library:
        return np.repeat(np.arange(256, dtype=np.uint8)[:, None], 3, axis=1)
    lines = _library[0](name).decode("ascii").split()
    return np.array([[int(line[k : k + 2], 16) for k in (1, 3, 5)] for line in lines], np.uint8)


def colours(name: str, shares: Floats) -> Pixels:
    """Return a table's colours of numbers from 0 to 1, nan as 0: shape (*shares.shape, 3)."""
    shades = table(name).astype(float)
    x = np.clip(np.nan_to_num(shares), 0.0, 1.0) * (len(shades) - 1)
    low = np.minimum(x.astype(int), len(shades) - 2)
    part = (x - low)[..., None]
    mixed = (1.0 - part) * shades[low] + part * shades[low + 1]
    return np.asarray(np.rint(mixed), dtype=np.uint8)
