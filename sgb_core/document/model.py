"""The document: everything a project file holds, as frozen values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sgb_core.arrays import Floats
from sgb_core.bodies.body import Body
from sgb_core.bodies.solid import Solid
from sgb_core.curves.continuity import JointReport
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import NO_EXTRA
from sgb_core.document.appearance.model import Appearance
from sgb_core.document.manufacture import Manufacture
from sgb_core.document.plates import PlateSettings
from sgb_core.surfaces import measures
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.turning_joints import measure_turning_joints
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
    """About which axis the profile turns, from which angle and how far, in degrees.

    >>> str(sgb.Revolution(sweep_deg=90.0).axis)
    'z'
    """

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

    >>> wall = sgb.Segment([(20, 0), (55, 10), (50, 60), (25, 80)])
    >>> cup = sgb.Document(sgb.Profile.of([wall]), name="Cup")
    >>> f"{cup.volume:.0f} {cup.unit}³, {cup.height:.0f} {cup.unit} high"
    '389587 mm³, 80 mm high'
    >>> fuller = sgb.edits.set_shape_parameter(cup, 0, "omega", 0.8)
    >>> cup.profile[0].shape.omega, fuller.profile[0].shape.omega
    (0.0, 0.8)
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

    def body(self) -> Body:
        """Return what the surface and ``solid`` make: it answers what is asked of an object."""
        return Body(self.surface, self.solid)

    @property
    def joints(self) -> tuple[JointReport, ...]:
        """What each joint truly is, under laws over the whole turn."""
        return measure_turning_joints(self.surface)

    @property
    def volume(self) -> float:
        """The volume that the drawn surface encloses, in unit³, whatever ``solid`` is."""
        return measures.volume(self)

    @property
    def area(self) -> float:
        """The area of the drawn surface, in unit²."""
        return measures.area(self)

    @property
    def centroid(self) -> Floats | None:
        """The centroid (x, y, z) of that volume, placed; None where there is none."""
        return measures.centroid(self)

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """The lower and upper corner (x, y, z) of the placed surface's box, each shape (3,)."""
        return measures.bounds(self)

    @property
    def height(self) -> float:
        """How far the surface reaches along its axis, in unit."""
        return measures.height(self)

    @property
    def largest_diameter(self) -> float:
        """Twice the largest distance of the surface from its axis, in unit."""
        return measures.largest_diameter(self)

    @property
    def generatrix_length(self) -> float:
        """The arc length of the profile, in unit, where laws hold of that at the start angle."""
        return measures.generatrix_length(self)

    @property
    def bending_energy(self) -> float | None:
        """∫ κ² dl of the same curve, in 1/unit; None where it diverges."""
        return measures.bending_energy(self)

    @property
    def surface_bending_energy(self) -> float | None:
        """∬ (κm² + κp²) dA of the surface; None where it diverges or laws hold."""
        return measures.surface_bending_energy(self)
