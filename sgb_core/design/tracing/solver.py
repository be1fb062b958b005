"""Least squares of the distances of points from a chain: Levenberg-Marquardt on its unknowns.

Each round lets the points' feet follow the chain and takes the distances along the normals there
(the tangential part of a distance does not count to first order, so joints and parameters slide
freely). Distances are in units of the tolerance, everything else in units of the size.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.design.tracing import feet as on_chain
from sgb_core.design.tracing.chain import (
    END_ANGLE,
    END_PUSH,
    FRAME,
    SHARE,
    START_ANGLE,
    START_PUSH,
    Chain,
    bounds,
    slopes,
)
from sgb_core.design.tracing.conditions import Condition, Rows, Run
from sgb_core.design.tracing.feet import Feet, followed, improved, sought
from sgb_core.interruption import checkpoint
from sgb_core.values import dataclass

# How much an uneven parametrisation costs: (third differences of the quartic points / reach)².
# Along a straight path nothing else keeps a segment from running to and fro.
_EVENNESS = 0.3
_THIRD = np.array([[-1.0, 3.0, -3.0, 1.0, 0.0], [0.0, -1.0, 3.0, -3.0, 1.0]])
_EVEN = np.kron(_THIRD.T @ _THIRD, np.eye(2))
# How much it costs that control points lie far out: (p / b)² + (q / (1 − b))² of the frames, which
# are how far they lie beyond their quartic points, in parts of the segment's reach.
_FARNESS = 1.0
# The numbers of a frame that are lengths.
_LENGTHS = [k for k in range(FRAME) if k not in (START_ANGLE, SHARE, END_ANGLE)]
# Damping: the first and the least; how it falls, and how it grows in how many tries.
_FIRST, _LEAST = 1e-3, 1e-9
_FALL, _GROWTH, _TRIES = 5.0, 10.0, 5
# No angle turns by more radians in one round, no point moves by more of its segment's reach.
_LONGEST = 0.5
# A round that gains a smaller part of the cost is quiet; after two of them the search ends.
_QUIET = 1e-3
_QUIET_ROUNDS = 2
# Every so many rounds the feet are sought afresh.
_SEEK_EVERY = 4
# From so many unknowns on Cholesky's way is quicker.
_MANY = 150
# And no more are sought together: the time grows with their cube, the memory with their square.
MOST = 2_000


@dataclass(frozen=True, slots=True)
class Cloud:
    """Ordered points in units of the size, shape (N, 2), with weights (N,).

    ``along`` (N,) is how far along the path they lie and ``tolerance`` in the same units.
    ``shares`` (N,) is which part of the profile's swept area each point stands for: their sum is
    1. A distance counts by what it is more than ``slack`` (N,).
    """

    points: Floats
    weights: Floats
    along: Floats
    shares: Floats
    slack: Floats
    tolerance: float

    def part(self, inside: NDArray[np.intp]) -> Cloud:
        """Return some of the points."""
        return Cloud(
            self.points[inside],
            self.weights[inside],
            self.along[inside],
            self.shares[inside],
            self.slack[inside],
            self.tolerance,
        )

    def weighted(self, factors: Floats) -> Cloud:
        """Return the same points with weights multiplied by ``factors``."""
        return replace(self, weights=self.weights * factors)


def joined(clouds: Sequence[Cloud]) -> Cloud:
    """Return the points of clouds that follow each other."""
    return Cloud(
        np.concatenate([cloud.points for cloud in clouds]),
        np.concatenate([cloud.weights for cloud in clouds]),
        np.concatenate([cloud.along for cloud in clouds]),
        np.concatenate([cloud.shares for cloud in clouds]),
        np.concatenate([cloud.slack for cloud in clouds]),
        clouds[0].tolerance,
    )


@dataclass(frozen=True, slots=True)
class State:
    """A chain with the feet of the points, their signed distances and the normals there."""

    chain: Chain
    feet: Feet
    distances: Floats
    normals: Floats = field(repr=False)

    @property
    def largest(self) -> float:
        """The largest distance, in tolerances."""
        return float(np.abs(self.distances).max())


def measured(chain: Chain, cloud: Cloud, feet: Feet, *, seek: bool = False) -> State:
    """Return a chain with the feet of the points, one step nearer, and how far they are."""
    control, layout = chain.quartics, chain.layout
    if seek:
        feet = sought(control, cloud.points, feet, closed=layout.closed)
    feet = improved(control, cloud.points, feet, closed=layout.closed, corners=layout.corners)
    place, slope, _ = followed(control, feet)
    off = place - cloud.points.T
    speed = np.hypot(slope[0], slope[1])
    speed[speed == 0.0] = 1.0
    normals = np.empty_like(slope)
    np.divide(slope[1], speed, out=normals[0])
    np.divide(slope[0], -speed, out=normals[1])
    distances = off[0] * normals[0] + off[1] * normals[1]
    # Past an end the distance is that from the end itself.
    clipped = np.flatnonzero((feet.s <= 0.0) | (feet.s >= 1.0))
    if len(clipped):
        away = off[:, clipped]
        length = np.hypot(away[0], away[1])
        side = np.where(distances[clipped] < 0.0, -1.0, 1.0)
        distances[clipped] = length * side
        toward = away / np.where(length > 0.0, length, 1.0) * side
        normals[:, clipped] = np.where(length > 0.0, toward, normals[:, clipped])
    if cloud.slack.any():
        distances = np.sign(distances) * np.maximum(np.abs(distances) - cloud.slack, 0.0)
    return State(chain, feet, distances / cloud.tolerance, normals.T)


def least_squares(
    state: State,
    cloud: Cloud,
    rounds: int,
    conditions: Sequence[Condition] = (),
    *,
    hopeless: float = np.inf,
) -> State:
    """Return the chain after at most ``rounds`` rounds, or fewer once it has settled.

    ``conditions`` add their rows to the squares. The search also ends where half of the rounds
    leave the largest distance above ``hopeless`` tolerances. A chain of more than MOST unknowns,
    some four hundred segments, stays as it is: all together would take minutes.
    """
    numbering = state.chain.layout.numbering()
    unknowns = int(numbering.max()) + 1
    if not 0 < unknowns <= MOST:
        return state
    damping, quiet = _FIRST, 0
    cost = _cost(state, cloud, conditions)
    for number in range(rounds):
        checkpoint()
        hessian, gradient = _normal_equations(state, cloud, numbering, conditions)
        scale = np.diag(hessian).copy()
        scale = np.maximum(scale, 1e-9 * scale.max())
        held = _held(state.chain, numbering, gradient)
        hessian[held], hessian[:, held], gradient[held] = 0.0, 0.0, 0.0
        for _ in range(_TRIES):
            full = _solved(hessian + np.diag(damping * scale + held), -gradient)
            step = _shortened(np.asarray(full), state.chain, numbering)
            moved = state.chain.moved(step, numbering)
            trial = measured(moved, cloud, state.feet, seek=number % _SEEK_EVERY == 2)
            gain = cost - _cost(trial, cloud, conditions)
            if gain > 0.0:
                break
            damping *= _GROWTH
        else:
            break
        foretold = -float(step @ (2.0 * gradient + hessian @ step))
        if gain > 0.75 * foretold:
            damping = max(damping / _FALL, _LEAST)
        elif gain < 0.25 * foretold:
            damping *= _FALL
        quiet = quiet + 1 if gain <= _QUIET * cost else 0
        state, cost = trial, cost - gain
        if quiet >= _QUIET_ROUNDS or (2 * number >= rounds and state.largest > hopeless):
            break
    return state


def _solved(matrix: Floats, values: Floats) -> Floats:
    """Return x with matrix·x = values for a symmetric matrix that damping makes positive."""
    if len(values) < _MANY:
        return np.asarray(np.linalg.solve(matrix, values))
    # Imported late: it takes a while to load.
    from scipy.linalg import LinAlgError, cho_factor, cho_solve

    try:
        factor = cho_factor(matrix, overwrite_a=False, check_finite=False)
    except LinAlgError:
        return np.asarray(np.linalg.solve(matrix, values))
    return np.asarray(cho_solve(factor, values, check_finite=False))


def _cost(state: State, cloud: Cloud, conditions: Sequence[Condition]) -> float:
    third = _THIRD @ state.chain.quartics
    cost = float(cloud.weights @ (state.distances * state.distances)) + float(
        (_evenness(state.chain)[:, None, None] * third**2).sum()
    )
    far, _ = _farness(state.chain)
    cost += float((far**2).sum())
    for condition in conditions:
        values, _ = condition(state.chain, state.distances, None)
        cost += float(values @ values)
    return cost


def _normal_equations(
    state: State, cloud: Cloud, numbering: NDArray[np.intp], conditions: Sequence[Condition]
) -> tuple[Floats, Floats]:
    """Return JᵀJ and Jᵀe in the unknowns, put together from those of each frame."""
    chain, feet = state.chain, state.feet
    count = chain.layout.count
    shares, products = on_chain.weights(feet.s), np.empty((len(feet.s), 5, 2))
    for axis in range(2):
        across = state.normals[:, axis] / cloud.tolerance
        np.multiply(shares, across[:, None], out=products[:, :, axis])
    rows = products.reshape(len(products), 10)
    if cloud.slack.any():
        rows[(cloud.slack > 0.0) & (state.distances == 0.0)] = 0.0
    weighted, runs = rows * cloud.weights[:, None], _runs(feet.segment, count)
    even = _evenness(chain)
    grams = even[:, None, None] * _EVEN
    pulls = even[:, None] * (chain.quartics.reshape(count, 10) @ _EVEN)
    for k, run in enumerate(runs):
        heavy = weighted[run]
        grams[k] += heavy.T @ rows[run]
        pulls[k] += state.distances[run] @ heavy
    by_frames = slopes(chain.frames, chain.layout.straight)
    turned = by_frames.transpose(0, 2, 1)
    far, far_by_frames = _farness(chain)
    far_turned = far_by_frames.transpose(0, 2, 1)
    blocks = turned @ grams @ by_frames + far_turned @ far_by_frames
    pushes = turned @ pulls[:, :, None] + far_turned @ far[:, :, None]
    # The number −1 of what is given is the last one, which is left out.
    unknowns = int(numbering.max()) + 1
    whole = np.zeros((unknowns + 1, unknowns + 1))
    np.add.at(whole, (numbering[:, :, None], numbering[:, None, :]), blocks)
    toward = np.zeros(unknowns + 1)
    np.add.at(toward, numbering, pushes[:, :, 0])
    hessian, gradient = whole[:-1, :-1].copy(), toward[:-1].copy()
    known = Rows(rows, runs, by_frames, numbering)
    for condition in conditions:
        values, slope = condition(chain, state.distances, known)
        hessian += slope.T @ slope
        gradient += slope.T @ values
    return hessian, gradient


def _runs(segments: NDArray[np.intp], count: int) -> list[Run]:
    """Return which points have their feet on each segment: slices where the feet are in order."""
    if (segments[1:] >= segments[:-1]).all():
        edges = np.searchsorted(segments, np.arange(count + 1)).tolist()
        return [slice(low, high) for low, high in pairwise(edges)]
    return [np.flatnonzero(segments == k) for k in range(count)]


def _evenness(chain: Chain) -> Floats:
    """Return how much the squares of third differences count, (count,)."""
    return np.asarray(_EVENNESS / chain.reach**2)


def _farness(chain: Chain) -> tuple[Floats, Floats]:
    """Return rows (count, 2) that tell how far out control points lie, and slopes by frames."""
    share = chain.frames[:, SHARE]
    scale = np.sqrt(_FARNESS) / chain.reach
    rows = np.empty((len(share), 2))
    by_frames = np.zeros((len(share), 2, chain.frames.shape[1]))
    for k, (push, part, sign) in enumerate(
        ((START_PUSH, share, -1.0), (END_PUSH, 1.0 - share, 1.0))
    ):
        rows[:, k] = scale * chain.frames[:, push] / part
        by_frames[:, k, push] = scale / part
        by_frames[:, k, SHARE] = sign * rows[:, k] / part
    return rows, by_frames


def _held(chain: Chain, numbering: NDArray[np.intp], gradient: Floats) -> NDArray[np.bool_]:
    """Return which unknowns lie at a bound that the squares push them against."""
    low, high = bounds(chain.frames)
    push = np.append(gradient, 0.0)[numbering]
    at_bound = ((chain.frames <= low) & (push > 0.0)) | ((chain.frames >= high) & (push < 0.0))
    held = np.zeros(len(gradient), dtype=bool)
    held[numbering[at_bound]] = True
    return held


def _shortened(step: Floats, chain: Chain, numbering: NDArray[np.intp]) -> Floats:
    """Return a step in which no angle turns and no point moves too far at once."""
    change = np.abs(np.append(step, 0.0)[numbering])
    change[:, _LENGTHS] /= chain.reach[:, None]
    worst = float(change.max()) / _LONGEST
    return step / worst if worst > 1.0 else step
