"""The lines of the measures panel: a name, what it means, and how it reads."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from app.state.stored import stored
from sgb_core.document.evaluation import Evaluation
from sgb_core.document.manufacture import Stage
from sgb_core.document.model import Document, Unit
from sgb_core.surfaces import measures
from sgb_core.values import dataclass

if TYPE_CHECKING:
    from sgb_core.document.body_measures import BodyMeasures

# Millilitres in one; the fluid ounce is that of the United States.
LIQUIDS = {"ml": 1.0, "l": 1000.0, "fl oz": 29.5735295625, "in³": 16.387064}
# From so many millilitres on a volume is read in litres.
LITRES_FROM = 1000.0
# From so many mm² or mm³ on areas and volumes are read in centimetres.
CENTIMETRES_FROM = 1e4


@dataclass(frozen=True, slots=True)
class Units:
    """In what is read: ``length`` None is the document's unit.

    ``liquid`` None is ml, or l for large volumes; where lengths are in inches it is fl oz.
    """

    length: Unit | None = None
    liquid: str | None = None

    def liquid_of(self, document: Document, millilitres: float = 0.0) -> str:
        """Return the name of the unit in which a volume is read as a liquid."""
        if self.liquid is not None:
            return self.liquid
        if (self.length or document.unit) is Unit.IN:
            return "fl oz"
        return "l" if abs(millilitres) >= LITRES_FROM else "ml"

    def lengths(self, document: Document, value: float, power: int = 1) -> str:
        """Return a length, area or volume with its unit: many mm² or mm³ in centimetres."""
        unit = self.length or document.unit
        if self.length is None and power > 1 and unit is Unit.MM and value >= CENTIMETRES_FROM:
            unit = Unit.CM
        ratio = document.unit.factor_to(unit)
        sign = {1: "", 2: "²", 3: "³"}[power]
        return f"{digits(value * ratio**power)} {unit}{sign}"

    def liquids(self, document: Document, value: float) -> str:
        """Return a volume as a liquid."""
        millilitres = value * document.unit.millilitres
        unit = self.liquid_of(document, millilitres)
        return f"{digits(millilitres / LIQUIDS[unit])} {unit}"

    def short_liquids(self, document: Document, value: float) -> str:
        """Return a volume as a liquid in three digits, whole millilitres."""
        millilitres = value * document.unit.millilitres
        unit = self.liquid_of(document, millilitres)
        amount = millilitres / LIQUIDS[unit]
        text = f"{amount:.0f}" if abs(amount) >= 100.0 else f"{amount:.3g}"
        return f"{text} {unit}"


def stored_units() -> Units:
    """Return the units in which measures were last asked for."""
    length = stored("measures/length", None, lambda text: Unit(str(text)) if text else None)
    liquid = stored("measures/liquid", None, _liquid_named)
    return Units(length, liquid)


def _liquid_named(text: object) -> str | None:
    if text and str(text) not in LIQUIDS:
        raise ValueError(text)
    return str(text) if text else None


@dataclass(frozen=True, slots=True)
class Measure:
    """One line about the drawn surface."""

    name: str
    meaning: str
    read: Callable[[Evaluation, Units], str]


@dataclass(frozen=True, slots=True)
class BodyMeasure:
    """One line about the body."""

    name: str
    meaning: str
    read: Callable[[Document, BodyMeasures, Units], str]


def _volume(evaluation: Evaluation, units: Units) -> str:
    return units.lengths(evaluation.document, evaluation.volume, 3)


def _liquid(evaluation: Evaluation, units: Units) -> str:
    return units.liquids(evaluation.document, evaluation.volume)


def _area(evaluation: Evaluation, units: Units) -> str:
    return units.lengths(evaluation.document, measures.area(evaluation.surface), 2)


def _height(evaluation: Evaluation, units: Units) -> str:
    return units.lengths(evaluation.document, evaluation.size[0])


def _diameter(evaluation: Evaluation, units: Units) -> str:
    return units.lengths(evaluation.document, evaluation.size[1])


def _drawn(evaluation: Evaluation, units: Units) -> str:
    return f"⌀ {_diameter(evaluation, units)} × {_height(evaluation, units)}"


def _length(evaluation: Evaluation, units: Units) -> str:
    length = measures.generatrix_length(evaluation.document.profile)
    return units.lengths(evaluation.document, length)


def _certain(evaluation: Evaluation, _units: Units) -> str:
    found = evaluation.certificates
    words = (
        ("off the axis", found.never_crosses_axis),
        ("monotone", found.height_monotone),
        ("convex", found.convex),
    )
    return ", ".join(word for word, holds in words if holds) or "nothing"


# Of a bare surface; a body has its own, under the same names.
SIZES = (
    Measure("Height", "Of the surface along the axis", _height),
    Measure("Diameter", "The largest of the surface, all around the turn", _diameter),
)
# What a body is made from, which need not have its size.
DRAWN = (Measure("Drawn line", "Largest diameter and height of the drawn surface", _drawn),)
GEOMETRY = (
    Measure(
        "Volume",
        "Enclosed by the drawn surface when the profile is closed to the axis: not what a vessel "
        "holds, nor what it is made of",
        _volume,
    ),
    Measure("Area", "Of the drawn surface, without end faces", _area),
    Measure("Profile length", "Length of the generatrix", _length),
    Measure(
        "Certain",
        "What no λ or ω can break, read off the control polygon alone, while no point moves:\n"
        "clear of the axis, only rising (or falling), convex when closed by its chord",
        _certain,
    ),
)
# What a bare surface has in place of what a vessel holds.
ENCLOSED = (
    Measure("Encloses", "As a liquid, the profile closed to the axis and without a wall", _liquid),
)


def _capacity(document: Document, found: BodyMeasures, units: Units) -> str:
    capacity = found.vessel.capacity
    return "no rim" if capacity is None else units.liquids(document, capacity)


def _filled(document: Document, found: BodyMeasures, units: Units) -> str:
    filled = found.filled
    return "no line" if filled is None else units.liquids(document, filled)


def _material(document: Document, found: BodyMeasures, units: Units) -> str:
    volume = found.vessel.material_volume
    return units.lengths(document, volume, 3)


def _mass(document: Document, found: BodyMeasures, _units: Units) -> str:
    from sgb_core.document.body_measures import mass_in_grams

    volume = found.vessel.material_volume
    grams = mass_in_grams(document, volume)
    return f"{digits(grams / 1000.0)} kg" if grams >= 1000.0 else f"{digits(grams)} g"


def _wall(document: Document, found: BodyMeasures, units: Units) -> str:
    least = found.vessel.wall_min
    return "–" if least is None else units.lengths(document, least)


def _inside(document: Document, found: BodyMeasures, units: Units) -> str:
    return units.lengths(document, found.vessel.inner_area, 2)


def _outside(document: Document, found: BodyMeasures, units: Units) -> str:
    return units.lengths(document, found.vessel.outer_area, 2)


def _body_height(document: Document, found: BodyMeasures, units: Units) -> str:
    return units.lengths(document, found.height)


def _body_diameter(document: Document, found: BodyMeasures, units: Units) -> str:
    return units.lengths(document, found.diameter)


def _centre(document: Document, found: BodyMeasures, units: Units) -> str:
    return f"{units.lengths(document, found.stand.height)} up"


def _stands(_document: Document, found: BodyMeasures, _units: Units) -> str:
    stand = found.stand
    if not stand.stands:
        return "no: it tips over"
    return f"yes, tips at {stand.tip_deg:.1f}°"


HOLDS = (
    BodyMeasure("To the line", "What it holds up to the fill line", _filled),
    BodyMeasure(
        "To the brim", "Filled to the brim, standing upright; a drain hole ignored", _capacity
    ),
)
BODY = (
    BodyMeasure("Height", "Of the body as it leaves: wall, floor and foot ring", _body_height),
    BodyMeasure(
        "Diameter",
        "The largest of the body as it leaves: a wall outside adds to it, a round rim takes away",
        _body_diameter,
    ),
)
CLAY = (
    BodyMeasure(
        "Material volume", "Volume of the wall and the floor, or of the filled solid", _material
    ),
    BodyMeasure("Mass", "The material's volume times its density", _mass),
    BodyMeasure("Smallest wall", "Straight through the wall, leaving out rim and floor", _wall),
    BodyMeasure("To glaze inside", "Area of the inside, up to the rim", _inside),
    BodyMeasure("To glaze outside", "Area of the outside and the rim, without the foot", _outside),
)
STABILITY = (
    BodyMeasure("Centre of mass", "Its height above the ground", _centre),
    BodyMeasure("Stands", "Whether the centre of mass is over the foot", _stands),
)
# In the order in which they are read and copied.
ALL_LINES = (*HOLDS, *ENCLOSED, *SIZES, *DRAWN, *CLAY, *STABILITY, *GEOMETRY)


def shrinkage_text(document: Document, diameter: float, height: float, units: Units) -> str:
    """Say how large the wet and the fired piece are, and by which convention."""
    shrinkage = document.manufacture.shrinkage
    sizes = []
    for stage in Stage:
        factor = shrinkage.factor(stage)
        across, up = (units.lengths(document, value * factor) for value in (diameter, height))
        drawn = " (as drawn)" if stage is shrinkage.drawn else f" (× {factor:.4f})"
        sizes.append(f"{stage.capitalize()}: ⌀ {across} × {up}{drawn}")
    other = "fired" if shrinkage.of is Stage.WET else "wet"
    sign = "−" if shrinkage.of is Stage.WET else "+"
    rule = f"{other} = {shrinkage.of} × (1 {sign} {shrinkage.percent:g} %)"
    return "\n".join([*sizes, f"{shrinkage.percent:g} % of the {shrinkage.of} size: {rule}"])


def digits(value: float) -> str:
    """Return five significant digits, without a power of ten where it can be avoided."""
    if value == 0.0:
        return "0"
    if not 1e-3 <= abs(value) < 1e9:
        return f"{value:.5g}"
    # No separators of thousands: what is copied must be read as a number elsewhere.
    whole = len(str(int(abs(value))))
    return f"{value:.{max(0, 5 - whole)}f}"
