"""A law: one shape parameter of some segments as a function of the rotation angle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves.profile import MAX_SEGMENTS
from sgb_core.curves.segment import PARAMETER_RANGES, ParameterName, parameter_range
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import FINITE, SHARE, Choice, Range, Schema
from sgb_core.fields.lists import Fixed, OrNone, Several
from sgb_core.fields.record import Record, check, says, table_of
from sgb_core.findings.refusal import RefusalError, SameAngle
from sgb_core.surfaces.laws.shape import LawShape
from sgb_core.surfaces.laws.shapes import SHAPES

# As many waves as the finest mesh, of 20 million triangles, shows well: with the 64 rows that a
# shape at least needs it has 156 000 columns, of which a wave takes 150.
MAX_WAVES = 1_000
MAX_KEYFRAMES = 500
# Keys nearer than this many degrees are at one angle: a curve between them would only jump.
CLOSEST_KEYS = 1e-9
_KEYS = Several(Fixed((FINITE, SHARE), "a pair [degrees, f]"), "pairs [degrees, f]", MAX_KEYFRAMES)


def _rules() -> Schema:
    """Return what lies between the fields: limits by the parameter, what a shape requires."""
    rules: list[Schema] = []
    for name in PARAMETER_RANGES:
        limits = parameter_range(name).schema({})
        ends = {"properties": {"from": limits, "to": limits}}
        rules.append({"if": {"properties": {"parameter": {"const": name}}}, "then": ends})
    table = table_of(Law)
    for shape in SHAPES.values():
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
    """One shape parameter of some segments as a function of the angle.

    The value is start + (end − start)·f(θ), θ from the start angle; ``kind`` names the shape of
    f. ``segments`` is None for all of them. ``count`` is the n of the n-fold cosine and
    ``keyframes`` holds (degrees, f) pairs, f in [0, 1].

    Raises RefusalError, a ValueError, for a value that is not allowed.
    """

    RECORD = Record(
        "law",
        "A shape parameter as from + (to − from)·f(θ), θ counted from start_deg.",
        first=("segments",),
        rules=_rules,
    )

    parameter: ParameterName = field(metadata=says(Choice(PARAMETER_RANGES)))
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
            Range(1, MAX_WAVES, whole=True),
            key="n",
            label="Waves",
            tip="How many waves there are around the turn",
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
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        allowed = parameter_range(self.parameter)
        allowed.take(self.start, ("law", "from"))
        allowed.take(self.end, ("law", "to"))
        if "keyframes" in self.shape.requires and not self.keyframes:
            raise replace(_KEYS, least=1).refusal(self.keyframes, ("law", "keyframes"))
        _check_angles(self.keyframes)

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
