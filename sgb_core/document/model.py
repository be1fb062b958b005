"""The document: everything a project file holds, as frozen values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sgb_core.bodies.solid import Solid
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import NO_EXTRA
from sgb_core.document.appearance.model import Appearance
from sgb_core.document.manufacture import Manufacture
from sgb_core.document.plates import PlateSettings
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.variation import Law

# What a file keeps at most: named states, and characters in the name of one.
MAX_STATES = 50
MAX_STATE_NAME = 60


class Unit(StrEnum):
    """The length unit of all coordinates."""

    MM = "mm"
    CM = "cm"
    IN = "in"

    @property
    def millimetres(self) -> float:
        """How many millimetres one unit is."""
        return {Unit.MM: 1.0, Unit.CM: 10.0, Unit.IN: 25.4}[self]

    @property
    def millilitres(self) -> float:
        """How many millilitres one cubic unit is."""
        return self.millimetres**3 / 1000.0

    def factor_to(self, other: Unit) -> float:
        """Return by what a length in this unit is multiplied to be in another."""
        return self.millimetres / other.millimetres


@dataclass(frozen=True, slots=True)
class Revolution:
    """About which axis the profile turns, from which angle and how far, in degrees."""

    axis: Axis = Axis.Z
    start_deg: float = 0.0
    sweep_deg: float = 360.0
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)


@dataclass(frozen=True, slots=True)
class Document:
    """One project: a profile, how it turns, and what the result means.

    ``states`` are other versions of it kept under names of their own, each a document without
    states; see :mod:`sgb_core.document.edits.states`.
    ``extra`` fields, here and in the parts, carry the file's unknown keys through load and save.
    """

    profile: Profile
    name: str = "Untitled"
    unit: Unit = Unit.MM
    revolution: Revolution = Revolution()
    variation: tuple[Law, ...] = ()
    solid: Solid = Solid()
    placement: Placement = Placement()
    manufacture: Manufacture = field(default=Manufacture(), kw_only=True)
    states: tuple[Document, ...] = field(default=(), kw_only=True)
    appearance: Appearance = field(default=Appearance(), kw_only=True)
    plate: PlateSettings | None = field(default=None, kw_only=True)
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    @property
    def surface(self) -> RevolutionSurface:
        """The rotation surface that the document describes."""
        return RevolutionSurface.of_degrees(
            self.profile,
            axis=self.revolution.axis,
            start_deg=self.revolution.start_deg,
            sweep_deg=self.revolution.sweep_deg,
            laws=self.variation,
            placement=self.placement,
        )
