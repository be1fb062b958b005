"""What a trace says it did."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.continuity import JointReport, measure_joints
from sgb_core.curves.profile import Profile
from sgb_core.design.tracing.feet import Feet, followed, improved, weights
from sgb_core.values import dataclass

# Samples of the chain for each length as long as its size, and of a segment at least and at most.
_SAMPLES, _LEAST_MOST = 600, (24, 2400)
# From so many of a segment's nearest samples Newton's method goes on to the feet.
_BRANCHES, _ROUNDS = 3, 6


@dataclass(frozen=True, slots=True)
class Trace:
    """A traced profile and how it lies to the points it was traced from.

    Lengths are in the points' unit. ``points`` counts those given, ``outliers`` numbers those
    left out, which the deviations do not count: distances of points from the curve. The largest
    is that of point ``farthest``, at ``farthest_point`` (r, h). ``joints`` are measured. ``exact``
    says that the source was made of lines, quadratics and cubics, and is kept as it is.
    """

    profile: Profile
    points: int
    tolerance: float
    largest_deviation: float
    rms_deviation: float
    farthest: int
    farthest_point: tuple[float, float]
    joints: tuple[JointReport, ...]
    outliers: tuple[int, ...] = ()
    exact: bool = False


def trace_of(
    profile: Profile,
    points: Floats,
    tolerance: float,
    outliers: NDArray[np.intp],
    *,
    exact: bool = False,
) -> Trace:
    """Return what is to be said of a profile traced from ``points``, shape (N, 2)."""
    counted = np.setdiff1d(np.arange(len(points)), outliers)
    off = distances(profile, points[counted])
    farthest = int(counted[np.argmax(off)])
    r, h = points[farthest].tolist()
    return Trace(
        profile,
        len(points),
        tolerance,
        float(off.max()),
        float(np.sqrt((off**2).mean())),
        farthest,
        (r, h),
        measure_joints(profile),
        tuple(outliers.tolist()),
        exact,
    )


def distances(profile: Profile, points: Floats) -> Floats:
    """Return the distance of each of many points, shape (N, 2), from a profile, shape (N,)."""
    if not len(points):
        return np.zeros(0)
    # Imported late: it takes a while to load.
    from scipy.spatial import cKDTree

    quartics = profile.quartics
    polygons = np.hypot(*np.diff(quartics, axis=1).transpose(2, 0, 1)).sum(axis=1)
    marks, spacings, nearest, numbers = [], [], [], []
    for quartic, share in zip(quartics, (polygons / profile.size).tolist(), strict=True):
        s = np.linspace(0.0, 1.0, int(np.clip(_SAMPLES * share, *_LEAST_MOST)))
        samples = weights(s) @ quartic
        away, near = cKDTree(samples).query(points, k=_BRANCHES)
        marks.append(s)
        spacings.append(float(np.hypot(*np.diff(samples, axis=0).T).max()))
        nearest.append(away)
        numbers.append(near)
    # A foot is no nearer to a sample than half its spacing: only so far can others be nearer.
    bound = np.min(nearest, axis=(0, 2))
    best = np.full(len(points), np.inf)
    sharp = frozenset(range(len(profile) + 1))
    for k, (s, spacing) in enumerate(zip(marks, spacings, strict=True)):
        point, branch = np.nonzero(nearest[k] <= (bound + spacing)[:, None])
        if not len(point):
            continue
        feet = Feet(np.full(len(point), k, dtype=np.intp), s[numbers[k][point, branch]])
        for _ in range(_ROUNDS):
            feet = improved(quartics, points[point], feet, closed=profile.closed, corners=sharp)
        off = followed(quartics, feet)[0] - points[point].T
        np.minimum.at(best, point, np.hypot(off[0], off[1]))
    return np.asarray(np.minimum(best, bound))
