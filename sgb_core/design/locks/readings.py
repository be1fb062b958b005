"""What each kind of dimension measures of a chain, with slopes; those of bodies as a model."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import atan2, degrees, hypot, pi
from types import MappingProxyType

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.design.demands import measures
from sgb_core.design.demands.chain import BLOCK
from sgb_core.design.demands.foot import foot_of
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.locks.gauge import NO_SLOPE, Gauge, Reading, Spot, row
from sgb_core.design.locks.held_volume import Base, Level, enclosed
from sgb_core.surfaces.curvature import cross
from sgb_core.values import dataclass

_STRAIGHT = 1e-9
_ON_AXIS = 1e-9
_LEVEL_STEP = 1e-6


@dataclass(frozen=True, slots=True)
class Setting:
    """What besides the chain a dimension depends on: the body, the fill line, the turn.

    The line is at a height, ``fill``, or so far ``below_rim``, or at a ``share`` of the way from
    the lowest to the highest level. ``grams`` is the mass of one unit³; lengths are in the
    document's unit, ``sweep`` in radians.
    """

    solid: Solid
    fill: float | None
    sweep: float
    grams: float
    closed: bool = False
    below_rim: float | None = None
    share: float | None = None


# Those whose model is set right by the body's own measure.
MODELLED = frozenset(
    {
        DimensionKind.CAPACITY,
        DimensionKind.FILLED,
        DimensionKind.MATERIAL,
        DimensionKind.MASS,
    }
)


def read(gauge: Gauge, dimension: Dimension, setting: Setting) -> Reading | None:
    """Return what a dimension measures, in the document's unit; None where there is no such thing.

    Points and joints have no value; wall, base and fill line are not the chain's.
    """
    make = _READERS.get(dimension.kind)
    return None if make is None else make(gauge, dimension, setting)


def spot_of(gauge: Gauge, dimension: Dimension) -> Spot | None:
    """Return where on the curve a diameter is taken, None for other kinds."""
    kind = dimension.kind
    if kind in (DimensionKind.NECK_DIAMETER, DimensionKind.NECK_HEIGHT):
        return gauge.neck()
    if kind in (DimensionKind.MAX_DIAMETER, DimensionKind.MAX_DIAMETER_HEIGHT):
        return _widest(gauge)
    if kind in (DimensionKind.RIM_DIAMETER, DimensionKind.FOOT_DIAMETER):
        return _end(gauge, kind is DimensionKind.RIM_DIAMETER)
    if kind is DimensionKind.DIAMETER_AT:
        return _outermost(gauge, dimension)
    if kind is DimensionKind.RADIUS and dimension.segment is not None:
        return Spot(dimension.segment, dimension.s or 0.0)
    return None


def rivals(gauge: Gauge, dimension: Dimension) -> list[tuple[Spot, Reading]]:
    """Return what a height or greatest diameter would be by other places that nearly reach as far.

    A lock keeps them all within it.
    """
    size = gauge.chain.size
    if dimension.kind is DimensionKind.HEIGHT:
        top, bottom = gauge.peaks(1, 1.0), gauge.peaks(1, -1.0)
        if len(top) == len(bottom) == 1:
            return []
        high, low = gauge.coordinate(top[0], 1), gauge.coordinate(bottom[0], 1)
        found = [(spot, (gauge.coordinate(spot, 1) - low).times(size)) for spot in top[1:]]
        found += [(spot, (high - gauge.coordinate(spot, 1)).times(size)) for spot in bottom[1:]]
        return found
    if dimension.kind is DimensionKind.MAX_DIAMETER:
        widest = _widest(gauge)
        sign = 1.0 if gauge.at(widest)[0] >= 0.0 else -1.0
        others = gauge.peaks(0, sign)[1:]
        return [(spot, gauge.coordinate(spot, 0).times(2.0 * sign * size)) for spot in others]
    return []


def _height(gauge: Gauge, _: Dimension, __: Setting) -> Reading:
    high = gauge.coordinate(gauge.extreme(1, 1.0), 1)
    return (high - gauge.coordinate(gauge.extreme(1, -1.0), 1)).times(gauge.chain.size)


def _widest(gauge: Gauge) -> Spot:
    right = gauge.extreme(0, 1.0)
    if float(gauge.samples[..., 0].min()) >= 0.0:
        return right
    left = gauge.extreme(0, -1.0)
    return right if gauge.at(right)[0] >= -gauge.at(left)[0] else left


def _end(gauge: Gauge, upper: bool) -> Spot:
    """Return the rim, or where the chain stands."""
    if not upper:
        foot = foot_of(gauge.quartics)
        return Spot(foot.segment, foot.s)
    segment, point = measures.end_of(gauge.quartics, upper)
    return Spot(segment, 1.0 if point == 4 else 0.0)


def _outermost(gauge: Gauge, dimension: Dimension) -> Spot | None:
    chain = gauge.chain
    level = ((dimension.height or 0.0) - chain.middle) / chain.size
    spots = gauge.crossings(level)
    return max(spots, key=lambda spot: abs(float(gauge.at(spot)[0])), default=None)


def _diameter(gauge: Gauge, dimension: Dimension, setting: Setting) -> Reading | None:
    if setting.closed and dimension.kind in (
        DimensionKind.RIM_DIAMETER,
        DimensionKind.FOOT_DIAMETER,
    ):
        return None
    spot = spot_of(gauge, dimension)
    if spot is None:
        return None
    within = dimension.kind is DimensionKind.FOOT_DIAMETER
    found = gauge.follows(spot, 0) if within else gauge.coordinate(spot, 0)
    factor = 2.0 * gauge.chain.size * (1.0 if found.value >= 0.0 else -1.0)
    if dimension.kind is DimensionKind.DIAMETER_AT:
        rates = gauge.at(spot, 1)
        if abs(float(rates[1])) > _STRAIGHT:
            along = gauge.coordinate(spot, 1).slope * (float(rates[0]) / float(rates[1]))
            found = Reading(found.value, found.slope - along)
    return found.times(factor)


def _height_of(gauge: Gauge, dimension: Dimension, _: Setting) -> Reading | None:
    spot = spot_of(gauge, dimension)
    if spot is None:
        return None
    chain = gauge.chain
    found = gauge.follows(spot, 1).times(chain.size)
    return Reading(found.value + chain.middle, found.slope)


def _between(gauge: Gauge, dimension: Dimension) -> tuple[Floats, Callable[[Floats], Floats]]:
    """Return the step from the first point to the second, and what makes slopes by it."""
    (k, i), (m, j) = dimension.points
    points = gauge.chain.points
    step = points[m, j] - points[k, i]

    def slope(rate: Floats) -> Floats:
        if not gauge.slopes:
            return NO_SLOPE
        whole = np.zeros(gauge.chain.blocks.size)
        first, second = BLOCK * k + 3 + 2 * i, BLOCK * m + 3 + 2 * j
        whole[first : first + 2] -= rate
        whole[second : second + 2] += rate
        return whole

    return step, slope


def _distance(gauge: Gauge, dimension: Dimension, _: Setting) -> Reading | None:
    step, slope = _between(gauge, dimension)
    length = hypot(step[0], step[1])
    if length == 0.0:
        return None
    return Reading(length, slope(step / length)).times(gauge.chain.size)


def _angle(gauge: Gauge, dimension: Dimension, _: Setting) -> Reading | None:
    step, slope = _between(gauge, dimension)
    square = float(step @ step)
    if square == 0.0:
        return None
    rate = np.array([-step[1], step[0]]) / square * degrees(1.0)
    return Reading(degrees(atan2(step[1], step[0])), slope(rate))


def _radius(gauge: Gauge, dimension: Dimension, _: Setting) -> Reading | None:
    spot = Spot(dimension.segment or 0, dimension.s or 0.0)
    first, second = gauge.at(spot, 1), gauge.at(spot, 2)
    speed, bend = hypot(first[0], first[1]), float(cross(first, second))
    if speed <= _STRAIGHT or abs(bend) <= _STRAIGHT * speed**3:
        return None
    # R = |P'|³ / |P' × P''|.
    value = speed**3 / abs(bend)
    by_first = 3.0 * value * first / speed**2 - value / bend * np.array([second[1], -second[0]])
    by_second = -value / bend * np.array([-first[1], first[0]])
    rows = np.outer(row(spot.s, 1), by_first) + np.outer(row(spot.s, 2), by_second)
    return Reading(value, gauge.lifted(spot.segment, rows)).times(gauge.chain.size)


def _volume(gauge: Gauge, _: Dimension, setting: Setting) -> Reading:
    found = _drawn(gauge)
    return found.times(setting.sweep / (2.0 * pi) * gauge.chain.size**3)


def _drawn(gauge: Gauge) -> Reading:
    found = gauge.volume()
    return found if found.value >= 0.0 else found.times(-1.0)


def _cavity(gauge: Gauge, setting: Setting, brim: Level) -> Reading:
    """Return what the hollow of a vessel holds, a full turn in the chain's size."""
    solid, size = setting.solid, gauge.chain.size
    if solid.side is WallSide.OUTSIDE:
        return enclosed(gauge, 0.0, None, brim)
    segment, point = measures.end_of(gauge.quartics, upper=False)
    on_axis = abs(float(gauge.quartics[segment, point, 0])) <= _ON_AXIS
    floor = Level(solid.base / size, Base.LOWEST if on_axis else Base.FOOT)
    return enclosed(gauge, solid.wall / size, floor, brim)


