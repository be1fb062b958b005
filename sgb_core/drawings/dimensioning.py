"""Which dimensions a drawing has, where each is taken, and its words.

The project's own are drawn; a project without any gets height, diameters, wall, floor and the
radii at its joints. Every value is that of :func:`dimension_value`, shown to a hundredth of a
millimetre or a thousandth of other units.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from math import hypot

import numpy as np

from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outline import Role
from sgb_core.bodies.solid import BodyKind
from sgb_core.design.demands.chain import Chain
from sgb_core.design.locks.dimension import Dimension, DimensionKind, Quantity
from sgb_core.design.locks.gauge import Gauge
from sgb_core.design.locks.readings import read, spot_of
from sgb_core.document.dimensions import dimension_value, setting_of
from sgb_core.document.model import Document, Unit
from sgb_core.values import dataclass

_K = DimensionKind
_VERTICAL = (_K.MAX_DIAMETER_HEIGHT, _K.NECK_HEIGHT, _K.FILL_LINE)
_ACROSS = (_K.RIM_DIAMETER, _K.MAX_DIAMETER, _K.FOOT_DIAMETER)
_USUAL = (_K.HEIGHT, _K.RIM_DIAMETER, _K.FOOT_DIAMETER, _K.MAX_DIAMETER, _K.WALL, _K.BASE)
# Of the size: radii beyond are as good as straight, places nearer than the last are one.
_STRAIGHT, _SAME = 10.0, 1e-6
_ALIKE = 1e-3


@dataclass(frozen=True, slots=True)
class Across:
    """A diameter between two level places at (±r, h), in mm of the object."""

    words: str
    r: float
    h: float


@dataclass(frozen=True, slots=True)
class Upright:
    """A height between two places at (r, h), in mm of the object."""

    words: str
    low: tuple[float, float]
    high: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Note:
    """Words with a line that leads to a place at (r, h) of the section, in mm of the object.

    ``along`` is a line that is measured, where it is not the place itself; ``inside`` tells that
    the place lies within the material and not on its outline.
    """

    words: str
    at: tuple[float, float]
    along: tuple[tuple[float, float], tuple[float, float]] | None = None
    inside: bool = False


@dataclass(frozen=True, slots=True)
class Dimensions:
    """All that is dimensioned; ``listed`` are labels and values without a place."""

    across: tuple[Across, ...] = ()
    upright: tuple[Upright, ...] = ()
    notes: tuple[Note, ...] = ()
    listed: tuple[tuple[str, str], ...] = ()


def number_words(value: float, unit: Unit) -> str:
    """Return a length in a unit as a drawing shows it."""
    text = f"{value:.{2 if unit is Unit.MM else 3}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def volume_words(value: float, unit: Unit) -> str:
    """Return a volume (unit³) in millilitres, or in litres from ten of them on."""
    millilitres = value * unit.millilitres
    return f"{millilitres / 1000.0:.2f} l" if millilitres >= 10_000.0 else f"{millilitres:.1f} ml"


def drawn_dimensions(document: Document) -> Dimensions:
    """Return what is dimensioned of a document."""
    own = [each for each in document.dimensions if each.is_number]
    taker = _Taker(document)
    if own:
        for dimension in own:
            taker.take(dimension)
    else:
        for kind in _USUAL:
            taker.take(Dimension(kind))
        taker.take_joints()
    return taker.taken()


def as_at_start(document: Document) -> Document:
    """Return a document with the section at its start angle as its profile, without laws."""
    if not document.variation:
        return document
    surface = document.surface
    section, stretch = surface.shape_at(surface.start), surface.section.stretch
    if stretch is not None:
        # Ends of segments lie where they are drawn; what is between them is near.
        section = section.with_segments(
            segment.with_points(stretch[k].of(segment.points))
            for k, segment in enumerate(section.segments)
        )
    return replace(document, profile=section, variation=())


class _Taker:
    """Finds the place of one dimension after the other, on the section at the start angle."""

    def __init__(self, document: Document) -> None:
        self._whole, document = document, as_at_start(document)
        self._document = document
        self._gauge = Gauge(Chain.of(document.profile), slopes=False)
        self._setting = setting_of(document)
        self._factor = document.unit.millimetres
        self._size = document.profile.size
        self._side = -1.0 if float(document.profile.quartics[..., 0].sum()) < 0.0 else 1.0
        self._across: list[Across] = []
        self._upright: list[Upright] = []
        self._notes: list[Note] = []
        self._listed: list[tuple[str, str]] = []

    def taken(self) -> Dimensions:
        """Return what was found."""
        return Dimensions(
            tuple(self._across), tuple(self._upright), tuple(self._notes), tuple(self._listed)
        )

    def take(self, dimension: Dimension) -> None:
        """Find the place of a dimension; one that has no value is left out."""
        kind = dimension.kind
        listed = _OTHERS.get(kind) is _Taker.take_listed
        value = dimension_value(self._whole if listed else self._document, dimension)
        if value is None:
            return
        if kind is _K.HEIGHT:
            # What is flat has no height to be drawn.
            if value > _SAME * self._size:
                self._take_height(value)
        elif kind in _ACROSS:
            self._take_across(dimension, value)
        elif kind in _VERTICAL:
            self._take_level(dimension, value)
        else:
            _OTHERS[kind](self, dimension, value)

    def _words(self, value: float, before: str = "") -> str:
        return f"{before}{number_words(value, self._document.unit)}"

    def _placed(self, point: tuple[float, float]) -> tuple[float, float]:
        return point[0] * self._factor * self._side, point[1] * self._factor

    def _spot(self, dimension: Dimension) -> tuple[float, float]:
        spot = spot_of(self._gauge, dimension)
        assert spot is not None  # It has a value, so it has a place.
        r, h = self._document.profile.point(spot.segment, spot.s).tolist()
        return self._placed((r, h))

    def _extreme(self, sign: float) -> tuple[float, float]:
        spot = self._gauge.extreme(1, sign)
        r, h = self._document.profile.point(spot.segment, spot.s).tolist()
        return self._placed((r, h))

    def _take_height(self, value: float) -> None:
        self._upright.append(Upright(self._words(value), self._extreme(-1.0), self._extreme(1.0)))

    def _take_across(self, dimension: Dimension, value: float) -> None:
        r, h = self._spot(dimension)
        words = self._words(value, "⌀")
        known = dimension.kind is _K.MAX_DIAMETER and any(
            each.words == words for each in self._across
        )
        if value > _SAME * self._size and not known:
            self._across.append(Across(words, abs(r), h))

    def _take_level(self, dimension: Dimension, value: float) -> None:
        """Take a height of the profile: above its lowest place where that is at 0."""
        foot, h = self._extreme(-1.0), value * self._factor
        at = (0.0, h) if dimension.kind is _K.FILL_LINE else self._spot(dimension)
        if abs(foot[1]) <= _SAME * self._size * self._factor and h > 0.0:
            self._upright.append(Upright(self._words(value), foot, (abs(at[0]), h)))
        else:
            self._notes.append(Note(self._words(value, "h "), (abs(at[0]), h)))

    def take_diameter(self, dimension: Dimension, value: float) -> None:
        """Take a diameter somewhere on the way up."""
        r, h = self._spot(dimension)
        self._notes.append(Note(self._words(value, "⌀"), (abs(r), h)))

    def take_radius(self, dimension: Dimension, value: float) -> None:
        """Take a radius of curvature."""
        self._notes.append(Note(self._words(value, "R"), self._spot(dimension)))

    def take_distance(self, dimension: Dimension, value: float) -> None:
        """Take how far apart two control points are."""
        first, last = self._points(dimension)
        middle = (0.5 * (first[0] + last[0]), 0.5 * (first[1] + last[1]))
        self._notes.append(Note(self._words(value), middle, (first, last)))

    def take_angle(self, dimension: Dimension, value: float) -> None:
        """Take the lean of the line between two control points."""
        first, last = self._points(dimension)
        self._notes.append(Note(f"∠{value:.2f}°", first, (first, last)))

    def _points(self, dimension: Dimension) -> list[tuple[float, float]]:
        points = self._document.profile.control_points
        return [self._placed(tuple(points[k, i].tolist())) for k, i in dimension.points]

    def take_wall(self, _: Dimension, value: float) -> None:
        """Take how thick the wall is, in the middle of its longest stretch."""
        at = self._within(Role.WALL, value)
        self._notes.append(Note(self._words(value, "wall "), at, inside=True))

    def take_base(self, _: Dimension, value: float) -> None:
        """Take how thick the floor is."""
        if value > 0.0:
            at = self._within(Role.FLOOR, value)
            self._notes.append(Note(self._words(value, "floor "), at, inside=True))

    def _within(self, role: Role, thickness: float) -> tuple[float, float]:
        """Return a place inside the material, half the thickness from the piece of a role."""
        section = cross_section(self._document.surface, self._document.solid)
        pieces = [piece for each in section.outlines for ring in each.rings for piece in ring]
        best, longest = None, 0.0
        for piece in pieces:
            if piece.role is role:
                ends = piece.ends
                length = hypot(*(ends[1] - ends[0]))
                if length > longest:
                    best, longest = piece, length
        if best is None:
            return self._placed((0.0, float(section.meridian.foot[1])))
        middle = np.array([0.5 * (best.start + best.end)])
        point, normal = best.points(middle)[0], best.normals(middle)[0]
        r, h = (point - 0.5 * thickness * normal).tolist()
        return abs(r) * self._factor, h * self._factor

    def take_listed(self, dimension: Dimension, value: float) -> None:
        """Take what has no place: a volume or a mass."""
        if dimension.facts.quantity is Quantity.VOLUME:
            words = volume_words(value, self._document.unit)
        else:
            words = f"{value:.1f} g"
        self._listed.append((dimension.label, words))

    def take_joints(self) -> None:
        """Take the radii of curvature on both sides of each joint where they are not straight."""
        profile = self._document.profile
        for joint in profile.joints:
            if not profile.joined[joint]:
                continue
            before, after = profile.neighbours(joint)
            sides = [self._radius(before, 1.0), self._radius(after, 0.0)]
            words = list(self._side_words(sides))
            if words:
                r, h = profile.point(before, 1.0).tolist()
                self._notes.append(Note(" / ".join(words), self._placed((r, h))))

    def _radius(self, segment: int, s: float) -> float | None:
        # By the one gauge: another for each joint would take the square of their number.
        found = read(self._gauge, Dimension(_K.RADIUS, segment=segment, s=s), self._setting)
        return None if found is None or found.value > _STRAIGHT * self._size else found.value

    def _side_words(self, sides: list[float | None]) -> Iterator[str]:
        first, last = sides
        if first is None and last is None:
            return
        if first is not None and last is not None and abs(first - last) <= _ALIKE * first:
            yield self._words(first, "R")
            return
        for value in sides:
            yield "straight" if value is None else self._words(value, "R")


_OTHERS: dict[DimensionKind, Callable[[_Taker, Dimension, float], None]] = {
    _K.NECK_DIAMETER: _Taker.take_diameter,
    _K.DIAMETER_AT: _Taker.take_diameter,
    _K.DISTANCE: _Taker.take_distance,
    _K.ANGLE: _Taker.take_angle,
    _K.RADIUS: _Taker.take_radius,
    _K.WALL: _Taker.take_wall,
    _K.BASE: _Taker.take_base,
    _K.CAPACITY: _Taker.take_listed,
    _K.FILLED: _Taker.take_listed,
    _K.VOLUME: _Taker.take_listed,
    _K.MATERIAL: _Taker.take_listed,
    _K.MASS: _Taker.take_listed,
}


def held(document: Document) -> tuple[str, str]:
    """Return what a document holds, as a label and words: its capacity, or the drawn volume."""
    if document.solid.kind is BodyKind.VESSEL:
        try:
            value = dimension_value(document, Dimension(_K.CAPACITY))
        except SolidError:
            value = None
        return "Capacity", "–" if value is None else volume_words(value, document.unit)
    return "Volume", volume_words(document.volume, document.unit)
