"""A figure plate as it is kept in the project: which states it shows, and how."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from itertools import product
from typing import TYPE_CHECKING

from sgb_core.curves.segment import NO_EXTRA, PARAMETER_RANGES, ParameterName
from sgb_core.document.errors import EditError
from sgb_core.findings.edits import NoState, NoSuch, WrongPanelCount

if TYPE_CHECKING:
    from sgb_core.document.model import Document

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
            raise EditError(NoSuch("segment", each.segment, count))
        low, high = PARAMETER_RANGES[each.parameter]
        for value in each.values:
            if not low <= value <= high:
                raise EditError(f"{each.parameter} is {value:g}; allowed is {low:g} to {high:g}")
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
    raise EditError(NoState(name))


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
        raise EditError(WrongPanelCount(count, MAX_PANELS))
