"""What is allowed in a document but doubtful: warnings, each a line of what, where and why."""

from __future__ import annotations

from sgb_core.curves.continuity import (
    EQUAL_DERIVATIVES,
    JointClass,
    JointReport,
    measure_joints,
)
from sgb_core.curves.profile import JointRule
from sgb_core.document.model import Document

# How much a joint can keep: a rule of a higher rank than what is measured is not satisfied.
RANKS = {"gap": 0, "free": 0, "G0": 1, "G1": 2, "C1": 3, "G2": 3}


def warnings(document: Document) -> list[str]:
    """Return what is doubtful about a document, one line each; nothing is changed."""
    return [line for report in measure_joints(document.profile) for line in joint_notices(report)]


def joint_notices(report: JointReport) -> list[str]:
    """Return what is doubtful about one joint."""
    if report.measured is JointClass.GAP:
        return [f"profile.joints[{report.joint}]: the ends are {report.gap:.6g} apart"]
    if satisfies(report):
        return []
    kink = "" if report.kink_deg is None else f" with a kink of {report.kink_deg:.4g}°"
    return [
        f"profile.joints[{report.joint}]: the rule is {report.rule}, "
        f"but the curve is only {report.measured} there{kink}"
    ]


def satisfies(report: JointReport) -> bool:
    """Return whether a joint is as good as its rule.

    C1 and G2 are both better than G1 and neither is better than the other; a joint that is both
    is measured as G2.
    """
    if report.rule is JointRule.C1 and report.measured is JointClass.G2:
        ratio = report.speed_ratio
        return ratio is not None and abs(ratio - 1.0) < EQUAL_DERIVATIVES
    if report.rule is JointRule.G2:
        return report.measured is JointClass.G2
    return RANKS[report.measured] >= RANKS[report.rule]
