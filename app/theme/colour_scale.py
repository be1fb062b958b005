"""From numbers to colours by the program's own perceptually uniform table."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

import resources
from sgb_core.arrays import Floats

NAME = "viridis"


@cache
def table() -> NDArray[np.uint8]:
    """Return the colours from low to high, shape (k, 3)."""
    lines = resources.read(f"colour_maps/{NAME}.txt").decode("ascii").split()
    return np.array([[int(line[k : k + 2], 16) for k in (1, 3, 5)] for line in lines], np.uint8)


def colours(parts: Floats) -> NDArray[np.uint8]:
    """Return the colours of numbers from 0 to 1, shape (*parts.shape, 3); nan counts as 0."""
    shades = table().astype(float)
    x = np.clip(np.nan_to_num(parts), 0.0, 1.0) * (len(shades) - 1)
    low = np.minimum(x.astype(int), len(shades) - 2)
    share = (x - low)[..., None]
    mixed = (1.0 - share) * shades[low] + share * shades[low + 1]
    return np.asarray(np.rint(mixed), dtype=np.uint8)
