"""Edits of what is painted in layers between two positions."""

from __future__ import annotations

from sgb_core.document.appearance.model import Layer, LayerKind
from sgb_core.document.edits.appearance import set_appearance
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoSuch

_USUAL = {
    LayerKind.BAND: Layer(LayerKind.BAND, start=0.55, end=0.65),
    LayerKind.RINGS: Layer(LayerKind.RINGS, start=0.5, end=0.7),
    LayerKind.STRIPES: Layer(LayerKind.STRIPES, start=0.1, end=0.6, count=24, width=0.4),
    LayerKind.GRADIENT: Layer(LayerKind.GRADIENT, stops=((0.0, "#1f4e79"), (1.0, "#f2efe6"))),
    LayerKind.SEGMENTS: Layer(LayerKind.SEGMENTS, segments=(0,)),
    LayerKind.TEXT: Layer(LayerKind.TEXT, start=0.45, end=0.55, count=2),
}


def usual_layer(kind: LayerKind) -> Layer:
    """Return what a new layer of a kind begins as."""
    return _USUAL[kind]


def add_layer(document: Document, layer: Layer) -> Document:
    """Paint another layer over those there are.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    >>> len(sgb.edits.add_layer(tube, sgb.edits.usual_layer("band")).appearance.drawing)
    1
    """
    return set_appearance(document, drawing=(*document.appearance.drawing, layer))


def remove_layer(document: Document, number: int) -> Document:
    """Remove the layer of a number; raises EditError where there is none."""
    drawing = document.appearance.drawing
    if not 0 <= number < len(drawing):
        raise EditError(NoSuch("layer", number, len(drawing)))
    return set_appearance(document, drawing=drawing[:number] + drawing[number + 1 :])
