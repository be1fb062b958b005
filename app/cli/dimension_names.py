"""Dimensions as they are named on the command line, and their values with units."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from app.cli.solve import LENGTHS, MASSES, NUMBER, VOLUMES
from sgb_core.design.locks.dimension import KINDS, Dimension, DimensionKind, Quantity
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Said
from sgb_core.findings.refusal import Argument, RefusalError

_NUMBER = r"-?[0-9]+(?:\.[0-9]*)?"
_POINT = r"([0-9]+)\.([0-3])"
_K = DimensionKind
# What follows a kind and a colon, and how it is read.
_PLACES: Mapping[DimensionKind, tuple[str, str, Callable[[re.Match[str]], dict[str, object]]]] = {
    _K.DIAMETER_AT: ("HEIGHT", rf"({_NUMBER})", lambda m: {"height": float(m[1])}),
    _K.POINT: ("SEGMENT.POINT", _POINT, lambda m: {"points": [(int(m[1]), int(m[2]))]}),
    _K.DISTANCE: ("SEGMENT.POINT-SEGMENT.POINT", f"{_POINT}-{_POINT}", lambda m: _two(m)),
    _K.ANGLE: ("SEGMENT.POINT-SEGMENT.POINT", f"{_POINT}-{_POINT}", lambda m: _two(m)),
    _K.RADIUS: (
        "SEGMENT@S",
        rf"([0-9]+)@({_NUMBER})",
        lambda m: {"segment": int(m[1]), "s": float(m[2])},
    ),
    _K.JOINT: ("JOINT", "([0-9]+)", lambda m: {"joint": int(m[1])}),
}


def _two(found: re.Match[str]) -> dict[str, object]:
    numbers = [int(found[k]) for k in range(1, 5)]
    return {"points": [tuple(numbers[:2]), tuple(numbers[2:])]}


def number_of(document: Document, name: str) -> tuple[Document, int]:
    """Return the document with a dimension that is named so, and its number.

    A name is a kind, where it needs a place followed by a colon and that: ``diameter_at:40``,
    ``point:2.3``, ``angle:2.3-2.2``, ``radius:2@0.5``, ``joint:1``. Raises EditError.
    """
    kind, _, place = name.partition(":")
    if kind not in KINDS:
        raise edits.EditError(Argument("the dimension", name, Said(", ".join(KINDS))))
    kind = DimensionKind(kind)
    fields: dict[str, object] = {}
    if kind in _PLACES:
        form, pattern, read = _PLACES[kind]
        found = re.fullmatch(pattern, place)
        if found is None:
            raise edits.EditError(Argument("the dimension", name, Said(f"{kind}:{form}")))
        fields = read(found)
    elif place:
        raise edits.EditError(Argument("the dimension", name, Said(kind)))
    if kind is _K.JOINT:
        joint = int(str(fields["joint"]))
        if joint < len(document.profile.rules):
            fields["rule"] = document.profile.rules[joint]
    try:
        dimension = Dimension(kind, **fields)  # type: ignore[arg-type]
    except RefusalError as error:
        raise edits.EditError(error.finding) from None
    told = edits.add_dimension(document, dimension)
    freed = [each.freed() for each in told.dimensions]
    return told, freed.index(dimension)


def value_in(document: Document, dimension: Dimension, text: str) -> float:
    """Return a value typed with its unit, in the document's; a bare number is in that.

    Volumes take ml, masses grams. Raises EditError.
    """
    quantity, length = dimension.facts.quantity, LENGTHS[document.unit.value]
    units: Mapping[str, float] = {
        Quantity.LENGTH: {name: factor / length for name, factor in LENGTHS.items()},
        Quantity.VOLUME: {name: factor / length**3 for name, factor in VOLUMES.items()},
        Quantity.MASS: MASSES,
        Quantity.ANGLE: {"deg": 1.0},
    }.get(quantity, {})
    sign, amount = (-1.0, text[1:]) if text.startswith("-") else (1.0, text)
    found = NUMBER.match(amount.strip())
    if found is None or (found[2] and found[2] not in units):
        allowed = Said(f"a number with {', '.join(units)}")
        raise edits.EditError(Argument(dimension.label, text, allowed))
    return sign * float(found[1]) * units.get(found[2], 1.0)
