"""Real roots of polynomials in Bernstein form on [0, 1], found without dividing by a lead."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

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
