"""What an edit changed, where that is a single value: which field, from what to what."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Kind, Range
from sgb_core.fields.lists import OrNone, Several
from sgb_core.fields.record import Flat, Part, Row, table_of
from sgb_core.findings.finding import Path
from sgb_core.values import dataclass

_POINT = Row(Range(length=True))


@dataclass(frozen=True, slots=True)
class Changed:
    """A field at ``path`` in the file that was ``before`` and is ``after``; ``row`` describes it.

    Of a control point the values are its (r, h).
    """

    path: Path
    row: Row
    before: object
    after: object


def only_change(before: Document, after: Document) -> Changed | None:
    """Return the one value in which two documents differ; None where it is none or several.

    A joint that carries its handles along counts as one point.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    >>> cup = sgb.edits.set_solid(tube, wall=4.0)
    >>> change = only_change(tube, cup)
    >>> change.path, change.before, change.after
    (('solid', 'wall'), 3.0, 4.0)
    """
    found = list(islice(_differences(before, after, ()), 2))
    return found[0] if len(found) == 1 else None


def _differences(before: object, after: object, path: Path) -> Iterator[Changed]:
    for row in table_of(type(after)).rows:
        old, new = getattr(before, row.name), getattr(after, row.name)
        if old is new:
            continue
        place = path if isinstance(row.kind, Flat) else (*path, row.key)
        if isinstance(new, Profile):
            yield from _of_profiles(old, new, place)
        elif old != new:
            yield from _of_values(row, row.kind, old, new, place)


def _of_values(row: Row, kind: Kind, old: object, new: object, path: Path) -> Iterator[Changed]:
    if isinstance(kind, OrNone) and old is not None and new is not None:
        kind = kind.inner
    if isinstance(kind, Part) and type(old) is type(new) and hasattr(kind.cls, "RECORD"):
        yield from _differences(old, new, path)
        return
    if isinstance(kind, Several) and isinstance(old, tuple) and isinstance(new, tuple):
        pairs = [k for k, (a, b) in enumerate(zip(old, new, strict=False)) if a != b]
        if len(old) == len(new) and len(pairs) == 1:
            (k,) = pairs
            yield from _of_values(row, kind.inner, old[k], new[k], (*path, k))
            return
    yield Changed(path, row, old, new)


def _of_profiles(old: Profile, new: Profile, path: Path) -> Iterator[Changed]:
    """Yield what differs in two chains; several differences where more than a value does."""
    if len(old) != len(new) or old.closed != new.closed or old.rules != new.rules:
        whole = Changed(path, Row(Part(Profile)), old, new)
        yield from (whole, whole)
        return
    moved = np.argwhere((old.control_points != new.control_points).any(axis=2))
    for segment, index in _told(old, [(int(k), int(i)) for k, i in moved]):
        place = (*path, "segments", segment, "points", index)
        first, second = (_place(each, segment, index) for each in (old, new))
        yield Changed(place, _POINT, first, second)
    for segment, (a, b) in enumerate(zip(old.segments, new.segments, strict=True)):
        if a.shape != b.shape:
            yield from _differences(a.shape, b.shape, (*path, "segments", segment))


def _told(profile: Profile, moved: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return the points to name of those that moved: a joint once, and for its handles too."""
    for joint in profile.joints:
        before, after = profile.neighbours(joint)
        own = {(before, 3), (after, 0)}
        if own <= set(moved) <= own | {(before, 2), (after, 1)}:
            return [(before, 3)]
    return moved


def _place(profile: Profile, segment: int, index: int) -> tuple[float, float]:
    point: Floats = profile.segments[segment].points[index]
    return float(point[0]), float(point[1])
