"""What ``measure`` and ``check`` say: contract.md's measures, as values and as tables."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import isfinite
from typing import Any

from app.cli.body_report import body_measures, body_rows
from sgb_core.curves.nearest import arc_length
from sgb_core.document.evaluation import Evaluation
from sgb_core.document.model import Document, Unit
from sgb_core.surfaces import measures as of
from sgb_core.surfaces.variation import Law

Measures = dict[str, Any]


def measures(evaluation: Evaluation) -> Measures:
    """Return the object that ``measure --json`` prints, keys as in contract.md, no NaN."""
    document, surface = evaluation.document, evaluation.surface
    centroid = of.centroid(surface)
    lower, upper = of.bounds(surface)
    section = surface.profile_at(surface.start)
    of_body, body_warnings = body_measures(document)
    return {
        "name": document.name,
        "unit": document.unit.value,
        "volume": _finite(of.volume(surface)),
        "area": _finite(of.area(surface)),
        "centroid": None if centroid is None else [_finite(value) for value in centroid],
        "bounds": [[_finite(value) for value in corner] for corner in (lower, upper)],
        "generatrix_length": _finite(of.generatrix_length(section)),
        "bending_energy": _finite(of.bending_energy(section)),
        "surface_bending_energy": _finite(of.surface_bending_energy(surface)),
        **{key: _finite(value) for key, value in of_body.items()},
        "segments": [
            {
                "leg_fractions": list(segment.shape.leg_fractions),
                "length": _finite(arc_length(segment)),
            }
            for segment in section.segments
        ],
        "joints": [
            {
                "rule": joint.rule.value,
                "measured": joint.measured.value,
                "kink_deg": _finite(joint.kink_deg),
                "speed_ratio": _finite(joint.speed_ratio),
                "curvature_jump": _finite(joint.curvature_jump),
            }
            for joint in evaluation.joints
        ],
        "warnings": [*evaluation.warnings, *body_warnings],
    }


def table(measured: Measures) -> str:
    """Return measures as text for people: aligned, with units."""
    unit = measured["unit"]
    lower, upper = measured["bounds"]
    millilitres = measured["volume"] * Unit(unit).millimetres ** 3 / 1000.0
    extent = [high - low for low, high in zip(lower, upper, strict=True)]
    lines = _aligned(
        [
            ("name", measured["name"]),
            ("volume", f"{_number(measured['volume'])} {unit}³ = {_number(millilitres)} ml"),
            ("area", f"{_number(measured['area'])} {unit}²"),
            ("centroid", _point(measured["centroid"], unit)),
            ("bounds", f"{_point(lower, unit)} to {_point(upper, unit)}"),
            ("extent", " × ".join(_number(value) for value in extent) + f" {unit}"),
            ("generatrix length", f"{_number(measured['generatrix_length'])} {unit}"),
            ("bending energy", _energy(measured["bending_energy"], unit)),
            *body_rows(measured, _number),
        ],
        separator="   ",
    )
    rows = [("segment", f"length ({unit})", "a", "b", "c")]
    rows += [
        (str(index), _number(segment["length"]), *map(_number, segment["leg_fractions"]))
        for index, segment in enumerate(measured["segments"])
    ]
    lines += ["", *_aligned(rows)]
    if measured["joints"]:
        joints = [("joint", "rule", "measured", "kink (°)", "speed ratio", f"κ jump (1/{unit})")]
        joints += [
            (
                str(index),
                joint["rule"],
                joint["measured"],
                *(_number(joint[key]) for key in ("kink_deg", "speed_ratio", "curvature_jump")),
            )
            for index, joint in enumerate(measured["joints"])
        ]
        lines += ["", *_aligned(joints)]
    return "\n".join([*lines, *_warning_lines(measured["warnings"])])


def contents(evaluation: Evaluation) -> str:
    """Return what a document holds, for people."""
    document = evaluation.document
    profile, turn = document.profile, document.revolution
    facts = [
        ("name", document.name),
        ("unit", document.unit.value),
        ("profile", f"{_count(len(profile), 'segment')}, {'a ring' if profile.closed else 'open'}"),
        ("size", f"{_number(profile.size)} {document.unit.value}"),
        ("axis", turn.axis.value),
        ("sweep", f"{_number(turn.sweep_deg)}° from {_number(turn.start_deg)}°"),
        ("body", document.solid.kind.value),
    ]
    facts += [
        (f"joint {joint.joint}", f"rule {joint.rule.value}, measured {joint.measured.value}")
        for joint in evaluation.joints
    ]
    facts += [("law", _law(law)) for law in document.variation]
    if not document.placement.is_identity:
        facts.append(("placement", _placement(document)))
    lines = _aligned(facts, separator="   ")
    warnings = [*evaluation.warnings, *body_measures(document)[1]]
    return "\n".join([*lines, *_warning_lines(warnings)])


def _law(law: Law) -> str:
    numbers = law.segments
    where = "all segments"
    if numbers is not None:
        where = f"segment{'s' * (len(numbers) != 1)} {', '.join(map(str, numbers))}"
    span = f"from {_number(law.start)} to {_number(law.end)}"
    return f"{law.parameter} of {where}: {law.kind}, {span}"


def _placement(document: Document) -> str:
    turns = ", ".join(f"{_number(value)}°" for value in document.placement.rotation_deg)
    return f"turned ({turns}), moved {_point(document.placement.translation, document.unit.value)}"


def _warning_lines(warnings: Iterable[str]) -> list[str]:
    lines = [f"warning: {warning}" for warning in warnings]
    return ["", *lines] if lines else []


def _energy(value: float | None, unit: str) -> str:
    return "infinite: an end derivative vanishes" if value is None else f"{_number(value)} 1/{unit}"


def _point(values: Sequence[float] | None, unit: str) -> str:
    if values is None:
        return "none: there is no volume"
    return f"({', '.join(_number(value) for value in values)}) {unit}"


def _number(value: float | None) -> str:
    """Return eight significant digits without trailing zeros, or a dash."""
    if value is None:
        return "–"
    # Adding 0 turns −0 into 0.
    return f"{value + 0.0:.8g}"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _finite(value: float | None) -> float | None:
    # Adding 0.0 makes −0.0 a plain 0.
    return float(value) + 0.0 if value is not None and isfinite(value) else None


def _aligned(rows: Sequence[Sequence[str]], separator: str = "  ") -> list[str]:
    """Return rows as lines whose columns line up on the left."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        separator.join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]
