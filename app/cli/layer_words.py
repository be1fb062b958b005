"""A layer of paint as the command line takes it: ``text,text=LIGHT,from=0.4,to=0.5,relief=1``."""

from __future__ import annotations

from sgb_core.document.appearance.model import Layer, LayerKind
from sgb_core.document.edits import add_layer, usual_layer
from sgb_core.document.edits.checks import checked
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Choice, Colour, Text
from sgb_core.fields.record import Row, table_of
from sgb_core.findings.typed import SaysNothing


def with_layer(document: Document, text: str) -> Document:
    """Return the document with a layer of a text over the others; the rest is as usual.

    Segments and stops are written with + between them: ``segments=0+2``,
    ``stops=0:#1f4e79+1:#f2efe6``. Raises EditError for what is no kind, no setting, or no value.
    """
    table = table_of(Layer)
    rows = {row.key: row for row in table.rows if row.key != "kind"}
    kind, *settings = (part.strip() for part in text.split(","))
    if kind not in set(LayerKind):
        raise EditError(SaysNothing(kind, "layer", tuple(map(str, LayerKind))))
    plain = table.to_plain(usual_layer(LayerKind(kind)))
    for setting in settings:
        key, equals, value = setting.partition("=")
        row = rows.get(key)
        if row is None or not equals:
            raise EditError(SaysNothing(setting, "layer", tuple(f"{key}=" for key in rows)))
        plain[key] = _plain(row, setting, value)
    return add_layer(document, checked(lambda: table.from_plain(plain, ("layer",))))


def _plain(row: Row, setting: str, text: str) -> object:
    """Return a setting as it stands in a file."""
    if isinstance(row.kind, Text | Choice | Colour):
        return text
    if row.key == "stops":
        pairs = [each.partition(":") for each in text.split("+")]
        return [[_number(setting, at), colour] for at, _, colour in pairs]
    if row.key == "segments":
        return [_number(setting, each) for each in text.split("+")]
    return _number(setting, text)


def _number(setting: str, text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        key, _, _ = setting.partition("=")
        raise EditError(SaysNothing(setting, "layer", (f"{key}= and a number",))) from None
    return int(number) if number.is_integer() else number
