"""Dimension lines on the paper: where they lie in pixels, and which one is under the pointer."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from app.hand.coordinates import Paper, ScreenPoint
from app.hand.hit_test import Handle, Target
from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.locks.spans import Span, spans

REACH = 6.0
# How far beside the shape lines of the rim, the foot and the height lie.
ASIDE = 15.0
_K = DimensionKind
_OUTSIDE = {_K.RIM_DIAMETER: (0.0, -ASIDE), _K.FOOT_DIAMETER: (0.0, ASIDE), _K.HEIGHT: (ASIDE, 0.0)}


@dataclass(frozen=True, slots=True)
class DimensionLine:
    """One line from ``start`` to ``end`` in pixels; what it measures lies ``aside`` of it."""

    number: int
    span: Span
    start: Floats
    end: Floats
    aside: tuple[float, float]


@lru_cache(maxsize=4)
def _spans(profile: Profile, dimensions: tuple[Dimension, ...]) -> list[Span | None]:
    return spans(profile, dimensions)


def dimension_lines(
    profile: Profile, dimensions: tuple[Dimension, ...], paper: Paper
) -> list[DimensionLine]:
    """Return the lines of the dimensions that have one."""
    found = []
    for number, (dimension, span) in enumerate(
        zip(dimensions, _spans(profile, dimensions), strict=True)
    ):
        if span is None:
            continue
        aside = _OUTSIDE.get(dimension.kind, (0.0, 0.0))
        start, end = paper.map(np.array([span.start, span.end])) + aside
        found.append(DimensionLine(number, span, start, end, aside))
    return found


def pick_dimension(
    profile: Profile, dimensions: tuple[Dimension, ...], paper: Paper, at: ScreenPoint
) -> Handle | None:
    """Return the dimension whose line a press would grab."""
    cursor = np.array((at.x, at.y))
    best, least = None, REACH
    for line in dimension_lines(profile, dimensions, paper):
        step = line.end - line.start
        squared = float(step @ step)
        part = float((cursor - line.start) @ step) / squared if squared > 0.0 else 0.0
        nearest = line.start + min(max(part, 0.0), 1.0) * step
        away = float(np.hypot(*(cursor - nearest)))
        if away < least:
            best, least = Handle(Target.DIMENSION, 0, line.number), away
    return best
