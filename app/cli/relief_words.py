"""Relief as the command line takes it: ``layer-0 depth=1.5,edge=2``."""

from __future__ import annotations

from typing import Any, Literal

from sgb_core.document.appearance.model import Raised
from sgb_core.document.edits import set_relief
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.typed import SaysNothing

_SETTINGS = ("depth=", "edge=", "raised=")


def relieved(document: Document, part: str, text: str) -> Document:
    """Return the document with the relief of a layer or a texture set.

    Raises EditError for what is neither, for what is no setting, and for no value of one.
    """
    kind, _, number = part.partition("-")
    what: Literal["layer", "texture"] = "layer" if kind == "layer" else "texture"
    if kind not in ("layer", "texture") or not number.isdecimal():
        raise EditError(SaysNothing(part, "relief", ("layer-0", "texture-0")))
    values: dict[str, Any] = {}
    for setting in text.split(","):
        key, equals, value = setting.strip().partition("=")
        if not equals or f"{key}=" not in _SETTINGS:
            raise EditError(SaysNothing(setting, "relief", _SETTINGS))
        values[key] = _value(key, setting, value)
    return set_relief(document, what, int(number), **values)


def _value(key: str, setting: str, text: str) -> object:
    if key == "raised":
        if text not in set(Raised):
            raise EditError(
                SaysNothing(setting, "relief", tuple(f"raised={each}" for each in Raised))
            )
        return Raised(text)
    try:
        return float(text)
    except ValueError:
        raise EditError(SaysNothing(setting, "relief", (f"{key}= and a number",))) from None
