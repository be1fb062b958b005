"""Patterns of holes through a vessel's wall: what can be asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum
from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import (
    IMAGE,
    LENGTH,
    LINE,
    POSITIVE_LENGTH,
    SHARE,
    Choice,
    Flag,
    Range,
)
from sgb_core.fields.record import Record, check, says
from sgb_core.lettering.fonts import TITLES, FontName
from sgb_core.values import dataclass

MOST_ROWS, MOST_AROUND, MOST_PATTERNS = 60, 400, 20
# Sides of a round hole where nothing else is asked for, and the fewest and the most.
_SIDES, _FEWEST, _MOST_SIDES = 40, 16, 400


class HoleShape(StrEnum):
    """The outline of a hole, seen straight on."""

    CIRCLE = "circle"
    ELLIPSE = "ellipse"
    SLOT = "slot"
    HEXAGON = "hexagon"
    TEXT = "text"
    PICTURE = "picture"

    @property
    def is_drawn(self) -> bool:
        """Whether holes are shapes of their own, laid around the wall, and not drilled straight."""
        return self in (HoleShape.TEXT, HoleShape.PICTURE)


@dataclass(frozen=True, slots=True)
class CutOut:
    """Rows of equal holes between the margins at foot and rim; lengths in the document's unit.

    Rows are spaced evenly along the drawn profile, holes evenly around; a ``stagger`` shifts every
    other row by half a step. A circle is as wide as high: ``height`` is that of the others, and of
    the capitals of a ``text``; what is darker than ``threshold`` of a ``picture``, named as a
    texture names it, is cut ``width`` wide. ``bridge`` is the least that two holes may leave
    between them; text and pictures are given bridges so wide that hold their islands.

    Raises RefusalError, a ValueError, for a value that is not allowed.

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
                HoleShape.TEXT: "Text",
                HoleShape.PICTURE: "Dark parts of a picture",
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
            tip="How high a hole is along the wall, or the capitals of a text are",
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
    text: str = field(
        default="LIGHT",
        kw_only=True,
        metadata=says(LINE, label="Text", tip="What is cut out, letter by letter", brief=True),
    )
    font: FontName = field(
        default=FontName.SANS_BOLD,
        kw_only=True,
        metadata=says(
            Choice(FontName),
            label="Font",
            tip="In which letters it is set",
            titles=TITLES,
            brief=True,
        ),
    )
    picture: str = field(
        default="geometric",
        kw_only=True,
        metadata=says(
            IMAGE, label="Picture", tip="The picture whose dark parts are cut out", brief=True
        ),
    )
    threshold: float = field(
        default=0.5,
        kw_only=True,
        metadata=says(
            SHARE,
            label="Darker than",
            tip="What is darker than this is cut: 0 % is black, 100 % white",
            brief=True,
        ),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)

    @property
    def extent(self) -> tuple[float, float]:
        """The width and the height of a hole that is not drawn."""
        return self.width, self.width if self.shape is HoleShape.CIRCLE else self.height

    def outline(self, within: float | None = None) -> Floats:
        """Return the outline of a hole that is not drawn, counter-clockwise about (0, 0), (k, 2).

        It goes around and up. Round ones are polygons of the same area, ``within`` so much of the
        curve; without it they have many corners, on the curve.
        """
        width, height = self.extent
        sides = _sides(max(width, height) / 2.0, within)
        if self.shape is HoleShape.HEXAGON:
            angles = pi / 6.0 + pi / 3.0 * np.arange(6)
            # As wide across its flats as asked for, its corners above and below.
            unit = np.stack([np.cos(angles) * 2.0 / np.sqrt(3.0), np.sin(angles)], axis=1)
        elif self.shape is HoleShape.SLOT and width != height:
            return _slot(width, height, within)
        else:
            angles = 2.0 * pi * np.arange(sides) / sides
            unit = np.stack([np.cos(angles), np.sin(angles)], axis=1)
            if within is not None:
                unit *= np.sqrt(2.0 * pi / sides / np.sin(2.0 * pi / sides))
        return np.asarray(unit * (width / 2.0, height / 2.0))


def _sides(radius: float, within: float | None) -> int:
    """Return how many sides stand for a circle: a multiple of four."""
    if within is None:
        return _SIDES
    count = pi / np.arccos(max(1.0 - within / radius, 0.0))
    return int(np.clip(4 * np.ceil(count / 4.0), _FEWEST, _MOST_SIDES))


def _slot(width: float, height: float, within: float | None) -> Floats:
    """Return a rectangle with half circles at its ends, which are those of the longer way.

    ``within`` some distance the corners between the ends of a half circle lie so far outside it
    that the area is that of the circle.
    """
    radius, along = min(width, height) / 2.0, abs(height - width) / 2.0
    sides = _sides(radius, within) // 2
    angles = pi * np.arange(sides + 1) / sides
    cap = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    # 2 k + (n − 2) k² times sin(π/n)/2 is the area of the unit half circle, π/2.
    wanted, inner = pi / np.sin(pi / sides), sides - 2.0
    if within is not None:
        cap[1:-1] *= (np.sqrt(1.0 + inner * wanted) - 1.0) / inner
    shift = np.array([0.0, along])
    upright = np.concatenate([cap + shift, -cap - shift])
    return upright if height >= width else np.stack([-upright[:, 1], upright[:, 0]], axis=1)


def place_count(cut_out: CutOut, whole: bool) -> int:
    """Return in how many places it stands; staggered rows of a part turn have one less."""
    less = 0 if whole or not cut_out.stagger else cut_out.rows // 2
    return cut_out.rows * cut_out.around - less
