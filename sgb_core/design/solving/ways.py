"""By what targets are reached: what may change of a chain, and how it is told afterwards."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from enum import StrEnum

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import PARAMETER_RANGES, ParameterName
from sgb_core.design.demands.chain import BLOCK, Chain
from sgb_core.design.demands.foot import standing
from sgb_core.design.demands.measures import lowest
from sgb_core.design.demands.unknowns import Unknowns, fraction_unknowns
from sgb_core.values import dataclass

# A size changes by this factor at most, either way.
_REACH = 1e3
# Points go no farther than this, in sizes of the profile, or than it is wide; end fractions stay
# above this.
_FARTHEST, _LEAST = 1.0, 0.02


class Way(StrEnum):
    """What may change: the size, or points and shape parameters by the least change."""

    ALL = "all"
    HEIGHT = "height"
    WIDTH = "width"
    SHAPE = "shape"
    POINTS = "points"
    BOTH = "both"


@dataclass(frozen=True, slots=True)
class Slider:
    """One shape parameter of one segment."""

    segment: int
    parameter: ParameterName


STRETCHES = (Way.ALL, Way.HEIGHT, Way.WIDTH)


def unknowns_by(
    way: Way | Slider,
    profile: Profile,
    start: Chain,
    fixed: Collection[tuple[int, int]] = (),
    governed: Collection[int] = (),
) -> Unknowns:
    """Return what may change of a profile, whose numbers are ``start``.

    ``fixed`` points stay where they are, as do the fractions of ``governed`` segments; a size and
    a single parameter know neither.
    """
    if isinstance(way, Slider):
        return _slider(way, profile, start)
    if way in STRETCHES:
        return _stretch(way, start)
    low, high = start.fractions.copy(), start.fractions.copy()
    if way is not Way.POINTS:
        free = [k for k in range(len(start)) if k not in governed]
        low[free] = np.minimum(low[free], [_LEAST, 0.0, _LEAST])
        high[free] = 1.0
    unknowns = fraction_unknowns(start, low, high)
    return unknowns if way is Way.SHAPE else _with_points(unknowns, profile, fixed)


def place_of(
    other: Profile,
    way: Way,
    profile: Profile,
    fixed: Collection[tuple[int, int]] = (),
    governed: Collection[int] = (),
) -> Floats:
    """Return the unknowns (m,) with which a profile comes nearest to another with as many parts."""
    start = Chain.of(profile)
    return unknowns_by(way, profile, start, fixed, governed).nearest(start.told(other))


def solved_profile(way: Way | Slider, profile: Profile, unknowns: Unknowns, y: Floats) -> Profile:
    """Return the profile that y stands for."""
    if not isinstance(way, Slider):
        return unknowns.chain(y).profile(profile, unknowns.start)
    segment = profile.segments[way.segment]
    low, high = PARAMETER_RANGES[way.parameter]
    value = min(max(getattr(segment.shape, way.parameter) + float(y[0]), low), high)
    shape = replace(segment.shape, **{way.parameter: value})
    return profile.with_segment(way.segment, segment.with_shape(shape))


def _slider(way: Slider, profile: Profile, start: Chain) -> Unknowns:
    """Return one parameter as the unknown, in which the leg fractions are linear."""
    shape = profile.segments[way.segment].shape
    low, high = PARAMETER_RANGES[way.parameter]
    least, most = (
        np.array(replace(shape, **{way.parameter: value}).leg_fractions) for value in (low, high)
    )
    matrix = np.zeros((start.blocks.size, 1))
    matrix[way.segment * BLOCK : way.segment * BLOCK + 3, 0] = (most - least) / (high - low)
    present = getattr(shape, way.parameter)
    return Unknowns(start, matrix, np.array([low - present]), np.array([high - present]))


def _stretch(way: Way, start: Chain) -> Unknowns:
    """Return a stretch from the origin, the lowest level or the axis, less 1, as the unknown."""
    blocks = np.zeros_like(start.blocks)
    points = blocks[:, 3:].reshape(-1, 4, 2)
    if way is not Way.HEIGHT:
        points[..., 0] = start.points[..., 0]
    if way is Way.ALL:
        points[..., 1] = start.points[..., 1] + start.middle / start.size
    elif way is Way.HEIGHT:
        points[..., 1] = start.points[..., 1] - lowest(start.quartics).value
    blocks[:, 3:] = points.reshape(-1, 8)
    return Unknowns(
        start, blocks.reshape(-1, 1), np.array([1.0 / _REACH - 1.0]), np.array([_REACH - 1.0])
    )


def _with_points(
    unknowns: Unknowns, profile: Profile, fixed: Collection[tuple[int, int]]
) -> Unknowns:
    """Return unknowns with all but fixed control points added.

    Those on the axis stay on it, those of a flat bottom at its level.
    """
    start, count, flat = unknowns.start, len(profile), standing(profile)
    # A narrow ring far from the axis changes its size by more than its own.
    farthest = max(_FARTHEST, float(np.abs(start.points[..., 0]).max()))
    columns: list[list[int]] = []
    starts: list[float] = []
    for segment in range(count):
        for point in range(4):
            before = (segment - 1) % count
            if point == 0 and _joined(start, profile, before, segment):
                continue
            keys = [(segment, point)]
            after = (segment + 1) % count
            if point == 3 and _joined(start, profile, segment, after):
                keys.append((after, 0))
            if any(key in fixed for key in keys):
                continue
            for axis in range(2):
                value = float(start.points[segment, point, axis])
                if axis == 0 and value == 0.0:
                    continue
                if axis == 1 and any(k in flat for k, _ in keys):
                    continue
                columns.append([BLOCK * k + 3 + 2 * p + axis for k, p in keys])
                starts.append(value if axis == 0 and value > 0.0 else np.inf)
    matrix = np.zeros((start.blocks.size, len(columns)))
    for column, rows in enumerate(columns):
        matrix[rows, column] = 1.0
    return Unknowns(
        start,
        np.concatenate([unknowns.matrix, matrix], axis=1),
        np.concatenate([unknowns.low, [-min(farthest, value) for value in starts]]),
        np.concatenate([unknowns.high, np.full(len(columns), farthest)]),
    )


def _joined(start: Chain, profile: Profile, before: int, after: int) -> bool:
    if after <= before and not profile.closed:
        return False
    return bool((start.points[before, 3] == start.points[after, 0]).all())
