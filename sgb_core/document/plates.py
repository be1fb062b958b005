"""A figure plate as it is kept in the project: which states it shows, and how."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sgb_core.curves.segment import NO_EXTRA, ParameterName

# What a plate holds at most.
MAX_PANELS = 48
MAX_VALUES = 24
MAX_TITLE = 200
MIN_WIDTH, MAX_WIDTH = 20.0, 600.0
MIN_DPI, MAX_DPI = 50, 1200


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

    parameter: ParameterName
    values: tuple[float, ...]
    segment: int | None = None
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)


@dataclass(frozen=True, slots=True)
class PlateCamera:
    """The direction from which all panels are seen, in degrees; what is seen always fits."""

    azimuth_deg: float = -58.0
    elevation_deg: float = 21.0
    projection: Projection = Projection.PARALLEL
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)


@dataclass(frozen=True, slots=True)
class PlateSettings:
    """A plate of the document's own panels.

    With ``states`` each named state is a panel ("" is the document as it is); else ``vary``, none
    to two variations, gives one for each value, or pair of values, the second running fastest.
    ``columns`` 0 chooses a number; ``panel_height_mm`` None takes what the contents need.
    """

    vary: tuple[Variation, ...] = ()
    states: tuple[str, ...] = ()
    columns: int = 0
    labels: bool = True
    captions: bool = True
    title: str = ""
    show: frozenset[PlatePart] = frozenset({PlatePart.GENERATRIX})
    width_mm: float = 175.0
    panel_height_mm: float | None = None
    dpi: int = 300
    common_scale: bool = True
    camera: PlateCamera = PlateCamera()
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)
