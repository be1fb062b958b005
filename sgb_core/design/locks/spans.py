"""Where dimensions lie in the profile half-plane, and which values places stand for."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, auto
from math import hypot

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.design.demands.chain import Chain
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.locks.gauge import Gauge
from sgb_core.design.locks.readings import spot_of

_K = DimensionKind
_DIAMETERS = (
    _K.MAX_DIAMETER,
    _K.RIM_DIAMETER,
    _K.FOOT_DIAMETER,
    _K.NECK_DIAMETER,
    _K.DIAMETER_AT,
)
_LEAST = 1e-6


class Way(Enum):
    """How a dimension's line runs."""

    ACROSS = auto()
    UP = auto()
    BETWEEN = auto()
    RADIUS = auto()


@dataclass(frozen=True, slots=True)
class Span:
    """What a dimension reaches from and to, as (r, h) each, in the profile's unit."""

    way: Way
    start: tuple[float, float]
    end: tuple[float, float]

    def value_at(self, place: tuple[float, float]) -> float:
        """Return the value that brings the end of its line to a place, or next to it."""
        length = hypot(self.end[0] - self.start[0], self.end[1] - self.start[1])
        least = _LEAST * max(length, 1e-12)
        if self.way is Way.ACROSS:
            return max(2.0 * abs(place[0]), least)
        if self.way is Way.UP:
            return max(place[1] - self.start[1], least)
        along = np.subtract(self.end, self.start) / (length or 1.0)
        return max(float(np.subtract(place, self.start) @ along), least)


def spans(profile: Profile, dimensions: tuple[Dimension, ...]) -> list[Span | None]:
    """Return where dimensions lie, None for those that have no line of their own."""
    if not dimensions:
        return []
    gauge = Gauge(Chain.of(profile), slopes=False)
    return [_span(gauge, profile, dimension) for dimension in dimensions]


def _span(gauge: Gauge, profile: Profile, dimension: Dimension) -> Span | None:
    kind = dimension.kind
    size, middle = gauge.chain.size, gauge.chain.middle
    if kind is _K.DISTANCE:
        (k, i), (m, j) = dimension.points
        first, second = profile.segments[k].points[i], profile.segments[m].points[j]
        return Span(Way.BETWEEN, _pair(first), _pair(second))
    if kind is _K.HEIGHT:
        low, high = gauge.at(gauge.extreme(1, -1.0)), gauge.at(gauge.extreme(1, 1.0))
        widest = float(np.abs(gauge.samples[..., 0]).max()) * size
        bottom, top = (float(place[1]) * size + middle for place in (low, high))
        return Span(Way.UP, (widest, bottom), (widest, top))
    spot = spot_of(gauge, dimension)
    if spot is None:
        return None
    r, h = (gauge.at(spot) * size + (0.0, middle)).tolist()
    if kind in _DIAMETERS:
        return Span(Way.ACROSS, (-r, h), (r, h))
    if kind is _K.RADIUS:
        segment = profile.segments[spot.segment]
        bend = float(segment.curvature(np.array(spot.s)))
        first = segment.derivative(np.array(spot.s))
        speed = float(np.hypot(*first))
        if not np.isfinite(bend) or abs(bend) * size < _LEAST or speed == 0.0:
            return None
        normal = np.array((-first[1], first[0])) / speed
        return Span(Way.RADIUS, _pair(np.array((r, h)) + normal / bend), (r, h))
    return None


def _pair(place: Floats) -> tuple[float, float]:
    return float(place[0]), float(place[1])
