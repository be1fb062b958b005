"""Where the laws of a surface are smooth in the angle, for quadrature and searches."""

from __future__ import annotations

from math import ceil, pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import LawKind


def angle_edges(surface: RevolutionSurface, bare: bool = False) -> Floats:
    """Return angles from 0 to the sweep between which every law is smooth, in radians.

    Breaks of the paper's law and keyframes, and the extremes of cosines; unless ``bare`` also
    enough others that 24 Gauss points between them integrate a law's cube to rounding.
    """
    found: list[Floats] = [np.linspace(0.0, 2.0 * pi, 2 if bare else 5)]
    for law in surface.laws:
        found.append(np.asarray(law.breaks))
        if law.kind in (LawKind.COSINE, LawKind.RAISED_COSINE):
            count = law.count if law.kind is LawKind.COSINE else 1
            step = 1 if bare else ceil(count / 16)
            found.append(np.arange(0.0, 2.0 * count, step) * (pi / count))
    edges = np.unique(np.concatenate(found))
    edges = np.concatenate([[0.0], edges[(edges > 0.0) & (edges < surface.sweep)], [surface.sweep]])
    # Two that differ by rounding alone would make a panel of no width.
    return np.asarray(edges[np.append(np.diff(edges) > 1e-12, True)])
