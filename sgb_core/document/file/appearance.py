"""The ``appearance`` section of a project file: read, checked and written."""

from __future__ import annotations

import base64
import binascii
import re
from enum import StrEnum

from sgb_core.curves.segment import PARAMETER_RANGES
from sgb_core.document.appearance import model as look
from sgb_core.document.appearance.model import (
    Along,
    Appearance,
    ColourMap,
    Layer,
    LayerKind,
    MapKind,
    Picture,
    Scale,
    Texture,
)
from sgb_core.document.appearance.pictures import PictureError, check_picture
from sgb_core.document.file.fields import Fields, Node

COLOUR = re.compile(r"#[0-9a-fA-F]{6}")
NAME = re.compile(r"[a-z][a-z0-9-]{0,39}|[0-9a-f]{64}")
MAX_SEGMENT = 1999
LIMIT = 1e12


def read_appearance(fields: Fields) -> Appearance:
    """Return the ``appearance`` section; raises FileError, one line."""
    default = look.PLAIN
    pictures = _pictures(fields["pictures"])
    textures = _items(fields["textures"], "textures")
    drawing = _items(fields["drawing"], "layers")
    shown = fields["map"]
    return Appearance(
        material=fields["material"].choice(look.MaterialName, default.material),
        color=_colour(fields["color"]) if fields["color"].is_given else None,
        lighting=fields["lighting"].choice(look.Lighting, default.lighting),
        background=fields["background"].choice(look.Background, default.background),
        shading=fields["shading"].choice(look.Shading, default.shading),
        shadow=fields["shadow"].boolean(False),
        silhouette=fields["silhouette"].boolean(False),
        features=fields["features"].boolean(False),
        textures=tuple(_texture(item, pictures) for item in textures),
        drawing=tuple(_layer(item.object()) for item in drawing),
        map=_map(shown.object()) if shown.is_given else None,
        pictures=pictures,
        extra=fields.rest(),
    )


def _items(node: Node, what: str) -> list[Node]:
    if not node.is_given:
        return []
    return node.array(f"a list of at most {look.MAX_LAYERS} {what}", 0, look.MAX_LAYERS)


def _colour(node: Node) -> str:
    if not isinstance(node.value, str) or not COLOUR.fullmatch(node.value):
        node.fail('a colour "#rrggbb"')
    return node.value.lower()


def _number(node: Node, fallback: float, low: float = -LIMIT, high: float = LIMIT) -> float:
    if not node.is_given:
        return fallback
    return node.number(f"a number from {low:g} to {high:g}", low, high)


def _pair(
    node: Node, fallback: tuple[float, float], low: float, high: float
) -> tuple[float, float]:
    if not node.is_given:
        return fallback
    first, second = node.array("a list of 2 numbers", 2, 2)
    return _number(first, 0.0, low, high), _number(second, 0.0, low, high)


def _segments(node: Node) -> tuple[int, ...]:
    items = node.array("a list of segment numbers", 0, MAX_SEGMENT + 1)
    allowed = f"a segment number from 0 to {MAX_SEGMENT}"
    return tuple(item.integer(allowed, 0, MAX_SEGMENT) for item in items)


def _texture(node: Node, pictures: tuple[Picture, ...]) -> Texture:
    fields = node.object()
    image = fields["image"]
    if not isinstance(image.value, str) or not NAME.fullmatch(image.value):
        image.fail("the name of a texture, or the SHA-256 of a picture in this file")
    if len(image.value) == 64 and all(each.name != image.value for each in pictures):
        image.fail("the SHA-256 of a picture under appearance.pictures")
    chosen = fields["segments"]
    everywhere = not chosen.is_given or chosen.value == "all"
    repeat = _pair(fields["repeat"], (8.0, 0.0), 0.0, look.MAX_REPEATS)
    if repeat[0] < 1.0:
        fields["repeat"].fail("at least 1 repeat around")
    return Texture(
        image.value,
        None if everywhere else _segments(chosen),
        repeat,
        _pair(fields["offset"], (0.0, 0.0), -look.MAX_REPEATS, look.MAX_REPEATS),
        _number(fields["rotate_deg"], 0.0, -360.0, 360.0),
        fields.rest(),
    )


