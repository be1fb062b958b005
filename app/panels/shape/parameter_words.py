"""What a shape parameter does to a segment, in plain words.

Each parameter slides a quartic point along a leg of the control polygon, so the direction in
which the curve goes follows from the polygon itself: dL/dλ1 is along P0 − P1, dL/dλ2 along
P1 − P2, dL/dλ3 along P3 − P2, and dL/dω their sum, weighted by how far each λ is from neutral.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

import numpy as np

from app.state.window_reader import WINDOW
from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import (
    DEGENERATE_LEG,
    LAMBDAS,
    PARAMETER_RANGES,
    SYMBOLS,
    ParameterName,
    Segment,
    ShapeParameters,
    neutral,
)
from sgb_core.surfaces.influence import quartic_rates
from sgb_core.surfaces.variation import Law

# A component smaller than this part of the other is not worth a word.
_MINOR = 0.4


def direction(vector: Sequence[float] | Floats) -> str:
    """Return where a vector (r, h) points: "outwards", "inwards and up", ..., "" for none."""
    r, h = float(vector[0]), float(vector[1])
    largest = max(abs(r), abs(h))
    if largest == 0.0:
        return ""
    words = []
    if abs(r) > _MINOR * largest:
        words.append("outwards" if r > 0 else "inwards")
    if abs(h) > _MINOR * largest:
        words.append("up" if h > 0 else "down")
    return " and ".join(words)


def end_name(segment: Segment, at_start: bool) -> str:
    """Return "lower end", "upper end", ... of a segment, by where its end points lie."""
    dr, dh = segment.points[3] - segment.points[0]
    sign = 1.0 if at_start else -1.0
    if abs(dh) >= abs(dr) and dh != 0.0:
        return "lower end" if sign * dh > 0 else "upper end"
    if dr != 0.0:
        return "inner end" if sign * dr > 0 else "outer end"
    return "start" if at_start else "end"


def effect(segment: Segment, parameter: ParameterName) -> Floats:
    """Return how the segment's middle moves per unit of a parameter, dL/dp at s = ½, (r, h)."""
    moved = quartic_rates(Profile((segment,)), parameter)[0]
    # The Bernstein polynomials of degree 4 at ½ that Q1, Q2 and Q3 count by.
    return np.asarray(np.array([0.25, 0.375, 0.25]) @ moved)


def without_effect(segment: Segment, parameter: ParameterName) -> str:
    """Return why moving a parameter changes nothing now, "" where it does change the shape."""
    shape = segment.shape
    if parameter == "omega":
        if shape.is_neutral:
            return "ω has no effect while λ = 1, 3, 1"
        return ""
    first = {"lambda1": 0, "lambda2": 1, "lambda3": 2}[parameter]
    leg = segment.points[first + 1] - segment.points[first]
    if hypot(leg[0], leg[1]) <= DEGENERATE_LEG * segment.size:
        return f"{SYMBOLS[parameter]} has no effect: P{first} and P{first + 1} coincide"
    if shape.omega == 0.0:
        return f"{SYMBOLS[parameter]} has no effect while ω = 0"
    return ""


def hint(segment: Segment) -> str:
    """Return the line shown in a card where some of its sliders do nothing, else ""."""
    shape = segment.shape
    if shape.omega == 0.0 and without_effect(segment, "omega"):
        return "Plain cubic: λ has no effect while ω = 0."
    if shape.omega == 0.0:
        return "λ has no effect while ω = 0."
    return without_effect(segment, "omega") and "ω has no effect while λ = 1, 3, 1."


def tooltip(segment: Segment, number: int, parameter: ParameterName) -> str:
    """Return what moving a parameter of segment ``number`` (from 0) does to the shape."""
    lines = [f"{_heading(segment, parameter)} of {WINDOW.segment(number)} ({SYMBOLS[parameter]})"]
    p0, p1, p2, p3 = segment.points
    if parameter == "lambda1":
        lines.append(_less("Q1", "P1’s circle (✱)", p1 - p0))
        lines.append("More: it slides back to the end point P0.")
    elif parameter == "lambda2":
        lines.append(_more("Q2", "P1’s circle (✱)", p1 - p2))
        lines.append("Less: it slides to P2’s circle (○) instead.")
    elif parameter == "lambda3":
        lines.append(_less("Q3", "P2’s circle (○)", p2 - p3))
        lines.append("More: it slides back to the end point P3.")
    else:
        lines.append(_omega_line(segment))
        lines.append("0 is the plain cubic curve, 1 the full effect of the three λ.")
    reason = without_effect(segment, parameter)
    if reason:
        lines.append(reason + ".")
    low, high = PARAMETER_RANGES[parameter]
    lines.append(
        f"{low:g} to {high:g}, neutral {neutral(parameter):g} · double-click the label to reset"
    )
    return "\n".join(lines)


def law_note(laws: Sequence[Law], number: int, parameter: ParameterName) -> str:
    """Return a line where a law makes the parameter vary with the angle, else ""."""
    for law in reversed(laws):
        if law.parameter == parameter and (law.segments is None or number in law.segments):
            return (
                f"Varies with the angle from {law.start:g} to {law.end:g} ({law.kind}); "
                "the slider’s own value is not used."
            )
    return ""


def _heading(segment: Segment, parameter: ParameterName) -> str:
    if parameter == "lambda1":
        return f"Fullness at the {end_name(segment, True)}"
    if parameter == "lambda3":
        return f"Fullness at the {end_name(segment, False)}"
    return "Belly" if parameter == "lambda2" else "Strength of all three λ"


def _less(point: str, circle: str, towards: Floats) -> str:
    return f"Less: {point} slides towards {circle}{_going(towards)}."


def _more(point: str, circle: str, towards: Floats) -> str:
    return f"More: {point} slides towards {circle}{_going(towards)}."


def _going(vector: Floats) -> str:
    words = direction(vector)
    return f", {words}" if words else ""


def _omega_line(segment: Segment) -> str:
    """Return where each quartic point goes with ω, and which of the paper's cases that is."""
    shape = segment.shape
    values = [(k, getattr(shape, name), neutral(name)) for k, name in enumerate(LAMBDAS, start=1)]
    slides = [
        f"Q{number} to {_GOALS[number][value > still]}"
        for number, value, still in values
        if value != still
    ]
    if not slides:
        return "More: the three λ count for more."
    words = direction(effect(segment, "omega"))
    middle = f"; the middle moves {words}" if words else ""
    return f"{_omega_case(shape)}. More: {', '.join(slides)}{middle}."


# Where a quartic point slides to with ω: with its λ below the neutral value, and above it.
_GOALS = {1: ("P1", "P0"), 2: ("P2", "P1"), 3: ("P2", "P3")}


def _omega_case(shape: ShapeParameters) -> str:
    above = [value > 1.0 for value in (shape.lambda1, shape.lambda3)]
    neutral_ends = [value == 1.0 for value in (shape.lambda1, shape.lambda3)]
    if all(neutral_ends):
        return "λ1 and λ3 neutral"
    if any(neutral_ends):
        return f"{'λ3' if neutral_ends[0] else 'λ1'} alone off neutral"
    if all(above):
        return "λ1 and λ3 above 1: away from the corners P1 and P2"
    return (
        "One of λ1 and λ3 above 1, one below"
        if any(above)
        else ("λ1 and λ3 below 1: into the corners P1 and P2")
    )
