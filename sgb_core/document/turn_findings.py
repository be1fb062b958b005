"""What laws make of a section on its way around: doubts that the stored profile does not show."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import distinct
from sgb_core.curves.crossings import certificates
from sgb_core.document.model import Document
from sgb_core.findings.profile import TurnsBeyondAxis
from sgb_core.surfaces.angular import angle_edges

# Sections looked at around a turn, beside the angles at which laws are extreme, and radii in each.
_SECTIONS = 181
_RADII = 65
# Less than this part of the size is rounding, or a touch of the axis.
_ROUNDING = 1e-9


def turn_findings(document: Document) -> list[TurnsBeyondAxis]:
    """Return each segment that laws carry beyond the axis, and where it is worst.

    Where the section crosses the axis the surface cuts through itself.
    """
    surface, profile = document.surface, document.profile
    # Parameters move no control point: the polygon can rule it out for every angle at once.
    if not surface.laws or certificates(profile).never_crosses_axis:
        return []
    theta = distinct(np.linspace(0.0, surface.sweep, _SECTIONS), angle_edges(surface, bare=True))
    # What stretches a radius by the height leaves it on its side: the depth is told with it.
    places = np.linspace(0.0, 1.0, _RADII)
    radii = surface.sections(theta).on(places)[..., 0]
    if radii.sum() < 0.0:
        radii = -radii
    least = radii.min(axis=-1)
    found = []
    for number in range(len(profile)):
        worst = int(np.argmin(least[:, number]))
        depth = -float(least[worst, number])
        if depth > _ROUNDING * profile.size:
            found.append(TurnsBeyondAxis(number, depth, float(np.degrees(theta[worst]))))
    return found
