"""The edit that makes a document's profile fair."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.fair import fair
from sgb_core.design.fairing.findings import Faired, Freedom, Keep
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.locks.equation import LockEquation
from sgb_core.document.dimensions import dimension_value
from sgb_core.document.edits.checks import checked, segment_number, with_profile
from sgb_core.document.errors import EditError
from sgb_core.document.lock_plan import lock_equations, locked_points, modelled
from sgb_core.document.model import Document
from sgb_core.findings.fairing import NoFairing
from sgb_core.findings.solving import NoTarget

# Bodies are held by their models, set right so often, until they differ by no larger part.
_ROUNDS = 6
_HELD = 1e-9


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
    for _ in range(_ROUNDS):
        found = fair(
            document.surface,
            energy,
            free,
            segments=segments,
            keep=keep,
            locks=locks,
            fixed=fixed,
        )
        result = with_profile(document, found.profile)
        locks, missed = _corrected(locks, rough, result)
        if missed <= _HELD:
            break
    return result, found


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
    locks: list[LockEquation], rough: frozenset[DimensionKind], result: Document
) -> tuple[list[LockEquation], float]:
    """Return locks by how much the object itself misses their models', and the largest part."""
    corrected, largest = [], 0.0
    for each in locks:
        dimension, target = each.lock.dimension, each.lock.target
        value = dimension_value(result, dimension) if dimension.kind in rough else None
        if value is not None and dimension.value is not None:
            apart = value - dimension.value
            largest = max(largest, abs(apart) / each.lock.scale)
            each = replace(each, lock=replace(each.lock, target=target - apart))
        corrected.append(each)
    return corrected, largest
