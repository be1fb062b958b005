"""What of the body and its look can be grabbed where it is seen: wall, floor, bands, textures."""

from __future__ import annotations

from dataclasses import replace
from enum import Enum, auto

import numpy as np

from app.hand import texture_place
from app.hand.coordinates import Paper, ScreenPoint, decimals_for, number
from app.state.overlays import Overlay
from app.state.presenter import Frame
from sgb_core.arrays import Floats
from sgb_core.bodies.solid import BodyKind
from sgb_core.curves.nearest import nearest
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.appearance.model import Along, Layer, LayerKind
from sgb_core.document.model import Document
from sgb_core.values import dataclass

REACH = 5.0
BAND_REACH = 7.0
# A wall is no thinner than this part of the profile's size, and this near to what it should be.
_THINNEST = 1e-3
_LIKE_WALL = 0.2
# By so much of the length apart lie the places that tell the direction there.
_NEAR = 1e-3
# Where a band's edge lies is looked for among so many places on each segment.
_SAMPLES = 65


class Kind(Enum):
    """The kinds of features."""

    WALL = auto()
    FLOOR = auto()
    BAND = auto()
    TEXTURE = auto()


_LABELS = {
    Kind.WALL: "Wall",
    Kind.FLOOR: "Floor",
    Kind.BAND: "Painted band",
    Kind.TEXTURE: "Texture",
}


@dataclass(frozen=True, slots=True)
class Feature:
    """One thing to grab: ``at`` is the place (r, h) where, ``angle`` the way it is dragged.

    ``layer`` is the number of a band's layer of paint, ``upper`` says which of its two edges, or
    ``layer`` is that of a texture;
    ``sign`` is 1 where a floor grows upwards, −1 where it grows downwards. ``angle`` is in degrees
    from the right upwards.
    """

    kind: Kind
    at: tuple[float, float]
    angle: float = 90.0
    layer: int = 0
    upper: bool = False
    sign: float = 1.0

    @property
    def label(self) -> str:
        """The undo entry's name."""
        return _LABELS[self.kind]

    def same(self, other: Feature | None) -> bool:
        """Whether both are the same thing, wherever it is touched."""
        return other is not None and replace(self, at=(0.0, 0.0), angle=0.0) == replace(
            other, at=(0.0, 0.0), angle=0.0
        )

    def is_gone(self, document: Document) -> bool:
        """Whether the layer of paint, or the texture, is there no longer."""
        look = document.appearance
        if self.kind is Kind.TEXTURE:
            return self.layer >= len(look.textures)
        return self.kind is Kind.BAND and self.layer >= len(look.drawing)

    def lines(self, document: Document, scale: float) -> list[str]:
        """Return what the heads-up label says."""
        decimals, unit = decimals_for(1.0 / scale), str(document.unit)
        if self.kind is Kind.WALL:
            return [f"wall {number(document.solid.wall, decimals)} {unit}"]
        if self.kind is Kind.FLOOR:
            return [f"floor {number(document.solid.base, decimals)} {unit}"]
        if self.kind is Kind.TEXTURE:
            return texture_place.told(document, self.layer)
        layer = document.appearance.drawing[self.layer]
        edge = "ends" if self.upper else "begins"
        share = 100.0 * (layer.end if self.upper else layer.start)
        of = "the height" if layer.by is Along.HEIGHT else "the length"
        return [f"painted {layer.kind.value}", f"{edge} at {number(share, 1)} % of {of}"]

    def dragged(self, before: Document, to: tuple[float, float]) -> Document:
        """Return the document with this feature drawn to a place (r, h)."""
        profile = before.profile
        if self.kind is Kind.WALL:
            wall = max(nearest(profile, to).distance, _THINNEST * profile.size)
            return edits.set_solid(before, wall=wall)
        if self.kind is Kind.FLOOR:
            base = before.solid.base + self.sign * (to[1] - self.at[1])
            return edits.set_solid(before, base=max(base, 0.0))
        if self.kind is Kind.TEXTURE:
            way = length_share(profile, to) - length_share(profile, self.at)
            return texture_place.moved(before, self.layer, 0.0, way)
        layers = list(before.appearance.drawing)
        layer = layers[self.layer]
        share = min(1.0, max(0.0, share_at(profile, layer, to)))
        if self.upper:
            layers[self.layer] = replace(layer, end=max(share, layer.start))
        else:
            layers[self.layer] = replace(layer, start=min(share, layer.end))
        return edits.set_appearance(before, drawing=tuple(layers))


def share_at(profile: Profile, layer: Layer, place: tuple[float, float]) -> float:
    """Return which part of the height, or of the length, lies up to a place."""
    if layer.by is Along.HEIGHT:
        low, high = (float(corner[1]) for corner in profile.bounds())
        return (place[1] - low) / (high - low) if high > low else 0.0
    return length_share(profile, place)


def length_share(profile: Profile, place: tuple[float, float]) -> float:
    """Return which part of the generatrix' length lies up to the point nearest to a place."""
    points, along = _along(profile)
    foot = int(np.hypot(*(points - place).T).argmin())
    return float(along[foot] / along[-1]) if along[-1] > 0.0 else 0.0


def edge_places(profile: Profile, layer: Layer, *, upper: bool) -> Floats:
    """Return where on the profile an edge of a layer lies, shape (m, 2)."""
    share = layer.end if upper else layer.start
    points, along = _along(profile)
    if layer.by is Along.HEIGHT:
        low, high = (float(corner[1]) for corner in profile.bounds())
        values, level = points[:, 1], low + share * (high - low)
    else:
        values, level = along, share * float(along[-1])
    before, after = values[:-1] - level, values[1:] - level
    steps = np.flatnonzero((before <= 0.0) != (after <= 0.0))
    if len(steps) == 0:
        return points[[int(np.abs(values - level).argmin())]]
    part = (before[steps] / (before[steps] - after[steps]))[:, None]
    return np.asarray(points[steps] + part * (points[steps + 1] - points[steps]))


