"""What the dimensions of a document measure: exact values, and the units that they count in."""

from __future__ import annotations

from math import radians

from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.flux import flux
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.vessel import capacity_to, vessel_measures
from sgb_core.design.demands.chain import Chain
from sgb_core.design.locks.dimension import Dimension, DimensionKind, Quantity
from sgb_core.design.locks.gauge import Gauge
from sgb_core.design.locks.readings import Setting, read
from sgb_core.document.model import Document
from sgb_core.findings.locks import Locked, LockMissed
from sgb_core.surfaces import measures

_K = DimensionKind
STORED = (_K.WALL, _K.BASE, _K.FILL_LINE)
# Of the value: a lock nearer than this holds.
HOLDS = 1e-8


def setting_of(document: Document) -> Setting:
    """Return what besides the curve its dimensions depend on."""
    return Setting(
        document.solid,
        document.manufacture.fill.height,
        radians(document.revolution.sweep_deg),
        document.unit.millilitres * document.manufacture.material.density,
        document.profile.closed,
        document.manufacture.fill.below_rim,
    )


def dimension_value(document: Document, dimension: Dimension) -> float | None:
    """Return what a dimension measures, exactly, in powers of the unit, degrees or grams.

    None where there is no such thing: a neck of a cone, a capacity of a filled body, and what
    points and joints' rules measure.
    """
    kind = dimension.kind
    if kind in STORED:
        return _stored(document, kind)
    if kind is _K.VOLUME:
        return measures.volume(document.surface)
    if kind in (_K.CAPACITY, _K.FILLED, _K.MATERIAL, _K.MASS):
        try:
            return _of_body(document, kind)
        except SolidError:
            return None
    found = read(Gauge(Chain.of(document.profile)), dimension, setting_of(document))
    return None if found is None else found.value


def _stored(document: Document, kind: DimensionKind) -> float | None:
    solid, fill = document.solid, document.manufacture.fill.height
    if kind is _K.FILL_LINE:
        return fill
    if solid.kind is not BodyKind.VESSEL:
        return None
    return solid.wall if kind is _K.WALL else solid.base


def _of_body(document: Document, kind: DimensionKind) -> float | None:
    surface, solid = document.surface, document.solid
    if solid.kind is BodyKind.SURFACE:
        return None
    if kind is _K.FILLED:
        line = document.fill_height
        return None if line is None else capacity_to(surface, solid, line)
    if surface.laws:
        measured = vessel_measures(surface, solid)
        if kind is _K.CAPACITY:
            return measured.capacity
        return measured.material_volume * _factor(document, kind)
    section = cross_section(surface, solid)
    if kind is _K.CAPACITY and section.brim is None:
        return None
    outlines = section.cavity if kind is _K.CAPACITY else section.outlines
    pieces = [piece for outline in outlines for ring in outline.rings for piece in ring]
    return 0.5 * surface.sweep * flux(pieces) * _factor(document, kind)


def _factor(document: Document, kind: DimensionKind) -> float:
    return setting_of(document).grams if kind is _K.MASS else 1.0


def measured_dimensions(document: Document) -> list[tuple[Dimension, float | None]]:
    """Return the dimensions of a document, each with what it measures now."""
    return [(each, dimension_value(document, each)) for each in document.dimensions]


def unit_of(document: Document, dimension: Dimension) -> str:
    """Return the unit of a dimension's value as it follows a number."""
    unit = str(document.unit)
    return {
        Quantity.LENGTH: f" {unit}",
        Quantity.ANGLE: "°",
        Quantity.VOLUME: f" {unit}³",
        Quantity.MASS: " g",
        Quantity.NONE: "",
    }[dimension.facts.quantity]


def locked_fact(document: Document, number: int) -> Locked:
    """Return what a lock holds, as people say it."""
    dimension = document.dimensions[number]
    return dimension_fact(document, dimension, dimension.value)


def dimension_fact(document: Document, dimension: Dimension, value: float | None) -> Locked:
    """Return a dimension with a value, in millilitres where it is a volume."""
    unit = unit_of(document, dimension)
    if value is not None and dimension.facts.quantity is Quantity.VOLUME:
        value, unit = value * document.unit.millilitres, " ml"
    joint = dimension.joint
    sides = None if joint is None else (joint, document.profile.neighbours(joint)[1])
    return Locked(dimension.label, value, unit, dimension.points, sides, dimension.rule)


def missed_locks(document: Document) -> tuple[LockMissed, ...]:
    """Return the locks whose values the object does not have."""
    found = []
    for number, dimension in enumerate(document.dimensions):
        if dimension.value is None:
            continue
        value = dimension_value(document, dimension)
        if value is None or abs(value - dimension.value) > HOLDS * max(1.0, abs(dimension.value)):
            found.append(LockMissed(number, locked_fact(document, number), value))
    return tuple(found)
