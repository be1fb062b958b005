"""Scales and papers: those of ISO 5455 and ISO 216, and what of them fits."""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum
from types import MappingProxyType

from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class Scale:
    """``paper`` millimetres of paper show ``real`` ones of the object.

    >>> str(Scale(1, 2)), Scale(1, 2).factor
    ('1:2', 0.5)
    """

    paper: int
    real: int

    @property
    def factor(self) -> float:
        """How many millimetres of paper show one of the object."""
        return self.paper / self.real

    def __str__(self) -> str:
        return f"{self.paper}:{self.real}"


TRUE_SIZE = Scale(1, 1)
# What drawings of the workshop are in, the largest first, and what plates are.
WORKSHOP = (Scale(2, 1), TRUE_SIZE, Scale(1, 2), Scale(1, 5))
PLATES = (TRUE_SIZE, Scale(1, 2), Scale(1, 3), Scale(1, 4), Scale(1, 5))
# Only where none of those fits, or all are too small to be read.
_BEYOND = tuple(Scale(1, digit * 10**power) for power in range(1, 12) for digit in (1, 2, 5))
_TINY = tuple(Scale(digit * 10**power, 1) for power in range(9, -1, -1) for digit in (10, 5, 2))


def scales_to_try(usual: tuple[Scale, ...], largest: float) -> tuple[Scale, ...]:
    """Return the scales to try in turn for an object of a size (mm), the largest first.

    What would be smaller than 40 mm at all the usual ones is enlarged until it is larger.
    """
    more = tuple(
        scale
        for scale in _TINY
        if largest * usual[0].factor < 40.0 and usual[0].factor < scale.factor <= 100.0 / largest
    )
    return (*more, *usual, *_BEYOND)


class Paper(StrEnum):
    """The sheets that drawings are made for."""

    A4 = "A4"
    A3 = "A3"
    A2 = "A2"
    A1 = "A1"
    LETTER = "Letter"


# Width and height in millimetres, upright.
SIZES: Mapping[Paper, tuple[float, float]] = MappingProxyType(
    {
        Paper.A4: (210.0, 297.0),
        Paper.A3: (297.0, 420.0),
        Paper.A2: (420.0, 594.0),
        Paper.A1: (594.0, 841.0),
        Paper.LETTER: (215.9, 279.4),
    }
)


@dataclass(frozen=True, slots=True)
class Sheet:
    """A paper, upright or lying."""

    paper: Paper
    lying: bool = False

    @property
    def size(self) -> tuple[float, float]:
        """Width and height in millimetres."""
        width, height = SIZES[self.paper]
        return (height, width) if self.lying else (width, height)

    def __str__(self) -> str:
        return f"{self.paper} {'landscape' if self.lying else 'portrait'}"


def sheets_of(paper: Paper) -> tuple[Sheet, Sheet]:
    """Return a paper as it is used first, then the other way: A4 and Letter upright."""
    upright = paper in (Paper.A4, Paper.LETTER)
    return Sheet(paper, not upright), Sheet(paper, upright)
