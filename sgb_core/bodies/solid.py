"""What the drawn surface means as an object: a bare surface, a filled solid, a vessel."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sgb_core.curves.segment import NO_EXTRA


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

    ``drain_hole`` is a diameter, ``foot_ring`` the height of the ring below the floor.

    >>> solid = sgb.Solid(sgb.BodyKind.VESSEL, wall=3.0, base=4.0)
    >>> str(solid.side), solid.drain_hole
    ('inside', 0.0)
    """

    kind: BodyKind = BodyKind.SURFACE
    wall: float = 3.0
    side: WallSide = WallSide.INSIDE
    base: float = 3.0
    rim: Rim = Rim.FLAT
    drain_hole: float = 0.0
    foot_ring: float = 0.0
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)
