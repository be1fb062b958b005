"""What a document's body cannot become at the default fineness, told before anybody tries."""

from __future__ import annotations

from contextlib import suppress

import numpy as np

from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.solid_mesh import widest
from sgb_core.document.model import Document
from sgb_core.findings.bodies import NoBodyFor
from sgb_core.findings.exports import SinglePrecision
from sgb_core.findings.finding import Finding
from sgb_core.surfaces.section import MERGE

# Of the size of a body, by how much a mesh of the default fineness is off.
SHARE = 1e-3


def export_doubts(document: Document) -> tuple[Finding, ...]:
    """Return what stops a mesh, or an STL file, of a document that is right in itself.

    >>> cup = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (30, 60))]))
    >>> export_doubts(cup)
    ()
    >>> far = sgb.edits.set_placement(cup, translation=(1e9, 0, 0))
    >>> [type(each).__name__ for each in export_doubts(far)]
    ['SinglePrecision']
    """
    return (*_too_narrow(document), *_too_far(document))


def _too_narrow(document: Document) -> list[Finding]:
    """Return that the end faces of a turn lie on each other; see :func:`body_mesh`."""
    surface = document.surface
    if document.solid.kind is BodyKind.SURFACE or surface.is_full_turn:
        return []
    # What has no section at all has been told.
    with suppress(SolidError):
        reach = widest(cross_section(surface, document.solid))
        if surface.sweep * reach < MERGE * surface.profile.size:
            return [NoBodyFor.TOO_NARROW]
    return []


def _too_far(document: Document) -> list[Finding]:
    """Return that single precision, which STL holds, rounds by more than the fineness."""
    size = document.profile.size
    away = float(np.abs(document.placement.translation).max())
    # An upper bound that nearly every document keeps: the box itself is dear where laws vary it.
    low, high = document.profile.bounds()
    reach = float(np.abs([low, high]).max())
    if _rounding(away + 2.0 * reach) <= SHARE * size:
        return []
    corners = np.array(document.bounds)
    farthest = float(np.abs(corners).max())
    if farthest > float(np.finfo(np.float32).max):
        return [SinglePrecision(farthest, None, None)]
    allowed = SHARE * float(np.linalg.norm(corners[1] - corners[0]))
    rounding = _rounding(farthest)
    return [SinglePrecision(farthest, rounding, allowed)] if rounding > allowed else []


def _rounding(value: float) -> float:
    """Return by how much single precision rounds a number of this size."""
    if value > float(np.finfo(np.float32).max):
        return float("inf")
    return float(np.spacing(np.float32(value))) / 2.0
