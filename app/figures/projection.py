"""Where a point of space lies in a panel, and whether the surface hides it there.

The same pose that draws the raster projects the curves, so both agree to rounding. A panel's
coordinates are half-heights from its middle: x from −aspect to aspect, y from −1 to 1.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter

from app.figures.plate import Array
from app.scene.camera import MARGIN, Pose

# A point is hidden where the surface lies nearer to the viewer by more than this part of the size.
NEARER = 2e-3


def project(pose: Pose, points: NDArray[np.float64]) -> tuple[Array, Array]:
    """Return (x, y), shape (..., 2), and the distance from the viewer's plane, shape (...)."""
    eye = (points - np.asarray(pose.focal)) @ pose.basis.T
    depth = pose.distance - eye[..., 2]
    shrink = 1.0 if pose.parallel else (depth / pose.distance)[..., None]
    return eye[..., :2] / (pose.parallel_scale * shrink), depth


def farthest_about(depth_map: Array) -> Array:
    """Return the farthest depth among the nine pixels about each: what :func:`hidden` asks for."""
    farthest: Array = maximum_filter(depth_map, size=3, mode="nearest")
    return farthest


def hidden(
    farthest: Array, seen: Array, depth: Array, aspect: float, size: float
) -> NDArray[np.bool_]:
    """Return which of the points the surface hides, shape (N,).

    ``seen`` (N, 2) and ``depth`` (N,) come from :func:`project`, ``farthest`` from the depths of
    the raster by :func:`farthest_about`. Beside its outline a line in the surface must not
    flicker, so a point is hidden only where all of the nine pixels about it are nearer.
    """
    rows, columns = farthest.shape
    column = np.floor((seen[:, 0] / aspect + 1.0) / 2.0 * columns).astype(int)
    row = np.floor((1.0 - seen[:, 1]) / 2.0 * rows).astype(int)
    inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows)
    nearest = np.full(len(seen), np.inf)
    nearest[inside] = farthest[row[inside], column[inside]]
    return depth > nearest + NEARER * size


def runs(flags: NDArray[np.bool_]) -> Iterator[tuple[int, int, bool]]:
    """Yield (first, last, flag) of the stretches of a polyline; neighbours share a point.

    Single points between two of the other kind are rounding and join their neighbours.
    """
    flags = flags.copy()
    if len(flags) > 2:
        lone = (flags[1:-1] != flags[:-2]) & (flags[1:-1] != flags[2:])
        flags[1:-1][lone] = flags[:-2][lone]
    changes = np.flatnonzero(flags[1:] != flags[:-1]) + 1
    starts = [0, *changes.tolist()]
    ends = [*changes.tolist(), len(flags) - 1]
    for first, last in zip(starts, ends, strict=True):
        yield first, last, bool(flags[first])


def natural_aspect(pose: Pose, clouds: Sequence[Array]) -> float:
    """Return width over height of what is seen of the points, between 0.45 and 2.4."""
    points = np.concatenate(clouds)
    seen, _ = project(pose.fitted(points, 1.0), points)
    # The margins are the same on all sides, so they make a slender panel less so.
    extent = np.ptp(seen, axis=0)
    room = MARGIN / (1.0 - MARGIN) * max(extent.max(), 1e-9)
    return float(np.clip((extent[0] + room) / (extent[1] + room), 0.45, 2.4))
