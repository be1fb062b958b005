"""Painted bands of a vessel's outside, as heights and a grey that prints as dark as the colour."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import accumulate

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.nearest import arc_length
from sgb_core.document.appearance.model import Along, Layer, LayerKind
from sgb_core.document.model import Document
from sgb_core.values import dataclass

# What black and white are shown as: lines drawn over a band are still seen.
_DARKEST, _LIGHTEST = 0.35, 0.95
_WEIGHTS = (0.2126, 0.7152, 0.0722)
_PLACES = 65


@dataclass(frozen=True, slots=True)
class Band:
    """Paint between two heights (mm of the object) in a grey, ``#rrggbb``."""

    low: float
    high: float
    colour: str


def bands_of(document: Document) -> tuple[Band, ...]:
    """Return bands, rings and painted segments, those on top last.

    Gradients and stripes along the profile are no bands and are left out.
    """
    return tuple(_bands(document))


def _bands(document: Document) -> Iterator[Band]:
    low, high = (float(corner[1]) for corner in document.profile.bounds())
    unit = document.unit.millimetres
    for layer in document.appearance.drawing:
        for first, last in _shares(layer):
            if layer.by is Along.HEIGHT:
                heights = np.array([low + share * (high - low) for share in (first, last)])
            else:
                heights = _heights_along(document, first, last)
            yield _band(heights * unit, layer)
        if layer.kind is LayerKind.SEGMENTS:
            for segment in layer.segments:
                if segment < len(document.profile):
                    s = np.linspace(0.0, 1.0, _PLACES)
                    yield _band(document.profile[segment].point(s)[:, 1] * unit, layer)


def _band(heights: Floats, layer: Layer) -> Band:
    return Band(float(heights.min()), float(heights.max()), grey(layer.color))


def _shares(layer: Layer) -> list[tuple[float, float]]:
    low, high = sorted((layer.start, layer.end))
    if layer.kind is LayerKind.BAND:
        return [(low, high)]
    if layer.kind is not LayerKind.RINGS:
        return []
    step = (high - low) / layer.count
    half = 0.5 * layer.width * step
    middles = [low + (ring + 0.5) * step for ring in range(layer.count)]
    return [(middle - half, middle + half) for middle in middles]


def _heights_along(document: Document, first: float, last: float) -> Floats:
    """Return heights of the profile between two shares of its length."""
    lengths = [0.0, *accumulate(arc_length(segment) for segment in document.profile)]
    s = np.linspace(0.0, 1.0, _PLACES)
    found = []
    for number, segment in enumerate(document.profile):
        points = segment.point(s)
        steps = np.hypot(*np.diff(points, axis=0).T)
        along = lengths[number] + np.concatenate([[0.0], np.cumsum(steps)])
        shares = along / lengths[-1]
        ends = np.interp(np.clip([first, last], shares[0], shares[-1]), shares, s)
        if last >= shares[0] and first <= shares[-1]:
            between = s[(s > ends[0]) & (s < ends[1])]
            found.append(segment.point(np.concatenate([ends[:1], between, ends[1:]]))[:, 1])
    return np.concatenate(found) if found else np.zeros(1)


def grey(colour: str) -> str:
    """Return the grey that is as bright as a colour (Rec. 709), neither black nor white."""
    parts = [int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)]
    bright = sum(weight * part for weight, part in zip(_WEIGHTS, parts, strict=True))
    level = round(255.0 * (_DARKEST + (_LIGHTEST - _DARKEST) * bright))
    return f"#{level:02x}{level:02x}{level:02x}"
