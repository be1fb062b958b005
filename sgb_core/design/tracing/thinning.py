"""Fewer points that stand for many, so that a search is quick."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.tracing.solver import Cloud

# So many points are searched as they are; more are thinned to about as many groups.
_MOST, _GROUPS = 400, 160
# The weight of a group's extreme points, beside its own.
_LIGHT = 1e-3


def thinned(cloud: Cloud) -> Cloud:
    """Return a cloud in which groups of neighbouring points are replaced by three.

    The first stands for the group, with all its weight: the middle of the parabola nearest to
    it, which is near a bent path too. The other two are those farthest to either side; nearly
    without weight, they only tell how far the largest distance is.
    """
    real = np.flatnonzero(cloud.slack == 0.0)
    size = 2 * (len(real) // (2 * _GROUPS)) + 1
    if len(real) <= _MOST or size < 3:
        return cloud
    count = len(real) // size
    # Left over are the last ones: they stay single points, as the ends are.
    grouped = real[1 : 1 + size * ((len(real) - 2) // size)].reshape(-1, size)
    count = len(grouped)
    points = cloud.points[grouped]
    middles = np.einsum("j,ijk->ik", _middle_weights(size), points)
    along = np.gradient(middles, axis=0)
    length = np.hypot(along[:, 0], along[:, 1])
    sides = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.where(length > 0, length, 1)[:, None]
    off = np.einsum("ijk,ik->ij", points - middles[:, None], sides)
    rows = np.arange(count)
    extremes = np.concatenate(
        [grouped[rows, off.argmin(axis=1)], grouped[rows, off.argmax(axis=1)]]
    )
    single = np.setdiff1d(np.arange(len(cloud.points)), grouped)
    kept = np.concatenate([single, extremes])
    others = cloud.part(kept)
    heavy = np.concatenate([others.weights[: len(single)], np.full(2 * count, _LIGHT)])
    shares = np.where(np.arange(len(kept)) < len(single), others.shares, 0.0)
    order = np.concatenate([kept.astype(np.float64), grouped[:, size // 2] + 0.5])
    place = np.argsort(order, kind="stable")
    return replace(
        cloud,
        points=np.concatenate([others.points, middles])[place],
        weights=np.concatenate([heavy, cloud.weights[grouped].sum(axis=1)])[place],
        along=np.concatenate([others.along, cloud.along[grouped].mean(axis=1)])[place],
        shares=np.concatenate([shares, cloud.shares[grouped].sum(axis=1)])[place],
        slack=np.concatenate([others.slack, np.zeros(count)])[place],
    )


def _middle_weights(size: int) -> Floats:
    """Return the weights whose sum is the middle value of the nearest parabola: Savitzky, Golay."""
    marks = np.arange(size) - size // 2
    weights = (3.0 * size**2 - 7.0 - 20.0 * marks**2) / 4.0
    return np.asarray(weights / weights.sum())
