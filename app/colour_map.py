"""A perceptually uniform map from numbers to colours: viridis, from 17 of its own colours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats

# Viridis of matplotlib (CC0) at equal steps; linear between them it stays within 1 of 255.
STOPS = (
    "#440154",
    "#48186a",
    "#472d7b",
    "#424086",
    "#3b528b",
    "#33638d",
    "#2c728e",
    "#26828e",
    "#21918c",
    "#1fa088",
    "#28ae80",
    "#3fbc73",
    "#5ec962",
    "#84d44b",
    "#addc30",
    "#d8e219",
    "#fde725",
)
_STOPS = np.array([[int(stop[k : k + 2], 16) for k in (1, 3, 5)] for stop in STOPS], float)


def colours(parts: Floats) -> NDArray[np.uint8]:
    """Return the colours of numbers from 0 to 1, shape (*parts.shape, 3); nan counts as 0."""
    x = np.clip(np.nan_to_num(parts), 0.0, 1.0) * (len(_STOPS) - 1)
    low = np.minimum(x.astype(int), len(_STOPS) - 2)
    share = (x - low)[..., None]
    mixed = (1.0 - share) * _STOPS[low] + share * _STOPS[low + 1]
    return np.asarray(np.rint(mixed), dtype=np.uint8)
