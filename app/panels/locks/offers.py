"""What can be dimensioned of a document and of what is selected in it."""

from __future__ import annotations

from collections.abc import Iterator

from sgb_core.curves.profile import SMOOTH_RULES, Profile
from sgb_core.design.locks.dimension import KINDS, Dimension, DimensionKind
from sgb_core.document.dimensions import dimension_value
from sgb_core.document.model import Document

PointId = tuple[int, int]
_K = DimensionKind
# Kinds that name no place: those of the whole object.
WHOLE = tuple(kind for kind, facts in KINDS.items() if not facts.needs and not facts.points)
# Searching a body takes too long for a menu that opens.
_OF_BODY = (_K.CAPACITY, _K.FILLED, _K.MATERIAL, _K.MASS)


def offers(document: Document, points: frozenset[PointId], segment: int) -> list[Dimension]:
    """Return the dimensions that are not there yet, those of what is selected first."""
    known = {each.freed() for each in document.dimensions}
    found = [*_of_selection(document.profile, points, segment), *_of_whole(document)]
    return [each for each in found if each not in known]


def _of_selection(
    profile: Profile, points: frozenset[PointId], segment: int
) -> Iterator[Dimension]:
    chosen = sorted(points)
    if len(chosen) == 2:
        yield Dimension(_K.DISTANCE, points=tuple(chosen))
        yield Dimension(_K.ANGLE, points=tuple(chosen))
    for point in chosen[:4]:
        yield Dimension(_K.POINT, points=(point,))
    if len(chosen) == 1:
        ((k, i),) = chosen
        # The end and its leg: the tangent there.
        yield Dimension(_K.ANGLE, points=((k, 0), (k, 1)) if i < 2 else ((k, 2), (k, 3)))
        yield Dimension(_K.DIAMETER_AT, height=float(profile.segments[k].points[i][1]))
    if segment < len(profile):
        yield Dimension(_K.RADIUS, segment=segment, s=0.5)
    for joint in profile.joints:
        rule = profile.rules[joint]
        if rule in SMOOTH_RULES and segment in profile.neighbours(joint):
            yield Dimension(_K.JOINT, joint=joint, rule=rule)


def _of_whole(document: Document) -> Iterator[Dimension]:
    for kind in WHOLE:
        dimension = Dimension(kind)
        if kind in _OF_BODY:
            if _has_body(document, kind):
                yield dimension
        elif dimension_value(document, dimension) is not None:
            yield dimension


def _has_body(document: Document, kind: DimensionKind) -> bool:
    body = document.solid.kind.value
    if kind is _K.FILLED:
        return body == "vessel" and document.fill_height is not None
    if kind is _K.CAPACITY:
        return body == "vessel" and not document.profile.closed
    return body != "surface"
