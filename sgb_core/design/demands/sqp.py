"""Sequential quadratic programming: least of a function under equations and bounds.

Each step minimises the Lagrange function's quadratic model, with the linearised equations held by
an augmented Lagrangian: where they exclude each other, the step meets them as well as it can
instead of failing. The model is convex on the free unknowns, and its bounds are met by an active
set.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.design.demands.unknowns import Unknowns
from sgb_core.interruption import checkpoint
from sgb_core.values import dataclass

Flags = NDArray[np.bool_]
# How much stiffer the equations are than the function in one step's model.
_STIFFNESS = 1e5
_MULTIPLIER_ROUNDS = 3
# An equation whose squared slope is below this is as good as flat: no step meets it.
_FLAT = 1e-12
_LARGEST = 1e9
_ARMIJO = 1e-4
_SHORTER = 0.5
_SHORTEST = 1e-6
_MOST_ACTIVE_SET_ROUNDS = 60
# A round that leaves more than the first part of what was missed, and more than the second, comes
# no nearer to the equations; so many in a row never will.
_GAINS, _AWAY, _MOST_IDLE = 0.9, 1e-5, 8
# Of a convex quadratic, Newton's step gains half of what the slope promises; a step that gains
# more than this part is tried at up to so many times its length.
_STEEP = 0.6
_FARTHEST = 16.0


@dataclass(frozen=True, slots=True)
class Model:
    """A problem expanded at one place, of m unknowns and k equations.

    ``value`` (infinite where there is none), ``gradient`` (m,) and ``hessian`` (m, m) are the
    function's; ``residual`` (k,) and ``slope`` (k, m) the equations'.
    """

    value: float
    gradient: Floats
    hessian: Floats
    residual: Floats
    slope: Floats


class Problem(Protocol):
    """Least ``value`` where all residuals vanish and y stays between the unknowns' bounds."""

    @property
    def unknowns(self) -> Unknowns:
        """What may change, between which bounds."""
        ...

    def expand(self, y: Floats, multipliers: Floats) -> Model:
        """Return the problem at y; the Hessian includes Σ multipliers · equations' where known."""
        ...

    def values(self, y: Floats) -> tuple[float, Floats]:
        """Return the function and the residuals at y alone."""
        ...


@dataclass(frozen=True, slots=True)
class Solution:
    """Where the search ended: ``met`` says that all equations hold there."""

    y: Floats
    value: float
    residual: Floats
    met: bool


def minimise(
    problem: Problem,
    y: Floats,
    *,
    rounds: int = 60,
    precision: float = 1e-9,
    exactness: float = 1e-12,
) -> Solution:
    """Return the least of a problem near ``y``.

    The search ends where a step changes no unknown by more than ``precision`` and the residuals
    are below ``exactness``, or where it can go no further.
    """
    y = np.clip(y, problem.unknowns.low, problem.unknowns.high)
    multipliers = np.zeros(len(problem.values(y)[1]))
    weight, least, idle = 0.0, np.inf, 0
    for _ in range(rounds):
        checkpoint()
        here = problem.expand(y, multipliers)
        step, multipliers = _step(
            here, multipliers, problem.unknowns.low - y, problem.unknowns.high - y
        )
        missed = float(np.abs(here.residual).max(initial=0.0))
        if float(np.abs(step).max(initial=0.0)) <= precision and missed <= exactness:
            break
        idle = idle + 1 if missed > max(_GAINS * least, _AWAY) else 0
        least = min(least, missed)
        if idle > _MOST_IDLE:
            # Equations that exclude each other: no round comes nearer to all of them.
            break
        # Powell's rule: a weight that an early step asked for does not cramp all later ones.
        largest = 1.5 * float(np.abs(multipliers).max(initial=0.0))
        weight = max(largest, 0.5 * (weight + largest))
        moved = _line_search(problem, y, here, step, weight)
        if moved is None:
            break
        y = moved
    value, residual = problem.values(y)
    y = restore(problem, y, exactness)
    value, residual = problem.values(y)
    return Solution(y, value, residual, bool(np.abs(residual).max(initial=0.0) <= 1e-9))


def restore(problem: Problem, y: Floats, exactness: float, rounds: int = 12) -> Floats:
    """Return the place near y where the equations hold, by Newton's method of least steps."""
    best, least = y, np.inf
    for _ in range(rounds):
        here = problem.expand(y, np.zeros(len(problem.values(y)[1])))
        missed = float(np.abs(here.residual).max(initial=0.0))
        if missed >= least:
            break
        best, least = y, missed
        if missed <= exactness:
            break
        flat = Model(0.0, np.zeros(len(y)), np.eye(len(y)), here.residual, here.slope)
        step, _ = _step(
            flat, np.zeros(len(here.residual)), problem.unknowns.low - y, problem.unknowns.high - y
        )
        y = np.clip(y + step, problem.unknowns.low, problem.unknowns.high)
    return best


