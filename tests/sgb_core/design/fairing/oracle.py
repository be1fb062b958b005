"""Energies of a quartic in arbitrary precision, straight from their definitions."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import mpmath as mp
import numpy as np
from mpmath.calculus.quadrature import GaussLegendre

from sgb_core.design.fairing.energy import Energy

Points = Sequence[Sequence[mp.mpf]]

EDGES = ("0", "1e-6", "1e-4", "1e-2", "0.1", "0.3", "0.5", "0.7", "0.9", "0.99", "0.9999", "1")
# Twenty-four nodes a panel.
_RULE, _DEGREE = GaussLegendre(mp.mp), 4


def exact(values: np.ndarray) -> list[list[mp.mpf]]:
    """Return an array (5, 2) as numbers of arbitrary precision, to the last bit."""
    return [[mp.mpf(float(value)) for value in row] for row in values]


def energy(kind: Energy, points: Points, edges: Sequence[str] = EDGES) -> mp.mpf:
    """Return ∫ κ² dl, ∫ (dκ/dl)² dl or ∫ (κm² + κp²) r dl of a quartic Bézier curve."""
    r, h = (_derivatives(_power([point[k] for point in points])) for k in range(2))

    def density(s: mp.mpf) -> mp.mpf:
        (x, v0, a0, j0), (_, v1, a1, j1) = ([_value(f, s) for f in row] for row in (r, h))
        speed = mp.hypot(v0, v1)
        turn = v0 * a1 - v1 * a0
        curvature = turn / speed**3
        if kind is Energy.BENDING:
            return curvature**2 * speed
        if kind is Energy.VARIATION:
            rate = (v0 * j1 - v1 * j0) / speed**3 - 3 * turn * (v0 * a0 + v1 * a1) / speed**5
            return rate**2 / speed
        return (curvature**2 + (v1 / (x * speed)) ** 2) * abs(x) * speed

    nodes = _RULE.get_nodes(mp.mpf(-1), mp.mpf(1), _DEGREE, mp.mp.prec)
    total = mp.mpf(0)
    for low, high in pairwise(mp.mpf(edge) for edge in edges):
        half = (high - low) / 2
        total += half * mp.fsum(w * density(low + half * (1 + x)) for x, w in nodes)
    return total


def _power(b: Sequence[mp.mpf]) -> list[mp.mpf]:
    """Return the coefficients of a quartic in Bernstein form, the highest power first."""
    return [
        b[4] - 4 * b[3] + 6 * b[2] - 4 * b[1] + b[0],
        4 * (b[3] - 3 * b[2] + 3 * b[1] - b[0]),
        6 * (b[2] - 2 * b[1] + b[0]),
        4 * (b[1] - b[0]),
        b[0],
    ]


def _value(coefficients: Sequence[mp.mpf], s: mp.mpf) -> mp.mpf:
    total = mp.mpf(0)
    for coefficient in coefficients:
        total = total * s + coefficient
    return total


def _derivatives(coefficients: list[mp.mpf]) -> list[list[mp.mpf]]:
    """Return a polynomial and its first three derivatives."""
    found = [coefficients]
    for _ in range(3):
        last = found[-1]
        found.append([(len(last) - 1 - k) * c for k, c in enumerate(last[:-1])])
    return found
