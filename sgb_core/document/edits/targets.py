"""Edits that search: the size at which a vessel holds a wanted volume."""

from __future__ import annotations

from enum import StrEnum

from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.vessel import capacity_to, vessel_measures
from sgb_core.design.targets import TargetError, solve_factor
from sgb_core.document.edits.whole import scale, set_height, set_largest_diameter
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoSize
from sgb_core.findings.errors import FindingError
from sgb_core.surfaces import measures


class Stretch(StrEnum):
    """What of the profile changes to meet a target; walls keep their thickness."""

    ALL = "all"
    HEIGHT = "height"
    RADIUS = "radius"


def held_volume(document: Document) -> float | None:
    """Return what the object holds in unit³: to its fill line, else to the brim.

    Of a bare surface or a filled solid the volume that the drawn surface encloses; None for a
    vessel without a rim. Raises SolidError, a ValueError, where the body cannot be made.
    """
    solid, surface = document.solid, document.surface
    if solid.kind is not BodyKind.VESSEL:
        return measures.volume(surface)
    height = document.fill_height
    if height is None:
        return vessel_measures(surface, solid).capacity
    return capacity_to(surface, solid, height)


def stretched(document: Document, factor: float, stretch: Stretch) -> Document:
    """Return the document with its profile, and fill line, stretched as a target asks."""
    if stretch is Stretch.ALL:
        return scale(document, factor)
    low, high = document.profile.bounds()
    if stretch is Stretch.HEIGHT:
        return set_height(document, factor * float(high[1] - low[1]))
    return set_largest_diameter(document, 2.0 * factor * max(abs(float(low[0])), float(high[0])))


def hold(document: Document, volume: float, stretch: Stretch | str = Stretch.ALL) -> Document:
    """Return the document stretched until it holds ``volume`` (unit³), to 1e-9 of it.

    Raises EditError where it has no capacity or no size holds so much.
    """
    way = Stretch(stretch)

    def measure(factor: float) -> float:
        found = held_volume(stretched(document, factor, way))
        if found is None:
            raise TargetError(NoSize.NO_RIM)
        return found

    try:
        return stretched(document, solve_factor(measure, volume), way)
    except FindingError as error:
        raise EditError(error.finding) from None
