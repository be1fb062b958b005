"""Why a joint is less than its rule asks for, in words."""

from __future__ import annotations

from sgb_core.curves.continuity import JointReport, measure_joint
from sgb_core.curves.moves import enforce
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
    return "nothing moved for it yet; choose the rule again to restore it"
