"""Edits by which a drawn segment enters the document."""

from __future__ import annotations

from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.edits.checks import as_edit_error, lowered, with_profile
from sgb_core.document.edits.renumber_laws import follow
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoEdit


@as_edit_error()
def draw_first(document: Document, segment: Segment) -> Document:
    """Replace the whole profile by one drawn segment; what belonged to its segments goes with it.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.edits.draw_first(tube, sgb.line((0, 0), (30, 0))).largest_diameter
    60.0
    """
    origin = [None]
    laws = follow(document.variation, origin)
    return with_profile(document, Profile((segment,)), laws, origin)


@as_edit_error()
def draw_on(
    document: Document,
    segment: Segment,
    rule: JointRule = JointRule.G0,
    *,
    at_start: bool = False,
    closing: JointRule | None = None,
) -> Document:
    """Add a drawn segment that leaves from an end of the profile, with the rule of the joint there.

    ``at_start`` draws on from the profile's start, against its direction. With ``closing`` the
    segment leads to the other end, and the profile becomes a ring whose joint there has this rule.
    Rules that what is drawn does not keep are lowered. Raises EditError on a ring, which has no
    end.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.edits.draw_on(tube, sgb.line((10, 60), (20, 60))).largest_diameter
    40.0
    """
    profile = document.profile
    if profile.closed:
        raise EditError(NoEdit.RING_HAS_NO_END)
    count = len(profile)
    rules: tuple[JointRule, ...]
    if at_start:
        segments = (segment.reversed(), *profile.segments)
        rules, origin = (rule, *profile.rules), [None, *range(count)]
    else:
        segments = (*profile.segments, segment)
        rules, origin = (*profile.rules, rule), [*range(count), None]
    if closing is not None:
        rules = (*rules, closing)
    longer = Profile(segments, rules, closing is not None, extra=profile.extra)
    near = {0 if at_start else count - 1}
    if closing is not None:
        near.add(count)
    longer = lowered(longer, sorted(near))
    return with_profile(document, longer, follow(document.variation, origin), origin)
