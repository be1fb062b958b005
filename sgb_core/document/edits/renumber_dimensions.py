"""Dimensions name segments, points and joints: how they follow when segments are renumbered."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sgb_core.curves.profile import Profile
from sgb_core.design.locks.dimension import Dimension, misplaced

_Origin = Sequence[int | None]


def dimensions_follow(
    dimensions: tuple[Dimension, ...], old: Profile, new: Profile, origin: _Origin | None
) -> tuple[Dimension, ...]:
    """Return the dimensions after an edit; those of what is gone are removed.

    ``origin[k]`` is the old number of what is segment k now, None for a new one; None for all
    says that numbers stay. Of a divided segment the points go with the half that has them.
    """
    if not dimensions:
        return dimensions
    if origin is not None and list(origin) != list(range(len(old))):
        turned = [_is_turned(old, new, k, came) for k, came in enumerate(origin)]
        dimensions = tuple(
            moved
            for each in dimensions
            if (moved := _followed(each, len(old), origin, turned)) is not None
        )
    return tuple(each for each in dimensions if misplaced(each, len(new), len(new.rules)) is None)


def _is_turned(old: Profile, new: Profile, segment: int, came: int | None) -> bool:
    """Return whether a segment is an old one run backwards."""
    if came is None:
        return False
    before, after = np.array(old.segments[came].points), np.array(new.segments[segment].points)
    straight = np.abs(after - before).sum()
    return bool(np.abs(after - before[::-1]).sum() < straight)


def _followed(
    dimension: Dimension, count: int, origin: _Origin, turned: list[bool]
) -> Dimension | None:
    if dimension.joint is not None:
        joint = _joint(dimension.joint, count, origin)
        return None if joint is None else replace(dimension, joint=joint)
    if dimension.segment is not None and dimension.s is not None:
        places = [k for k, came in enumerate(origin) if came == dimension.segment]
        if len(places) != 1:
            return None
        s = 1.0 - dimension.s if turned[places[0]] else dimension.s
        return replace(dimension, segment=places[0], s=s)
    if not dimension.points:
        return dimension
    points = [_point(point, origin, turned) for point in dimension.points]
    known = tuple(point for point in points if point is not None)
    return replace(dimension, points=known) if len(known) == len(points) else None


def _point(point: tuple[int, int], origin: _Origin, turned: list[bool]) -> tuple[int, int] | None:
    segment, index = point
    places = [k for k, came in enumerate(origin) if came == segment]
    if not places:
        return None
    # In a ring's numbering, too, the halves of a divided segment follow each other.
    first, last = places[0], places[-1]
    if turned[first]:
        return (last, 3 - index) if index < 2 else (first, 3 - index)
    return (first, index) if index < 2 else (last, index)


def _joint(joint: int, count: int, origin: _Origin) -> int | None:
    sides = {joint, (joint + 1) % count}
    for k, came in enumerate(origin):
        following = origin[(k + 1) % len(origin)]
        if {came, following} == sides and (came != following or count == 1):
            return k
    return None
