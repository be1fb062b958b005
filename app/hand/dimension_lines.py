"""Dimension lines on the paper: where they lie in pixels, and which one is under the pointer."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from app.hand.coordinates import Paper, ScreenPoint
from app.hand.hit_test import Handle, Target
from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.locks.readings import Setting
from sgb_core.design.locks.spans import Span, Way, spans
from sgb_core.document.dimensions import setting_of
from sgb_core.document.model import Document
from sgb_core.values import dataclass

REACH = 6.0
# How far beside the shape lines of the rim, the foot and the height lie.
ASIDE = 15.0
# A line shorter than this has its arrows outside, each as long as the second.
_SHORT, _OUTER = 26.0, 18.0
# An angle's arc as a part of its line.
_ARC, _ARC_POINTS = 0.6, 17
_K = DimensionKind
_OUTSIDE = {_K.RIM_DIAMETER: (0.0, -ASIDE), _K.FOOT_DIAMETER: (0.0, ASIDE), _K.HEIGHT: (ASIDE, 0.0)}


@dataclass(frozen=True, slots=True)
class DimensionLine:
    """One line from ``start`` to ``end`` in pixels; what it measures lies ``aside`` of it.

    ``place`` is where on the curve a level is taken, ``arc`` (n, 2) what an angle sweeps, with its
    corner as the first.
    """

    number: int
    span: Span
    start: Floats
    end: Floats
    aside: tuple[float, float]
    place: Floats | None = None
    arc: Floats | None = None

    @property
    def is_short(self) -> bool:
        """Whether there is no room for its arrows between its ends: they stand outside."""
        return float(np.hypot(*(self.end - self.start))) < _SHORT

    @property
    def drawn(self) -> tuple[Floats, Floats]:
        """Where the line begins and ends as it is drawn, its outer arrows with it."""
        if not self.is_short:
            return self.start, self.end
        way = self.end - self.start
        length = float(np.hypot(*way))
        along = way / length if length > 0.0 else np.array((0.0, -1.0))
        return self.start - _OUTER * along, self.end + _OUTER * along


@lru_cache(maxsize=4)
def _spans(
    profile: Profile, dimensions: tuple[Dimension, ...], setting: Setting
) -> list[Span | None]:
    return spans(profile, dimensions, setting)


def dimension_lines(document: Document, paper: Paper) -> list[DimensionLine]:
    """Return the lines of the dimensions that have one."""
    dimensions = document.dimensions
    found = []
    for number, (dimension, span) in enumerate(
        zip(
            dimensions,
            _spans(document.profile, dimensions, setting_of(document)) if dimensions else (),
            strict=True,
        )
    ):
        if span is None:
            continue
        aside = _OUTSIDE.get(dimension.kind, (0.0, 0.0))
        start, end = paper.map(np.array([span.start, span.end])) + aside
        place = None if span.place is None else paper.map(np.array(span.place))
        arc = paper.map(_arc(span)) if span.way is Way.TURN else None
        found.append(DimensionLine(number, span, start, end, aside, place, arc))
    return found


def _arc(span: Span) -> Floats:
    """Return an angle's corner and its arc (n, 2) from straight away from the axis to its line."""
    start, way = np.array(span.start), np.subtract(span.end, span.start)
    turns = np.linspace(0.0, np.arctan2(way[1], way[0]), _ARC_POINTS)
    around = _ARC * float(np.hypot(*way)) * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    return np.concatenate([start[None], start + around])


def pick_dimension(document: Document, paper: Paper, at: ScreenPoint) -> Handle | None:
    """Return the dimension whose line a press would grab."""
    cursor = np.array((at.x, at.y))
    best, least = None, REACH
    for line in dimension_lines(document, paper):
        start, end = line.drawn
        step = end - start
        squared = float(step @ step)
        part = float((cursor - start) @ step) / squared if squared > 0.0 else 0.0
        nearest = start + min(max(part, 0.0), 1.0) * step
        away = float(np.hypot(*(cursor - nearest)))
        if away < least:
            best, least = Handle(Target.DIMENSION, 0, line.number), away
    return best
