"""Where dimensions lie in the profile half-plane, and which values places stand for."""

from __future__ import annotations

from enum import Enum, auto
from math import atan2, degrees, hypot

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.curves.profile import Profile
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.measures import end_of
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.locks.gauge import Gauge, Spot
from sgb_core.design.locks.readings import Setting, spot_of
from sgb_core.values import dataclass

_K = DimensionKind
_DIAMETERS = (
    _K.MAX_DIAMETER,
    _K.RIM_DIAMETER,
    _K.FOOT_DIAMETER,
    _K.NECK_DIAMETER,
    _K.DIAMETER_AT,
)
_LEAST = 1e-6
# Levels stand at this part of the way from the axis to the widest place, or at twice of it.
_INSIDE = 0.3
# Of a segment: joints and quartic points, which are grabbed first, seldom lie there.
_BESIDE_MARKS = 0.375


class Way(Enum):
    """How a dimension's line runs."""

    ACROSS = auto()
    UP = auto()
    LEVEL = auto()
    BETWEEN = auto()
    RADIUS = auto()
    TURN = auto()


@dataclass(frozen=True, slots=True)
class Span:
    """What a dimension reaches from and to, as (r, h) each, in the profile's unit.

    A LEVEL reaches from height 0; ``place`` is where on the curve it is taken. A TURN is the angle
    at ``start`` from straight away from the axis to ``end``.
    """

    way: Way
    start: tuple[float, float]
    end: tuple[float, float]
    place: tuple[float, float] | None = None

    def value_at(self, place: tuple[float, float]) -> float:
        """Return the value that brings the end of its line to a place, or next to it."""
        length = hypot(self.end[0] - self.start[0], self.end[1] - self.start[1])
        least = _LEAST * max(length, 1e-12)
        if self.way is Way.ACROSS:
            return max(2.0 * abs(place[0]), least)
        if self.way is Way.LEVEL:
            return place[1]
        if self.way is Way.TURN:
            return degrees(atan2(place[1] - self.start[1], place[0] - self.start[0]))
        if self.way is Way.UP:
            return max(place[1] - self.start[1], least)
        along = np.subtract(self.end, self.start) / (length or 1.0)
        return max(float(np.subtract(place, self.start) @ along), least)


def spans(
    profile: Profile, dimensions: tuple[Dimension, ...], setting: Setting
) -> list[Span | None]:
    """Return where dimensions lie, None for those that have no line of their own."""
    if not dimensions:
        return []
    gauge = Gauge(Chain.of(profile), slopes=False)
    return [_span(gauge, profile, dimension, setting) for dimension in dimensions]


def _span(gauge: Gauge, profile: Profile, dimension: Dimension, setting: Setting) -> Span | None:
    kind = dimension.kind
    if kind in (_K.WALL, _K.BASE):
        if setting.solid.kind is not BodyKind.VESSEL:
            return None
        solid = setting.solid
        return _wall(gauge, solid) if kind is _K.WALL else _floor(gauge, solid)
    if kind is _K.FILL_LINE:
        if setting.fill is None:
            return None
        inside = _INSIDE * float(gauge.samples[..., 0].flat[_widest(gauge)]) * gauge.chain.size
        return Span(Way.LEVEL, (inside, 0.0), (inside, setting.fill))
    size, middle = gauge.chain.size, gauge.chain.middle
    if kind in (_K.DISTANCE, _K.ANGLE):
        (k, i), (m, j) = dimension.points
        first, second = profile.segments[k].points[i], profile.segments[m].points[j]
        if kind is _K.ANGLE and np.array_equal(first, second):
            return None
        way = Way.BETWEEN if kind is _K.DISTANCE else Way.TURN
        return Span(way, _pair(first), _pair(second))
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
    if kind in (_K.MAX_DIAMETER_HEIGHT, _K.NECK_HEIGHT):
        inside = 2.0 * _INSIDE * r
        return Span(Way.LEVEL, (inside, 0.0), (inside, h), (r, h))
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


def _widest(gauge: Gauge) -> int:
    """Return the number of the sample farthest from the axis."""
    return int(np.abs(gauge.samples[..., 0]).argmax())


def _wall(gauge: Gauge, solid: Solid) -> Span | None:
    """Return a wall's thickness in the segment that passes the middle height farthest out."""
    quartics, size = gauge.quartics, gauge.chain.size
    passes = gauge.crossings(0.0)
    if not passes:
        return None
    outermost = max(passes, key=lambda each: abs(float(gauge.at(each)[0])))
    spot = Spot(outermost.segment, _BESIDE_MARKS)
    across, up = gauge.at(spot, 1).tolist()
    speed = hypot(across, up)
    if speed == 0.0:
        return None
    # Outwards: to the right of the way from foot to rim on the right of the axis.
    way = 1.0 if quartics[-1, 4, 1] >= quartics[0, 0, 1] else -1.0
    way *= 1.0 if gauge.samples[..., 0].sum() >= 0.0 else -1.0
    way *= -1.0 if solid.side is WallSide.INSIDE else 1.0
    outer = gauge.at(spot) * size + (0.0, gauge.chain.middle)
    moved = outer + way * solid.wall / speed * np.array((up, -across))
    return Span(Way.BETWEEN, _pair(outer), _pair(moved))


def _floor(gauge: Gauge, solid: Solid) -> Span:
    """Return a floor's thickness between the axis and the foot, from where it is measured."""
    chain = gauge.chain
    segment, point = end_of(gauge.quartics, upper=False)
    r, h = gauge.quartics[segment, point].tolist()
    low = float(gauge.samples[..., 1].min())
    inside = solid.side is WallSide.INSIDE
    if abs(r) <= _LEAST:
        # Closed at the axis: from the lowest place, and not far out.
        r = _INSIDE * float(gauge.samples[..., 0].flat[_widest(gauge)])
        h = low if inside else h
    at, level = _INSIDE * 2.0 * r * chain.size, h * chain.size + chain.middle
    rise = solid.base if inside else -solid.base
    return Span(Way.BETWEEN, (at, level), (at, level + rise))


def _pair(place: Floats) -> tuple[float, float]:
    return float(place[0]), float(place[1])
