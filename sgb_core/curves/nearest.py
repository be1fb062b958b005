"""The point of a curve nearest a given one, and the length of curves."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import hypot

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.nodes import gauss
from sgb_core.curves.profile import Profile
from sgb_core.curves.roots import dot, real_roots, slow_points
from sgb_core.curves.segment import Segment
from sgb_core.values import dataclass

# Starting places per segment for many foot points at once, and Newton's rounds from each.
_STARTS = 129
_BRANCHES = 3
_ROUNDS = 12
# How often the search for a largest distance is made four times finer.
_CLOSER = 4
# Length: Gauss-Legendre points on a piece, and how deep a piece may be halved.
_GAUSS = 16
_DEEPEST = 48
_LENGTH_ROUNDING = 1e-14


@dataclass(frozen=True, slots=True)
class Nearest:
    """The nearest point of a profile: on which segment, at which s, where, how far."""

    segment: int
    s: float
    point: tuple[float, float]
    distance: float


def nearest(profile: Profile, point: ArrayLike) -> Nearest:
    """Return the point of the profile nearest to ``point`` = (r, h).

    Exact up to rounding: within a segment the distance is least at an end or where
    (L(s) − p)·L'(s) = 0, a polynomial of degree 7 whose real roots are all found.

    >>> found = sgb.nearest(sgb.Profile.of([sgb.line((20, 0), (20, 60))]), (26, 15))
    >>> found.segment, found.s, found.distance
    (0, 0.25, 6.0)
    """
    x, y = (float(value) for value in np.asarray(point, dtype=np.float64))
    best: Nearest | None = None
    for number, segment in enumerate(profile.segments):
        if best is not None and _box_distance(segment, x, y) >= best.distance:
            continue
        s, place, gap = foot_point(segment, x, y)
        if best is None or gap < best.distance:
            best = Nearest(number, s, place, gap)
    assert best is not None  # A profile has at least one segment.
    return best


def foot_point(segment: Segment, x: float, y: float) -> tuple[float, tuple[float, float], float]:
    """Return (s, point, distance) of the point of one segment nearest to (x, y), exactly."""
    candidates = np.array([0.0, *real_roots(_foot_polynomial(segment.quartic - [x, y])), 1.0])
    places = segment.point(candidates)
    gaps = np.hypot(places[:, 0] - x, places[:, 1] - y)
    k = int(np.argmin(gaps))
    return float(candidates[k]), (float(places[k, 0]), float(places[k, 1])), float(gaps[k])


def distances(segment: Segment, points: ArrayLike) -> Floats:
    """Return how far each of many points, shape (N, 2), is from a segment, shape (N,).

    Newton's method goes to the foot points from the three nearest local minima among 129 points
    of the curve: near a crossing the nearest sample can lie on the wrong branch.
    """
    p = np.asarray(points, dtype=np.float64)
    marks = np.linspace(0.0, 1.0, _STARTS)
    squares = ((p[:, None, :] - segment.point(marks)) ** 2).sum(axis=2)
    padded = np.pad(squares, ((0, 0), (1, 1)), constant_values=np.inf)
    minima = (squares <= padded[:, :-2]) & (squares <= padded[:, 2:])
    ranked = np.argsort(np.where(minima, squares, np.inf), axis=1)[:, :_BRANCHES]
    s = marks[ranked]
    best: Floats = np.sqrt(squares.min(axis=1))
    for _ in range(_ROUNDS):
        off, slope = segment.point(s) - p[:, None, :], segment.derivative(s)
        bend = (off * segment.derivative(s, 2)).sum(axis=2)
        full = (slope**2).sum(axis=2)
        # Where the squared distance is not convex, Gauss-Newton's step leads downhill.
        under = np.where(full + bend > 0.0, full + bend, full)
        value = (off * slope).sum(axis=2)
        step = np.divide(value, under, out=np.zeros_like(s), where=under > 0.0)
        s = np.clip(s - np.clip(step, -1.0 / _STARTS, 1.0 / _STARTS), 0.0, 1.0)
        gap = segment.point(s) - p[:, None, :]
        best = np.minimum(best, np.hypot(gap[..., 0], gap[..., 1]).min(axis=1))
    return best


def farthest(segments: Sequence[Segment], others: Sequence[Segment]) -> float:
    """Return the largest distance of a point of ``segments`` from the nearest of ``others``.

    129 points of each segment tell where it is; about there it is sought by ever closer ones,
    to about 1e-5 of itself.
    """

    def gap(place: Floats) -> float:
        x, y = place.tolist()
        return min(foot_point(other, x, y)[2] for other in others)

    largest = 0.0
    for segment in segments:
        marks = np.linspace(0.0, 1.0, _STARTS)
        places = segment.point(marks)
        found = np.min([distances(other, places) for other in others], axis=0)
        # In a hairpin the quick search can miss the branch, so the worst are looked at again.
        for _ in marks:
            worst = int(np.argmax(found))
            exact = gap(places[worst])
            if exact >= 0.999 * found[worst]:
                break
            found[worst] = exact
        s, reach = float(marks[worst]), 1.0 / (_STARTS - 1)
        for _ in range(_CLOSER):
            close = np.clip(np.linspace(s - reach, s + reach, 9), 0.0, 1.0)
            gaps = [gap(place) for place in segment.point(close)]
            s, reach = float(close[int(np.argmax(gaps))]), reach / 4.0
            largest = max(largest, *gaps)
    return largest


def arc_length(segment: Segment, start: float = 0.0, end: float = 1.0) -> float:
    """Return the length of a segment between two parameters, to about 1e-13 of itself.

    Adaptive Gauss-Legendre: a piece is halved until its halves agree with it. The first pieces
    end where |L'| is least, so that a cusp, where the integrand is not smooth, is no inside point.

    >>> sgb.arc_length(sgb.line((0, 0), (30, 40)))
    50.0
    """
    if start == end:
        return 0.0
    slopes = 4.0 * np.diff(segment.quartic, axis=0)
    polygon = float(np.hypot(slopes[:, 0], slopes[:, 1]).sum()) / 4.0
    if polygon == 0.0:
        return 0.0
    total = 0.0
    slow = [s for s in slow_points(segment.quartic) if start < s < end]
    pieces = [
        (low, high, _gauss(slopes, low, high), 0) for low, high in pairwise([start, *slow, end])
    ]
    while pieces:
        low, high, whole, depth = pieces.pop()
        middle = 0.5 * (low + high)
        left, right = _gauss(slopes, low, middle), _gauss(slopes, middle, high)
        if abs(left + right - whole) <= _LENGTH_ROUNDING * polygon or depth == _DEEPEST:
            total += left + right
        else:
            pieces += [(low, middle, left, depth + 1), (middle, high, right, depth + 1)]
    return total


def _gauss(slopes: Floats, low: float, high: float) -> float:
    nodes, weights = gauss(_GAUSS)
    values = basis.bernstein(3, low + (high - low) * nodes) @ slopes
    return float((high - low) * (weights @ np.hypot(values[:, 0], values[:, 1])))


def _box_distance(segment: Segment, x: float, y: float) -> float:
    """Return how far a point is from the box around the quartic points: a lower bound."""
    (low_x, low_y), (high_x, high_y) = segment.quartic.min(axis=0), segment.quartic.max(axis=0)
    return hypot(max(low_x - x, 0.0, x - high_x), max(low_y - y, 0.0, y - high_y))


def _foot_polynomial(offset: Floats) -> list[float]:
    """Return the Bernstein coefficients, degree 7, of (L(s) − p)·L'(s)/4."""
    return dot(offset, np.diff(offset, axis=0))
