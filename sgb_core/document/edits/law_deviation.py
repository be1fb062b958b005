"""How far a surface with laws over the angle moves when segments are divided or merged."""

from __future__ import annotations

from math import pi

import numpy as np

from sgb_core.curves.polyline import farthest
from sgb_core.document.model import Document
from sgb_core.surfaces.sections import Sections

# Angles of a full turn and points of a section at which the sections are compared.
ANGLES = 48
POINTS = 129


def divided_deviation(document: Document, divided: Document, index: int, s: float) -> float:
    """Return the largest distance, over all angles, between a segment and its two parts.

    Points with the same parameter are compared: s·u with u of the first part, and so on.
    """
    u = np.linspace(0.0, 1.0, POINTS)
    whole, parts = _sections(document), _sections(divided)
    pieces = (
        (whole.on(s * u)[:, index], parts.on(u)[:, index]),
        (whole.on(s + (1.0 - s) * u)[:, index], parts.on(u)[:, index + 1]),
    )
    return max(float(np.hypot(*np.moveaxis(a - b, -1, 0)).max()) for a, b in pieces)


def merged_deviation(
    document: Document, pair: tuple[int, int], merged: Document, index: int
) -> float:
    """Return the largest distance, over all angles, from two segments to the one in their place.

    Distances run from points of the pair to a fine polyline of the merged segment.
    """
    u = np.linspace(0.0, 1.0, POINTS)
    old, new = _sections(document), _sections(merged)
    line = new[:, index].on(np.linspace(0.0, 1.0, 4 * POINTS))
    points = np.concatenate([old[:, k].on(u) for k in pair], axis=1)
    return max(farthest(points[k], line[k]) for k in range(ANGLES))


def _sections(document: Document) -> Sections:
    return document.surface.sections(np.linspace(0.0, 2.0 * pi, ANGLES, endpoint=False))
