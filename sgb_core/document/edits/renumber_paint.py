"""Paint belongs to segments: how a look follows when segments are renumbered."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sgb_core.document.appearance.model import Along, Appearance, ColourMap, Layer, Texture


def look_follows(look: Appearance, origin: Sequence[int | None]) -> Appearance:
    """Return a look after segments were moved, removed, divided or added.

    ``origin[k]`` is the old number of what is segment k now, None for a new one. A texture over
    everything stays one; what is left without a segment is removed with its segment. A map of
    one segment's influence that is gone shows that of all.
    """
    textures = tuple(new for each in look.textures for new in _texture(each, origin))
    drawing = tuple(new for each in look.drawing for new in _layer(each, origin))
    shown = None if look.map is None else _map(look.map, origin)
    if (textures, drawing, shown) == (look.textures, look.drawing, look.map):
        return look
    return replace(look, textures=textures, drawing=drawing, map=shown)


def look_reversed(look: Appearance) -> Appearance:
    """Return a look for the same profile run backwards: lengths count from its other end."""
    drawing = tuple(_turned(layer) if layer.by is Along.LENGTH else layer for layer in look.drawing)
    return look if drawing == look.drawing else replace(look, drawing=drawing)


def _renumbered(numbers: tuple[int, ...], origin: Sequence[int | None]) -> tuple[int, ...]:
    return tuple(k for k, old in enumerate(origin) if old is not None and old in numbers)


def _texture(texture: Texture, origin: Sequence[int | None]) -> list[Texture]:
    if texture.segments is None:
        return [texture]
    segments = _renumbered(texture.segments, origin)
    return [replace(texture, segments=segments)] if segments else []


def _layer(layer: Layer, origin: Sequence[int | None]) -> list[Layer]:
    if not layer.segments:
        return [layer]
    segments = _renumbered(layer.segments, origin)
    return [replace(layer, segments=segments)] if segments else []


def _map(shown: ColourMap, origin: Sequence[int | None]) -> ColourMap:
    if shown.segment is None:
        return shown
    return replace(shown, segment=next(iter(_renumbered((shown.segment,), origin)), None))


def _turned(layer: Layer) -> Layer:
    stops = tuple((1.0 - place, colour) for place, colour in reversed(layer.stops))
    return replace(
        layer, start=1.0 - layer.end, end=1.0 - layer.start, twist=-layer.twist, stops=stops
    )
