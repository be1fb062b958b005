"""What ``measure`` and ``check`` say, as tables for people."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from app.cli.body_report import body_rows
from sgb_core.document.dimensions import dimension_fact, measured_dimensions, missed_locks
from sgb_core.document.evaluation import Evaluation
from sgb_core.document.export_doubts import export_doubts
from sgb_core.document.measures import Measures, body_measured
from sgb_core.document.model import Document, Unit
from sgb_core.findings.words import say
from sgb_core.surfaces.variation import Law


def table(measured: Measures) -> str:
    """Return measures as text for people: aligned, with units."""
    unit = measured["unit"]
    lower, upper = measured["bounds"]
    millilitres = measured["volume"] * Unit(unit).millilitres
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
    rows: list[tuple[str, ...]] = [("segment", f"length ({unit})", "a", "b", "c")]
    rows += [
        (str(index), _number(segment["length"]), *map(_number, segment["leg_fractions"]))
        for index, segment in enumerate(measured["segments"])
    ]
    lines += ["", *_aligned(rows)]
    if measured["joints"]:
        joints: list[tuple[str, ...]] = [
            ("joint", "rule", "measured", "kink (°)", "speed ratio", f"κ jump (1/{unit})")
        ]
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
    if document.twist.turns:
        facts.append(("twist", f"{_number(document.twist.turns)} turns, {document.twist.ease}"))
    facts += [
        ("lock" if each.locked else "dimension", say(dimension_fact(document, each, value)))
        for each, value in measured_dimensions(document)
    ]
    if not document.placement.is_identity:
        facts.append(("placement", _placement(document)))
    lines = _aligned(facts, separator="   ")
    warnings = [
        say(each)
        for each in (
            *evaluation.findings,
            *body_measured(document)[1],
            *export_doubts(document),
            *missed_locks(document),
        )
    ]
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


def _aligned(rows: Sequence[Sequence[str]], separator: str = "  ") -> list[str]:
    """Return rows as lines whose columns line up on the left."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        separator.join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]
