"""The document: everything a project file holds, as frozen values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from math import fmod, radians
from typing import Any

from sgb_core.arrays import Floats
from sgb_core.bodies.body import Body
from sgb_core.bodies.cut_outs import MOST_PATTERNS, CutOut
from sgb_core.bodies.hole_pattern import Pattern
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.continuity import JointReport
from sgb_core.curves.profile import Profile
from sgb_core.design.locks.dimension import MAX_DIMENSIONS, Dimension, misplaced
from sgb_core.document.appearance.dark_parts import patterns_of
from sgb_core.document.appearance.model import OWN_PICTURE, Appearance
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.guides import MAX_GUIDES, Guide
from sgb_core.document.manufacture import Manufacture
from sgb_core.document.plates import MAX_STATE_NAME, PlateSettings
from sgb_core.document.reference import Reference
from sgb_core.document.unit import Unit as Unit
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import Choice, Kind, Range, Said, Schema, Text
from sgb_core.fields.lists import OrNone, Several
from sgb_core.fields.record import Flat, Part, Record, check, says, table_of
from sgb_core.findings.finding import Path
from sgb_core.findings.refusal import MISSING, RefusalError, Taken
from sgb_core.surfaces import measures
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.turning_joints import measure_turning_joints
from sgb_core.surfaces.twist import Twist
from sgb_core.values import dataclass

# What a project keeps at most.
MAX_STATES = 50
MAX_LAWS = 500
# An angle is counted modulo 360; a larger one would lose its degrees to rounding.
MAX_START = 1e9
_SWEEP = Range(above=0.0, high=360.0)


@dataclass(frozen=True, slots=True)
class Revolution:
    """About which axis the profile turns, from which angle and how far, in degrees.

    >>> str(sgb.Revolution(sweep_deg=90.0).axis)
    'z'
    """

    RECORD = Record("revolution")

    axis: Axis = field(default=Axis.Z, metadata=says(Choice(Axis), label="Axis"))
    start_deg: float = field(
        default=0.0, metadata=says(Range(-MAX_START, MAX_START), label="Start angle")
    )
    sweep_deg: float = field(default=360.0, metadata=says(_SWEEP, label="Sweep"))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        # The smallest doubles vanish in radians.
        if radians(self.sweep_deg) == 0.0:
            raise _SWEEP.refusal(self.sweep_deg, ("revolution", "sweep_deg"))


@dataclass(frozen=True, slots=True)
class _State(Kind):
    """A document under a name of its own, without states, plate and reference."""

    @property
    def words(self) -> str:
        return 'an object {"name": ..., "profile": ...}'

    def take(self, value: object, path: Path) -> Document:
        state: Document = Part(Document).take(value, path)
        _STATE_NAME.take(state.name, (*path, "name"))
        for key in _NOT_IN_STATES:
            if getattr(state, key):
                raise _NONE.refusal(getattr(state, key), (*path, key))
        return state

    def from_plain(self, value: object, path: Path) -> Any:
        if not isinstance(value, Mapping):
            raise self.refusal(value, path)
        _STATE_NAME.take(value.get("name", MISSING), (*path, "name"))
        for key in _NOT_IN_STATES:
            if key in value:
                raise _NONE.refusal(value[key], (*path, key))
        return table_of(Document).from_plain(value, path)

    def to_plain(self, value: Any) -> object:
        return table_of(Document).to_plain(value)

    def schema(self, shared: Schema) -> Schema:
        if "state" not in shared:
            properties = table_of(Document).properties(shared, without=_NOT_IN_STATES)
            properties["name"] = _STATE_NAME.schema(shared)
            required = ["name", "profile"]
            shared["state"] = {"type": "object", "required": required, "properties": properties}
        return {"$ref": "#/$defs/state"}


_STATE_NAME = Text(1, MAX_STATE_NAME)
_NOT_IN_STATES = ("states", "plate", "reference")
_NONE = Said("none in a state")


@dataclass(frozen=True, slots=True)
class Document:
    """One project: a profile, how it turns, and what the result means.

    ``states`` are other versions of it kept under names of their own, each a document without
    states; see :mod:`sgb_core.document.edits.states`.
    ``extra`` fields, here and in the parts, carry the file's unknown keys through load and save.
    A section of the file is a field here: it is read, checked, written and put into the schema
    by what its class says of it.

    Raises RefusalError, a ValueError, for a value that is not allowed: whatever can be made can be
    saved and loaded again.

    >>> wall = sgb.Segment([(20, 0), (55, 10), (50, 60), (25, 80)])
    >>> cup = sgb.Document(sgb.Profile.of([wall]), name="Cup")
    >>> f"{cup.volume:.0f} {cup.unit}³, {cup.height:.0f} {cup.unit} high"
    '389587 mm³, 80 mm high'
    >>> fuller = sgb.edits.set_shape_parameter(cup, 0, "omega", 0.8)
    >>> cup.profile[0].shape.omega, fuller.profile[0].shape.omega
    (0.0, 0.8)
    """

    RECORD = Record("", first=("name", "unit"), reserved=("format", "version"))

    profile: Profile = field(metadata=says(Part(Profile)))
    name: str = field(default="Untitled", metadata=says(Text(), label="Name"))
    unit: Unit = field(
        default=Unit.MM, metadata=says(Choice(Unit), label="Unit", tip="The unit of all lengths.")
    )
    revolution: Revolution = field(default=Revolution(), metadata=says(Part(Revolution)))
    variation: tuple[Law, ...] = field(
        default=(),
        metadata=says(
            Several(Part(Law), "laws", MAX_LAWS),
            tip="Where two laws name the same parameter of a segment the later one counts.",
            brief=True,
        ),
    )
    twist: Twist = field(default=Twist(), kw_only=True, metadata=says(Part(Twist), brief=True))
    solid: Solid = field(default=Solid(), metadata=says(Part(Solid), brief=True))
    placement: Placement = field(default=Placement(), metadata=says(Part(Placement), brief=True))
    cut_outs: tuple[CutOut, ...] = field(
        default=(),
        kw_only=True,
        metadata=says(
            Several(Part(CutOut), "patterns", MOST_PATTERNS),
            tip="Patterns of holes through a vessel's wall.",
            brief=True,
        ),
    )
    appearance: Appearance = field(
        default=Appearance(), kw_only=True, metadata=says(Part(Appearance), brief=True)
    )
    manufacture: Manufacture = field(
        default=Manufacture(), kw_only=True, metadata=says(Flat(Manufacture))
    )
    dimensions: tuple[Dimension, ...] = field(
        default=(),
        kw_only=True,
        metadata=says(
            Several(Part(Dimension), "dimensions", MAX_DIMENSIONS),
            tip="What is dimensioned; locked ones hold while everything else changes.",
            brief=True,
        ),
    )
    guides: tuple[Guide, ...] = field(
        default=(),
        kw_only=True,
        metadata=says(
            Several(Part(Guide), "guides", MAX_GUIDES),
            tip="Lines to draw by; they are no part of the object.",
            brief=True,
        ),
    )
    states: tuple[Document, ...] = field(
        default=(),
        kw_only=True,
        metadata=says(
            Several(_State(), "states", MAX_STATES),
            tip="Other versions of the document, kept under different names; each has the "
            "sections of a document.",
            brief=True,
        ),
    )
    plate: PlateSettings | None = field(
        default=None, kw_only=True, metadata=says(OrNone(Part(PlateSettings)), brief=True)
    )
    reference: Reference | None = field(
        default=None, kw_only=True, metadata=says(OrNone(Part(Reference)), brief=True)
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        fault = self.profile.fault
        if fault is not None:
            raise RefusalError(fault)
        names: set[str] = set()
        for place, state in enumerate(self.states):
            if state.name in names:
                raise RefusalError(Taken(("states", place, "name"), "state"))
            names.add(state.name)
        last = len(self.profile) - 1
        for place, dimension in enumerate(self.dimensions):
            wrong = misplaced(dimension, len(self.profile), len(self.profile.rules))
            if wrong is not None:
                key, value, most = wrong
                raise Said(f"a number from 0 to {most}").refusal(value, ("dimensions", place, *key))
        for place, cut_out in enumerate(self.cut_outs):
            name = cut_out.picture
            if len(name) == 64 and self.appearance.picture(name) is None:
                raise OWN_PICTURE.refusal(name, ("cut_outs", place, "picture"))
        for place, law in enumerate(self.variation):
            if law.segments and max(law.segments) > last:
                number = next(k for k, segment in enumerate(law.segments) if segment > last)
                path = ("variation", place, "segments", number)
                raise Said(f"a segment number from 0 to {last}").refusal(law.segments[number], path)

    @property
    def surface(self) -> RevolutionSurface:
        """The rotation surface that the document describes."""
        return RevolutionSurface.of_degrees(
            self.profile,
            axis=self.revolution.axis,
            start_deg=fmod(self.revolution.start_deg, 360.0),
            sweep_deg=self.revolution.sweep_deg,
            laws=self.variation,
            placement=self.placement,
            twist=self.twist,
        )

    def body(self) -> Body:
        """Return what the surface and ``solid`` make: it answers what is asked of an object."""
        return Body(self.surface, self.solid, self.patterns, relief_of(self.appearance))

    @property
    def patterns(self) -> tuple[Pattern, ...]:
        """The cut-outs with the shapes of their pictures."""
        return patterns_of(self.cut_outs, self.appearance)

    @property
    def has_body(self) -> bool:
        """Whether there is more than the drawn surface: a solid, or a relief on it."""
        bare = self.solid.kind is BodyKind.SURFACE
        return not bare or relief_of(self.appearance) is not None

    @property
    def rim_height(self) -> float:
        """The height of the upper end of the profile, which is a vessel's rim."""
        first, last = self.profile.segments[0].points[0], self.profile.segments[-1].points[3]
        return max(float(first[1]), float(last[1]))

    @property
    def fill_height(self) -> float | None:
        """The height of the fill line as a profile's h; None where there is none."""
        return self.manufacture.fill.level(self.rim_height)

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
