"""What drawings say of a relief: they show the smooth wall under it."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from sgb_core.bodies.body import Body
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.model import Document
from sgb_core.drawings.dimensioning import number_words


def relief_words(document: Document) -> str:
    """Return that the relief is left out, how far it goes and how wide all is with it.

    Empty where there is none. Raises SolidError where the body cannot be made.
    """
    relief = relief_of(document.appearance)
    if relief is None:
        return ""
    low, high = relief.reach
    parts = [f"raised by up to {number_words(high, document.unit)}"] if high > 0.0 else []
    parts += [f"sunk by up to {number_words(-low, document.unit)}"] if low < 0.0 else []
    widest = number_words(2.0 * _reach(document.body()), document.unit)
    return (
        f"Without the relief, {' and '.join(parts)} {document.unit}; with it the greatest "
        f"diameter is {widest} {document.unit}"
    )


@lru_cache(maxsize=8)
def _reach(body: Body) -> float:
    """Return how far from the axis a body reaches with its relief, in unit."""
    surface = body.surface
    up = surface.directions(np.array(0.0))[2]
    away = body.worked.mesh.positions - np.asarray(surface.placement.translation)
    across = away - np.outer(away @ up, up)
    return float(np.linalg.norm(across, axis=1).max())