def _step(here: Model, multipliers: Floats, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    """Return the step of one model and the multipliers after it."""
    scale = float(np.abs(here.hessian).max(initial=0.0)) or 1.0
    squares = (here.slope**2).sum(axis=1)
    stiff = _STIFFNESS * scale / np.maximum(squares, _FLAT)
    stiffened = here.slope * stiff[:, None]
    matrix = here.hessian + stiffened.T @ here.slope
    step = np.zeros(len(low))
    for _ in range(_MULTIPLIER_ROUNDS if len(multipliers) else 1):
        pull = here.gradient + here.slope.T @ multipliers + stiffened.T @ here.residual
        step = box_minimum(matrix, pull, low, high, step)
        multipliers = multipliers + stiff * (here.residual + here.slope @ step)
        # Those of equations that exclude each other grow without bound.
        multipliers = np.clip(multipliers, -_LARGEST, _LARGEST)
    return step, multipliers


def box_minimum(matrix: Floats, pull: Floats, low: Floats, high: Floats, start: Floats) -> Floats:
    """Return the p in a box with the least ½ p·A p + pull·p, by an active set.

    Where A is not positive definite on the free unknowns the sizes of all its eigenvalues count.
    """
    p = np.clip(start, low, high)
    solved, convex = np.zeros(len(p), dtype=bool), False
    for _ in range(_MOST_ACTIVE_SET_ROUNDS):
        slope = matrix @ p + pull
        free = ~(((p <= low) & (slope > 0.0)) | ((p >= high) & (slope < 0.0)))
        # Where the last step was whole, all that is left on the same unknowns is rounding.
        if not (free & ~solved).any():
            break
        try:
            move, inwards = _newton(matrix, slope, free, (p <= low, p >= high))
        except np.linalg.LinAlgError:
            if convex:
                break
            # Once for all rounds: what is convex as a whole is so on all its parts.
            matrix, convex, solved = _convex(matrix), True, np.zeros(len(p), dtype=bool)
            continue
        if float(np.abs(move).max()) <= 1e-15:
            # All that is left leads off bounds: the steepest first.
            steepest = int(np.abs(np.where(free & ~inwards, slope, 0.0)).argmax())
            move[steepest] = -slope[steepest] / matrix[steepest, steepest]
            if abs(move[steepest]) <= 1e-15:
                break
        target = np.clip(p + move, low, high)
        change = target - p
        if change @ (slope + 0.5 * (matrix @ change)) > 0.0:
            # Cut off at several bounds it leads up: then only as far as the first of them.
            way = np.where(move > 0.0, high - p, low - p)
            part = min(1.0, float((way[move != 0.0] / move[move != 0.0]).min()))
            target = np.clip(p + part * move, low, high)
        if np.abs(target - p).max() <= 1e-16:
            break
        whole = np.array_equal(target, p + move)
        solved = inwards & whole
        p = target
    return p


def _newton(
    matrix: Floats, slope: Floats, free: Flags, at: tuple[Flags, Flags]
) -> tuple[Floats, Flags]:
    """Return the step to the bottom on the free unknowns, and those that it moves.

    Unknowns at their low and high bounds, ``at``, are held where it would lead beyond. Raises
    LinAlgError where there is no bottom.
    """
    while True:
        move = np.zeros(len(slope))
        lower = np.linalg.cholesky(matrix[np.ix_(free, free)])
        move[free] = -np.linalg.solve(lower.T, np.linalg.solve(lower, slope[free]))
        beyond = (at[0] & (move < 0.0)) | (at[1] & (move > 0.0))
        if not beyond.any():
            return move, free
        free = free & ~beyond
        if not free.any():
            return np.zeros(len(slope)), free


def _convex(matrix: Floats) -> Floats:
    """Return the matrix with the sizes of its eigenvalues, none of them too small."""
    values, vectors = np.linalg.eigh(matrix)
    sizes = np.maximum(np.abs(values), 1e-10 * np.abs(values).max())
    return np.asarray((vectors * np.where(sizes > 0.0, sizes, 1.0)) @ vectors.T)


def _line_search(
    problem: Problem, y: Floats, here: Model, step: Floats, weight: float
) -> Floats | None:
    """Return the place after the longest halved step that improves function and residuals.

    The merit is the function plus ``weight`` times the residuals' sizes. Where the whole step
    only bends off the equations, it is corrected to second order; where the merit falls as fast
    at its end as at its start, as it does where the function is not convex, it goes on.
    """

    def merit(place: Floats) -> float:
        value, residual = problem.values(place)
        return value + weight * float(np.abs(residual).sum())

    def moved(part: float) -> Floats:
        return np.clip(y + part * step, problem.unknowns.low, problem.unknowns.high)

    missed = float(np.abs(here.residual).sum())
    left = float(np.abs(here.residual + here.slope @ step).sum())
    start = here.value + weight * missed
    promised = min(float(here.gradient @ step) - weight * (missed - left), -1e-12 * abs(start))
    part = 1.0
    while part > _SHORTEST:
        place = moved(part)
        found = merit(place)
        if found <= start + _ARMIJO * part * promised + 1e-14 * abs(start):
            break
        if part == 1.0 and len(here.residual):
            inside = (place > problem.unknowns.low) & (place < problem.unknowns.high)
            corrected = place.copy()
            back = np.linalg.lstsq(here.slope[:, inside], problem.values(place)[1], rcond=None)[0]
            corrected[inside] -= back
            corrected = np.clip(corrected, problem.unknowns.low, problem.unknowns.high)
            if np.isfinite(corrected).all() and merit(corrected) <= start + _ARMIJO * promised:
                return corrected
        part *= _SHORTER
    else:
        return None
    if part == 1.0 and start - found > _STEEP * -promised:
        while part < _FARTHEST:
            part *= 2.0
            beyond = moved(part)
            farther = merit(beyond)
            if farther >= found:
                break
            place, found = beyond, farther
    return place
