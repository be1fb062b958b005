"""Shapes that can be cut out of a wall: islands are tied to it, and bridges are wide enough.

The island inside an O would fall out: strips through the letter hold it. Whatever else hangs on
less than the least bridge is tied so too, and shapes nearer to each other than that give way.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sgb_core.arrays import Floats, frozen
from sgb_core.values import dataclass

# A piece narrower than this part of the least bridge, or of the whole, is not worth a hole.
_CRUMB, _DUST = 0.25, 2e-3
# A neck is one where the least bridge, narrowed by this part of it, does not pass.
_SLACK = 0.01
# How often islands are looked for again after they were tied.
_ROUNDS = 4
# Of the whole extent: how far outlines may be drawn straighter.
_STRAIGHT = 1e-4


@dataclass(frozen=True, slots=True, eq=False)
class Stencil:
    """The pieces to be cut: polygons without inner rings about (0, 0), around and up.

    ``width`` and ``height`` are those of all together, ``shapes`` is their union.
    """

    pieces: tuple[shapely.Polygon, ...]
    shapes: BaseGeometry
    width: float
    height: float

    @property
    def outlines(self) -> tuple[Floats, ...]:
        """The pieces' outlines counter-clockwise, (k, 2) each, no point repeated."""
        return tuple(
            frozen(shapely.get_coordinates(shapely.orient_polygons(piece).exterior)[:-1])
            for piece in self.pieces
        )


@dataclass(frozen=True, slots=True, eq=False)
class Shapes:
    """What is to be cut out, as drawn: separate ``parts`` from left to right, of any size."""

    parts: tuple[BaseGeometry, ...]


@lru_cache(maxsize=32)
def stencil_of(shapes: Shapes, factor: float, bridge: float, line: bool) -> Stencil | None:
    """Return shapes ``factor`` times as large, held by bridges of at least ``bridge``.

    The parts of a ``line``, as letters are, are moved apart where they stand too near. None where
    islands cannot be held, or a ``bridge`` of 0 leaves them to fall out; no pieces at all where
    there is nothing to cut.
    """
    parts = [shapely.transform(part, lambda points: factor * points) for part in shapes.parts]
    drawn = shapely.union_all(_apart(parts, bridge) if line else parts)
    if drawn.is_empty:
        return Stencil((), drawn, 0.0, 0.0)
    left, below, right, above = drawn.bounds
    middle = np.array([left + right, below + above]) / 2.0
    size = min(right - left, above - below)
    drawn = shapely.transform(drawn, lambda points: points - middle).simplify(_STRAIGHT * size)
    pieces = _spaced(_polygons(drawn), bridge, size)
    for _ in range(_ROUNDS):
        islands = _islands(pieces, bridge)
        if not islands:
            break
        if bridge == 0.0:
            return None
        pieces = _tied(pieces, islands, bridge)
    if _islands(pieces, bridge):
        return None
    # What is narrower than a bridge cannot be held: it is cut away. Pieces may have come apart.
    pieces = _spaced([shapely.Polygon(piece.exterior) for piece in pieces], bridge, size)
    return Stencil(tuple(pieces), shapely.union_all(pieces), right - left, above - below)


def _polygons(shape: BaseGeometry) -> list[shapely.Polygon]:
    parts = shapely.get_parts(shape)
    return [part for part in parts if isinstance(part, shapely.Polygon) and part.area > 0.0]


def _apart(letters: Sequence[BaseGeometry], bridge: float) -> list[BaseGeometry]:
    """Return the letters of a line, each as far to the right as the least bridge asks."""
    found: list[BaseGeometry] = []
    shift = 0.0
    for letter in letters:
        moved = _shifted(letter, shift)
        if found:
            for _ in range(_ROUNDS * 4):
                short = bridge - float(shapely.distance(found[-1], moved))
                if short <= 0.0:
                    break
                shift += max(short, 0.05 * bridge)
                moved = _shifted(letter, shift)
        found.append(moved)
    return found


def _shifted(shape: BaseGeometry, shift: float) -> BaseGeometry:
    return shapely.transform(shape, lambda points: points + np.array([shift, 0.0]))


def _spaced(polygons: list[shapely.Polygon], bridge: float, size: float) -> list[shapely.Polygon]:
    """Return the polygons with the least bridge between any two: the larger give way."""
    kept: list[shapely.Polygon] = []
    worthy = [part for polygon in polygons for part in _worthy(polygon, bridge, size)]
    for polygon in sorted(worthy, key=lambda each: each.area):
        near = [other for other in kept if shapely.dwithin(other, polygon, bridge * (1.0 - _SLACK))]
        left = polygon
        if near and bridge > 0.0:
            left = polygon.difference(shapely.union_all(near).buffer(bridge * (1.0 + _SLACK)))
        kept += _worthy(left, bridge, size)
    return kept


def _worthy(shape: BaseGeometry, bridge: float, size: float) -> list[shapely.Polygon]:
    """Return the parts of a shape that are more than crumbs, without their thinnest spikes.

    The sides of a narrower spike would cross where they are taken apart into chords, and sides of
    hardly any length are merged where the wall is cut, with the way that they face.
    """
    least = max(_CRUMB * bridge, _DUST * size) / 2.0
    # Where sides are nearly parallel a mitre's length is no number, and GEOS bevels it.
    with np.errstate(divide="ignore", invalid="ignore"):
        opened = shape.buffer(-least, join_style="mitre").buffer(least, join_style="mitre")
    sides = shapely.remove_repeated_points(opened.intersection(shape), _STRAIGHT * size)
    return _polygons(sides.buffer(0.0))


def _islands(pieces: Sequence[shapely.Polygon], bridge: float) -> list[shapely.Polygon]:
    """Return the parts of the wall that nothing holds, or only less than the least bridge."""
    if not pieces:
        return []
    half = bridge * (0.5 - _SLACK)
    # What is narrower than a bridge is gone where the pieces are so much larger.
    grown = shapely.union_all(pieces).buffer(half) if half > 0.0 else shapely.union_all(pieces)
    inner = [shapely.Polygon(ring) for part in _polygons(grown) for ring in part.interiors]
    return [
        island.buffer(half * (1.0 + _SLACK)) for island in inner if island.area > half * half / 4.0
    ]


def _tied(
    pieces: Sequence[shapely.Polygon], islands: Sequence[shapely.Polygon], bridge: float
) -> list[shapely.Polygon]:
    """Return the pieces with upright strips left standing between islands and what is around."""
    cut = shapely.union_all(pieces)
    left, below, right, above = cut.bounds
    half = bridge / 2.0 * (1.0 + _SLACK)
    strips: list[BaseGeometry] = []
    for island in islands:
        x, y = _middle(island)
        held = []
        for strip in (
            shapely.box(x - half, below - bridge, x + half, above + bridge),
            shapely.box(left - bridge, y - half, right + bridge, y + half),
        ):
            held = [part for part in _polygons(strip.intersection(cut)) if part.intersects(island)]
            if held:
                break
        strips += [part.buffer(half * _SLACK, join_style="mitre") for part in held]
    size = min(right - left, above - below)
    return _spaced(_polygons(cut.difference(shapely.union_all(strips))), bridge, size)


def _middle(island: shapely.Polygon) -> tuple[float, float]:
    """Return the middle of an island, or a point inside one that is hollow there."""
    point = island.centroid
    if not island.contains(point):
        point = island.representative_point()
    return float(point.x), float(point.y)
