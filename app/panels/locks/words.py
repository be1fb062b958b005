"""How dimensions are called and counted in the window."""

from __future__ import annotations

from app.state.presenter import Frame
from app.state.window_reader import told
from sgb_core.design.locks.dimension import Dimension, DimensionKind, Quantity
from sgb_core.document.body_measures import mass_in_grams
from sgb_core.document.dimensions import dimension_fact, dimension_value
from sgb_core.document.model import Document

_K = DimensionKind
_OF_BODY = (_K.CAPACITY, _K.FILLED, _K.MATERIAL, _K.MASS)


def name_of(document: Document, dimension: Dimension) -> str:
    """Return what a dimension is called, without its value."""
    label = told(dimension_fact(document, dimension, None))
    if dimension.height is not None:
        return f"Diameter at h = {dimension.height:g}"
    if dimension.segment is not None:
        return f"{label}, segment {dimension.segment + 1}"
    return label


def unit_of(document: Document, dimension: Dimension) -> str:
    """Return in what a dimension is told."""
    return {
        Quantity.LENGTH: str(document.unit),
        Quantity.ANGLE: "deg",
        Quantity.VOLUME: "ml",
        Quantity.MASS: "g",
        Quantity.NONE: "",
    }[dimension.facts.quantity]


def factor_of(document: Document, dimension: Dimension) -> float:
    """Return by what a value is multiplied to be told in that unit."""
    is_volume = dimension.facts.quantity is Quantity.VOLUME
    return document.unit.millilitres if is_volume else 1.0


def shown_value(frame: Frame, dimension: Dimension) -> float | None:
    """Return what a dimension measures as far as that is known at once.

    What the body measures is known when it has been made, that of a lock always.
    """
    document = frame.document
    if dimension.value is not None:
        return dimension.value
    if dimension.kind not in _OF_BODY:
        return dimension_value(document, dimension)
    body = frame.body
    if body is None or body.measures is None or body.document.solid is not document.solid:
        return None
    measured = body.measures
    return {
        _K.CAPACITY: measured.vessel.capacity,
        _K.FILLED: measured.filled,
        _K.MATERIAL: measured.vessel.material_volume,
        _K.MASS: mass_in_grams(document, measured.vessel.material_volume),
    }[dimension.kind]
