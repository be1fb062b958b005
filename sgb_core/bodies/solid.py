"""What the drawn surface means as an object: a bare surface, a filled solid, a vessel."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum

from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import LENGTH, POSITIVE_LENGTH, Choice
from sgb_core.fields.record import Record, check, says
from sgb_core.values import dataclass


class BodyKind(StrEnum):
    """Surface: as drawn. Filled: closed to the axis. Vessel: a wall along the profile."""

    SURFACE = "surface"
    FILLED = "filled"
    VESSEL = "vessel"


class WallSide(StrEnum):
    """On which side of the drawn profile a vessel's material lies."""

    INSIDE = "inside"
    OUTSIDE = "outside"


class Rim(StrEnum):
    """The upper end of a vessel's wall: cut flat or rounded by a half circle."""

    FLAT = "flat"
    ROUND = "round"


@dataclass(frozen=True, slots=True)
class Solid:
    """The ``solid`` section of a project; lengths in the document's unit.

    ``drain_hole`` is a diameter, ``foot_ring`` the height of the ring below the floor. Raises
    RefusalError, a ValueError, for a value that is not allowed.

    >>> solid = sgb.Solid(sgb.BodyKind.VESSEL, wall=3.0, base=4.0)
    >>> str(solid.side), solid.drain_hole
    ('inside', 0.0)
    """

    RECORD = Record("solid", "What the drawn surface means as an object; lengths in the unit.")

    kind: BodyKind = field(
        default=BodyKind.SURFACE,
        metadata=says(
            Choice(BodyKind),
            label="Body",
            titles={
                BodyKind.SURFACE: "Surface",
                BodyKind.FILLED: "Filled",
                BodyKind.VESSEL: "Vessel",
            },
            tips={
                BodyKind.SURFACE: "The bare surface as drawn, without thickness",
                BodyKind.FILLED: "A full solid: the ends of the profile are closed to the axis",
                BodyKind.VESSEL: "A pot: a wall of even thickness along the profile, and a floor",
            },
        ),
    )
    wall: float = field(
        default=3.0,
        metadata=says(
            POSITIVE_LENGTH,
            label="Wall",
            tip="How thick the wall is, measured straight through it and not level: shoulders and "
            "belly are as thick as the rest",
            reach=0.06,
        ),
    )
    side: WallSide = field(
        default=WallSide.INSIDE,
        metadata=says(
            Choice(WallSide),
            label="Wall lies",
            tip="On which side of the drawn line the material is",
            titles={
                WallSide.INSIDE: "Inside the drawn line",
                WallSide.OUTSIDE: "Outside the drawn line",
            },
        ),
    )
    base: float = field(
        default=3.0,
        metadata=says(
            LENGTH,
            label="Floor",
            tip="How thick the floor is. With 0 a profile that ends off the axis stays open below",
            reach=0.08,
        ),
    )
    rim: Rim = field(
        default=Rim.FLAT,
        metadata=says(
            Choice(Rim),
            label="Rim",
            tip="Cut level, or rounded over across the wall, as high as drawn",
            titles={Rim.FLAT: "Flat", Rim.ROUND: "Rounded"},
        ),
    )
    drain_hole: float = field(
        default=0.0,
        metadata=says(
            LENGTH,
            label="Drain hole ⌀",
            tip="Width of a round hole through the middle of the floor; 0 is none",
            reach=0.15,
        ),
    )
    foot_ring: float = field(
        default=0.0,
        metadata=says(
            LENGTH,
            label="Foot ring",
            tip="Height of a ring below the floor to stand on, as wide as the wall; 0 is none",
            reach=0.06,
        ),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
