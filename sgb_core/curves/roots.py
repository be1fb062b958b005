"""Polynomials in Bernstein form on [0, 1]: values, real roots, extremes, products.

Roots are found without dividing by a lead, so that none runs off to infinity.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import comb

import numpy as np

from sgb_core.arrays import Floats, Ints

# A polynomial smaller than this part of its largest coefficient is zero up to rounding.
_ROUNDING = 1e-14
# Bisection alone halves the bracket below the spacing of floats in this many steps.
_MOST_STEPS = 64


def evaluate(coefficients: Sequence[float], s: float) -> float:
    """Return the polynomial with these Bernstein coefficients at ``s`` (de Casteljau)."""
    row = list(coefficients)
    r = 1.0 - s
    for level in range(len(row) - 1, 0, -1):
        for k in range(level):
            row[k] = r * row[k] + s * row[k + 1]
    return row[0]


def real_roots(coefficients: Sequence[float]) -> list[float]:
    """Return the roots in [0, 1] of a polynomial in Bernstein form, ascending.

    Between two neighbouring extrema the polynomial is monotone and has at most one root, which
    a bracket closes in on; the extrema are the roots of the derivative, and so on down to a
    straight line. An extremum that touches zero up to rounding counts as one root. A polynomial
    that is zero throughout has none.
    """
    scale = max(map(abs, coefficients))
    if scale == 0.0:
        return []
    if all(value > 0.0 for value in coefficients) or all(value < 0.0 for value in coefficients):
        return []  # The polynomial lies in the hull of its coefficients.
    if len(coefficients) == 1:
        return []
    if len(coefficients) == 2:
        low, high = coefficients
        return [low / (low - high)] if low != high else []
    slopes = [high - low for low, high in pairwise(coefficients)]
    marks = [0.0, *real_roots(slopes), 1.0]
    values = [evaluate(coefficients, mark) for mark in marks]
    tolerance = _ROUNDING * scale
    found: list[float] = []
    for mark, value in zip(marks, values, strict=True):
        if abs(value) <= tolerance:
            found.append(mark)
    for k in range(len(marks) - 1):
        low, high = values[k], values[k + 1]
        if abs(low) > tolerance and abs(high) > tolerance and (low < 0.0) != (high < 0.0):
            found.append(_bracketed(coefficients, slopes, marks[k], marks[k + 1], low))
    return sorted(set(found))


def roots_of_each(coefficients: Floats) -> tuple[Floats, Ints]:
    """Return the roots of polynomials, shape (n, degree + 1), and whose they are, (m,) each."""
    signs = np.sign(coefficients)
    # Of one sign a polynomial lies off zero as its coefficients do.
    may = np.flatnonzero(((signs != signs[:, :1]) | (signs == 0.0)).any(axis=1))
    roots = [real_roots(row) for row in coefficients[may].tolist()]
    flat = [root for found in roots for root in found]
    return np.array(flat), np.repeat(may, [len(found) for found in roots])


def extremes(coefficients: Sequence[float]) -> tuple[float, float]:
    """Return the least and greatest value on [0, 1] of a polynomial in Bernstein form."""
    low = min(coefficients[0], coefficients[-1])
    high = max(coefficients[0], coefficients[-1])
    if low <= min(coefficients) and max(coefficients) <= high:
        return low, high  # The hull of the coefficients is reached by the ends themselves.
    slopes = [after - before for before, after in pairwise(coefficients)]
    values = [low, high, *(evaluate(coefficients, s) for s in real_roots(slopes))]
    return min(values), max(values)


def extremes_of_all(coefficients: Floats) -> tuple[float, float]:
    """Return the least and greatest value on [0, 1] of polynomials, shape (n, degree + 1)."""
    ends = coefficients[:, [0, -1]]
    low, high = float(ends.min()), float(ends.max())
    # Each lies in the hull of its coefficients: few can reach beyond all the ends.
    beyond = (coefficients.min(axis=1) < low) | (coefficients.max(axis=1) > high)
    for row in coefficients[beyond].tolist():
        least, most = extremes(row)
        low, high = min(low, least), max(high, most)
    return low, high


def dot(first: Floats, second: Floats) -> list[float]:
    """Return the Bernstein coefficients of the scalar product of two Bézier curves.

    Shapes (m + 1, 2) and (n + 1, 2); Bᵢᵐ Bⱼⁿ = C(m,i) C(n,j) / C(m+n,i+j) · Bᵢ₊ⱼᵐ⁺ⁿ.
    """
    m, n = len(first) - 1, len(second) - 1
    products = first @ second.T
    value = np.zeros(m + n + 1)
    for i in range(m + 1):
        for j in range(n + 1):
            value[i + j] += comb(m, i) * comb(n, j) / comb(m + n, i + j) * products[i, j]
    return [float(v) for v in value]


def slow_points(quartic: Floats) -> list[float]:
    """Return the s in [0, 1] where |L'| of a quartic, shape (5, 2), may be least: L'·L'' = 0."""
    slopes = np.diff(quartic, axis=0)
    return real_roots(dot(slopes, np.diff(slopes, axis=0)))


def _bracketed(
    coefficients: Sequence[float], slopes: Sequence[float], low: float, high: float, at_low: float
) -> float:
    """Return the root between two signs: Newton's method, kept inside a shrinking bracket."""
    degree = len(coefficients) - 1
    s = 0.5 * (low + high)
    for _ in range(_MOST_STEPS):
        value = evaluate(coefficients, s)
        if value == 0.0:
            return s
        if (value < 0.0) == (at_low < 0.0):
            low = s
        else:
            high = s
        slope = degree * evaluate(slopes, s)
        following = s - value / slope if slope != 0.0 else low
        if not low < following < high:
            following = 0.5 * (low + high)
        if following in (low, high) or abs(following - s) <= 1e-17:
            return following
        s = following
    return s
