"""The axis of a body of revolution from points of its surface, robustly."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints
from sgb_core.findings.sources import NoSource
from sgb_core.sources.errors import SourceError
from sgb_core.values import dataclass

# Points drawn from the surface, always the same ones; so many are used to find the axis.
_SAMPLES, _USED, _SEED = 200_000, 12_000, 15
# Rounds from each start, and to the end.
_ROUNDS, _LAST_ROUNDS = 12, 60
# Cells along the axis in which the radius is compared, and the least points of one.
_CELLS, _LEAST = 48, 12
# The scale of the robust weights, in medians of the departures.
_SCALE = 2.0
# A sharper look at the end: outliers count for less.
_SETTLED = 1e-9


@dataclass(frozen=True, slots=True)
class AxisLine:
    """A line: a point of it and its unit direction, both of shape (3,)."""

    point: Floats
    direction: Floats

    def frame(self) -> Floats:
        """Return three unit vectors, rows of shape (3, 3): two across the axis, then along it."""
        helper = np.eye(3)[int(np.argmin(np.abs(self.direction)))]
        first = np.cross(helper, self.direction)
        first /= np.linalg.norm(first)
        return np.stack([first, np.cross(self.direction, first), self.direction])

    def cylindrical(self, points: Floats) -> tuple[Floats, Floats, Floats]:
        """Return radius, angle and height along the axis of points, each of shape (N,)."""
        x, y, h = self.frame() @ (points - self.point).T
        return np.hypot(x, y), np.arctan2(y, x), h


def surface_samples(vertices: Floats, faces: Ints) -> tuple[Floats, Floats]:
    """Return points spread evenly over the triangles and their unit normals, (N, 3) each."""
    corners = vertices[faces]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    doubled = np.linalg.norm(cross, axis=1)
    total = float(doubled.sum())
    if total <= 0.0:
        raise SourceError(NoSource.NO_AREA)
    rng = np.random.default_rng(_SEED)
    # Stratified along the running area: even, and each triangle about as often as it should.
    marks = (np.arange(_SAMPLES) + rng.random(_SAMPLES)) * (total / _SAMPLES)
    chosen = np.searchsorted(np.cumsum(doubled), marks, side="right")
    chosen = np.minimum(chosen, len(faces) - 1)
    u, v = rng.random((2, _SAMPLES))
    over = u + v > 1.0
    u, v = np.where(over, 1.0 - u, u), np.where(over, 1.0 - v, v)
    a, b, c = corners[chosen].transpose(1, 0, 2)
    points = a + u[:, None] * (b - a) + v[:, None] * (c - a)
    normals = cross[chosen] / np.maximum(doubled[chosen], 1e-300)[:, None]
    return points, normals


def find_axis(points: Floats, normals: Floats) -> AxisLine:
    """Return the axis about which most of the surface turns.

    Starts are the line that the normals meet (the linear complex of Pottmann and Wallner, which
    fits all lines n·(d × (p − c)) = 0 at once) and the principal axes; from each the departures of
    the radius from its mean in cells along the axis are made least, with weights that leave
    handles, spouts and damage aside. Raises SourceError where the surface is flat.
    """
    rng = np.random.default_rng(_SEED)
    used = rng.permutation(len(points))[:_USED]
    cloud, sides = points[used], normals[used]
    centre = cloud.mean(axis=0)
    spread = np.linalg.svd(cloud - centre, compute_uv=False) / np.sqrt(len(cloud))
    size = float(np.hypot.reduce(np.ptp(cloud, axis=0)))
    if spread[2] <= 1e-6 * size:
        raise SourceError(NoSource.FLAT)
    tries = []
    for start in _starts(cloud, sides, centre, size):
        axis, misfit = _improved(cloud, start, _ROUNDS)
        tries.append((misfit, axis))
    axis = min(tries, key=lambda found: found[0])[1]
    axis, _ = _improved(points[rng.permutation(len(points))[: 4 * _USED]], axis, _LAST_ROUNDS)
    direction = axis.direction
    # Upwards: along the coordinate that the axis follows most.
    if direction[int(np.argmax(np.abs(direction)))] < 0.0:
        direction = -direction
    foot = axis.point + float((centre - axis.point) @ direction) * direction
    return AxisLine(foot, direction)


def _starts(points: Floats, normals: Floats, centre: Floats, size: float) -> list[AxisLine]:
    off = (points - centre) / size
    starts = []
    moments = np.concatenate([np.cross(off, normals), normals], axis=1)
    weights = np.ones(len(points))
    for _ in range(_ROUNDS):
        _, vectors = np.linalg.eigh((moments * weights[:, None]).T @ moments)
        line = vectors[:, 0]
        length = float(np.linalg.norm(line[:3]))
        if length < 1e-6:
            break
        line = line / length
        departure = np.abs(moments @ line)
        scale = max(_SCALE * float(np.median(departure)), 1e-6)
        weights = 1.0 / (1.0 + (departure / scale) ** 2)
    if length >= 1e-6:
        direction = line[:3]
        # m = c × d gives the point of the axis nearest the centre: c = d × m.
        starts.append(AxisLine(centre + size * np.cross(direction, line[3:]), direction))
    principal = np.linalg.svd(off - off.mean(axis=0), full_matrices=False)[2]
    starts += [AxisLine(centre, direction) for direction in principal]
    return starts


def _improved(points: Floats, axis: AxisLine, rounds: int) -> tuple[AxisLine, float]:
    """Return the axis after rounds of weighted least squares, and the robust misfit.

    A shift t across the axis changes a radius by −t·u, u pointing outwards; a tilt α by −h α·u and
    the height by r α·u. In each cell the radius is linear in the height, with slope b, so that a
    departure changes by −t·u − (h + b r) α·u.
    """
    misfit = np.inf
    for _ in range(rounds):
        frame = axis.frame()
        x, y, h = frame @ (points - axis.point).T
        r = np.hypot(x, y)
        u = np.stack([x, y]) / np.maximum(r, 1e-12)
        cell = _cells(r, h)
        departure, slope = _departures(r, h, cell, np.ones(len(r)))
        known = cell >= 0
        if known.sum() < 50:
            return axis, np.inf
        for _ in range(2):
            scale = max(_SCALE * float(np.median(np.abs(departure[known]))), 1e-12)
            weights = np.where(known, 1.0 / (1.0 + (departure / scale) ** 2) ** 2, 0.0)
            departure, slope = _departures(r, h, cell, weights)
        misfit = float(np.median(np.abs(departure[known]))) / max(float(np.median(r)), 1e-12)
        lever = h + slope * r
        rows = np.stack([-u[0], -u[1], -lever * u[0], -lever * u[1]], axis=1)
        # The cells' own means move along.
        rows = rows - _cell_means(rows, cell, weights)
        heavy = rows * weights[:, None]
        system = heavy.T @ rows
        step = np.linalg.lstsq(system, -heavy.T @ departure, rcond=1e-9)[0]
        shift = step[0] * frame[0] + step[1] * frame[1]
        tilt = step[2] * frame[0] + step[3] * frame[1]
        length = float(np.linalg.norm(tilt))
        if length > 0.3:
            tilt = tilt * (0.3 / length)
        direction = axis.direction + tilt
        axis = AxisLine(axis.point + shift, direction / np.linalg.norm(direction))
        if np.linalg.norm(shift) < _SETTLED * float(r.max()) and length < _SETTLED:
            break
    return axis, misfit


def _cells(r: Floats, h: Floats) -> NDArray[np.intp]:
    """Return the cell of each point: by height, and apart where walls lie one behind the other.

    −1 where a cell has too few points.
    """
    low, high = float(h.min()), float(h.max())
    step = (high - low) / _CELLS or 1.0
    row = np.clip(((h - low) / step).astype(np.intp), 0, _CELLS - 1)
    # In each row the radii fall into groups: a gap wider than the row is high parts them.
    order = np.lexsort((r, row))
    sorted_r, sorted_row = r[order], row[order]
    parts = (np.diff(sorted_r, prepend=sorted_r[:1]) > step) | (
        np.diff(sorted_row, prepend=sorted_row[:1]) != 0
    )
    cell = np.empty(len(r), dtype=np.intp)
    cell[order] = np.cumsum(parts)
    counts = np.bincount(cell)
    return np.where(counts[cell] >= _LEAST, cell, -1)


def _cell_means(values: Floats, cell: NDArray[np.intp], weights: Floats) -> Floats:
    """Return the weighted mean of each point's cell, shape of ``values``."""
    number = np.maximum(cell, 0)
    count = int(number.max()) + 1
    heavy = np.bincount(number, weights, count)
    heavy = np.where(heavy > 0.0, heavy, 1.0)
    columns = values if values.ndim == 2 else values[:, None]
    means = np.stack(
        [np.bincount(number, weights * column, count) / heavy for column in columns.T], axis=1
    )[number]
    return means if values.ndim == 2 else means[:, 0]


def _departures(
    r: Floats, h: Floats, cell: NDArray[np.intp], weights: Floats
) -> tuple[Floats, Floats]:
    """Return the departures of radii from a line r(h) in each cell, and the lines' slopes."""
    weights = np.where(cell >= 0, weights, 0.0)
    off_h, off_r = h - _cell_means(h, cell, weights), r - _cell_means(r, cell, weights)
    square = _cell_means(off_h * off_h, cell, weights)
    product = _cell_means(off_h * off_r, cell, weights)
    slope = np.divide(product, square, out=np.zeros_like(r), where=square > 1e-300)
    # Near the vertical a radius says little of the height: the slope is bounded.
    slope = np.clip(slope, -3.0, 3.0)
    departure = off_r - slope * off_h
    return np.where(cell >= 0, departure, 0.0), slope
