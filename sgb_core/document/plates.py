"""A figure plate as it is kept in the project: which states it shows, and how."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum

from sgb_core.curves.segment import PARAMETER_RANGES, ParameterName, parameter_value
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import FINITE, Choice, Chosen, Flag, Range, Text
from sgb_core.fields.lists import OrNone, Several
from sgb_core.fields.record import Part, Record, check, says
from sgb_core.values import dataclass

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
        allowed = parameter_value(self.parameter)
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
