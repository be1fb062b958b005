"""Edits of what paint raises or sinks."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal, TypeVar

from sgb_core.document.appearance.model import Layer, Raised, Texture
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.edits.appearance import set_appearance
from sgb_core.document.edits.checks import changed, checked
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoSuch

Part = TypeVar("Part", Layer, Texture)


def set_relief(
    document: Document,
    what: Literal["layer", "texture"],
    number: int,
    *,
    depth: float | None = None,
    edge: float | None = None,
    raised: Raised | str | None = None,
) -> Document:
    """Raise what a layer of the drawing or a texture paints by a depth, or sink it where negative.

    Lengths are in the unit; what is None stays as it is. ``raised`` says for a texture whether its
    light or its dark parts stand at the full depth. Raises EditError for one there is not, and
    for a value that is not allowed.

    >>> from sgb_core.document.appearance.model import Layer
    >>> band = Layer("band", start=0.4, end=0.6)
    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    >>> tube = sgb.edits.set_appearance(tube, drawing=(band,))
    >>> ringed = sgb.edits.set_relief(tube, "layer", 0, depth=1.5, edge=2)
    >>> round(float(ringed.body().mesh().bounds[1][0]), 3)
    21.5
    """
    look = document.appearance
    if what == "layer":
        own = _numbered(look.drawing, what, number)
        layer = changed(own, relief=depth, edge=edge)
        return set_appearance(document, drawing=_with(look.drawing, number, layer))
    texture = changed(_numbered(look.textures, what, number), relief=depth, edge=edge)
    texture = changed(texture, raised=raised)
    return set_appearance(document, textures=_with(look.textures, number, texture))


def _numbered(parts: tuple[Part, ...], what: Literal["layer", "texture"], number: int) -> Part:
    if not 0 <= number < len(parts):
        raise EditError(NoSuch(what, number, len(parts)))
    return parts[number]


def _with(parts: tuple[Part, ...], number: int, part: Part) -> tuple[Part, ...]:
    listed = list(parts)
    listed[number] = part
    return tuple(listed)


def enlarged_relief(document: Document, factor: float) -> Document:
    """Return the document with depths and edges ``factor`` times as large; paint stays as it is."""
    look = document.appearance
    if relief_of(look) is None:
        return document
    wanted = checked(
        lambda: replace(
            look,
            textures=tuple(_enlarged(each, factor) for each in look.textures),
            drawing=tuple(_enlarged(each, factor) for each in look.drawing),
        )
    )
    return replace(document, appearance=wanted)


def _enlarged(part: Part, factor: float) -> Part:
    if part.relief == 0.0:
        return part
    return replace(part, relief=part.relief * factor, edge=part.edge * factor)
