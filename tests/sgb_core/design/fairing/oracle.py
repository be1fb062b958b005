"""Energies of a quartic in arbitrary precision, straight from their definitions."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import mpmath as mp
import numpy as np

from sgb_core.design.fairing.energy import Energy

Points = Sequence[Sequence[mp.mpf]]

EDGES = ("0", "1e-6", "1e-4", "1e-2", "0.1", "0.3", "0.5", "0.7", "0.9", "0.99", "0.9999", "1")


def exact(values: np.ndarray) -> list[list[mp.mpf]]:
    """Return an array (5, 2) as numbers of arbitrary precision, to the last bit."""
    return [[mp.mpf(float(value)) for value in row] for row in values]


def energy(kind: Energy, points: Points, edges: Sequence[str] = EDGES) -> mp.mpf:
    """Return ∫ κ² dl, ∫ (dκ/dl)² dl or ∫ (κm² + κp²) r dl of a quartic Bézier curve."""
    derivatives = [points]
    for order in range(3):
        last = derivatives[-1]
        derivatives.append(
            [[(4 - order) * (q[k] - p[k]) for k in range(2)] for p, q in pairwise(last)]
        )

    def at(order: int, s: mp.mpf) -> list[mp.mpf]:
        row = derivatives[order]
        degree = len(row) - 1
        weights = [mp.binomial(degree, k) * s**k * (1 - s) ** (degree - k) for k in range(len(row))]
        return [mp.fsum(w * p[k] for w, p in zip(weights, row, strict=True)) for k in range(2)]

    def density(s: mp.mpf) -> mp.mpf:
        (r, _), v, a, j = (at(order, s) for order in range(4))
        speed = mp.hypot(*v)
        turn = v[0] * a[1] - v[1] * a[0]
        curvature = turn / speed**3
        if kind is Energy.BENDING:
            return curvature**2 * speed
        if kind is Energy.VARIATION:
            rate = (v[0] * j[1] - v[1] * j[0]) / speed**3
            rate -= 3 * turn * (v[0] * a[0] + v[1] * a[1]) / speed**5
            return (rate / speed) ** 2 * speed
        around = v[1] / (r * speed)
        return (curvature**2 + around**2) * abs(r) * speed

    return mp.quad(density, [mp.mpf(edge) for edge in edges])
