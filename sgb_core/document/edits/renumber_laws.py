"""Laws over the angle belong to segments: how they follow when segments are renumbered."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from sgb_core.curves.segment import PARAMETER_RANGES
from sgb_core.surfaces.laws.law import LawParameter
from sgb_core.surfaces.variation import Law

_MIRRORED: dict[LawParameter, LawParameter] = {
    "lambda1": "lambda3",
    "lambda2": "lambda2",
    "lambda3": "lambda1",
    "omega": "omega",
    "radius": "radius",
}


def reversed_law(law: Law) -> Law:
    """Return the law for the same segment run backwards: λ1 ↔ λ3, λ2 → 6 − λ2."""
    if law.parameter == "lambda2":
        high = PARAMETER_RANGES["lambda2"][1]
        return replace(law, start=high - law.start, end=high - law.end)
    return replace(law, parameter=_MIRRORED[law.parameter])


def follow(
    laws: tuple[Law, ...], origin: Sequence[int | None], backwards: Collection[int] = ()
) -> tuple[Law, ...]:
    """Return the laws after segments were moved, removed, divided, added or reversed.

    ``origin[k]`` is the old number of what is segment k now, None for a new one; ``backwards``
    holds the new numbers of segments that were reversed. A law for all segments also governs
    new ones, unless it has to be divided because only some were reversed. Laws left without a
    segment are removed.
    """
    followed = [new for law in laws for new in _follow(law, origin, frozenset(backwards))]
    return laws if tuple(followed) == laws else tuple(followed)


def _follow(law: Law, origin: Sequence[int | None], backwards: frozenset[int]) -> list[Law]:
    if _MIRRORED[law.parameter] == law.parameter != "lambda2":
        backwards = frozenset()
    if law.segments is None:
        if not backwards:
            return [law]
        if len(backwards) == len(origin):
            return [reversed_law(law)]
    members = [k for k, old in enumerate(origin) if old is not None and law.applies_to(old)]
    straight = tuple(k for k in members if k not in backwards)
    turned = tuple(k for k in members if k in backwards)
    found = []
    if straight:
        found.append(replace(law, segments=straight))
    if turned:
        found.append(replace(reversed_law(law), segments=turned))
    return found


def laws_of(laws: Sequence[Law], segment: int) -> list[Law]:
    """Return the laws that govern a segment."""
    return [law for law in laws if law.applies_to(segment)]
