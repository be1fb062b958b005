"""A joint in words: what it is measured to be, and the rules that can be kept at it."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from app.state.window_reader import WINDOW
from app.widgets.quantity import format_number
from sgb_core.curves.continuity import JointClass, JointReport
from sgb_core.curves.profile import JointRule

RULES: Mapping[JointRule, str] = MappingProxyType(
    {
        JointRule.FREE: "Free",
        JointRule.G0: "G0 joined",
        JointRule.G1: "G1 smooth",
        JointRule.C1: "C1 even",
        JointRule.G2: "G2 curvature",
    }
)
RULE_MEANINGS: Mapping[JointRule, str] = MappingProxyType(
    {
        JointRule.FREE: "Free: the ends may part",
        JointRule.G0: "G0: the ends stay together",
        JointRule.G1: "G1: no kink",
        JointRule.C1: "C1: equal speed",
        JointRule.G2: "G2: equal curvature",
    }
)

_CLASSES: Mapping[JointClass, str] = MappingProxyType(
    {
        JointClass.GAP: "a gap",
        JointClass.G0: "G0, joined with a kink",
        JointClass.G1: "G1, smooth",
        JointClass.C1: "C1, smooth with equal end derivatives",
        JointClass.G2: "G2, smooth with equal curvature",
    }
)


def chip_text(joint: JointReport) -> str:
    """Return the measured class, with the kink angle where there is one: "G0 12.3°"."""
    if joint.measured == JointClass.G0 and joint.kink_deg is not None:
        return f"G0 {_degrees(joint.kink_deg)}"
    return joint.measured.value


def chip_state(joint: JointReport) -> str:
    """Return "bad" where a rule is not met, "good" for a smooth joint, else "plain"."""
    if not joint.holds:
        return "bad"
    return "plain" if joint.measured in (JointClass.GAP, JointClass.G0) else "good"


def details(joint: JointReport, segment: int, following: int) -> str:
    """Return everything measured at the joint of two segments (counted from 0), in lines."""
    first, second = WINDOW.number(segment), WINDOW.number(following)
    lines = [
        f"Joint of segments {first} and {second}: {_CLASSES[joint.measured]}.",
        "Measured from the curve, whatever the rule.",
    ]
    if joint.measured == JointClass.GAP:
        lines.append(f"Gap {joint.gap:.3g}.")
    elif joint.measured == JointClass.G0 and joint.kink_deg is not None:
        lines.append(f"Kink {_degrees(joint.kink_deg)}.")
    else:
        if joint.speed_ratio is not None:
            lines.append(f"Speed ratio {joint.speed_ratio:.4g}.")
        if joint.curvature_jump is not None:
            lines.append(f"Curvature jump {joint.curvature_jump:.3g}.")
    if joint.degenerate:
        lines.append("An end derivative vanishes here: λ = 4 with ω = 1, or points coincide.")
    kept = "free, nothing is kept" if joint.rule == JointRule.FREE else RULES[joint.rule]
    lines.append(f"Rule while editing: {kept}.")
    if joint.rule == JointRule.G2:
        lines.append(
            "Kept exactly, by λ1 or λ3, then λ2, of the side that yields, then of the other, as "
            "far as they reach."
        )
    if not joint.holds:
        lines.append("The curve is less than the rule asks for.")
    return "\n".join(lines)


def _degrees(angle: float) -> str:
    return f"{format_number(angle, 1 if angle >= 0.05 else 6)}°"
