"""The figure plate of a document: keeping one, and the panels that it shows."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.document.plates import MAX_PANELS, PlateSettings, Variation
from sgb_core.findings.edits import NoState, NoSuch, WrongPanelCount
from sgb_core.values import dataclass


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

    Raises EditError for a state or a segment that there is not, and for too many panels.
    """
    plain = replace(document, states=(), plate=None, reference=None)
    if plate.states:
        _check_count(len(plate.states))
        return tuple(_state_panel(document, plain, name) for name in plate.states)
    count = len(document.profile)
    for each in plate.vary:
        if each.segment is not None and not 0 <= each.segment < count:
            raise EditError(NoSuch("segment", each.segment, count))
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
