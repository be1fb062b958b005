"""Where the laws of a surface are smooth in the angle, for quadrature and searches."""

from __future__ import annotations

from math import ceil, gcd, pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.revolution import RevolutionSurface


def angle_edges(surface: RevolutionSurface, bare: bool = False) -> Floats:
    """Return angles from 0 to the sweep between which every law is smooth, in radians.

    Breaks of the laws and the extremes of their waves; unless ``bare`` also
    enough others that 24 Gauss points between them integrate a law's cube to rounding.
    """
    found: list[Floats] = [np.linspace(0.0, 2.0 * pi, 2 if bare else 5)]
    for law in surface.laws:
        found.append(np.asarray(law.breaks))
        count = law.waves
        if count:
            step = 1 if bare else ceil(count / 16)
            found.append(np.arange(0.0, 2.0 * count, step) * (pi / count))
    edges = np.unique(np.concatenate(found))
    # Two that differ by rounding alone would make a panel of no width.
    inside = edges[(edges > 1e-12) & (edges < surface.sweep - 1e-12)]
    inside = inside[np.append(np.diff(inside) > 1e-12, True)] if len(inside) else inside
    return np.concatenate([[0.0], inside, [surface.sweep]])


def different_angles(surface: RevolutionSurface, theta: Floats) -> tuple[Floats, float, float]:
    """Return the angles about which the surface looks different, and between which it is whole.

    ``theta`` count from the start. Laws with waves repeat themselves n times in a turn and are
    mirrored at their extremes: a full turn is made of wedges from 0 to π/n, into which the
    angles are folded. What is nearest to a point of a wedge lies in the same wedge, since mirror
    images on the other side of its planes are further away. Without such wedges the bounds are
    those of the sweep, infinite for a full turn.
    """
    if not surface.is_full_turn:
        return theta, 0.0, surface.sweep
    counts = [law.waves for law in surface.laws]
    if 0 in counts:
        return theta, -np.inf, np.inf
    wedge = pi / (gcd(*counts) or 1)
    turned = np.mod(theta, 2.0 * wedge)
    folded = np.sort(np.minimum(turned, 2.0 * wedge - turned))
    return folded[np.append(True, np.diff(folded) > 1e-9)], 0.0, wedge