def _layer(fields: Fields) -> Layer:
    kind = fields["kind"].choice(LayerKind)
    plain = Layer(kind)
    stops: list[tuple[float, str]] = []
    if fields["stops"].is_given or kind is LayerKind.GRADIENT:
        for item in fields["stops"].array("a list of 2 to 50 pairs [position, colour]", 2, 50):
            place, colour = item.array("a pair [position, colour]", 2, 2)
            stops.append((_number(place, 0.0, 0.0, 1.0), _colour(colour)))
    count = fields["count"]
    return Layer(
        kind,
        _colour(fields["color"]) if fields["color"].is_given else plain.color,
        _number(fields["from"], plain.start, 0.0, 1.0),
        _number(fields["to"], plain.end, 0.0, 1.0),
        fields["by"].choice(Along, plain.by),
        count.integer("a whole number from 1 to 1000", 1, 1000) if count.is_given else plain.count,
        _number(fields["width"], plain.width, 0.0, 1.0),
        _number(fields["twist"], plain.twist, -100.0, 100.0),
        tuple(sorted(stops, key=lambda stop: stop[0])),
        _segments(fields["segments"]) if fields["segments"].is_given else (),
        fields.rest(),
    )


def _map(fields: Fields) -> ColourMap:
    of = fields["of"].choice(MapKind)
    low, high = fields["low"], fields["high"]
    segment, name = fields["segment"], fields["parameter"]
    parameter = next((each for each in PARAMETER_RANGES if each == name.value), None)
    if parameter is None:
        if name.is_given:
            name.fail(", ".join(f'"{each}"' for each in PARAMETER_RANGES))
        parameter = "omega"
    allowed = f"a segment number from 0 to {MAX_SEGMENT}"
    shown = ColourMap(
        of,
        _number(low, 0.0) if low.is_given else None,
        _number(high, 0.0) if high.is_given else None,
        fields["scale"].choice(Scale, Scale.AUTO),
        parameter,
        segment.integer(allowed, 0, MAX_SEGMENT) if segment.is_given else None,
        fields.rest(),
    )
    if shown.low is not None and shown.high is not None and not shown.low < shown.high:
        high.fail("a number above the lower limit")
    return shown


def _pictures(node: Node) -> tuple[Picture, ...]:
    if not node.is_given:
        return ()
    allowed = f"a list of at most {look.MAX_PICTURES} pictures"
    found = []
    for item in node.array(allowed, 0, look.MAX_PICTURES):
        most = f"base64 text of at most {look.MAX_PICTURE_BYTES >> 20} MB"
        if not isinstance(item.value, str) or len(item.value) > look.MAX_PICTURE_BYTES * 3 // 2:
            item.fail(most)
        try:
            data = base64.b64decode(item.value, validate=True)
            check_picture(data)
        except (binascii.Error, PictureError):
            item.fail(f"a PNG or JPEG picture as {most}")
        found.append(Picture(data))
    return tuple(found)


def appearance_tree(appearance: Appearance) -> dict[str, object]:
    """Return the section; what says nothing but the default is left out."""
    tree: dict[str, object] = {}
    for key in ("material", "color", "lighting", "background", "shading"):
        _put(tree, key, getattr(appearance, key), getattr(look.PLAIN, key))
    for key in ("shadow", "silhouette", "features"):
        _put(tree, key, getattr(appearance, key), False)
    if appearance.textures:
        tree["textures"] = [_texture_tree(texture) for texture in appearance.textures]
    if appearance.drawing:
        tree["drawing"] = [_layer_tree(layer) for layer in appearance.drawing]
    if appearance.map is not None:
        tree["map"] = _map_tree(appearance.map)
    if appearance.pictures:
        tree["pictures"] = [
            base64.b64encode(picture.data).decode("ascii") for picture in appearance.pictures
        ]
    return {**tree, **appearance.extra}


def _put(tree: dict[str, object], key: str, value: object, default: object) -> None:
    if value != default:
        tree[key] = str(value) if isinstance(value, StrEnum) else value


def _texture_tree(texture: Texture) -> dict[str, object]:
    return {
        "image": texture.image,
        "segments": "all" if texture.segments is None else list(texture.segments),
        "repeat": list(texture.repeat),
        "offset": list(texture.offset),
        "rotate_deg": texture.rotate_deg,
        **texture.extra,
    }


def _layer_tree(layer: Layer) -> dict[str, object]:
    plain = Layer(layer.kind)
    tree: dict[str, object] = {"kind": str(layer.kind)}
    for key, name in (("color", "color"), ("from", "start"), ("to", "end"), ("by", "by")):
        _put(tree, key, getattr(layer, name), getattr(plain, name))
    for key in ("count", "width", "twist"):
        _put(tree, key, getattr(layer, key), getattr(plain, key))
    if layer.stops:
        tree["stops"] = [list(stop) for stop in layer.stops]
    if layer.segments:
        tree["segments"] = list(layer.segments)
    return {**tree, **layer.extra}


def _map_tree(shown: ColourMap) -> dict[str, object]:
    tree: dict[str, object] = {"of": str(shown.of)}
    plain = ColourMap(shown.of)
    for key in ("low", "high", "scale", "parameter", "segment"):
        _put(tree, key, getattr(shown, key), getattr(plain, key))
    return {**tree, **shown.extra}
