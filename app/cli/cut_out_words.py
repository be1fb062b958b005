"""Patterns of holes as the command line takes them: ``slot,width=5,rows=2+circle,width=4``."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.document.edits import set_cut_outs, usual_cut_out, with_picture
from sgb_core.document.edits.checks import checked
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Choice, Flag, Text
from sgb_core.fields.record import Row, table_of
from sgb_core.findings.cut_outs import NoPatternValue, NoPatternWord

_FLAGS = {"yes": True, "no": False, "true": True, "false": False}
_FILES = (".png", ".jpg", ".jpeg")


def with_patterns(document: Document, text: str) -> Document:
    """Return the document with the patterns of a text; what is not named suits the object.

    A picture is a texture of the program, or a PNG or JPEG file, which the document then keeps.
    Raises EditError for what is no shape, no setting, or no value of one, and OSError for a file
    that cannot be read.
    """
    if text.strip() == "none":
        return set_cut_outs(document, ())
    found: list[CutOut] = []
    for each in text.split("+"):
        document, pattern = _pattern(document, each)
        found.append(pattern)
    return set_cut_outs(document, found)


def _pattern(document: Document, text: str) -> tuple[Document, CutOut]:
    rows = {row.key: row for row in table_of(CutOut).rows}
    shape, *settings = (part.strip() for part in text.split(","))
    if shape not in set(HoleShape):
        raise EditError(NoPatternWord(shape, "shape", (*map(str, HoleShape), "none")))
    values: dict[str, Any] = {}
    for setting in settings:
        key, equals, value = setting.partition("=")
        row = rows.get(key)
        if row is None or not equals or key == "shape":
            allowed = tuple(f"{key}=" for key in rows if key != "shape")
            raise EditError(NoPatternWord(setting, "setting", allowed))
        if key == "picture" and value.lower().endswith(_FILES):
            document, value = with_picture(document, Path(value).read_bytes())
        values[row.name] = _value(row, setting, value)
    usual = usual_cut_out(document, HoleShape(shape))
    return document, checked(lambda: replace(usual, **values))


def _value(row: Row, setting: str, text: str) -> object:
    if isinstance(row.kind, Flag):
        if text not in _FLAGS:
            raise EditError(NoPatternValue(setting, "yes or no"))
        return _FLAGS[text]
    if isinstance(row.kind, Text):
        return text
    if isinstance(row.kind, Choice):
        if text not in map(str, row.kind.names):
            raise EditError(NoPatternValue(setting, " or ".join(map(str, row.kind.names))))
        return text
    try:
        number = float(text)
    except ValueError:
        raise EditError(NoPatternValue(setting, "a number")) from None
    return int(number) if number.is_integer() else number
