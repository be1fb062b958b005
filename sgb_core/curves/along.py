"""A profile along its arc length: curvature, and how far it is from the plain cubic."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.nearest import arc_length, distances
from sgb_core.curves.nodes import gauss
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import NEUTRAL, Segment
from sgb_core.values import dataclass

# Gauss points between neighbouring samples.
_NODES, _WEIGHTS = gauss(6)


@dataclass(frozen=True, slots=True, eq=False)
class Along:
    """Samples of one segment, each array of shape (N,) but ``points`` (N, 2).

    ``length`` is the arc length from the profile's start; ``curvature`` is signed, positive where
    the curve turns left, and not finite where it has none; ``deviation`` is the distance from the
    nearest point of the plain cubic on the same polygon, λ = (1, 3, 1) and ω = 0.
    """

    s: Floats
    points: Floats
    length: Floats
    curvature: Floats
    deviation: Floats


def along(profile: Profile, per_segment: int) -> tuple[Along, ...]:
    """Return ``per_segment`` ≥ 2 samples of each segment at equal steps of s, ends included."""
    # In parts of the size: cubes of the least lengths there are would vanish.
    start, found, size = 0.0, [], profile.size or 1.0
    s = np.linspace(0.0, 1.0, per_segment)
    for segment in profile.segments:
        unit = segment.with_points(segment.points / size)
        length = arc_length(unit)
        with np.errstate(over="ignore"):
            curvature = unit.curvature(s) / size
        deviation = distances(unit.with_shape(NEUTRAL), unit.point(s)) * size
        lengths = (start + _lengths(unit, s, length)) * size
        found.append(Along(s, segment.point(s), lengths, curvature, deviation))
        start += length
    return tuple(found)


def _lengths(segment: Segment, s: Floats, whole: float) -> Floats:
    """Return the arc length from s = 0; steps by Gauss' rule, together the whole length."""
    steps = np.diff(s)[:, None]
    rates = segment.derivative(s[:-1, None] + steps * _NODES)
    parts = (np.hypot(rates[..., 0], rates[..., 1]) * _WEIGHTS * steps).sum(axis=1)
    total = float(parts.sum())
    lengths = np.concatenate([[0.0], np.cumsum(parts)])
    if total > 0.0:
        lengths *= whole / total
    # The next segment begins where this one ends, to the last bit.
    lengths[-1] = whole
    return np.asarray(lengths)
