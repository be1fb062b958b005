"""What is allowed in a document but doubtful: warnings, each a line of what, where and why."""

from __future__ import annotations

from collections.abc import Sequence

from sgb_core.curves.continuity import JointClass, JointReport, measure_joints
from sgb_core.curves.crossings import Crossing, Stretch, axis_crossings, self_intersections
from sgb_core.curves.profile import Profile
from sgb_core.document.head_to_tail import joined_head_to_tail
from sgb_core.document.model import Document

# Comparing all pieces of the curve with all others takes seconds in longer chains.
MOST_COMPARED = 100


def self_crossings(profile: Profile) -> tuple[Crossing, ...]:
    """Return where a profile of at most MOST_COMPARED segments crosses itself."""
    return self_intersections(profile) if len(profile) <= MOST_COMPARED else ()


def warnings(document: Document) -> list[str]:
    """Return what is doubtful about a document, one line each; nothing is changed."""
    profile = document.profile
    return list(
        notices(
            document,
            measure_joints(profile),
            axis_crossings(profile),
            self_crossings(profile),
        )
    )


def notices(
    document: Document,
    joints: Sequence[JointReport],
    beyond_axis: Sequence[Stretch],
    crossings: Sequence[Crossing],
) -> tuple[str, ...]:
    """Return the warnings of a document whose profile has been examined already."""
    lines = [line for report in joints for line in joint_notices(report)]
    if any(r.measured is JointClass.GAP for r in joints) and joined_head_to_tail(document.profile):
        lines.append(
            "profile: parts of the chain run in opposite directions; "
            "put head to tail they meet end to end"
        )
    lines += [
        f"profile.segments[{stretch.segment}]: beyond the axis "
        f"from s = {stretch.s0:.4g} to {stretch.s1:.4g}"
        for stretch in beyond_axis
    ]
    lines += [
        f"profile.segments[{crossing.segment_a}]: crosses segment {crossing.segment_b} "
        f"at r = {crossing.point[0]:.6g}, h = {crossing.point[1]:.6g}"
        for crossing in crossings
    ]
    if len(document.profile) > MOST_COMPARED:
        lines.append(
            f"profile: more than {MOST_COMPARED} segments, so not examined for crossing itself"
        )
    return tuple(lines)


def joint_notices(report: JointReport) -> list[str]:
    """Return what is doubtful about one joint."""
    if report.measured is JointClass.GAP:
        return [f"profile.joints[{report.joint}]: the ends are {report.gap:.6g} apart"]
    if report.holds:
        return []
    kink = "" if report.kink_deg is None else f" (kink {report.kink_deg:.4g}°)"
    return [
        f"profile.joints[{report.joint}]: the rule is {report.rule}, "
        f"but the curve is only {report.measured} there{kink}"
    ]
