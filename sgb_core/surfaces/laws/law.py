"""A law: one shape parameter of some segments, or the radius, as a function of the angle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from itertools import pairwise
from types import MappingProxyType
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves.profile import MAX_SEGMENTS
from sgb_core.curves.segment import PARAMETER_RANGES, SYMBOLS, parameter_range
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import FINITE, SHARE, Choice, Range, Said, Schema
from sgb_core.fields.lists import Fixed, OrNone, Several
from sgb_core.fields.record import Record, check, says, table_of
from sgb_core.findings.refusal import RefusalError, SameAngle
from sgb_core.surfaces.laws.shape import LawShape
from sgb_core.surfaces.laws.shapes import SHAPES
from sgb_core.values import dataclass

LawParameter = Literal["lambda1", "lambda2", "lambda3", "omega", "radius"]
RADIUS: Literal["radius"] = "radius"
# The radius is multiplied by a law's value; more than a hundredfold says nothing.
LAW_RANGES: Mapping[LawParameter, Range] = MappingProxyType(
    {**{name: parameter_range(name) for name in PARAMETER_RANGES}, RADIUS: Range(0.0, 100.0)}
)
# What people read for a parameter that a law varies.
LAW_SYMBOLS: Mapping[LawParameter, str] = MappingProxyType(
    {**{name: SYMBOLS[name] for name in PARAMETER_RANGES}, RADIUS: "Radius"}
)

# As many waves as the finest mesh, of 20 million triangles, shows well: with the 64 rows that a
# shape at least needs it has 156 000 columns, of which a wave takes 150.
MAX_WAVES = 1_000
_COUNT = Range(1, MAX_WAVES, whole=True)
MAX_KEYFRAMES = 500
# Keys nearer than this many degrees are at one angle: a curve between them would only jump.
CLOSEST_KEYS = 1e-9
# Narrower flanks than this many degrees no mesh shows.
_FLANK = Range(0.001, 180.0)
_POSITIVE = Said("values whose factor of the radius stays above 0 at every angle")
_KEYS = Several(Fixed((FINITE, SHARE), "a pair [degrees, f]"), "pairs [degrees, f]", MAX_KEYFRAMES)
# How many times its departure a law may be at some height; below 0 it is reversed.
STRENGTHS = Range(-10.0, 10.0)
MAX_STRENGTHS = 100
# Keys nearer than this part of the height are at one height.
CLOSEST_STRENGTHS = 1e-6
_ALONG = Several(Fixed((SHARE, STRENGTHS), "a pair [u, k]"), "pairs [u, k]", MAX_STRENGTHS)
_APART = Said(f"keys that are at least {CLOSEST_STRENGTHS:g} of the height apart")
_OF_RADIUS = Said("no such keys but in a law of the radius")


def _rules() -> Schema:
    """Return what lies between the fields: limits by the parameter, what a shape requires."""
    rules: list[Schema] = []
    for name, allowed in LAW_RANGES.items():
        limits = allowed.schema({})
        ends = {"properties": {"from": limits, "to": limits}}
        rules.append({"if": {"properties": {"parameter": {"const": name}}}, "then": ends})
    table = table_of(Law)
    for shape in SHAPES.values():
        if shape.least_count > 1:
            count = table.row("count").key
            fewest = {"required": [count], "properties": {count: {"minimum": shape.least_count}}}
            rules.append({"if": {"properties": {"law": {"const": shape.name}}}, "then": fewest})
        keys = [table.row(name).key for name in shape.requires]
        if keys:
            least: Schema = {key: {"minItems": 1} for key in keys}
            rules.append(
                {
                    "if": {"properties": {"law": {"const": shape.name}}},
                    "then": {"required": keys, "properties": least},
                }
            )
    return {"allOf": rules}


@dataclass(frozen=True, slots=True)
class Law:
    """One shape parameter of some segments, or the radius, as a function of the angle.

    The value is start + (end − start)·f(θ), θ from the start angle; ``kind`` names the shape of
    f. ``segments`` is None for all of them. Of the radius it is a factor, above 0 at every angle.
    ``count`` is the n of a shape that repeats itself, ``keyframes`` holds (degrees, f) pairs, f in
    [0, 1]; ``sharp``, ``round`` and ``flank`` (degrees) are as the shapes that use them say.
    ``along`` holds (u, k) pairs: a factor of the radius is 1 + k(u)·(value − 1), u the share of
    the height; without any k is 1.

    Raises RefusalError, a ValueError, for a value that is not allowed.
    """

    RECORD = Record(
        "law",
        "A shape parameter, or a factor of the radius, as from + (to − from)·f(θ), θ counted from "
        "start_deg.",
        first=("segments",),
        rules=_rules,
    )

    parameter: LawParameter = field(metadata=says(Choice(LAW_RANGES)))
    kind: str = field(metadata=says(Choice(SHAPES), key="law", label="Law"))
    start: float = field(default=0.0, metadata=says(FINITE, key="from", label="From"))
    end: float = field(default=1.0, metadata=says(FINITE, key="to", label="To"))
    segments: tuple[int, ...] | None = field(
        default=None,
        metadata=says(
            OrNone(
                Several(Range(0, MAX_SEGMENTS - 1, whole=True), "segment numbers", MAX_SEGMENTS),
                "all",
            )
        ),
    )
    count: int = field(
        default=1,
        metadata=says(
            _COUNT,
            key="n",
            label="Waves",
            tip="How many waves there are around the turn",
            brief=True,
        ),
    )
    sharp: float = field(
        default=0.0,
        metadata=says(
            SHARE,
            label="Sharpness",
            tip="0: an even wave; 1: a ridge between round hollows",
            brief=True,
        ),
    )
    round: float = field(
        default=0.0,
        metadata=says(
            SHARE,
            label="Rounding",
            tip="The radius of the corners as a part of the radius of the circle about them",
            brief=True,
        ),
    )
    flank: float = field(
        default=5.0,
        metadata=says(
            _FLANK,
            label="Flank",
            tip="How many degrees a steep flank is wide, at most half a wave",
            brief=True,
        ),
    )
    keyframes: tuple[tuple[float, float], ...] = field(
        default=(),
        metadata=says(
            _KEYS,
            label="Keys",
            tip="Pairs [degrees, f] of a periodic curve, f from 0 to 1.",
            brief=True,
        ),
    )
    along: tuple[tuple[float, float], ...] = field(
        default=(),
        metadata=says(
            _ALONG,
            label="Along the height",
            tip="Pairs [u, k], u from 0 at the lowest to 1 at the highest height: the departure of "
            "the radius is k times as large there. Without any it is the same at every height.",
            brief=True,
        ),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        allowed = LAW_RANGES[self.parameter]
        allowed.take(self.start, ("law", "from"))
        allowed.take(self.end, ("law", "to"))
        if self.count < self.shape.least_count:
            raise replace(_COUNT, low=self.shape.least_count).refusal(self.count, ("law", "n"))
        if "keyframes" in self.shape.requires and not self.keyframes:
            raise replace(_KEYS, least=1).refusal(self.keyframes, ("law", "keyframes"))
        _check_angles(self.keyframes)
        if self.parameter == RADIUS and min(self.reach) <= 0.0:
            worse = "from" if self.start < self.end else "to"
            raise _POSITIVE.refusal(min(self.start, self.end), ("law", worse))
        self._check_along()

    def _check_along(self) -> None:
        """Refuse strengths of what is no radius, at one height, and those that leave no radius."""
        if not self.along:
            return
        if self.parameter != RADIUS:
            raise _OF_RADIUS.refusal(self.along, ("law", "along"))
        heights = sorted(u for u, _ in self.along)
        if any(after - before < CLOSEST_STRENGTHS for before, after in pairwise(heights)):
            raise _APART.refusal(self.along, ("law", "along"))
        if min(self._factors) <= 0.0:
            raise _POSITIVE.refusal(self.along, ("law", "along"))

    @property
    def shape(self) -> LawShape:
        """The shape of f."""
        return SHAPES[self.kind]

    def fraction(self, theta: ArrayLike) -> Floats:
        """Return f(θ) in [0, 1], θ in radians from the start angle; period 2π."""
        return self.shape.fraction(self, np.asarray(theta, dtype=np.float64))

    def fraction_rate(self, theta: ArrayLike, side: ArrayLike = 1) -> Floats:
        """Return df/dθ per radian; ``side`` (+1 or −1) picks the one at creases."""
        return self.shape.rate(self, np.asarray(theta, dtype=np.float64), np.asarray(side))

    @property
    def reach(self) -> tuple[float, float]:
        """The values where f is least and greatest."""
        low, high = (self.start + (self.end - self.start) * f for f in self.shape.span(self))
        return low, high

    @property
    def steady(self) -> float | None:
        """The strength where it is the same at every height, else None."""
        strengths = {k for _, k in self.along} or {1.0}
        return strengths.pop() if len(strengths) == 1 else None

    @property
    def _factors(self) -> list[float]:
        """The factors of the radius where strength and value are extreme."""
        strengths = [k for _, k in self.along] or [1.0]
        return [1.0 + k * (value - 1.0) for k in strengths for value in self.reach]

    @property
    def widest(self) -> float:
        """The largest factor of the radius at any angle and height."""
        return max(self._factors)

    @property
    def breaks(self) -> tuple[float, ...]:
        """The angles in [0, 2π) where f is not smooth, in radians."""
        return self.shape.breaks(self)

    @property
    def creases(self) -> tuple[float, ...]:
        """The angles in [0, 2π) where df/dθ jumps, in radians."""
        return self.shape.creases(self)

    @property
    def waves(self) -> int:
        """How often f repeats itself in a turn, mirrored about its extremes; 0: it does not."""
        return self.shape.waves(self)

    def applies_to(self, segment: int) -> bool:
        """Whether the law governs this segment."""
        return self.segments is None or segment in self.segments


def _check_angles(keys: tuple[tuple[float, float], ...]) -> None:
    """Refuse two keys at one angle, 0 and 360 being one, unless they say the same."""
    values: dict[float, float] = {}
    for turn, fraction in keys:
        if values.setdefault(turn % 360.0, fraction) != fraction:
            raise RefusalError(SameAngle(("law", "keyframes"), turn))
    turns = sorted(values)
    for before, after in pairwise([*turns, turns[0] + 360.0] if len(turns) > 1 else []):
        if after - before < CLOSEST_KEYS:
            raise RefusalError(SameAngle(("law", "keyframes"), before))
