"""What becomes of the object: how far it is filled, what it is made of, how much it shrinks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum
from types import MappingProxyType

from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import COORDINATE, MAX_COORDINATE, Choice, Range, Said, Text
from sgb_core.fields.lists import OrNone
from sgb_core.fields.record import Part, Record, check, says
from sgb_core.values import dataclass

# Grams per cubic centimetre as commonly given; a bisque-fired stoneware body for clay, beech for
# wood, soda-lime for glass.
DENSITIES: Mapping[str, float] = MappingProxyType(
    {
        "clay": 1.9,
        "porcelain": 2.4,
        "PLA": 1.24,
        "plaster": 1.1,
        "glass": 2.5,
        "wood": 0.72,
        "steel": 7.85,
    }
)
MAX_DENSITY = 100.0
MAX_MATERIAL_NAME = 60
# No ceramic body shrinks by half; beyond it the wet size would soon have no bound.
MAX_SHRINKAGE = 50.0

# How far a fill line may lie below the rim.
DISTANCE = Range(0.0, MAX_COORDINATE, length=True)


@dataclass(frozen=True, slots=True)
class Fill:
    """The ``fill`` section: how high the object is filled; with neither field there is no line.

    ``height`` is a height of the profile, ``below_rim`` how far the line lies below the rim: it
    stays so when the shape changes. At most one of them is given.

    >>> from sgb_core.document.manufacture import Fill
    >>> Fill(below_rim=10.0).level(rim=95.0)
    85.0
    """

    RECORD = Record(
        "fill",
        "The fill line, either as a height of the profile or by how far it lies below the rim; "
        "without either there is none.",
    )

    height: float | None = field(
        default=None, metadata=says(OrNone(COORDINATE), label="Fill line", brief=True)
    )
    below_rim: float | None = field(
        default=None,
        metadata=says(OrNone(DISTANCE), label="Fill line below the rim", brief=True),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        if self.height is not None and self.below_rim is not None:
            raise Said("null beside a height").refusal(self.below_rim, ("fill", "below_rim"))

    def level(self, rim: float) -> float | None:
        """Return the height of the fill line under a rim at a height; None where there is none."""
        return self.height if self.below_rim is None else rim - self.below_rim


@dataclass(frozen=True, slots=True)
class Material:
    """The ``material`` section: a name, and the density in grams per cubic centimetre."""

    RECORD = Record(
        "material", "What the body is made of; the density in grams per cubic centimetre."
    )

    name: str = field(default="clay", metadata=says(Text(1, MAX_MATERIAL_NAME), label="Material"))
    density: float = field(
        default=DENSITIES["clay"],
        metadata=says(Range(above=0.0, high=MAX_DENSITY), label="Density"),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)


class Stage(StrEnum):
    """Before and after the shrinking."""

    WET = "wet"
    FIRED = "fired"


@dataclass(frozen=True, slots=True)
class Shrinkage:
    """The ``shrinkage`` section: ``percent`` of which size, and which of the two is drawn.

    Of the wet size: fired = wet·(1 − p/100), as potters' clay bodies are specified. Of the fired
    size: wet = fired·(1 + p/100). At 12 % the wet size is 1.136 and 1.12 times the fired one.
    """

    RECORD = Record(
        "shrinkage",
        "Of the wet size: fired = wet·(1 − percent/100). Of the fired size: wet = "
        "fired·(1 + percent/100). drawn says which of the two sizes the profile has.",
    )

    percent: float = field(default=0.0, metadata=says(Range(0.0, MAX_SHRINKAGE), label="Shrinkage"))
    of: Stage = field(default=Stage.WET, metadata=says(Choice(Stage), label="Shrinkage counts"))
    drawn: Stage = field(default=Stage.FIRED, metadata=says(Choice(Stage), label="Drawn is"))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)

    @property
    def wet_over_fired(self) -> float:
        """How many times as large as the fired piece the wet one is, each way."""
        part = self.percent / 100.0
        return 1.0 / (1.0 - part) if self.of is Stage.WET else 1.0 + part

    def factor(self, stage: Stage) -> float:
        """Return by what drawn lengths are multiplied to be those at ``stage``."""
        if stage is self.drawn:
            return 1.0
        return self.wet_over_fired if stage is Stage.WET else 1.0 / self.wet_over_fired


@dataclass(frozen=True, slots=True)
class Manufacture:
    """The sections of a project that say what becomes of the object."""

    RECORD = Record("", brief=True)

    fill: Fill = field(default=Fill(), metadata=says(Part(Fill)))
    material: Material = field(default=Material(), metadata=says(Part(Material)))
    shrinkage: Shrinkage = field(default=Shrinkage(), metadata=says(Part(Shrinkage)))

    def __post_init__(self) -> None:
        check(self)
