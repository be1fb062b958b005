"""How much of a segment's marks is shown where segments crowd: they give way to the shape."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats

# Marks nearer to each other than CLEAR pixels are left out, from ROOMY on they are shown in full.
CLEAR = 12.0
ROOMY = 40.0
# How many legs of room an end counts as having; from joint to joint there are three.
ENDS = 2.0


def leg_lengths(points: Floats) -> Floats:
    """Return the mean length of each segment's legs; ``points`` is (n, 4, k), the result (n,)."""
    steps = np.diff(points, axis=1)
    return np.asarray(np.sqrt((steps**2).sum(axis=-1)).mean(axis=1))


def presence(pixels: ArrayLike) -> Floats:
    """Return how much is shown at mean leg lengths in pixels: 0 for nothing, 1 for all."""
    spare = (np.asarray(pixels, dtype=np.float64) - CLEAR) / (ROOMY - CLEAR)
    # What is shown at all is shown so that it can be seen.
    return np.where(spare < 0.0, 0.0, np.clip(spare, 0.15, 1.0))


def segment_presence(places: Floats, lit: Collection[int]) -> Floats:
    """Return for each segment how much of its marks is shown, those that are ``lit`` in full.

    ``places``, shape (n, 4, 2), are the control points in pixels.
    """
    found = presence(leg_lengths(places))
    found[[k for k in lit if k < len(found)]] = 1.0
    return found


def end_presence(places: Floats, lit: Collection[int]) -> Floats:
    """Return the same for the ends of segments, which lie farther apart than their handles."""
    found = presence(ENDS * leg_lengths(places))
    found[[k for k in lit if k < len(found)]] = 1.0
    return found


def shown_points(places: Floats, lit: Collection[int]) -> np.ndarray:
    """Return which control points are shown, and so can be grabbed: shape (n, 4), true or false."""
    ends, inner = end_presence(places, lit) > 0.0, segment_presence(places, lit) > 0.0
    return np.stack([ends, inner, inner, ends], axis=1)