def _capacity(gauge: Gauge, _: Dimension, setting: Setting) -> Reading | None:
    if setting.solid.kind is not BodyKind.VESSEL or setting.closed:
        return None
    found = _cavity(gauge, setting, Level(0.0, Base.RIM))
    return found.times(setting.sweep / (2.0 * pi) * gauge.chain.size**3)


def _filled(gauge: Gauge, _: Dimension, setting: Setting) -> Reading | None:
    if setting.solid.kind is not BodyKind.VESSEL or setting.closed:
        return None
    chain, brim = gauge.chain, Level(0.0, Base.RIM)
    if setting.share is not None:
        return _to_share(gauge, setting, setting.share)
    if setting.below_rim is not None:
        brim = Level(-setting.below_rim / chain.size, Base.RIM)
    elif setting.fill is None:
        return None
    else:
        level = (setting.fill - chain.middle) / chain.size
        segment, point = measures.end_of(gauge.quartics, upper=True)
        if level < float(gauge.quartics[segment, point, 1]):
            brim = Level(level)
    found = _cavity(gauge, setting, brim)
    return found.times(setting.sweep / (2.0 * pi) * chain.size**3)


def _to_share(gauge: Gauge, setting: Setting, share: float) -> Reading:
    """Return what a vessel holds to a line that goes with its height."""
    low = gauge.coordinate(gauge.extreme(1, -1.0), 1)
    rise = (gauge.coordinate(gauge.extreme(1, 1.0), 1) - low).times(share)
    level = low.value + rise.value
    found, beyond = (_cavity(gauge, setting, Level(level + step)) for step in (0.0, _LEVEL_STEP))
    # The volume grows with the line by the area there.
    area = (beyond.value - found.value) / _LEVEL_STEP
    found = Reading(found.value, found.slope + area * (low.slope + rise.slope))
    return found.times(setting.sweep / (2.0 * pi) * gauge.chain.size**3)


