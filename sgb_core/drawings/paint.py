"""Paint on a vessel's outside, as heights and a grey that prints as dark as the colour."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import accumulate
from typing import TypeAlias

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.nearest import arc_length
from sgb_core.curves.profile import Profile
from sgb_core.document.appearance.model import Along, Layer, LayerKind
from sgb_core.document.appearance.texture_painting import mixed_colours
from sgb_core.document.model import Document
from sgb_core.values import dataclass

# What black and white are shown as: lines drawn over a band are still seen.
_DARKEST, _LIGHTEST = 0.35, 0.95
_WEIGHTS = (0.2126, 0.7152, 0.0722)
_PLACES = 65
# Bands by which a gradient is drawn: from one to the next no eye sees a step.
_STEPS = 48


@dataclass(frozen=True, slots=True)
class Band:
    """Paint between two heights (mm of the object) in a grey, ``#rrggbb``; ``edged`` by lines."""

    low: float
    high: float
    colour: str
    edged: bool = True


@dataclass(frozen=True, slots=True, eq=False)
class Stripe:
    """Paint that runs up: at ``heights`` (k,), in mm, between angles from the start, (k,) each."""

    heights: Floats
    first: Floats
    last: Floats
    colour: str


Painted: TypeAlias = Band | Stripe


def paint_of(document: Document) -> tuple[Painted, ...]:
    """Return bands, rings, gradients, stripes and painted segments, those on top last."""
    return tuple(_paint(document))


def _paint(document: Document) -> Iterator[Painted]:
    for layer in document.appearance.drawing if document.appearance.paint else ():
        if layer.kind is LayerKind.GRADIENT:
            yield from _gradient(document, layer)
        elif layer.kind is LayerKind.STRIPES:
            yield from _stripes(document, layer)
        else:
            yield from _bands(document, layer)


def _bands(document: Document, layer: Layer) -> Iterator[Band]:
    for first, last in _shares(layer):
        yield _band(_heights(document, layer, first, last), grey(layer.color))
    if layer.kind is LayerKind.SEGMENTS:
        for segment in layer.segments:
            if segment < len(document.profile):
                s = np.linspace(0.0, 1.0, _PLACES)
                heights = document.profile[segment].point(s)[:, 1] * document.unit.millimetres
                yield _band(heights, grey(layer.color))


def _gradient(document: Document, layer: Layer) -> Iterator[Band]:
    """Yield a gradient as many bands in the colours of their steps, each to its end.

    They lie over each other: between two that only met a reader would show a line.
    """
    low, high = sorted((layer.start, layer.end))
    begins = np.arange(_STEPS) / _STEPS
    colours = mixed_colours(layer, begins + 0.5 / _STEPS) / 255.0
    for first, colour in zip(begins.tolist(), colours.tolist(), strict=True):
        begin = low + first * (high - low)
        yield _band(_heights(document, layer, begin, high), _grey(colour), edged=False)


def _stripes(document: Document, layer: Layer) -> Iterator[Stripe]:
    """Yield each stripe once, its middle at the foot on the way once around from the start."""
    low, high = sorted((layer.start, layer.end))
    part = np.linspace(0.0, 1.0, _PLACES)
    ends = [_heights(document, layer, low, low + share * (high - low)) for share in part]
    heights = np.array([each[-1] for each in ends])
    half = 0.5 * min(layer.width, 1.0)
    for number in range(layer.count):
        # As the surface is painted: a stripe lies where the turns are a whole number.
        middle = (number / layer.count - layer.twist * part) * document.surface.sweep
        aside = half / layer.count * document.surface.sweep
        yield Stripe(heights, middle - aside, middle + aside, grey(layer.color))


def _heights(document: Document, layer: Layer, first: float, last: float) -> Floats:
    """Return heights (k,) between two positions of a layer, in mm; those of both at the ends."""
    unit = document.unit.millimetres
    if layer.by is Along.LENGTH:
        return _heights_along(document, first, last) * unit
    low, high = (float(corner[1]) for corner in document.profile.bounds())
    return np.array([low + share * (high - low) for share in (first, last)]) * unit


def _band(heights: Floats, colour: str, edged: bool = True) -> Band:
    return Band(float(heights.min()), float(heights.max()), colour, edged)


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
    s = np.linspace(0.0, 1.0, _PLACES)
    found = []
    for segment, shares in zip(document.profile, _shares_along(document.profile), strict=True):
        ends = np.interp(np.clip([first, last], shares[0], shares[-1]), shares, s)
        if last >= shares[0] and first <= shares[-1]:
            between = s[(s > ends[0]) & (s < ends[1])]
            found.append(segment.point(np.concatenate([ends[:1], between, ends[1:]]))[:, 1])
    return np.concatenate(found) if found else np.zeros(1)


# A gradient and stripes ask for many stretches of one profile.
@lru_cache(maxsize=4)
def _shares_along(profile: Profile) -> tuple[Floats, ...]:
    """Return for each segment at which shares of the whole length its places lie."""
    lengths = [0.0, *accumulate(map(arc_length, profile))]
    s = np.linspace(0.0, 1.0, _PLACES)
    found = []
    for length, segment in zip(lengths, profile, strict=False):
        steps = np.hypot(*np.diff(segment.point(s), axis=0).T)
        found.append((length + np.concatenate([[0.0], np.cumsum(steps)])) / lengths[-1])
    return tuple(found)


def grey(colour: str) -> str:
    """Return the grey that is as bright as a colour (Rec. 709), neither black nor white."""
    return _grey(_parts(colour))


def _parts(colour: str) -> list[float]:
    return [int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)]


def _grey(parts: Sequence[float]) -> str:
    bright = sum(weight * part for weight, part in zip(_WEIGHTS, parts, strict=True))
    level = round(255.0 * (_DARKEST + (_LIGHTEST - _DARKEST) * bright))
    return f"#{level:02x}{level:02x}{level:02x}"
