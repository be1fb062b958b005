"""Points as they come, made fit to be traced: checked, scaled, ends and outliers decided."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import isfinite

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sgb_core.arrays import Floats
from sgb_core.design.tracing.corners import noise_of, scatter_of
from sgb_core.design.tracing.errors import TraceError
from sgb_core.design.tracing.outliers import isolated_outliers
from sgb_core.fields.kinds import MAX_COORDINATE, Range, Said
from sgb_core.findings.refusal import Argument
from sgb_core.findings.tracing import NoPoint, NoTrace, Scattered, TooFewPoints, WithinTolerance
from sgb_core.values import dataclass

_COORDINATES = Range(-MAX_COORDINATE, MAX_COORDINATE)
_TOLERANCES = Range(above=0.0)
# So many points that scatter by so many tolerances across any path cannot be followed.
_MANY, _SCATTERS = 200, 2.0
# Points closer than this part of the size are one.
_SAME = 1e-9
# Ends as near as so many usual steps belong to a closed outline.
_CLOSING = 1.5
_FEWEST_CLOSED = 5
# and enclose at least this part of the square of its length; a circle 0.08, a square 0.06.
_ENCLOSES = 0.004


@dataclass(frozen=True, slots=True)
class Prepared:
    """Points in units of the size about the middle height: (r, h − middle) / size.

    The first and last of ``points`` (N, 2) may have been moved onto the axis, which ``poles``
    tells. ``tolerance`` is in the same units; ``outliers`` number ``given`` ones, ``corners``
    those in ``points``. A closed outline ends with its first point again. ``numbers`` (N,) are
    those of ``points`` in ``given``.
    """

    given: Floats
    points: Floats
    weights: Floats
    outliers: NDArray[np.intp]
    tolerance: float
    size: float
    middle: float
    closed: bool
    poles: tuple[bool, bool]
    corners: tuple[int, ...]
    numbers: NDArray[np.intp]

    def without(self, left_out: NDArray[np.intp]) -> Prepared:
        """Return the same with some of ``points``, by their places there, among the outliers."""
        stays = np.ones(len(self.points), dtype=bool)
        stays[left_out] = False
        place = np.cumsum(stays) - 1
        return replace(
            self,
            points=self.points[stays],
            weights=self.weights[stays],
            outliers=np.union1d(self.outliers, self.numbers[~stays]),
            corners=tuple(int(place[k]) for k in self.corners if stays[k]),
            numbers=self.numbers[stays],
        )

    def restored(self, places: Floats) -> Floats:
        """Return places (..., 2) in the given coordinates."""
        return np.asarray(places * self.size + np.array([0.0, self.middle]))


def checked_points(points: ArrayLike) -> Floats:
    """Return points as an array of shape (N, 2), N ≥ 2; raise TraceError where they are not."""
    array = np.asarray(points, dtype=np.float64)
    if array.ndim != 2 or array.shape[1] != 2:
        allowed = Said("the shape (N, 2): r and h")
        raise TraceError(Argument("points", array.shape, allowed))
    wrong = np.flatnonzero(~np.isfinite(array).all(axis=1))
    if len(wrong):
        raise TraceError(NoPoint(int(wrong[0])))
    if len(array) and np.abs(array).max() > MAX_COORDINATE:
        farthest = float(array.flat[int(np.argmax(np.abs(array)))])
        raise TraceError(Argument("coordinate", farthest, _COORDINATES))
    if len(array) < 2:
        raise TraceError(TooFewPoints(len(array)))
    return array


def prepare(
    points: ArrayLike,
    tolerance: float | None,
    weights: ArrayLike | None,
    corners: Sequence[int],
    closed: bool | None,
    *,
    left_out: NDArray[np.intp] | None = None,
) -> Prepared:
    """Return points ready to be traced, without ``left_out``; by default isolated outliers are.

    Raises TraceError for points that are not finite, that lie in one place or all on the axis,
    for many that follow no path, and for a tolerance or weights that are not above 0.
    """
    given = checked_points(points)
    size = float(np.hypot(*np.ptp(given, axis=0)))
    if size <= 0.0:
        raise TraceError(NoTrace.ONE_PLACE)
    if tolerance is None:
        tolerance = 1e-3 * size
    if not (isfinite(tolerance) and tolerance > 0.0):
        raise TraceError(Argument("tolerance", tolerance, _TOLERANCES))
    if size <= tolerance:
        raise TraceError(WithinTolerance(tolerance))
    if np.abs(given[:, 0]).max() <= tolerance:
        raise TraceError(NoTrace.ON_AXIS)
    heavy = _weights(weights, len(given))
    steps = np.hypot(*np.diff(given, axis=0).T)
    kept = np.append(0, np.flatnonzero(steps > _SAME * size) + 1)
    # What lies in one place counts there with all its weight.
    heavy = np.add.reduceat(heavy, kept)
    scatter = max(noise_of(given[kept]), scatter_of(given[kept]))
    if len(kept) > _MANY and scatter > _SCATTERS * tolerance:
        raise TraceError(Scattered(scatter, tolerance))
    closed = _is_closed(given[kept], tolerance) if closed is None else closed
    outliers = kept[isolated_outliers(given[kept], tolerance)] if left_out is None else left_out
    stays = ~np.isin(kept, outliers)
    kept, heavy = kept[stays], heavy[stays]
    middle = float(given[:, 1].min() + given[:, 1].max()) / 2.0
    scaled = (given[kept] - np.array([0.0, middle])) / size
    poles = (False, False)
    if closed:
        if np.hypot(*(scaled[-1] - scaled[0])) > _SAME:
            scaled = np.concatenate([scaled, scaled[:1]])
            heavy, kept = np.append(heavy, 0.0), np.append(kept, kept[0])
        if len(scaled) < _FEWEST_CLOSED:
            raise TraceError(NoTrace.FEW_CLOSED)
    else:
        near = np.abs(scaled[[0, -1], 0]) <= tolerance / size
        poles = (bool(near[0]), bool(near[1]))
        scaled[[0, -1], 0] = np.where(near, 0.0, scaled[[0, -1], 0])
    where = {int(number): place for place, number in enumerate(kept)}
    known = tuple(sorted({where[k] for k in corners if k in where}))
    return Prepared(
        given, scaled, heavy, outliers, tolerance / size, size, middle, closed, poles, known, kept
    )


def _weights(weights: ArrayLike | None, count: int) -> Floats:
    if weights is None:
        return np.ones(count)
    heavy = np.asarray(weights, dtype=np.float64)
    allowed = Said(f"a finite number above 0 for each of the {count} points")
    if heavy.shape != (count,):
        raise TraceError(Argument("weights", heavy.shape, allowed))
    wrong = ~(np.isfinite(heavy) & (heavy > 0.0))
    if wrong.any():
        raise TraceError(Argument("weights", float(heavy[wrong][0]), allowed))
    return heavy / float(heavy.mean())


def _is_closed(points: Floats, tolerance: float) -> bool:
    if len(points) < _FEWEST_CLOSED or np.abs(points[[0, -1], 0]).max() <= tolerance:
        return False
    steps = np.hypot(*np.diff(points, axis=0).T)
    gap, length = float(np.hypot(*(points[-1] - points[0]))), float(steps.sum())
    if gap > max(tolerance, _CLOSING * float(np.median(steps))):
        return False
    # A stroke that only comes back encloses nothing.
    off = points - points[0]
    area = 0.5 * abs(float((off[:-1, 0] * off[1:, 1] - off[1:, 0] * off[:-1, 1]).sum()))
    return area > _ENCLOSES * length**2
