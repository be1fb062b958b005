"""The array types that the core passes around, and how it freezes them."""

from __future__ import annotations

from typing import TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.int64]
Mask: TypeAlias = NDArray[np.bool_]
_Real = TypeVar("_Real", np.float32, np.float64)
# Half as large, for the brightness of pictures.
Singles: TypeAlias = NDArray[np.float32]


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


def box(points: NDArray[_Real]) -> tuple[NDArray[_Real], NDArray[_Real]]:
    """Return the lower and upper corner of the box around points (n, k), n ≥ 1, each shape (k,).

    Column by column, since numpy takes ten times as long along the longer axis of such an array.
    """
    columns = points.T
    low = np.array([column.min() for column in columns], dtype=points.dtype)
    return low, np.array([column.max() for column in columns], dtype=points.dtype)


def distinct(*values: ArrayLike) -> Floats:
    """Return the different numbers of some arrays, increasing.

    numpy's own union loads its masked arrays, which takes longer than most short commands compute.
    """
    found = np.sort(np.concatenate([np.asarray(each, np.float64).ravel() for each in values]))
    different: Floats = found[np.append(True, found[1:] != found[:-1])[: len(found)]]
    return different


def between(places: Floats, count: int) -> tuple[NDArray[np.intp], Floats]:
    """Return which of ``count`` ≥ 2 samples lies before each place, and how far beyond it.

    ``places`` count the samples from 0; a value there is that of the sample times one minus the
    part plus the next one's times the part. Beyond the first and the last the parts go on.
    """
    low = np.clip(np.floor(places), 0, count - 2).astype(np.intp)
    return low, places - low
