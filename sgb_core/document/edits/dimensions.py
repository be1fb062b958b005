"""Edits of dimensions and locks: added, locked, given a value that the shape then takes on."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sgb_core.curves.continuity import measure_joint
from sgb_core.curves.flare import flared
from sgb_core.curves.profile import SMOOTH_RULES
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.foot import foot_of
from sgb_core.design.demands.measures import end_of
from sgb_core.design.fairing.fair import changes
from sgb_core.design.fairing.findings import Change
from sgb_core.design.locks.dimension import (
    MAX_DIMENSIONS,
    Dimension,
    DimensionKind,
    misplaced,
)
from sgb_core.document.dimensions import STORED, dimension_value
from sgb_core.document.edits.checks import checked, finite
from sgb_core.document.edits.manufacture import set_fill
from sgb_core.document.edits.points import place_points
from sgb_core.document.edits.whole import set_height, set_largest_diameter, set_solid
from sgb_core.document.errors import EditError
from sgb_core.document.lock_keeper import Kept, LockKeeper
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoSuch, TooMany
from sgb_core.findings.locks import LocksInTheWay, NoDimension
from sgb_core.values import dataclass

_ENDS = (DimensionKind.RIM_DIAMETER, DimensionKind.FOOT_DIAMETER)


@dataclass(frozen=True, slots=True)
class Reached:
    """A document that has the value asked for, or the nearest that locks allow, and what moved."""

    document: Document
    moved: tuple[Change, ...]
    in_the_way: LocksInTheWay | None


def add_dimension(document: Document, dimension: Dimension) -> Document:
    """Add a dimension, the same document where it is there already.

    A lock without a value takes the present one. Raises EditError for what this object does not
    have.

    >>> cup = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (40, 60))]))
    >>> sgb.edits.add_dimension(cup, sgb.Dimension("rim_diameter")).dimensions[0].locked
    False
    """
    if any(_same(dimension, each) for each in document.dimensions):
        return document
    if len(document.dimensions) >= MAX_DIMENSIONS:
        raise EditError(TooMany("dimensions", MAX_DIMENSIONS))
    if misplaced(dimension, len(document.profile), len(document.profile.rules)) is not None:
        raise EditError(NoDimension.NOTHING)
    if dimension.is_number and dimension_value(document, dimension) is None:
        raise EditError(NoDimension.NOTHING)
    return _with(document, (*document.dimensions, dimension))


def remove_dimension(document: Document, number: int) -> Document:
    """Remove a dimension, and its lock with it."""
    _numbered(document, number)
    rest = tuple(each for k, each in enumerate(document.dimensions) if k != number)
    return _with(document, rest)


def set_lock(document: Document, number: int, locked: bool) -> Document:
    """Lock a dimension at what it measures now, or let it only tell again."""
    dimension = _numbered(document, number)
    if dimension.locked == locked:
        return document
    if not locked:
        return _replaced(document, number, dimension.freed())
    return _replaced(document, number, locked_now(document, dimension))


def locked_now(document: Document, dimension: Dimension) -> Dimension:
    """Return a dimension locked at what it measures now.

    Raises EditError where it measures nothing, or a joint does not keep the rule to be locked.
    """
    if dimension.joint is not None:
        report = measure_joint(document.profile, dimension.joint)
        if report.rule not in SMOOTH_RULES or not report.holds:
            raise EditError(NoDimension.SMOOTH)
        return replace(dimension, rule=report.rule, locked=True)
    if not dimension.is_number:
        return replace(dimension, locked=True)
    value = dimension_value(document, dimension)
    if value is None:
        raise EditError(NoDimension.NOTHING)
    return checked(lambda: dimension.held_at(value))


def set_dimension(document: Document, number: int, value: float) -> Reached:
    """Give a dimension a value, by the mildest change that keeps all locks and joints' rules.

    A lock goes on holding the new value, another dimension only tells again. Where the locks do
    not let it get so far it goes as far as it can. Raises EditError where nothing can be done.
    """
    dimension = _numbered(document, number)
    if not dimension.is_number:
        raise EditError(NoDimension.NO_VALUE)
    wanted = finite(value, dimension.label)
    if dimension.kind in STORED:
        return _set_stored(document, number, wanted)
    now = dimension_value(document, dimension)
    if now is None:
        raise EditError(NoDimension.NOTHING)
    if now == 0.0 and dimension.kind in _ENDS:
        raise EditError(NoDimension.ON_AXIS)
    driven = checked(lambda: dimension.held_at(wanted))
    stretched = _stretched(document, dimension, wanted)
    edited = _replaced(stretched, number, driven)
    kept = LockKeeper().keep(document, edited, settle=True, hand=False)
    result = kept.document
    if not dimension.locked:
        result = _replaced(result, number, dimension)
    return Reached(result, changes(document.profile, result.profile), kept.in_the_way)


def _stretched(document: Document, dimension: Dimension, value: float) -> Document:
    """Return where the search for a value begins.

    An overall size stretches the whole; a rim or a foot takes the curve beside it along.
    """
    if dimension.kind is DimensionKind.HEIGHT:
        return set_height(document, value)
    if dimension.kind is DimensionKind.MAX_DIAMETER:
        return set_largest_diameter(document, value)
    if dimension.kind in _ENDS:
        return _flared(document, dimension.kind is DimensionKind.RIM_DIAMETER, value / 2.0)
    return document


def _flared(document: Document, upper: bool, radius: float) -> Document:
    """Return a document whose rim or foot has a radius, the curve beside it going along."""
    profile = document.profile
    number, index = end_of(profile.quartics, upper)
    last, after = index > 0, 0
    if not upper:
        foot = foot_of(Chain.of(profile).quartics)
        if foot.after is None:
            return document
        number, index, after = foot.segment, round(4 * foot.s), foot.after
    now = float(profile.control_points[number, index and 3, 0])
    if now <= 0.0:
        return document
    points = flared(profile, last=last, step=radius - now, after=after)
    moved = np.argwhere((points != profile.control_points).any(axis=2)).tolist()
    return place_points(document, {(k, i): points[k, i] for k, i in moved})


def _set_stored(document: Document, number: int, value: float) -> Reached:
    dimension = document.dimensions[number]
    freed = _replaced(document, number, dimension.freed())
    if dimension.kind is DimensionKind.FILL_LINE:
        edited = set_fill(freed, value)
    else:
        name = "wall" if dimension.kind is DimensionKind.WALL else "base"
        edited = set_solid(freed, **{name: value})  # type: ignore[arg-type]
    if dimension.locked:
        edited = _replaced(edited, number, checked(lambda: dimension.held_at(value)))
    kept = LockKeeper().keep(document, edited, settle=True)
    return Reached(kept.document, changes(document.profile, kept.document.profile), kept.in_the_way)


def keep_locks(start: Document, edited: Document) -> Kept:
    """Return an edited document with its locks held, set right by the body's own measures.

    Raises EditError with the locks that exclude the edit.
    """
    return LockKeeper().keep(start, edited, settle=True)


def _numbered(document: Document, number: int) -> Dimension:
    count = len(document.dimensions)
    if not 0 <= number < count:
        raise EditError(NoSuch("dimension", number, count))
    return document.dimensions[number]


def _same(one: Dimension, other: Dimension) -> bool:
    """Return whether two dimensions measure the same."""
    return one.freed() == other.freed()


def _replaced(document: Document, number: int, dimension: Dimension) -> Document:
    changed = tuple(
        dimension if k == number else each for k, each in enumerate(document.dimensions)
    )
    return _with(document, changed)


def _with(document: Document, dimensions: tuple[Dimension, ...]) -> Document:
    return checked(lambda: replace(document, dimensions=dimensions))
