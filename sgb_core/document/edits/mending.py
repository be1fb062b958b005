"""Edits that mend in one step what is wrong with a document."""

from __future__ import annotations

from collections.abc import Mapping
from math import floor, log10

from sgb_core.arrays import Floats
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.vessel import section_findings
from sgb_core.curves.axis_stop import beyond_axis
from sgb_core.curves.constraints import PointKey, move_control_points
from sgb_core.curves.crossings import axis_crossings
from sgb_core.document.edits.checks import lowered, met, with_profile
from sgb_core.document.edits.points import place_points
from sgb_core.document.edits.whole import set_solid
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.bodies import SealedHollow, TightCurve
from sgb_core.findings.edits import NoEdit

# Halvings of the range in which the largest wall is looked for.
_HALVINGS = 24
# Significant digits of a wall that is found, rounded down.
_DIGITS = 2


def push_inside_axis(document: Document) -> Document:
    """Bring every point that lies beyond the axis back to it, so that the profile crosses no more.

    Ends go onto the axis; handles are drawn back along their legs. The joints keep their rules
    where the profile then stays inside, else these are lowered to what the joints are.

    >>> wall = sgb.Segment([(20, 0), (-30, 20), (-30, 40), (20, 60)])
    >>> inside = sgb.edits.push_inside_axis(sgb.Document(sgb.Profile.of([wall])))
    >>> sgb.check(inside)
    ()
    """
    places = beyond_axis(document.profile)
    if not places:
        return document
    kept = place_points(document, {key: tuple(place) for key, place in places.items()})
    if not axis_crossings(kept.profile):
        return kept
    return _put(document, places)


def _put(document: Document, places: Mapping[PointKey, Floats]) -> Document:
    """Return the document with just these points elsewhere, rules lowered to what then is."""
    profile = document.profile
    held = met(profile, profile.joints)
    moved = move_control_points(profile, places, keep_rules=False).profile
    return with_profile(document, lowered(moved, held))


def fit_wall(document: Document) -> Document:
    """Make the wall of a vessel as thick as fits, at most as thick as it is, two digits of it.

    Raises EditError where no wall fits.
    """
    present = document.solid.wall
    if _fits(document, present):
        return document
    low, high = 0.0, present
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        if _fits(document, middle):
            low = middle
        else:
            high = middle
        if low > 0.0 and _rounded_down(low) == _rounded_down(high):
            break
    if low == 0.0:
        raise EditError(NoEdit.NO_WALL)
    rounded = _rounded_down(low)
    return set_solid(document, wall=rounded if _fits(document, rounded) else low)


def _rounded_down(value: float) -> float:
    step = 10.0 ** (floor(log10(value)) + 1 - _DIGITS)
    return round(floor(value / step + 1e-9) * step, 12)


def _fits(document: Document, wall: float) -> bool:
    """Whether a vessel has a body with this wall, as thick all along, and its hollow is open."""
    try:
        found = section_findings(document.surface, set_solid(document, wall=wall).solid)
    except (SolidError, EditError):
        return False
    return not any(isinstance(each, TightCurve | SealedHollow) for each in found)


def no_drain_hole(document: Document) -> Document:
    """Take the drain hole away."""
    return set_solid(document, drain_hole=0.0)


def flat_rim(document: Document) -> Document:
    """Cut the rim flat."""
    return set_solid(document, rim="flat")


def no_foot_ring(document: Document) -> Document:
    """Take the foot ring away."""
    return set_solid(document, foot_ring=0.0)
