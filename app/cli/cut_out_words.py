"""Patterns of holes as the command line takes them: ``slot,width=5,rows=2+circle,width=4``."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.document.edits import usual_cut_out
from sgb_core.document.edits.checks import checked
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Choice, Flag
from sgb_core.fields.record import Row, table_of
from sgb_core.findings.cut_outs import NoPatternValue, NoPatternWord

_FLAGS = {"yes": True, "no": False, "true": True, "false": False}


def patterns(document: Document, text: str) -> tuple[CutOut, ...]:
    """Return the patterns of a text; settings not named are those that suit the object.

    Raises EditError for what is no shape, no setting, or no value of one.
    """
    if text.strip() == "none":
        return ()
    return tuple(_pattern(document, each) for each in text.split("+"))


def _pattern(document: Document, text: str) -> CutOut:
    rows = {row.key: row for row in table_of(CutOut).rows}
    shape, *settings = (part.strip() for part in text.split(","))
    if shape not in set(HoleShape):
        raise EditError(NoPatternWord(shape, "shape", (*map(str, HoleShape), "none")))
    values: dict[str, Any] = {"shape": HoleShape(shape)}
    for setting in settings:
        key, equals, value = setting.partition("=")
        row = rows.get(key)
        if row is None or not equals or isinstance(row.kind, Choice):
            allowed = tuple(f"{key}=" for key in rows if key != "shape")
            raise EditError(NoPatternWord(setting, "setting", allowed))
        values[row.name] = _value(row, setting, value)
    usual = usual_cut_out(document)
    return checked(lambda: replace(usual, **values))


def _value(row: Row, setting: str, text: str) -> object:
    if isinstance(row.kind, Flag):
        if text not in _FLAGS:
            raise EditError(NoPatternValue(setting, "yes or no"))
        return _FLAGS[text]
    try:
        number = float(text)
    except ValueError:
        raise EditError(NoPatternValue(setting, "a number")) from None
    return int(number) if number.is_integer() else number
