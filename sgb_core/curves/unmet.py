"""Why a joint is less than its rule asks for, in words."""

from __future__ import annotations

from collections import Counter

from sgb_core.curves.constraints import enforce
from sgb_core.curves.continuity import JointReport, measure_joint, measure_joints
from sgb_core.curves.profile import Profile


def unmet_reason(profile: Profile, joint: int, report: JointReport | None = None) -> str | None:
    """Return why the rule of a joint does not hold; None where it does.

    ``report`` is what was measured there, where that is known already. The reason is what stops
    the rule from being restored as the profile is now; where nothing does, choosing the rule
    again would restore it. Raises IndexError where the profile has no such joint.
    """
    truth = measure_joint(profile, joint) if report is None else report
    if truth.holds:
        return None
    start = f"joint {joint} is "
    for note in enforce(profile, joint).notes:
        if note.startswith(start):
            return note.partition(": ")[2]
    return "it can be restored, as things are now: choose the rule again"


def unmet_notes(profile: Profile, before: Profile) -> list[str]:
    """Return a line for each joint whose rule an edit of the profile ``before`` did not keep.

    A joint that fell as short of the same rule before the edit is not named again.
    """
    # Joints are renumbered by an edit, so they are recognised by what they are.
    known = Counter((r.rule, r.measured) for r in measure_joints(before) if not r.holds)
    notes = []
    for report in measure_joints(profile):
        same = report.rule, report.measured
        if report.holds:
            continue
        if known[same]:
            known[same] -= 1
            continue
        reason = unmet_reason(profile, report.joint, report)
        notes.append(f"joint {report.joint} is {report.measured}, not {report.rule}: {reason}")
    return notes
