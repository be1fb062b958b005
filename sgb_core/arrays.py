"""The array types that the core passes around, and how it freezes them."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.int64]


def frozen(values: ArrayLike) -> Floats:
    """Return a read-only float64 copy of ``values``, in C order."""
    array = np.array(values, dtype=np.float64, order="C")
    array.flags.writeable = False
    return array


def frozen_ints(values: ArrayLike) -> Ints:
    """Return a read-only int64 copy of ``values``, in C order."""
    array = np.array(values, dtype=np.int64, order="C")
    array.flags.writeable = False
    return array