def _along(profile: Profile) -> tuple[Floats, Floats]:
    points = profile.sample(_SAMPLES).reshape(-1, 2)
    steps = np.hypot(*np.diff(points, axis=0).T)
    return points, np.concatenate(([0.0], np.cumsum(steps)))


def bands(document: Document) -> list[tuple[int, Layer]]:
    """Return the layers of paint that have edges to grab, with their numbers."""
    drawing = document.appearance.drawing
    return [(k, each) for k, each in enumerate(drawing) if each.kind is not LayerKind.SEGMENTS]


def pick_band(document: Document, paper: Paper, at: ScreenPoint) -> Feature | None:
    """Return the edge of a painted layer that a press would grab; upper layers come first."""
    for number_, layer in reversed(bands(document)):
        for upper in (True, False):
            places = edge_places(document.profile, layer, upper=upper)
            away = np.hypot(*(paper.map(places) - (at.x, at.y)).T)
            if away.min() <= BAND_REACH:
                r, h = places[int(away.argmin())].tolist()
                return Feature(Kind.BAND, (r, h), layer=number_, upper=upper)
    return None


def textures(document: Document) -> list[Feature]:
    """Return where on the profile each texture is grabbed: in the middle of a tile."""
    found: list[Feature] = []
    if not document.appearance.textures:
        return found
    on = texture_place.unrolled(document)
    for number_ in range(len(document.appearance.textures)):
        tiling = texture_place.laid(document, number_, on)
        if tiling is not None:
            _, v = tiling.centre(0.0)
            (r, h), (before, below) = (texture_place.place_at(on, v + d) for d in (_NEAR, -_NEAR))
            angle = float(np.degrees(np.arctan2(h - below, r - before)))
            place = texture_place.place_at(on, v)
            found.append(Feature(Kind.TEXTURE, place, angle=angle, layer=number_))
    return found


def pick_texture(document: Document, paper: Paper, at: ScreenPoint) -> Feature | None:
    """Return the texture that a press would grab; later ones lie over earlier ones."""
    for feature in reversed(textures(document)):
        if np.hypot(*(paper.map(feature.at) - (at.x, at.y))) <= BAND_REACH:
            return feature
    return None


def pick_body(frame: Frame, paper: Paper, at: ScreenPoint) -> Feature | None:
    """Return the wall or the floor that a press would grab, on the edge of the body's section."""
    state, document = frame.body, frame.document
    if state is None or document.solid.kind is not BodyKind.VESSEL:
        return None
    best: tuple[float, Floats, Floats] | None = None
    for part in state.section(state.surface.start):
        for loop in (part.exterior, *part.holes):
            ring = np.concatenate([loop, loop[:1]])
            found = _foot(paper.map(ring), ring, at)
            if found is not None and (best is None or found[0] < best[0]):
                best = found
    if best is None or best[0] > REACH:
        return None
    return _named(document, best[1], best[2])


def _foot(places: Floats, ring: Floats, at: ScreenPoint) -> tuple[float, Floats, Floats] | None:
    """Return how far a polyline passes in pixels, where in the design, and its direction there."""
    start, step = places[:-1], np.diff(places, axis=0)
    squared = (step**2).sum(axis=1)
    part = ((np.array((at.x, at.y)) - start) * step).sum(axis=1)
    part = np.clip(part / np.where(squared > 0.0, squared, 1.0), 0.0, 1.0)
    away = np.hypot(*(start + part[:, None] * step - (at.x, at.y)).T)
    if len(away) == 0:
        return None
    k = int(away.argmin())
    way = ring[k + 1] - ring[k]
    return float(away[k]), ring[k] + part[k] * way, way


def _named(document: Document, place: Floats, way: Floats) -> Feature | None:
    """Return what an edge of the section is: wall, floor, or neither."""
    solid, profile = document.solid, document.profile
    at = (float(place[0]), float(place[1]))
    thick = nearest(profile, at).distance
    low = float(profile.bounds()[0][1])
    level = abs(way[1]) <= 0.05 * abs(way[0])
    rise = at[1] - low
    like = _LIKE_WALL * max(solid.base, 1e-9 * profile.size)
    if level and abs(abs(rise) - solid.base) <= like and solid.base > 0.0:
        return Feature(Kind.FLOOR, at, sign=1.0 if rise >= 0.0 else -1.0)
    if abs(thick - solid.wall) <= _LIKE_WALL * solid.wall:
        angle = float(np.degrees(np.arctan2(way[0], -way[1])))
        return Feature(Kind.WALL, at, angle=angle)
    return None


def fill_height(frame: Frame) -> float | None:
    """Return the height of the fill line that is shown; bare surfaces show none."""
    if frame.document.solid.kind is not BodyKind.VESSEL or not frame.view.shows(Overlay.LIQUID):
        return None
    return frame.document.fill_height


def on_fill_line(frame: Frame, paper: Paper, at: ScreenPoint) -> bool:
    """Whether a press would grab the liquid's surface where its section is seen."""
    height = fill_height(frame)
    if height is None or frame.body is None or not frame.body.liquid_section:
        return False
    reach = max((np.abs(loop[:, 0]).max() for loop in frame.body.liquid_section), default=0.0)
    ring = np.array(((0.0, height), (float(reach), height)))
    found = _foot(paper.map(ring), ring, at)
    return found is not None and found[0] <= REACH
