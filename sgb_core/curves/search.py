"""Searches on an interval: where a function changes its sign, and where it is least.

SciPy's would serve, but take longer to load than all the rest of the core, and ask for one place
at a time. The roots of polynomials, which need no bracket, are in the module of that name.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sgb_core.arrays import Floats

# Enough to reach the rounding of a minimum, about the square root of that of a float.
_GOLDEN_STEPS = 36
_GOLDEN = 0.5 * (5.0**0.5 - 1.0)


def sign_change(function: Callable[[Floats], Floats], low: float, high: float) -> float:
    """Return where a function of (k,) places changes its sign between ``low`` and ``high``.

    Each of ten calls finds the sixty-fourth part of the interval in which it does.
    """
    for _ in range(10):
        places = np.linspace(low, high, 65)
        negative = function(places) < 0.0
        first = int(np.argmax(negative != negative[0]))
        low, high = float(places[max(first - 1, 0)]), float(places[first or -1])
    return (low + high) / 2.0


def least(function: Callable[[float], float], low: float, middle: float, high: float) -> float:
    """Return where a function is least between ``low`` and ``high``, by the golden section.

    ``middle`` is the best place known so far; it is returned where nothing better is found.
    """
    best, value = middle, function(middle)
    left, right = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
    at_left, at_right = function(left), function(right)
    for _ in range(_GOLDEN_STEPS):
        if at_left <= at_right:
            high, right, at_right = right, left, at_left
            left = high - _GOLDEN * (high - low)
            at_left = function(left)
        else:
            low, left, at_left = left, right, at_right
            right = low + _GOLDEN * (high - low)
            at_right = function(right)
    for place, found in ((left, at_left), (right, at_right)):
        if found < value:
            best, value = place, found
    return best
