"""A single unknown looked for along its whole range: where a miss vanishes, or is least."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import isnan

from sgb_core.arrays import Floats

_EXACT = 1e-15
# Halvings by which the end of what can be measured is found.
_HALVINGS = 50


def least_along(places: Floats, apart: Callable[[float], float]) -> float:
    """Return the place nearest to 0 where ``apart`` vanishes, or where it is least in size.

    ``places`` (n,) rise; between neighbours with opposite signs Brent's method finds the zero.
    Where ``apart`` is not a number there is nothing to be measured: up to there it is looked too.
    """
    from scipy.optimize import brentq

    known = [(at, apart(at)) for at in places.tolist()]
    ends = [
        _end(one[0], other[0], apart) if isnan(other[1]) else _end(other[0], one[0], apart)
        for one, other in pairwise(known)
        if isnan(one[1]) != isnan(other[1])
    ]
    known = sorted(known + [(at, apart(at)) for at in ends])
    crossings = [(low, high) for (low, one), (high, other) in pairwise(known) if one * other <= 0.0]
    if crossings:
        low, high = min(crossings, key=lambda ends: max(0.0, ends[0], -ends[1]))
        return float(brentq(apart, low, high, xtol=_EXACT, rtol=8.9e-16))
    measured = [each for each in known if not isnan(each[1])]
    return min(measured, key=lambda each: abs(each[1]), default=(0.0, 0.0))[0]


def _end(inside: float, outside: float, apart: Callable[[float], float]) -> float:
    """Return the last place from inside towards outside at which there is a measure."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (inside + outside)
        if isnan(apart(middle)):
            outside = middle
        else:
            inside = middle
    return inside
