"""What can be dimensioned of a profile and its body, and be locked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from enum import StrEnum, auto
from types import MappingProxyType

from sgb_core.curves.profile import MAX_SEGMENTS, SMOOTH_RULES, JointRule
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import COORDINATE, FINITE, SHARE, Choice, Flag, Range, Said
from sgb_core.fields.lists import Fixed, OrNone, Several
from sgb_core.fields.record import Record, check, says
from sgb_core.values import dataclass

MAX_DIMENSIONS = 200


class DimensionKind(StrEnum):
    """What a dimension measures."""

    HEIGHT = "height"
    MAX_DIAMETER = "max_diameter"
    MAX_DIAMETER_HEIGHT = "max_diameter_height"
    RIM_DIAMETER = "rim_diameter"
    FOOT_DIAMETER = "foot_diameter"
    NECK_DIAMETER = "neck_diameter"
    NECK_HEIGHT = "neck_height"
    DIAMETER_AT = "diameter_at"
    DISTANCE = "distance"
    ANGLE = "angle"
    RADIUS = "radius"
    POINT = "point"
    JOINT = "joint"
    WALL = "wall"
    BASE = "base"
    FILL_LINE = "fill_line"
    CAPACITY = "capacity"
    FILLED = "filled"
    VOLUME = "volume"
    MATERIAL = "material"
    MASS = "mass"


class Quantity(StrEnum):
    """What a dimension's value is counted in: the unit, degrees, unit³, grams, or nothing."""

    LENGTH = auto()
    ANGLE = auto()
    VOLUME = auto()
    MASS = auto()
    NONE = auto()


@dataclass(frozen=True, slots=True)
class KindFacts:
    """What a kind is called, counted in, and told by; ``points`` is how many points it names."""

    label: str
    quantity: Quantity = Quantity.LENGTH
    points: int = 0
    needs: tuple[str, ...] = ()


_K, _Q = DimensionKind, Quantity
KINDS: Mapping[DimensionKind, KindFacts] = MappingProxyType(
    {
        _K.HEIGHT: KindFacts("Height"),
        _K.MAX_DIAMETER: KindFacts("Greatest diameter"),
        _K.MAX_DIAMETER_HEIGHT: KindFacts("Height of the greatest diameter"),
        _K.RIM_DIAMETER: KindFacts("Rim diameter"),
        _K.FOOT_DIAMETER: KindFacts("Foot diameter"),
        _K.NECK_DIAMETER: KindFacts("Neck diameter"),
        _K.NECK_HEIGHT: KindFacts("Height of the neck"),
        _K.DIAMETER_AT: KindFacts("Diameter at a height", needs=("height",)),
        _K.DISTANCE: KindFacts("Distance", points=2),
        _K.ANGLE: KindFacts("Angle", _Q.ANGLE, points=2),
        _K.RADIUS: KindFacts("Radius of curvature", needs=("segment", "s")),
        _K.POINT: KindFacts("Point", _Q.NONE, points=1),
        _K.JOINT: KindFacts("Joint rule", _Q.NONE, needs=("joint", "rule")),
        _K.WALL: KindFacts("Wall"),
        _K.BASE: KindFacts("Floor"),
        _K.FILL_LINE: KindFacts("Fill line"),
        _K.CAPACITY: KindFacts("Capacity", _Q.VOLUME),
        _K.FILLED: KindFacts("Volume to the fill line", _Q.VOLUME),
        _K.VOLUME: KindFacts("Volume", _Q.VOLUME),
        _K.MATERIAL: KindFacts("Material", _Q.VOLUME),
        _K.MASS: KindFacts("Mass", _Q.MASS),
    }
)
_SIGNED = (_K.ANGLE, _K.MAX_DIAMETER_HEIGHT, _K.NECK_HEIGHT, _K.FILL_LINE)
# With which power of the size a value grows.
_POWERS = {_Q.LENGTH: 1, _Q.VOLUME: 3, _Q.MASS: 3}
_SEGMENT = Range(0, MAX_SEGMENTS - 1, whole=True)
_POINT = Fixed((_SEGMENT, Range(0, 3, whole=True)), "a pair [segment, point]")
_POINTS = Several(_POINT, "pairs [segment, point]", 2)
_VALUE = FINITE
_POSITIVE = Range(above=0.0, said="a positive number")


