"""The edit that makes a document's profile fair."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from math import inf

from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.fair import fair
from sgb_core.design.fairing.findings import Faired, Freedom, Keep, LocksExcludeError
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.locks.equation import LockEquation
from sgb_core.design.locks.secants import Secants
from sgb_core.document.dimensions import dimension_value
from sgb_core.document.edits.checks import checked, segment_number, with_profile
from sgb_core.document.errors import EditError
from sgb_core.document.lock_plan import lock_equations, locked_points, modelled
from sgb_core.document.model import Document
from sgb_core.findings.fairing import MeasureInTheWay, NoFairing
from sgb_core.findings.solving import NoTarget

# Bodies are held by their models, set right so often, until they differ by no larger part.
_ROUNDS = 10
_HELD = 1e-9
# Where no round comes so near, one that does to this part is good enough.
_NEARLY = 1e-8


def fair_profile(
    document: Document,
    energy: Energy = Energy.BENDING,
    free: Freedom = Freedom.SHAPE,
    *,
    segments: Collection[int] | None = None,
    keep: Collection[Keep] = (),
) -> tuple[Document, Faired]:
    """Return the document with the fairest profile that keeps its locks, and what was found.

    Raises LocksExcludeError where nothing keeps all that is asked for, EditError for a segment
    that is not there and for an energy that is not known.
    """
    for segment in segments or ():
        segment_number(document, segment)
    if document.variation and energy is Energy.SURFACE:
        raise EditError(NoFairing.LAWS)
    asked = _with_capacity(document) if Keep.CAPACITY in keep else document
    locks, rough, fixed = lock_equations(asked), modelled(asked), locked_points(asked)
    near, last, best, least = None, Secants(), None, inf
    for _ in range(_ROUNDS):
        try:
            found = fair(
                document.surface,
                energy,
                free,
                segments=segments,
                keep=keep,
                locks=locks,
                fixed=fixed,
                near=near,
            )
        except LocksExcludeError:
            if best is None:
                raise
            break
        result, near = with_profile(document, found.profile), found.profile
        locks, missed = _corrected(locks, rough, result, last)
        if missed < least:
            best, least = (result, found), missed
        if least <= _HELD:
            break
    assert best is not None
    if least <= _NEARLY:
        return best
    if free is Freedom.POINTS:
        # Models that lead points from place to place still hold where no point moves.
        return fair_profile(document, energy, segments=segments, keep=keep)
    worst = next(each.name for each in locks if each.lock.dimension.kind in rough)
    raise LocksExcludeError(MeasureInTheWay(worst, least))


def _with_capacity(document: Document) -> Document:
    """Return a document whose capacity is locked at what it is."""
    dimension = Dimension(DimensionKind.CAPACITY)
    if any(each.locked and each.kind is dimension.kind for each in document.dimensions):
        return document
    value = dimension_value(document, dimension)
    if value is None:
        raise EditError(NoTarget.NO_CAPACITY)
    held = checked(lambda: dimension.held_at(value))
    return replace(document, dimensions=(*document.dimensions, held))


def _corrected(
    locks: list[LockEquation],
    rough: frozenset[DimensionKind],
    result: Document,
    last: Secants,
) -> tuple[list[LockEquation], float]:
    """Return locks by how much the object itself misses their models', and the largest part."""
    corrected, largest = [], 0.0
    for each in locks:
        dimension, target = each.lock.dimension, each.lock.target
        value = dimension_value(result, dimension) if dimension.kind in rough else None
        if value is not None and dimension.value is not None:
            apart = value - dimension.value
            largest = max(largest, abs(apart) / each.lock.scale)
            following = last.following(dimension.kind, target, apart)
            each = replace(each, lock=replace(each.lock, target=following))
        corrected.append(each)
    return corrected, largest
