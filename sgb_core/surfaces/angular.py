"""Where the laws of a surface are smooth in the angle, for quadrature and searches."""

from __future__ import annotations

from itertools import combinations_with_replacement
from math import ceil, comb, gcd, pi

import numpy as np

from sgb_core.arrays import Floats, distinct
from sgb_core.curves.nodes import panels
from sgb_core.surfaces.revolution import RevolutionSurface

# Half waves of a law between two edges at most, so that the points between follow them.
_MOST_EXTREMES = 2


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
            step = 1 if bare else min(ceil(count / 16), _MOST_EXTREMES)
            found.append(np.arange(0.0, 2.0 * count, step) * (pi / count))
    edges = distinct(*found)
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


# As many angles at most stand for all, if that gives a degree of at least 1; for one law's f
# no higher degree than 20 is of use.
_MOST_ANGLES, _HIGHEST = 60, 20


def representative_angles(surface: RevolutionSurface, count: int) -> tuple[Floats, Floats]:
    """Return few angles from the start, and positive weights that sum to the sweep.

    Composite Gauss of ``count`` points between breaks and extremes of the laws, of which as many
    are kept as there are polynomials of the laws' f up to some degree, which the weights
    integrate alike: whatever the number of waves and keys, what depends on a law's f smoothly is
    integrated as by so many Gauss points in f.
    """
    theta, weights = panels(angle_edges(surface, bare=True), count)
    shares = np.array([law.fraction(theta) for law in surface.laws if law.start != law.end])
    shares = np.unique(np.round(shares, 12), axis=0) if len(shares) else np.zeros((1, len(theta)))
    # What a wave repeats is one angle.
    _, first, number = np.unique(shares, axis=1, return_index=True, return_inverse=True)
    weights = np.bincount(number.ravel(), weights, len(first)).astype(np.float64)
    order = np.argsort(first)
    theta, weights, shares = theta[first[order]], weights[order], shares[:, first[order]]
    low, high = shares.min(axis=1), shares.max(axis=1)
    moving = shares[high > low]
    degree = _degree(len(moving))
    if comb(len(moving) + degree, degree) >= len(theta):
        return theta, weights
    span = (high - low)[high > low, None]
    rows = _polynomials(2.0 * (moving - low[high > low, None]) / span - 1.0, degree)
    kept = _fewer(rows, weights)
    return theta[kept > 0.0], kept[kept > 0.0]


def _degree(variables: int) -> int:
    """Return the highest degree of which polynomials are few enough."""
    degree = 1
    while degree < _HIGHEST and comb(variables + degree + 1, variables) <= _MOST_ANGLES:
        degree += 1
    return degree


def _polynomials(x: Floats, degree: int) -> Floats:
    """Return the products of Chebyshev polynomials of total degree up to ``degree``, (K, k).

    ``x`` has shape (variables, k), in [−1, 1].
    """
    single = np.cos(np.arange(degree + 1)[:, None, None] * np.arccos(np.clip(x, -1.0, 1.0)))
    rows = []
    for chosen in combinations_with_replacement(range(len(x) + 1), degree):
        # Variable 0 stands for 1.
        powers = np.bincount(chosen, minlength=len(x) + 1)[1:]
        rows.append(np.prod([single[power, k] for k, power in enumerate(powers)], axis=0))
    return np.array(rows)


def _fewer(rows: Floats, weights: Floats) -> Floats:
    """Return weights ≥ 0, most of them 0, that integrate ``rows`` (K, k) like the given ones.

    There are such with at most K above 0 (Tchakaloff, 1957).
    """
    # Imported late: it takes longer to load than all the rest of the core.
    from scipy.optimize import nnls

    moments = rows @ weights
    try:
        found, off = nnls(rows, moments, maxiter=30 * len(rows))
    except RuntimeError:
        return weights
    return np.asarray(found) if off <= 1e-12 * float(weights.sum()) else weights