@dataclass(frozen=True, slots=True)
class Dimension:
    """One dimension: a lock where it is ``locked``, else one that only tells.

    ``value`` is what a lock holds, in powers of the document's unit, degrees or grams; only locks
    of numbers have one. ``points`` are (segment, point), ``height`` is an h of the profile, and
    ``s`` a place on ``segment``. A locked joint keeps ``rule``, a locked point its place. An angle
    is that of the line from the first point to the second, from the r axis to the h axis.

    Raises RefusalError, a ValueError, for a value that is not allowed.

    >>> sgb.Dimension("rim_diameter", locked=True, value=80.0).label
    'Rim diameter'
    """

    RECORD = Record(
        "dimension",
        "A dimension; locked ones keep their value while everything else changes.",
        brief=True,
        first=("kind",),
    )

    kind: DimensionKind = field(metadata=says(Choice(DimensionKind), label="Dimension"))
    locked: bool = field(default=False, metadata=says(Flag(), label="Locked"))
    value: float | None = field(
        default=None, metadata=says(OrNone(_VALUE, absent=True), label="Value")
    )
    points: tuple[tuple[int, int], ...] = field(default=(), metadata=says(_POINTS))
    height: float | None = field(default=None, metadata=says(OrNone(COORDINATE, absent=True)))
    segment: int | None = field(default=None, metadata=says(OrNone(_SEGMENT, absent=True)))
    s: float | None = field(default=None, metadata=says(OrNone(SHARE, absent=True)))
    joint: int | None = field(default=None, metadata=says(OrNone(_SEGMENT, absent=True)))
    rule: JointRule | None = field(
        default=None, metadata=says(OrNone(Choice(JointRule), absent=True))
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        facts = self.facts
        if len(self.points) != facts.points or len(set(self.points)) < len(self.points):
            words = f"a list of {facts.points} different pairs [segment, point]"
            raise Said(words).refusal(self.points, ("dimension", "points"))
        for name in ("height", "segment", "s", "joint", "rule"):
            if (getattr(self, name) is not None) != (name in facts.needs):
                words = "a value" if name in facts.needs else f"none for {self.kind.value}"
                raise Said(words).refusal(getattr(self, name), ("dimension", name))
        if self.rule is not None and self.rule not in SMOOTH_RULES:
            raise Said('"G1", "C1", "G2"').refusal(self.rule, ("dimension", "rule"))
        self._check_value()

    def _check_value(self) -> None:
        path = ("dimension", "value")
        holds = self.locked and self.facts.quantity is not Quantity.NONE
        if (self.value is not None) != holds:
            words = "a number where locked" if holds else "none where it is not locked"
            raise Said(words).refusal(self.value, path)
        if self.value is not None and self.kind not in _SIGNED and self.kind is not _K.BASE:
            _POSITIVE.take(self.value, path)

    @property
    def facts(self) -> KindFacts:
        """What is said of its kind."""
        return KINDS[self.kind]

    @property
    def label(self) -> str:
        """What it is called."""
        return self.facts.label

    @property
    def is_number(self) -> bool:
        """Whether it has a value at all."""
        return self.facts.quantity is not Quantity.NONE

    def held_at(self, value: float | None) -> Dimension:
        """Return the same dimension locked at a value."""
        return replace(self, locked=True, value=value)

    def freed(self) -> Dimension:
        """Return the same dimension as one that only tells."""
        return replace(self, locked=False, value=None)

    def enlarged(self, factor: float) -> Dimension:
        """Return the dimension of an object ``factor`` times as large."""
        power = _POWERS.get(self.facts.quantity, 0)
        return replace(
            self,
            value=None if self.value is None else self.value * factor**power,
            height=None if self.height is None else self.height * factor,
        )


def misplaced(
    dimension: Dimension, segments: int, joints: int
) -> tuple[tuple[str | int, ...], int, int] | None:
    """Return which number of a dimension a profile does not have, and the most that it has."""
    for place, (segment, _) in enumerate(dimension.points):
        if segment >= segments:
            return ("points", place, 0), segment, segments - 1
    if dimension.segment is not None and dimension.segment >= segments:
        return ("segment",), dimension.segment, segments - 1
    if dimension.joint is not None and dimension.joint >= joints:
        return ("joint",), dimension.joint, joints - 1
    return None
