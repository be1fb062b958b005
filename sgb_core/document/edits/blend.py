"""Documents between two others: points, shape parameters, laws and sweep in proportion."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.curves.profile import JointRule
from sgb_core.curves.segment import PARAMETER_RANGES, Segment, ShapeParameters
from sgb_core.document.edits.checks import as_edit_error, lowered
from sgb_core.document.edits.whole import set_unit
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoEdit, OtherLength
from sgb_core.surfaces.variation import Law


@as_edit_error()
def blend(first: Document, second: Document, share: float) -> Document:
    """Return the document that lies ``share`` (0 to 1) of the way from one to another.

    Control points, λ1, λ2, λ3, ω, start angle, sweep and the values of laws change in proportion,
    lengths at their true size; all else is the first's. Joints are lowered to what they are
    between. Raises EditError where the two are not built alike.
    """
    second = set_unit(second, first.unit, convert=True)
    one, other = first.profile, second.profile
    if len(one) != len(other):
        raise EditError(OtherLength(len(one), len(other)))
    if one.closed is not other.closed:
        raise EditError(NoEdit.RING_AND_OPEN)
    if first.revolution.axis is not second.revolution.axis:
        raise EditError(NoEdit.OTHER_AXIS)
    laws = tuple(_law(a, b, share) for a, b in zip(first.variation, second.variation, strict=False))
    if len(first.variation) != len(second.variation):
        raise EditError(NoEdit.OTHER_LAWS)
    segments = [_segment(a, b, share) for a, b in zip(one.segments, other.segments, strict=True)]
    # A joint that is loose in one of them is loose between.
    looser = other if share > 0.0 else one
    rules = tuple(
        mine if theirs is not JointRule.FREE else theirs
        for mine, theirs in zip(one.rules, looser.rules, strict=True)
    )
    between = replace(one, segments=tuple(segments), rules=rules)
    one_turn, other_turn = first.revolution, second.revolution
    turn = replace(
        one_turn,
        start_deg=_mixed(one_turn.start_deg, other_turn.start_deg, share),
        sweep_deg=_mixed(one_turn.sweep_deg, other_turn.sweep_deg, share),
    )
    profile = lowered(between, between.joints)
    return replace(first, profile=profile, revolution=turn, variation=laws)


def _mixed(one: float, other: float, share: float) -> float:
    # Rounding must not lead out of what either of them may be.
    mixed = (1.0 - share) * one + share * other
    return one if one == other else min(max(mixed, min(one, other)), max(one, other))


def _segment(one: Segment, other: Segment, share: float) -> Segment:
    shape = {
        name: _mixed(getattr(one.shape, name), getattr(other.shape, name), share)
        for name in PARAMETER_RANGES
    }
    points = (1.0 - share) * one.points + share * other.points
    return replace(one.with_points(points), shape=ShapeParameters(**shape))


def _law(one: Law, other: Law, share: float) -> Law:
    alike = replace(other, start=one.start, end=one.end, along=one.along, extra=one.extra)
    if alike != one or len(one.along) != len(other.along):
        raise EditError(NoEdit.OTHER_LAWS)
    start, end = _mixed(one.start, other.start, share), _mixed(one.end, other.end, share)
    along = tuple(
        (_mixed(u, v, share), _mixed(k, m, share))
        for (u, k), (v, m) in zip(one.along, other.along, strict=True)
    )
    return replace(one, start=start, end=end, along=along)
