"""The number that a handle stands for: what it is called, what it is now, and how it is set."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from app.hand.features import Feature, Kind
from app.hand.hit_test import Handle, Target
from app.widgets.number_kind import NumberKind
from sgb_core.design.locks.dimension import Quantity
from sgb_core.document import edits
from sgb_core.document.dimensions import dimension_value
from sgb_core.document.model import Document
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class HandleNumber:
    """One number of a document, seen and grabbed as a line or an edge.

    ``edit`` returns the document with another value of it.
    """

    name: str
    value: float
    kind: NumberKind
    edit: Callable[[Document, float], Document]


def handle_number(document: Document, handle: Handle | None) -> HandleNumber | None:
    """Return the number of a dimension line, the fill line, a wall, a floor or a painted edge.

    None for what has more than one number, or none now.
    """
    if handle is None:
        return None
    if handle.target is Target.DIMENSION:
        return _dimension(document, handle.index)
    if handle.target is Target.LEVEL and document.fill_height is not None:
        length = NumberKind(unit=str(document.unit))
        return HandleNumber("Fill line", document.fill_height, length, edits.move_fill)
    return None if handle.feature is None else _feature(document, handle.feature)


def _dimension(document: Document, number: int) -> HandleNumber | None:
    dimension = document.dimensions[number]
    value = dimension_value(document, dimension) if dimension.value is None else dimension.value
    if value is None:
        return None
    turns = dimension.facts.quantity is Quantity.ANGLE
    return HandleNumber(
        dimension.label,
        value,
        NumberKind(unit="deg" if turns else str(document.unit)),
        lambda d, v: edits.set_dimension(d, number, v).document,
    )


def _feature(document: Document, feature: Feature) -> HandleNumber | None:
    unit = str(document.unit)
    if feature.kind is Kind.WALL:
        kind = NumberKind(minimum=0.0, unit=unit, above_minimum=True)
        return HandleNumber(
            feature.label, document.solid.wall, kind, lambda d, v: edits.set_solid(d, wall=v)
        )
    if feature.kind is Kind.FLOOR:
        kind = NumberKind(minimum=0.0, unit=unit)
        return HandleNumber(
            feature.label, document.solid.base, kind, lambda d, v: edits.set_solid(d, base=v)
        )
    if feature.kind is Kind.BAND:
        return _band(document, feature)
    return None


def _band(document: Document, feature: Feature) -> HandleNumber:
    layer = document.appearance.drawing[feature.layer]
    # An edge goes no farther than the band's other one.
    low, high = (layer.start, 1.0) if feature.upper else (0.0, layer.end)
    kind = NumberKind(100.0 * low, 100.0 * high, "%")

    def moved(before: Document, percent: float) -> Document:
        layers = list(before.appearance.drawing)
        share = percent / 100.0
        band = layers[feature.layer]
        layers[feature.layer] = (
            replace(band, end=share) if feature.upper else replace(band, start=share)
        )
        return edits.set_appearance(before, drawing=tuple(layers))

    name = f"{feature.label} {'ends' if feature.upper else 'begins'}"
    share = layer.end if feature.upper else layer.start
    return HandleNumber(name, 100.0 * share, kind, moved)