def _material(gauge: Gauge, _: Dimension, setting: Setting) -> Reading | None:
    solid, size = setting.solid, gauge.chain.size
    if solid.kind is BodyKind.SURFACE:
        return None
    share = setting.sweep / (2.0 * pi) * size**3
    drawn = _drawn(gauge)
    if solid.kind is BodyKind.FILLED:
        return drawn.times(share)
    if setting.closed:
        inner = enclosed(gauge, solid.wall / size, None, None)
        found = drawn - (inner if inner.value >= 0.0 else inner.times(-1.0))
        return found.times(share if found.value >= 0.0 else -share)
    rim = Level(0.0, Base.RIM)
    if solid.side is WallSide.INSIDE:
        return (drawn - _cavity(gauge, setting, rim)).times(share)
    outer = enclosed(gauge, -solid.wall / size, None, rim)
    return (outer - drawn).times(share)


def _mass(gauge: Gauge, dimension: Dimension, setting: Setting) -> Reading | None:
    found = _material(gauge, dimension, setting)
    return None if found is None else found.times(setting.grams)


_Reader = Callable[[Gauge, Dimension, Setting], Reading | None]
_K = DimensionKind
_READERS: Mapping[DimensionKind, _Reader] = MappingProxyType(
    {
        _K.HEIGHT: _height,
        _K.MAX_DIAMETER: _diameter,
        _K.MAX_DIAMETER_HEIGHT: _height_of,
        _K.RIM_DIAMETER: _diameter,
        _K.FOOT_DIAMETER: _diameter,
        _K.NECK_DIAMETER: _diameter,
        _K.NECK_HEIGHT: _height_of,
        _K.DIAMETER_AT: _diameter,
        _K.DISTANCE: _distance,
        _K.ANGLE: _angle,
        _K.RADIUS: _radius,
        _K.CAPACITY: _capacity,
        _K.FILLED: _filled,
        _K.VOLUME: _volume,
        _K.MATERIAL: _material,
        _K.MASS: _mass,
    }
)
