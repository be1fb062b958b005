"""What is allowed in a document but doubtful: what, where and how much."""

from __future__ import annotations

from collections.abc import Sequence

from sgb_core.curves.coincidence import coincident_points
from sgb_core.curves.continuity import (
    JointClass,
    JointReport,
    gap_at,
    unmet_rule,
)
from sgb_core.curves.crossings import axis_crossings, self_intersections
from sgb_core.curves.head_to_tail import joined_head_to_tail
from sgb_core.document.model import Document
from sgb_core.document.turn_findings import turn_findings
from sgb_core.findings.finding import Finding
from sgb_core.findings.joints import Gap
from sgb_core.findings.profile import BeyondAxis, Crossing, MoreCrossings, OpposedParts

# Of the places where a profile crosses itself so many are named, the rest counted.
MOST_NAMED = 16


def check(document: Document) -> tuple[Finding, ...]:
    """Return what is doubtful about a document's profile and laws; nothing is changed.

    >>> legs = [sgb.line((20, 0), (20, 30)), sgb.line((20, 30), (50, 60))]
    >>> bent = sgb.Document(sgb.Profile.of(legs, ["G1"]))
    >>> [sgb.say(finding) for finding in sgb.check(bent)]
    ['profile.joints[0]: the rule is G1, but the curve is only G0 there (kink 45°)']
    >>> sgb.check(sgb.edits.set_rule(bent, 0, "free"))
    ()
    """
    profile = document.profile
    return findings_of(
        document, document.joints, axis_crossings(profile), self_intersections(profile)
    )


def findings_of(
    document: Document,
    joints: Sequence[JointReport],
    beyond_axis: Sequence[BeyondAxis],
    crossings: Sequence[Crossing],
) -> tuple[Finding, ...]:
    """Return the findings of a document whose profile has been examined already."""
    profile = document.profile
    found: list[Finding] = []
    for report in joints:
        if report.measured is JointClass.GAP:
            found.append(gap_at(profile, report))
        # Beside a single point no rule can hold: the point is what is said, once.
        elif not report.holds and report.kink_deg is not None:
            found.append(unmet_rule(profile, report))
    if any(isinstance(each, Gap) for each in found) and joined_head_to_tail(profile):
        found.append(OpposedParts())
    found += coincident_points(profile)
    found += [*beyond_axis, *turn_findings(document)]
    found += crossings[:MOST_NAMED]
    if len(crossings) > MOST_NAMED:
        found.append(MoreCrossings(len(crossings) - MOST_NAMED))
    return tuple(found)
