"""Profiles and segments as they stand in a project file, where a table alone cannot say it.

A segment has λ1, λ2, λ3 in one list and its held ends in another; an empty list of joints is no
default but says that there are none.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum
from typing import Any

import numpy as np

from sgb_core.curves.profile import Profile, rule_for_each_joint
from sgb_core.curves.segment import (
    NEUTRAL,
    POINTS,
    SEGMENT_KEYS,
    ParameterName,
    Segment,
    ShapeParameters,
    parameter_range,
)
from sgb_core.fields.extra import NO_EXTRA, Extra
from sgb_core.fields.kinds import Choice, Said, Schema
from sgb_core.fields.lists import Fixed, Several
from sgb_core.fields.record import Codec, Table, register
from sgb_core.findings.finding import Path
from sgb_core.findings.refusal import MISSING

LAMBDAS: tuple[ParameterName, ...] = ("lambda1", "lambda2", "lambda3")


class SegmentEnd(StrEnum):
    """The ends of a segment by their names in ``holds``."""

    START = "start"
    END = "end"


_LAMBDA = Fixed(
    tuple(parameter_range(name) for name in LAMBDAS), "a list of 3 numbers [λ1, λ2, λ3]"
)
_OMEGA = parameter_range("omega")
_HOLDS = Several(Choice(SegmentEnd), 'of "start" and "end"', 2)


class _Segments(Codec):
    """The codec of segments."""

    def from_plain(self, plain: object, path: Path) -> Segment:
        if not isinstance(plain, Mapping):
            raise Said('an object {"points": [...]}').refusal(plain, path)
        points = POINTS.take(plain.get("points", MISSING), (*path, "points"))
        shape = NEUTRAL
        if "lambda" in plain or "omega" in plain:
            lambdas = plain.get("lambda", _lambdas(NEUTRAL))
            lambda1, lambda2, lambda3 = _LAMBDA.take(lambdas, (*path, "lambda"))
            omega = _OMEGA.take(plain.get("omega", NEUTRAL.omega), (*path, "omega"))
            shape = ShapeParameters(lambda1, lambda2, lambda3, omega)
        holds = _HOLDS.take(plain.get("holds", ()), (*path, "holds"))
        rest = {key: value for key, value in plain.items() if key not in SEGMENT_KEYS}
        return Segment(
            np.array(points),
            shape,
            Extra(rest) if rest else NO_EXTRA,
            holds_start=SegmentEnd.START in holds,
            holds_end=SegmentEnd.END in holds,
        )

    def to_plain(self, value: Any) -> dict[str, object]:
        ends = {SegmentEnd.START: value.holds_start, SegmentEnd.END: value.holds_end}
        held = [str(end) for end, holds in ends.items() if holds]
        return {
            "points": value.points.tolist(),
            "lambda": list(_lambdas(value.shape)),
            "omega": value.shape.omega,
            **({"holds": held} if held else {}),
            **value.extra,
        }

    def schema(self, shared: Schema) -> Schema:
        told = {
            "points": (
                POINTS,
                "Four control points [r, h]: signed distance from the axis, height along it.",
            ),
            "lambda": (_LAMBDA, "The local shape parameters λ1, λ2, λ3."),
            "omega": (_OMEGA, "The global shape parameter ω."),
            "holds": (
                _HOLDS,
                "The ends that do not yield to the rule of their joint where the other side can.",
            ),
        }
        defaults = {"lambda": list(_lambdas(NEUTRAL)), "omega": NEUTRAL.omega, "holds": []}
        return {
            "type": "object",
            "required": ["points"],
            "properties": {
                key: {
                    **kind.schema(shared),
                    "description": words,
                    **({"default": defaults[key]} if key in defaults else {}),
                }
                for key, (kind, words) in told.items()
            },
        }


def _lambdas(shape: ShapeParameters) -> tuple[float, ...]:
    return shape.lambda1, shape.lambda2, shape.lambda3


class _Profiles(Table):
    """The codec of profiles."""

    def made(self, plain: Mapping[str, object], path: Path, **more: object) -> Profile:
        profile: Profile = super().made(plain, path, **more)
        if plain.get("joints") == [] and profile.rules:
            allowed = rule_for_each_joint(len(profile), profile.closed)
            raise allowed.refusal([], (*path, "joints"))
        return profile


register(Segment, _Segments())
register(Profile, _Profiles(Profile))
