"""Patterns of holes through a vessel's wall: what can be asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum
from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import LENGTH, POSITIVE_LENGTH, Choice, Flag, Range
from sgb_core.fields.record import Record, check, says
from sgb_core.values import dataclass

MOST_ROWS, MOST_AROUND, MOST_PATTERNS = 60, 400, 20
# Sides of a round hole, and those of the ends of a slot.
_SIDES, _END_SIDES = 40, 20


class HoleShape(StrEnum):
    """The outline of a hole, seen straight on."""

    CIRCLE = "circle"
    ELLIPSE = "ellipse"
    SLOT = "slot"
    HEXAGON = "hexagon"


@dataclass(frozen=True, slots=True)
class CutOut:
    """Rows of equal holes between the margins at foot and rim; lengths in the document's unit.

    Rows are spaced evenly along the drawn profile, holes evenly around; a ``stagger`` shifts every
    other row by half a step. A circle is as wide as high: ``height`` is that of the others.
    ``bridge`` is the least that two holes may leave between them. Raises RefusalError, a
    ValueError, for a value that is not allowed.

    >>> from sgb_core.bodies.cut_outs import CutOut
    >>> str(CutOut(width=6.0).shape)
    'circle'
    """

    RECORD = Record("cut_outs", "Rows of holes through a vessel's wall; lengths in the unit.")

    shape: HoleShape = field(
        default=HoleShape.CIRCLE,
        metadata=says(
            Choice(HoleShape),
            label="Holes",
            tip="The outline of the holes",
            titles={
                HoleShape.CIRCLE: "Circles",
                HoleShape.ELLIPSE: "Ellipses",
                HoleShape.SLOT: "Slots",
                HoleShape.HEXAGON: "Hexagons",
            },
        ),
    )
    width: float = field(
        default=6.0,
        metadata=says(
            POSITIVE_LENGTH, label="Hole width", tip="How wide a hole is, around", reach=0.2
        ),
    )
    height: float = field(
        default=6.0,
        metadata=says(
            POSITIVE_LENGTH,
            label="Hole height",
            tip="How high a hole is along the wall; a circle is as high as wide",
            reach=0.5,
        ),
    )
    rows: int = field(
        default=3,
        metadata=says(
            Range(1, MOST_ROWS, whole=True), label="Rows", tip="Rows of holes, one above the other"
        ),
    )
    around: int = field(
        default=12,
        metadata=says(
            Range(1, MOST_AROUND, whole=True), label="Holes around", tip="Holes in each row"
        ),
    )
    stagger: bool = field(
        default=True,
        metadata=says(
            Flag(),
            label="Staggered",
            tip="Every other row stands half a step on",
        ),
    )
    foot_margin: float = field(
        default=8.0,
        metadata=says(
            LENGTH,
            label="Margin below",
            tip="How much wall stays whole above the floor",
            reach=0.3,
        ),
    )
    rim_margin: float = field(
        default=8.0,
        metadata=says(
            LENGTH, label="Margin above", tip="How much wall stays whole below the rim", reach=0.3
        ),
    )
    bridge: float = field(
        default=2.0,
        metadata=says(
            LENGTH,
            label="Least bridge",
            tip="Holes that leave less than this between them are refused",
            reach=0.1,
        ),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)

    @property
    def extent(self) -> tuple[float, float]:
        """The width and the height of a hole."""
        return self.width, self.width if self.shape is HoleShape.CIRCLE else self.height

    def outline(self) -> Floats:
        """Return a hole's outline counter-clockwise about (0, 0), (k, 2): around and up."""
        width, height = self.extent
        if self.shape is HoleShape.HEXAGON:
            angles = pi / 6.0 + pi / 3.0 * np.arange(6)
            # As wide across its flats as asked for, its corners above and below.
            unit = np.stack([np.cos(angles) * 2.0 / np.sqrt(3.0), np.sin(angles)], axis=1)
        elif self.shape is HoleShape.SLOT and width != height:
            return _slot(width, height)
        else:
            angles = 2.0 * pi * np.arange(_SIDES) / _SIDES
            unit = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        return np.asarray(unit * (width / 2.0, height / 2.0))


def _slot(width: float, height: float) -> Floats:
    """Return a rectangle with half circles at its ends, which are those of the longer way."""
    radius, along = min(width, height) / 2.0, abs(height - width) / 2.0
    angles = pi * np.arange(_END_SIDES + 1) / _END_SIDES
    cap = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    shift = np.array([0.0, along])
    upright = np.concatenate([cap + shift, -cap - shift])
    return upright if height >= width else np.stack([-upright[:, 1], upright[:, 0]], axis=1)


def hole_count(pattern: CutOut, whole: bool) -> int:
    """Return how many holes a pattern has; staggered rows of a part turn have one less."""
    less = 0 if whole or not pattern.stagger else pattern.rows // 2
    return pattern.rows * pattern.around - less
