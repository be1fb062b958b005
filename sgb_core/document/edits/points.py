"""Edits that move control points by hand."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.axis_stop import stops
from sgb_core.curves.constraints import PointKey, move_control_points
from sgb_core.curves.legs import scaled_legs
from sgb_core.curves.profile import Profile
from sgb_core.document.edits.checks import (
    finite,
    keeping_ring,
    lowered,
    met,
    segment_number,
    with_profile,
)
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.kinds import MAX_COORDINATE, Said
from sgb_core.findings.edits import NoEdit, NotOfSegment
from sgb_core.findings.refusal import Argument

# How often points that follow what was stopped at the axis are stopped in their turn.
_STOPS = 4


def move_point(
    document: Document,
    segment: int,
    index: int,
    position: Sequence[float],
    *,
    keep_rules: bool = True,
    scale_legs: bool = False,
    stop_at_axis: bool = False,
) -> Document:
    """Move one control point (``index`` 0 to 3) to ``position`` = (r, h).

    Ends that meet stay together, except at a free joint, and a joint carries its legs. Where a
    leg of a G1, C1 or G2 joint moves, the other side follows. Without ``keep_rules`` nothing
    else moves but the other end at a joint, and a rule that this breaks is lowered to what the
    joint then is. With ``scale_legs`` the legs of the segments at an end or joint that moves keep
    their directions, and their lengths in proportion to the chord. With ``stop_at_axis`` no point
    goes through the axis (see :mod:`sgb_core.curves.axis_stop`).

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> wider = sgb.edits.move_point(cylinder, 0, 3, (15, 60))
    >>> wider.largest_diameter
    30.0
    """
    key = _key(document, segment, index)
    targets = {key: _pair(position, "the point")}
    if scale_legs and keep_rules:
        targets |= scaled_legs(document.profile, key, targets[key])
    return _move(document, targets, keep_rules, stop_at_axis)


def move_points(
    document: Document,
    points: Iterable[PointKey],
    step: Sequence[float],
    *,
    keep_rules: bool = True,
    stop_at_axis: bool = False,
) -> Document:
    """Move several control points, given as (segment, index), by ``step`` = (dr, dh) at once.

    With ``stop_at_axis`` no point goes through the axis, as in :func:`move_point`.
    """
    shift = _pair(step, "the step")
    old = document.profile.control_points
    keys = {_key(document, segment, index) for segment, index in points}
    targets = {key: old[key] + shift for key in sorted(keys)}
    return _move(document, targets, keep_rules, stop_at_axis)


def scale_points(
    document: Document,
    points: Iterable[PointKey],
    factors: Sequence[float],
    about: Sequence[float] | None = None,
    *,
    keep_rules: bool = True,
) -> Document:
    """Scale several control points by ``factors`` = (in r, in h) about a place (r, h).

    Without ``about`` it is the middle of the box around them; a factor of −1 mirrors.
    """
    old = document.profile.control_points
    keys = sorted({_key(document, segment, index) for segment, index in points})
    if not keys:
        return document
    ratio = _pair(factors, "the factor")
    places = np.array([old[key] for key in keys])
    if about is None:
        middle = (places.min(axis=0) + places.max(axis=0)) / 2.0
    else:
        middle = _pair(about, "the middle")
    moved = middle + (places - middle) * ratio
    return _move(document, dict(zip(keys, moved, strict=True)), keep_rules)


def place_points(
    document: Document, places: Mapping[PointKey, Sequence[float]], *, keep_rules: bool = True
) -> Document:
    """Move several control points, each to its own (r, h)."""
    targets = {_key(document, *key): _pair(place, "the point") for key, place in places.items()}
    return _move(document, targets, keep_rules) if targets else document


def _move(
    document: Document,
    targets: dict[PointKey, Floats],
    keep_rules: bool,
    stop_at_axis: bool = False,
) -> Document:
    profile = document.profile
    points = profile.control_points
    if all(np.array_equal(points[key], target) for key, target in targets.items()):
        return document
    # Checked before the joints' geometry is computed from it.
    if any(np.abs(target).max() > MAX_COORDINATE for target in targets.values()):
        raise EditError(NoEdit.TOO_FAR)

    def move(profile: Profile) -> Profile:
        wanted = targets
        moved = move_control_points(profile, wanted, keep_rules).profile
        # Where a joint's rule then carries another point across, that one stops, too.
        for _ in range(_STOPS if stop_at_axis else 0):
            stopped = stops(profile, moved)
            if not stopped:
                break
            wanted = wanted | stopped
            moved = move_control_points(profile, wanted, keep_rules).profile
        # What a rule would carry across again and again stays, whatever becomes of the rule.
        left = stops(profile, moved) if stop_at_axis else {}
        return move_control_points(moved, left, False).profile if left else moved

    moved = keeping_ring(profile, move)
    if not keep_rules:
        moved = lowered(moved, met(profile, profile.joints))
    return with_profile(document, moved)


def _key(document: Document, segment: int, index: int) -> PointKey:
    segment_number(document, segment)
    if not 0 <= index <= 3:
        raise EditError(NotOfSegment("points", index))
    return segment, index


def _pair(values: Sequence[float], what: str) -> Floats:
    if len(values) != 2:
        raise EditError(Argument(what, values, Said("a pair (r, h)")))
    return np.array([finite(value, what) for value in values])
