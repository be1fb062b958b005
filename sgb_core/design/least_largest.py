"""The least sum of squares, and the least largest, of many smooth functions within bounds.

For the largest each step is a linear programme within a trust region: min t with
|dᵢ + ∇dᵢ·x| ≤ t, |x| ≤ Δ. Where as many functions are equal as unknowns plus one, as in Chebyshev
approximation, it converges quadratically.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats

_MOST_STEPS = 30
# A step that promises less than this part of the largest value, or moves less, ends the search.
_LEAST_GAIN = 1e-5
_LEAST_REACH = 1e-10
_FIRST_REACH = 0.1
# Damping of the least squares: the first, the least, and what it is multiplied or divided by in at
# most so many tries. Unknowns that hardly count are damped as if they did.
_DAMPING, _LEAST_DAMPING, _STIFFER, _TRIES = 1e-3, 1e-12, 8.0, 8
_FLAT = 1e-9
# A step that gains a smaller part of the squares is quiet; after two of them the search ends.
_QUIET = 1e-4


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
    functions: Functions,
    start: Floats,
    stepped: Callable[[], None] = _unwatched,
    most: int = 60,
) -> Floats:
    """Return the vector of the least sum of squares near a start, after ``most`` steps at most.

    Levenberg and Marquardt; what the squares push against a bound is held there. ``stepped`` is
    called at every step; what it raises ends the search.
    """
    low, high = np.transpose(functions.bounds)
    vector, damping, quiet = np.clip(start, low, high), _DAMPING, 0
    values = functions.distances(vector)
    for _ in range(most):
        stepped()
        slopes, cost = functions.slopes(vector), float(values @ values)
        hessian, gradient = slopes.T @ slopes, slopes.T @ values
        scale = np.maximum(np.diag(hessian), _FLAT * float(np.diag(hessian).max()))
        free = ~((vector <= low) & (gradient > 0.0) | (vector >= high) & (gradient < 0.0))
        if cost == 0.0 or not gradient[free].any():
            break
        for _ in range(_TRIES):
            stiff = hessian + np.diag(damping * scale)
            moved = vector + _step(stiff, gradient, free, low - vector, high - vector)
            tried = functions.distances(moved)
            if float(tried @ tried) < cost:
                break
            damping *= _STIFFER
        else:
            break
        vector, values = moved, tried
        damping = max(damping / _STIFFER, _LEAST_DAMPING)
        quiet = quiet + 1 if cost - float(values @ values) <= _QUIET * cost else 0
        if quiet > 1:
            break
    return vector


def _step(
    stiff: Floats, gradient: Floats, free: NDArray[np.bool_], least: Floats, most: Floats
) -> Floats:
    """Return the step of the least gᵀx + ½ xᵀHx; what would leave its bounds stops at them."""
    step, free = np.zeros(len(gradient)), free.copy()
    while free.any():
        pull = -(gradient + stiff[:, ~free] @ step[~free])[free]
        wanted = np.linalg.solve(stiff[np.ix_(free, free)], pull)
        step[free] = np.clip(wanted, least[free], most[free])
        stopped = step[free] != wanted
        if not stopped.any():
            break
        free[free] = ~stopped
    return step


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
