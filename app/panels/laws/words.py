"""Laws over the angle in plain words: their kinds, what they leave behind, what they lack."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from app.widgets.quantity import format_number
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import SYMBOLS, ParameterName, Segment
from sgb_core.document.model import Document
from sgb_core.surfaces.variation import Law, LawKind

KINDS: Mapping[LawKind, str] = MappingProxyType(
    {
        LawKind.RAISED_COSINE: "Raised cosine",
        LawKind.COSINE: "Cosine, n waves",
        LawKind.PAPER: "Paper’s law",
        LawKind.KEYFRAMES: "Keyframes",
    }
)
TIPS: Mapping[LawKind, str] = MappingProxyType(
    {
        LawKind.RAISED_COSINE: "Swells once around the turn, smooth everywhere",
        LawKind.COSINE: "n even waves around the turn, smooth everywhere: flutes and lobes",
        LawKind.PAPER: (
            "The law of the paper: even steps of its rational parameter t.\n"
            "It leaves a crease on two meridians, at the start and opposite"
        ),
        LawKind.KEYFRAMES: "A curve of your own through keys that you drag",
    }
)
CONSTANT = "Constant"
CONSTANT_TIP = "No law: the same at every angle, as the slider in Shape says"

# How many waves a new law has.
WAVES = 5


def row_text(law: Law) -> str:
    """Return a law as one line: "λ2 · all · raised cosine · 1 → 5"."""
    kind = KINDS[law.kind].lower()
    if law.kind is LawKind.COSINE:
        kind = f"{law.count} waves" if law.count > 1 else "1 wave"
    ends = f"{format_number(law.start, 2)} → {format_number(law.end, 2)}"
    return f"{SYMBOLS[law.parameter]} · {segments_text(law)} · {kind} · {ends}"


def segments_text(law: Law) -> str:
    """Return which segments a law governs, counted from 1 as the window does."""
    if law.segments is None:
        return "all segments"
    if len(law.segments) == 1:
        return f"segment {law.segments[0] + 1}"
    if not law.segments:
        return "no segment"
    return "segments " + ", ".join(str(k + 1) for k in law.segments)


def default_law(document: Document, kind: LawKind, segments: tuple[int, ...] | None) -> Law:
    """Return a law whose effect can be seen: ω where a λ is not neutral, else λ2."""
    profile = document.profile
    chosen = [s for k, s in enumerate(profile.segments) if segments is None or k in segments]
    parameter: ParameterName = "omega" if any(_is_shaped(s) for s in chosen) else "lambda2"
    start, end = (0.0, 1.0) if parameter == "omega" else (1.0, 5.0)
    keys = ((0.0, 0.0), (120.0, 1.0), (240.0, 0.5)) if kind is LawKind.KEYFRAMES else ()
    count = WAVES if kind is LawKind.COSINE else 1
    return Law(parameter, kind, start, end, segments, count, keys)


def advice(document: Document, index: int) -> tuple[str, ParameterName | None]:
    """Return what to know about a law, and the parameter that must not be 0 for it to show."""
    laws, profile = document.variation, document.profile
    law = laws[index]
    governed = [k for k in range(len(profile)) if law.applies_to(k)]
    if not governed:
        return "Choose a segment: this law governs none.", None
    later = laws[index + 1 :]
    if all(_governs(later, k, law.parameter) for k in governed):
        return "Not used: a later law sets the same parameter of the same segments.", None
    if _is_idle(profile, laws, governed, law.parameter):
        if law.parameter == "omega":
            return "ω shows nothing while λ = 1, 3, 1: change a λ in Shape.", None
        return f"{SYMBOLS[law.parameter]} shows nothing while ω = 0.", "omega"
    if law.start == law.end:
        return "From and To are the same: the parameter does not vary.", None
    if law.kind is LawKind.PAPER:
        return (
            "The paper’s law leaves a crease on two meridians: at the start angle and "
            "opposite. The cosine laws are smooth.",
            None,
        )
    if law.kind is not LawKind.KEYFRAMES:
        return "Double-click the curve to shape it by keys of your own.", None
    return "Double-click adds a key, drag moves it, Del removes it.", None


def _governs(laws: Sequence[Law], segment: int, parameter: ParameterName) -> bool:
    return any(law.parameter == parameter and law.applies_to(segment) for law in laws)


def _is_idle(
    profile: Profile, laws: Sequence[Law], governed: Sequence[int], parameter: ParameterName
) -> bool:
    """Whether a parameter changes nothing in any of the segments it varies in."""
    for k in governed:
        segment = profile.segments[k]
        if parameter == "omega":
            others: tuple[ParameterName, ...] = ("lambda1", "lambda2", "lambda3")
            if _is_shaped(segment) or any(_governs(laws, k, name) for name in others):
                return False
        elif segment.shape.omega > 0.0 or _governs(laws, k, "omega"):
            return False
    return True


def _is_shaped(segment: Segment) -> bool:
    shape = segment.shape
    return (shape.lambda1, shape.lambda2, shape.lambda3) != (1.0, 3.0, 1.0)
