"""What is allowed in a document but doubtful: warnings, each a line of what, where and why."""

from __future__ import annotations

from collections.abc import Sequence

from sgb_core.curves.continuity import JointClass, JointReport, measure_joints
from sgb_core.curves.crossings import Crossing, Stretch, axis_crossings, self_intersections
from sgb_core.curves.head_to_tail import joined_head_to_tail
from sgb_core.document.model import Document
from sgb_core.document.turn_notices import turn_notices

# Of the places where a profile crosses itself so many are named, the rest counted.
MOST_NAMED = 16


def warnings(document: Document) -> list[str]:
    """Return what is doubtful about a document, one line each; nothing is changed.

    >>> legs = [sgb.line((20, 0), (20, 30)), sgb.line((20, 30), (50, 60))]
    >>> bent = sgb.Document(sgb.Profile.of(legs, ["G1"]))
    >>> len(sgb.check(bent)), len(sgb.check(sgb.edits.set_rule(bent, 0, "free")))
    (1, 0)
    """
    profile = document.profile
    return list(
        notices(
            document,
            measure_joints(profile),
            axis_crossings(profile),
            self_intersections(profile),
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
    lines += turn_notices(document)
    lines += [
        f"profile.segments[{crossing.segment_a}]: crosses segment {crossing.segment_b} "
        f"at r = {crossing.point[0]:.6g}, h = {crossing.point[1]:.6g}"
        for crossing in crossings[:MOST_NAMED]
    ]
    if len(crossings) > MOST_NAMED:
        lines.append(f"profile: crosses itself in {len(crossings) - MOST_NAMED} more places")
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
