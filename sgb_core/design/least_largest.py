"""The least largest of many smooth functions, by linear programmes within a trust region.

Sequential linear programming: each step solves min t with |dᵢ + ∇dᵢ·x| ≤ t, |x| ≤ Δ. Where as many
functions are equal as unknowns plus one, as in Chebyshev approximation, it converges quadratically.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np

from sgb_core.arrays import Floats

_MOST_STEPS = 30
# A step that promises less than this part of the largest value, or moves less, ends the search.
_LEAST_GAIN = 1e-5
_LEAST_REACH = 1e-10
_FIRST_REACH = 0.1


class Functions(Protocol):
    """Smooth functions of a vector within bounds, one for each sample."""

    bounds: list[tuple[float, float]]

    def distances(self, vector: Floats) -> Floats:
        """Return the values, shape (samples,)."""
        ...

    def slopes(self, vector: Floats) -> Floats:
        """Return their derivatives, shape (samples, unknowns)."""
        ...


def _unwatched() -> None:
    """Let a search run to its end."""


def least_squares(
    functions: Functions, start: Floats, stepped: Callable[[], None] = _unwatched
) -> Floats:
    """Return the vector of the least sum of squares near a start.

    ``stepped`` is called at every step; what it raises ends the search.
    """
    # Imported late: only fitting needs it, and it takes a while to load.
    from scipy.optimize import least_squares as search

    low, high = np.transpose(functions.bounds)
    inside = np.clip(start, low + 1e-9, high - 1e-9)

    def slopes(vector: Floats) -> Floats:
        stepped()
        return functions.slopes(vector)

    found = search(functions.distances, inside, slopes, bounds=(low, high), max_nfev=60)
    return np.asarray(found.x)


def least_largest(
    functions: Functions, start: Floats, stepped: Callable[[], None] = _unwatched
) -> Floats:
    """Return the vector of the least largest value without its sign near a start.

    ``stepped`` is called at every step; what it raises ends the search.
    """
    from scipy.optimize import linprog

    low, high = np.transpose(functions.bounds)
    vector, reach = np.clip(start, low, high), _FIRST_REACH
    values = functions.distances(vector)
    cost = np.append(np.zeros(len(vector)), 1.0)
    slopes: Floats | None = None
    for _ in range(_MOST_STEPS):
        largest = float(np.abs(values).max())
        if slopes is None:
            stepped()
            slopes = functions.slopes(vector)
        level = -np.ones((len(slopes), 1))
        rows = np.block([[slopes, level], [-slopes, level]])
        least, most = np.maximum(low - vector, -reach), np.minimum(high - vector, reach)
        found = linprog(
            cost / largest if largest else cost,
            A_ub=rows / (largest or 1.0),
            b_ub=np.concatenate([-values, values]) / (largest or 1.0),
            bounds=[*zip(least, most, strict=True), (0.0, None)],
            method="highs",
        )
        if found.x is None:
            break
        promised = largest - float(found.x[-1])
        if promised <= _LEAST_GAIN * largest:
            break
        moved = np.clip(vector + found.x[:-1], low, high)
        tried = functions.distances(moved)
        gained = largest - float(np.abs(tried).max())
        if gained > 0.1 * promised:
            vector, values, slopes = moved, tried, None
            reach *= 2.0 if gained > 0.7 * promised else 1.0
        else:
            reach *= 0.25
        if reach < _LEAST_REACH:
            break
    return vector
