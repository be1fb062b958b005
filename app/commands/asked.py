"""Commands with a number: "height 95", "wall 4 mm", typed into the palette."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from types import MappingProxyType

from app.state.presenter import Presenter
from app.widgets.quantity import QuantityError, format_number, parse_number
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.document import edits
from sgb_core.document.guides import Guide, GuideAt
from sgb_core.document.model import Document
from sgb_core.surfaces.laws.law import RADIUS, Law
from sgb_core.surfaces.laws.lobes import LOBES
from sgb_core.surfaces.laws.polygon import POLYGON
from sgb_core.surfaces.laws.shape import LawShape
from sgb_core.values import dataclass

_ASKED = re.compile(r"\s*([^\W\d]+)\s*[:=]?\s*([\d.,+\-(].*)", re.UNICODE)
_FLUID = re.compile(r"fl\s*oz", re.IGNORECASE)


COUNT = "n"


@dataclass(frozen=True, slots=True)
class Quantity:
    """What can be set by its name and a number.

    ``unit`` is "" for lengths of the document, COUNT for what is counted.
    """

    title: str
    edit: Callable[[Document, float], Document]
    unit: str = ""


def _wall(document: Document, value: float) -> Document:
    return edits.set_solid(document, kind="vessel", wall=value)


def _base(document: Document, value: float) -> Document:
    return edits.set_solid(document, kind="vessel", base=value)


def _volume(document: Document, millilitres: float) -> Document:
    from sgb_core.document.edits.targets import hold

    return hold(document, millilitres / document.unit.millilitres)


def _hold(document: Document, millilitres: float) -> Document:
    return _volume(_vessel(document), millilitres)


def _below_rim(document: Document, value: float) -> Document:
    return edits.set_fill(_vessel(document), below_rim=value)


def _vessel(document: Document) -> Document:
    """Return what can hold something: a bare or filled surface gets a wall, as it would by hand."""
    return edits.set_solid(document, kind="vessel")


def _sweep(document: Document, value: float) -> Document:
    return edits.set_revolution(document, sweep_deg=value)


def _shrinkage(document: Document, value: float) -> Document:
    return edits.set_shrinkage(document, percent=value)


def _repeated(shape: LawShape, document: Document, count: float) -> Document:
    """Let the radius swell so many times around the turn, by the last law of this shape if any."""
    laws = document.variation
    for index in reversed(range(len(laws))):
        if laws[index].shape is shape and laws[index].parameter == RADIUS:
            return edits.replace_law(document, index, replace(laws[index], count=round(count)))
    law = Law(RADIUS, shape.name, *shape.natural, count=round(count))
    return edits.add_law(document, law)


def _twist(document: Document, turns: float) -> Document:
    return edits.set_twist(document, turns=turns)


def _guide(at: GuideAt, document: Document, value: float) -> Document:
    return edits.add_guide(document, Guide(at, value))


def _across(kind: DimensionKind, document: Document, value: float) -> Document:
    """Give a diameter a value by the mildest change; its line then tells it in the drawing."""
    wanted = Dimension(kind)
    told = edits.add_dimension(document, wanted)
    number = [each.freed() for each in told.dimensions].index(wanted)
    return edits.set_dimension(told, number, value).document


_HEIGHT = Quantity("Height", edits.set_height)
_DIAMETER = Quantity("Largest diameter", edits.set_largest_diameter)
_RIM = Quantity("Rim diameter", partial(_across, DimensionKind.RIM_DIAMETER))
_FOOT = Quantity("Foot diameter", partial(_across, DimensionKind.FOOT_DIAMETER))
_WALL = Quantity("Wall", _wall)
_FLOOR = Quantity("Floor", _base)
_FILL = Quantity("Fill line below the rim", _below_rim)
_HOLD = Quantity("Make it hold", _hold, "ml")
QUANTITIES: Mapping[str, Quantity] = MappingProxyType(
    {
        "height": _HEIGHT,
        "high": _HEIGHT,
        "tall": _HEIGHT,
        "diameter": _DIAMETER,
        "width": _DIAMETER,
        "wide": _DIAMETER,
        "rim": _RIM,
        "mouth": _RIM,
        "foot": _FOOT,
        "wall": _WALL,
        "thickness": _WALL,
        "thick": _WALL,
        "floor": _FLOOR,
        "base": _FLOOR,
        "volume": Quantity("Volume", _volume, "ml"),
        "hold": _HOLD,
        "holds": _HOLD,
        "capacity": _HOLD,
        "fill": _FILL,
        "below": _FILL,
        "line": _FILL,
        "scale": Quantity("Scale", edits.scale, "×"),
        "guide": Quantity("Level guide at", partial(_guide, GuideAt.HEIGHT)),
        "level": Quantity("Level guide at", partial(_guide, GuideAt.HEIGHT)),
        "upright": Quantity("Upright guide at", partial(_guide, GuideAt.RADIUS)),
        "sweep": Quantity("Sweep", _sweep, "°"),
        "lobes": Quantity("Lobes", partial(_repeated, LOBES), COUNT),
        "sides": Quantity("Sides", partial(_repeated, POLYGON), COUNT),
        "twist": Quantity("Twist", _twist, "turns"),
        "shrinkage": Quantity("Shrinkage", _shrinkage, "%"),
    }
)


def asked(presenter: Presenter, query: str) -> tuple[str, Callable[[], object]] | None:
    """Return what a query asks to set, in words, and what does it; None where it asks nothing.

    The first letters of a quantity's name suffice where there are at least three.
    """
    match = _ASKED.fullmatch(query)
    if match is None:
        return None
    quantity = _named(match[1].casefold())
    if quantity is None:
        return None
    unit = quantity.unit or str(presenter.document.unit)
    try:
        value = _value(match[2], quantity, unit)
    except QuantityError:
        return None
    gap = "" if unit == "°" else " "
    number = format_number(value)
    words = f"{quantity.title} {number}{gap}{unit}"
    if unit == "×":
        words = f"{quantity.title} × {number}"
    elif unit == COUNT:
        words = f"{quantity.title} {number}"
    return words, lambda: presenter.do(words, partial(_applied, quantity.edit, value))


def _named(word: str) -> Quantity | None:
    if word in QUANTITIES:
        return QUANTITIES[word]
    near = [name for name in QUANTITIES if len(word) >= 3 and name.startswith(word)]
    return QUANTITIES[near[0]] if near else None


def _value(text: str, quantity: Quantity, unit: str) -> float:
    if quantity.unit == "ml":
        return parse_number(_FLUID.sub("oz", text), "ml")
    if quantity.unit:
        return parse_number(text.strip().removesuffix("%").removesuffix("°"), "")
    return parse_number(text, unit)


def _applied(
    edit: Callable[[Document, float], Document], value: float, document: Document
) -> Document:
    return edit(document, value)
