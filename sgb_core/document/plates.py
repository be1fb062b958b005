"""A figure plate as it is kept in the project: which states it shows, and how."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from itertools import product
from typing import TYPE_CHECKING

from sgb_core.curves.segment import PARAMETER_RANGES, ParameterName, parameter_range
from sgb_core.document.errors import EditError
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import FINITE, Choice, Chosen, Flag, Range, Text
from sgb_core.fields.lists import OrNone, Several
from sgb_core.fields.record import Part, Record, check, says

if TYPE_CHECKING:
    from sgb_core.document.model import Document

# What a plate holds at most.
MAX_PANELS = 48
MAX_VALUES = 24
MAX_TITLE = 200
MIN_WIDTH, MAX_WIDTH = 20.0, 600.0
MIN_DPI, MAX_DPI = 50, 1200
# Characters in the name of a state, by which a plate calls it.
MAX_STATE_NAME = 60


class PlatePart(StrEnum):
    """What is drawn over the surfaces."""

    GENERATRIX = "generatrix"
    POLYGON = "polygon"
    CIRCLES = "circles"
    AXES = "axes"


class Projection(StrEnum):
    """How a camera projects."""

    PARALLEL = "parallel"
    PERSPECTIVE = "perspective"


@dataclass(frozen=True, slots=True)
class Variation:
    """A shape parameter and the values that it takes, of one segment or (None) of all."""

    RECORD = Record("vary")

    parameter: ParameterName = field(metadata=says(Choice(PARAMETER_RANGES)))
    values: tuple[float, ...] = field(
        metadata=says(Several(FINITE, "numbers", MAX_VALUES, 1), label="Values")
    )
    segment: int | None = field(
        default=None,
        metadata=says(OrNone(Range(0, 10**6, whole=True, said="a segment number"), "all")),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        allowed = parameter_range(self.parameter)
        for place, value in enumerate(self.values):
            allowed.take(value, ("vary", "values", place))


@dataclass(frozen=True, slots=True)
class PlateCamera:
    """The direction from which all panels are seen, in degrees; what is seen always fits."""

    RECORD = Record("camera")

    azimuth_deg: float = field(default=-58.0, metadata=says(FINITE))
    elevation_deg: float = field(default=21.0, metadata=says(Range(-90.0, 90.0)))
    projection: Projection = field(default=Projection.PARALLEL, metadata=says(Choice(Projection)))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)


@dataclass(frozen=True, slots=True)
class PlateSettings:
    """A plate of the document's own panels.

    With ``states`` each named state is a panel ("" is the document as it is); else ``vary``, none
    to two variations, gives one for each value, or pair of values, the second running fastest.
    ``columns`` 0 chooses a number; ``panel_height_mm`` None takes what the contents need.
    """

    RECORD = Record(
        "plate",
        'A figure plate: each named state is a panel ("" is the document as it is), or else each '
        "value, or pair of values, of the variations. Values lie in the parameter's range, states "
        f"and segments exist, and there are at most {MAX_PANELS} panels.",
    )

    vary: tuple[Variation, ...] = field(
        default=(), metadata=says(Several(Part(Variation), "variations", 2))
    )
    states: tuple[str, ...] = field(
        default=(),
        metadata=says(Several(Text(most=MAX_STATE_NAME), "names of states", MAX_PANELS)),
    )
    columns: int = field(
        default=0, metadata=says(Range(0, MAX_PANELS, whole=True), label="Columns")
    )
    labels: bool = field(default=True, metadata=says(Flag()))
    captions: bool = field(default=True, metadata=says(Flag()))
    title: str = field(default="", metadata=says(Text(most=MAX_TITLE), label="Title"))
    show: frozenset[PlatePart] = field(
        default=frozenset({PlatePart.GENERATRIX}), metadata=says(Chosen(PlatePart, "parts"))
    )
    width_mm: float = field(
        default=175.0, metadata=says(Range(MIN_WIDTH, MAX_WIDTH), label="Width")
    )
    panel_height_mm: float | None = field(
        default=None, metadata=says(OrNone(Range(5.0, MAX_WIDTH)), label="Panel height")
    )
    dpi: int = field(
        default=300, metadata=says(Range(MIN_DPI, MAX_DPI, whole=True), label="Resolution")
    )
    common_scale: bool = field(default=True, metadata=says(Flag()))
    camera: PlateCamera = field(default=PlateCamera(), metadata=says(Part(PlateCamera)))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)


@dataclass(frozen=True, slots=True)
class PlatePanel:
    """One panel's document, and what tells it from the others."""

    document: Document
    values: tuple[tuple[Variation, float], ...] = ()
    state: str = ""


def set_plate(document: Document, plate: PlateSettings | None) -> Document:
    """Keep a plate in the document; raises EditError for one that it cannot draw."""
    if plate == document.plate:
        return document
    if plate is not None:
        plate_panels(document, plate)
    return replace(document, plate=plate)


def plate_panels(document: Document, plate: PlateSettings) -> tuple[PlatePanel, ...]:
    """Return the panels of a plate, in order.

    Raises EditError for a state, a segment or a value that there is not, and for too many panels.
    """
    plain = replace(document, states=(), plate=None)
    if plate.states:
        _check_count(len(plate.states))
        return tuple(_state_panel(document, plain, name) for name in plate.states)
    count = len(document.profile)
    for each in plate.vary:
        if each.segment is not None and not 0 <= each.segment < count:
            raise EditError(f"there is no segment {each.segment}; the last is {count - 1}")
    total = 1
    for each in plate.vary:
        total *= len(each.values)
    _check_count(total)
    panels = []
    for values in product(*(each.values for each in plate.vary)):
        pairs = tuple(zip(plate.vary, values, strict=True))
        panels.append(PlatePanel(_varied(plain, pairs), pairs))
    return tuple(panels)


def _state_panel(document: Document, plain: Document, name: str) -> PlatePanel:
    if not name:
        return PlatePanel(plain)
    for each in document.states:
        if each.name == name:
            return PlatePanel(each, state=name)
    raise EditError(f"there is no state {name!r}")


def _varied(document: Document, pairs: tuple[tuple[Variation, float], ...]) -> Document:
    """Set the parameters on the polygon as it is: a plate compares, so no rule moves a point."""
    segments = list(document.profile.segments)
    for each, value in pairs:
        for number, segment in enumerate(segments):
            if each.segment in (None, number):
                shape = replace(segment.shape, **{each.parameter: value})
                segments[number] = segment.with_shape(shape)
    return replace(document, profile=document.profile.with_segments(segments))


def _check_count(count: int) -> None:
    if not 1 <= count <= MAX_PANELS:
        raise EditError(f"the plate has {count} panels; allowed is 1 to {MAX_PANELS}")
