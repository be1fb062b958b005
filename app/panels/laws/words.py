"""Laws over the angle in plain words: their kinds, what they leave behind, what they lack."""

from __future__ import annotations

from collections.abc import Sequence

from app.state.window_reader import WINDOW
from app.widgets.quantity import format_number
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import LAMBDAS, ParameterName, Segment
from sgb_core.document.model import Document
from sgb_core.surfaces.laws.law import LAW_SYMBOLS, RADIUS, Law, LawParameter
from sgb_core.surfaces.laws.shape import LawShape
from sgb_core.surfaces.laws.shapes import SHAPES

CONSTANT = "Constant"
CONSTANT_TIP = "No law: the same at every angle, as the slider in Shape says"


def offered() -> tuple[LawShape, ...]:
    """Return the shapes that a law may have, as lists offer them.

    Smooth ones first, then those that leave creases, last those that are drawn by hand.
    """

    def place(shape: LawShape) -> tuple[bool, bool]:
        return bool(shape.requires), not shape.is_smooth

    return tuple(sorted(SHAPES.values(), key=place))


def row_text(law: Law) -> str:
    """Return a law as one line: "λ2 · all · raised cosine · 1 → 5"."""
    kind = law.shape.words(law)
    ends = f"{format_number(law.start, 2)} → {format_number(law.end, 2)}"
    return f"{LAW_SYMBOLS[law.parameter]} · {segments_text(law)} · {kind} · {ends}"


def segments_text(law: Law) -> str:
    """Return which segments a law governs, counted from 1 as the window does."""
    if law.segments is None:
        return "all segments"
    if len(law.segments) == 1:
        return WINDOW.segment(law.segments[0])
    if not law.segments:
        return "no segment"
    return "segments " + ", ".join(str(WINDOW.number(k)) for k in law.segments)


def default_law(document: Document, shape: LawShape, segments: tuple[int, ...] | None) -> Law:
    """Return a law whose effect can be seen: ω where a λ is not neutral, else λ2.

    Shapes made for it vary the radius, of all segments: those of some would tear off.
    """
    if shape.of_radius:
        return Law(RADIUS, shape.name, *shape.natural, **shape.first)
    profile = document.profile
    chosen = [s for k, s in enumerate(profile.segments) if segments is None or k in segments]
    parameter: ParameterName = "omega" if any(_is_shaped(s) for s in chosen) else "lambda2"
    start, end = (0.0, 1.0) if parameter == "omega" else (1.0, 5.0)
    return Law(parameter, shape.name, start, end, segments, **shape.first)


def advice(document: Document, index: int) -> tuple[str, ParameterName | None]:
    """Return what to know about a law, and the parameter that must not be 0 for it to show."""
    laws, profile = document.variation, document.profile
    law = laws[index]
    governed = [k for k in range(len(profile)) if law.applies_to(k)]
    if not governed:
        return "Choose a segment: this law governs none.", None
    later = laws[index + 1 :]
    if law.parameter == RADIUS:
        if law.start == law.end == 1.0:
            return "From and To are 1: the radius is as drawn.", None
        return law.shape.advice, None
    if all(_governs(later, k, law.parameter) for k in governed):
        return "Not used: a later law sets the same parameter of the same segments.", None
    if _is_idle(profile, laws, governed, law.parameter):
        if law.parameter == "omega":
            return "ω shows nothing while λ = 1, 3, 1: change a λ in Shape.", None
        return f"{LAW_SYMBOLS[law.parameter]} shows nothing while ω = 0.", "omega"
    if law.start == law.end:
        return "From and To are the same: the parameter does not vary.", None
    return law.shape.advice, None


def _governs(laws: Sequence[Law], segment: int, parameter: LawParameter) -> bool:
    return any(law.parameter == parameter and law.applies_to(segment) for law in laws)


def _is_idle(
    profile: Profile, laws: Sequence[Law], governed: Sequence[int], parameter: ParameterName
) -> bool:
    """Whether a parameter changes nothing in any of the segments it varies in."""
    for k in governed:
        segment = profile.segments[k]
        if parameter == "omega":
            if _is_shaped(segment) or any(_governs(laws, k, name) for name in LAMBDAS):
                return False
        elif segment.shape.omega > 0.0 or _governs(laws, k, "omega"):
            return False
    return True


def _is_shaped(segment: Segment) -> bool:
    return not segment.shape.is_neutral
