"""A few steps of Newton's method along the equations: for searches that follow a hand.

Much cheaper than the sequential quadratic programming of :mod:`sgb_core.design.demands.sqp`, and
without its certainty: no line search, a fixed number of steps, then a return to the equations.
Where it ends is to be judged by the caller.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.design.demands.sqp import Model, Problem

Flags = NDArray[np.bool_]
# No unknown goes farther in one step, and a step that goes no farther is the last.
_LONGEST = 0.3
_SHORT = 1e-3
_ACTIVE_ROUNDS = 12
_RETURNS = 8
EXACT = 1e-11
_RANK = 1e-10


def follow(
    problem: Problem, equations: Callable[[Floats], tuple[Floats, Floats]], y: Floats, steps: int
) -> tuple[Floats, float]:
    """Return where ``steps`` from ``y`` lead, and the largest of the residuals there."""
    low, high = problem.unknowns.low, problem.unknowns.high
    multipliers = np.zeros(len(equations(y)[0]))
    for _ in range(steps):
        here = problem.expand(y, multipliers)
        if not np.isfinite(here.value) or not np.isfinite(here.residual).all():
            return y, np.inf
        step, multipliers = _step(here, low - y, high - y)
        longest = float(np.abs(step).max(initial=0.0))
        step *= min(1.0, _LONGEST / longest) if longest else 1.0
        y = np.clip(y + step, low, high)
        if longest <= _SHORT:
            break
    best, least = y, np.inf
    for _ in range(_RETURNS):
        missed, slope = equations(y)
        size = float(np.abs(missed).max(initial=0.0))
        if not size < least:
            break
        best, least = y, size
        if least <= EXACT:
            break
        free = (y > low) & (y < high)
        back = np.zeros(len(y))
        back[free] = np.linalg.lstsq(slope[:, free], missed, rcond=None)[0]
        y = np.clip(y - back, low, high)
    return best, least


def _step(here: Model, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    """Return the least of the model on the linearised equations, within bounds, and multipliers.

    By an active set of unknowns at their bounds: those that would leave them stay there, and go
    free again where the slope leads inside.
    """
    step, free = np.zeros(len(low)), np.ones(len(low), dtype=bool)
    multipliers = np.zeros(len(here.slope))
    for _ in range(_ACTIVE_ROUNDS):
        part = _least(here, step, free)
        outside = free & ((part < low) | (part > high))
        step = np.clip(part, low, high)
        free &= ~outside
        slope = here.gradient + here.hessian @ step
        if len(here.slope) and free.any():
            found = np.linalg.lstsq(here.slope[:, free].T, -slope[free], rcond=None)[0]
            multipliers = np.asarray(found)
        if outside.any():
            continue
        reduced = slope + here.slope.T @ multipliers
        inward = np.where(step <= low, -reduced, reduced)
        inward[free] = 0.0
        most = int(np.argmax(inward))
        if inward[most] <= 0.0:
            break
        free[most] = True
    return step, multipliers


def _least(here: Model, step: Floats, free: Flags) -> Floats:
    """Return the least on the linearised equations by the free unknowns, the others as they are.

    Where the model is not convex along the equations the sizes of its eigenvalues count.
    """
    part = step.copy()
    if not free.any():
        return part
    slope = here.slope[:, free]
    part[free] = 0.0
    if len(slope):
        wanted = -here.residual - here.slope @ part
        part[free] = np.linalg.lstsq(slope, wanted, rcond=None)[0]
    pull = (here.gradient + here.hessian @ part)[free]
    along = _null_space(slope, int(free.sum()))
    values, vectors = np.linalg.eigh(along.T @ here.hessian[np.ix_(free, free)] @ along)
    sizes = np.abs(values)
    sizes = np.maximum(sizes, _RANK * sizes.max(initial=1e-300))
    part[free] -= along @ (vectors @ ((vectors.T @ (along.T @ pull)) / sizes))
    return part


def _null_space(slope: Floats, count: int) -> Floats:
    """Return directions (count, k) along which no equation of ``slope`` (m, count) changes."""
    if len(slope) == 0:
        return np.eye(count)
    _, sizes, rows = np.linalg.svd(slope)
    rank = int((sizes > _RANK * sizes.max(initial=0.0)).sum())
    return np.asarray(rows[rank:].T)
