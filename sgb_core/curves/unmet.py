"""Which joints are less than their rules ask for, and why."""

from __future__ import annotations

from collections import Counter

from sgb_core.curves.constraints import keep_rule
from sgb_core.curves.continuity import JointReport, measure_joint, measure_joints, unmet_rule
from sgb_core.curves.profile import Profile
from sgb_core.findings.joints import Hindrance, UnmetRule


def hindrance_at(
    profile: Profile, joint: int, report: JointReport | None = None
) -> Hindrance | None:
    """Return why the rule of a joint does not hold; None where it does.

    ``report`` is what was measured there, where that is known already. The hindrance is what stops
    the rule from being restored as the profile is now; where nothing does, choosing the rule
    again would restore it. Raises IndexError where the profile has no such joint.
    """
    truth = measure_joint(profile, joint) if report is None else report
    if truth.holds:
        return None
    found = (each.hindrance for each in keep_rule(profile, joint).unmet if each.joint == joint)
    return next(found, Hindrance.RESTORABLE)


def newly_unmet(profile: Profile, before: Profile) -> list[UnmetRule]:
    """Return the rules that an edit of the profile ``before`` did not keep, and why.

    A joint that fell as short of the same rule before the edit is not named again.
    """
    # Joints are renumbered by an edit, so they are recognised by what they are.
    known = Counter((r.rule, r.measured) for r in measure_joints(before) if not r.holds)
    found = []
    for report in measure_joints(profile):
        same = report.rule, report.measured
        if report.holds:
            continue
        if known[same]:
            known[same] -= 1
            continue
        found.append(unmet_rule(profile, report, hindrance_at(profile, report.joint, report)))
    return found
