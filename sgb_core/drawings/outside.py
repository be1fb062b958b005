"""The outside of what is no plain turning, as lines that are seen of its mesh."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.bodies.body import Body
from sgb_core.bodies.contours import seen_lines
from sgb_core.document.model import Document
from sgb_core.drawings.page import Path

# Of the size: the mesh is not finer, whatever the scale, and what is shorter is no line.
_FINEST, _SHORTEST = 5e-4, 2e-3


def outside_of_mesh(document: Document, tolerance: float, mirror: float) -> tuple[Path, ...]:
    """Return what is seen of the half beyond the axis, in mm of the object, at r ≥ 0.

    ``tolerance`` is in the document's unit. The section lies in the plane of the start angle, to
    the right where ``mirror`` is 1, to the left where it is −1.
    """
    surface, size = document.surface, document.profile.size
    within = max(tolerance, _FINEST * size)
    factor = document.unit.millimetres
    return tuple(
        Path.through([(r * factor, h * factor) for r, h in part.tolist()])
        for part in _seen(Body(surface, document.solid, document.patterns), within, mirror)
    )


@lru_cache(maxsize=8)
def _seen(body: Body, within: float, mirror: float) -> tuple[Floats, ...]:
    surface, size = body.surface, body.surface.profile.size
    mesh = body.mesh(tolerance=within)
    along, aside, up = surface.directions(np.array(surface.start))
    frame = np.stack([-along, up, -mirror * aside])
    shift = frame @ np.asarray(surface.placement.translation)
    half = shapely.box(0.0, -1e9 * size, 1e9 * size, 1e9 * size)
    found = []
    for line in seen_lines(mesh, frame, within):
        for part in _parts(line - shift[:2], half, within):
            if float(np.hypot(*np.ptp(part, axis=0))) > _SHORTEST * size:
                found.append(part)
    return tuple(found)


def _parts(line: Floats, half: shapely.Geometry, tolerance: float) -> list[Floats]:
    """Return a line's parts on the side drawn, without points that the eye does not miss."""
    clipped = shapely.get_parts(shapely.intersection(shapely.LineString(line), half))
    whole = shapely.line_merge(shapely.multilinestrings(clipped[shapely.length(clipped) > 0.0]))
    return [
        shapely.get_coordinates(shapely.simplify(part, 0.5 * tolerance))
        for part in shapely.get_parts(whole)
    ]
