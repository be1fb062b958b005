"""The fairest leg fractions of single segments, many segments and starts at once.

Where a joint asks for no more than G1, no segment's shape bears on another: each is a problem of
three unknowns in a box. Cusps inside a segment are walls of infinite energy between several
valleys, so a search looks through the whole box first and goes down from several places.
"""

from __future__ import annotations

from dataclasses import field
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.basis import quartic_points
from sgb_core.design.fairing.energy import Energy, Expansion, Moves, energies, expand
from sgb_core.design.fairing.measure import segment_energies
from sgb_core.design.fairing.nodes import exact_nodes, graded_nodes, look_nodes
from sgb_core.interruption import checkpoint
from sgb_core.values import dataclass

# Leg fractions of the first look through the box, ends left out.
_END_GRID = (0.01, 0.06, 0.2, 0.5, 1.0)
_MIDDLE_GRID = (0.05, 0.35, 0.65, 0.95)
# Starts for each segment, besides the present shape; how long they go on before those in one
# valley are merged, how many of the lowest are followed to the end, and how far.
_STARTS = 6
_ROUNDS_BEFORE_MERGING = 4
_FINALISTS = 2
_LAST_ROUNDS = 12
# A change that gains less than these parts of the energy, and of 1, is none: so little is rounding.
_NO_WORSE = 1.0 + 1e-12
_NOTHING_GAINED = 1e-14
# An end fraction stays this far from 0, where the energy is infinite unless the curve is straight
# there: no other minimum has been seen below 1e-5.
LEAST = 1e-6
# Segments at once: larger arrays leave the processor's and the allocator's caches.
_BATCH = 32
# Steps of Newton's method, each at most so long in any fraction, and shortened so far.
_ROUNDS = 60
_LONGEST_STEP = 0.4
_SHORTER = 0.35
_SHORTEST = 1e-5
# A descent ends where a step gains less than this part: in a search, and at the end.
_CONVERGED = 1e-5
_SETTLED = 1e-12
_ROUNDING = 1e-14
# Two descents that have come so near each other end in the same place.
_SAME_VALLEY = 0.02
# A step is taken where it brings at least this part of what its slope promises.
_ARMIJO = 1e-4


@dataclass(frozen=True, slots=True)
class Box:
    """What each leg fraction may be: ``low`` and ``high`` of shape (B, 3)."""

    low: Floats
    high: Floats

    def __getitem__(self, chosen: list[int] | NDArray[np.intp]) -> Box:
        """Return the boxes of some segments of a batch."""
        return Box(self.low[chosen], self.high[chosen])

    def clip(self, fractions: Floats) -> Floats:
        """Return fractions (B, 3) brought into the box."""
        return np.clip(fractions, self.low, self.high)


def quartics_of(points: Floats, fractions: Floats) -> Floats:
    """Return the quartic points (B, 5, 2) of control points (B, 4, 2) and fractions (B, 3)."""
    return quartic_points(points, (fractions[:, 0], fractions[:, 1], fractions[:, 2]))


def fraction_moves(points: Floats) -> Moves:
    """Return how Q1, Q2 and Q3 move with a, b and c: along P1 − P0, P1 − P2 and P2 − P3."""
    along = np.stack(
        [points[:, 1] - points[:, 0], points[:, 1] - points[:, 2], points[:, 2] - points[:, 3]],
        axis=1,
    )
    return Moves((1, 2, 3), along)


def starts(energy: Energy, points: Floats, box: Box, most: int) -> Floats:
    """Return places (B, most, 3) to go down from: the lowest of a coarse look, well apart."""
    axes = np.meshgrid(_END_GRID, _MIDDLE_GRID, _END_GRID, indexing="ij")
    grid = np.stack([axis.ravel() for axis in axes], axis=-1)
    places = box.low[:, None] + grid * (box.high - box.low)[:, None]
    nodes = look_nodes()
    heights = np.empty((len(points), len(grid)))
    for k, polygon in enumerate(points):
        heights[k] = energies(energy, quartic_points(polygon, tuple(places[k].T)), nodes)
    heights = np.where(np.isfinite(heights), heights, np.inf)
    chosen = np.empty((len(points), most), dtype=np.intp)
    near = _near()
    for k in range(most):
        chosen[:, k] = np.argmin(heights, axis=1)
        heights = np.where(near[chosen[:, k]], np.inf, heights)
    return np.take_along_axis(places, chosen[..., None], axis=1)


@lru_cache(maxsize=1)
def _near() -> NDArray[np.bool_]:
    """Return which places of the grid are neighbours, or the same, in each direction."""
    shape = len(_END_GRID), len(_MIDDLE_GRID), len(_END_GRID)
    index = np.indices(shape).reshape(3, -1).T
    return np.asarray((np.abs(index[:, None] - index[None]) <= 1).all(axis=-1))


@dataclass(slots=True)
class Descent:
    """Newton's method from many starts at once, in batches, each start at its own pace.

    ``place`` (B, 3) and ``value`` (B,) are where each has come to. Fractions at a bound that
    would leave the box stay; where an energy is not convex the sizes of its Hessian's
    eigenvalues count.
    """

    energy: Energy
    points: Floats
    box: Box
    place: Floats
    exact: bool = False
    value: Floats = field(init=False)
    _step: Floats = field(init=False)
    _slope: Floats = field(init=False)
    _part: Floats = field(init=False)
    _going: NDArray[np.bool_] = field(init=False)

    def __post_init__(self) -> None:
        self.place = self.box.clip(self.place)
        self.value = np.full(len(self.place), np.inf)
        self._step, self._slope = np.zeros_like(self.place), np.zeros_like(self.place)
        self._part = np.ones(len(self.place))
        self._going = np.ones(len(self.place), dtype=bool)

    def run(self, rounds: int = _ROUNDS) -> Descent:
        """Go on for at most so many rounds from each start."""
        left = np.full(len(self.place), rounds)
        while True:
            chosen = np.flatnonzero(self._going & (left > 0))[:_BATCH]
            if len(chosen) == 0:
                return self
            left[chosen] -= 1
            checkpoint()
            self._round(chosen)

    def merge(self, group: int) -> None:
        """Stop descents that have come close to a lower one of the same ``group`` in a row."""
        place = self.place.reshape(-1, group, 3)
        value = self.value.reshape(-1, group)
        close = np.abs(place[:, :, None] - place[:, None]).max(axis=-1) < _SAME_VALLEY
        first = np.arange(group)[:, None] > np.arange(group)
        lower = (value[:, None, :] < value[:, :, None]) | (
            (value[:, None, :] == value[:, :, None]) & first
        )
        self._going &= ~(close & lower).any(axis=2).ravel()

    def _round(self, chosen: NDArray[np.intp]) -> None:
        points, box, place = self.points[chosen], self.box[chosen], self.place[chosen]
        tried = box.clip(place + self._part[chosen, None] * self._step[chosen])
        quartics = quartics_of(points, tried)
        nodes = (exact_nodes if self.exact else graded_nodes)(self.energy, quartics)
        here = expand(self.energy, quartics, nodes, fraction_moves(points))
        before = self.value[chosen]
        promised = (self._slope[chosen] * (tried - place)).sum(axis=1)
        with np.errstate(invalid="ignore"):
            good = here.value <= before + _ARMIJO * promised + _ROUNDING * before
            gain = (before - here.value) > (_SETTLED if self.exact else _CONVERGED) * here.value
        step, slope = _newton_step(here, tried, box)
        self._part[chosen] = np.where(good, 1.0, _SHORTER * self._part[chosen])
        self._going[chosen] = np.where(
            good, gain & (step != 0.0).any(axis=1), self._part[chosen] > _SHORTEST
        )
        kept = chosen[good]
        self.place[kept], self.value[kept] = tried[good], here.value[good]
        self._step[kept], self._slope[kept] = step[good], slope[good]


def _newton_step(here: Expansion, place: Floats, box: Box) -> tuple[Floats, Floats]:
    """Return steps (B, 3) towards the bottom, and free slopes: zero where a bound holds."""
    gradient = here.gradient
    low, high = place <= box.low, place >= box.high
    held = (low & (gradient > 0.0)) | (high & (gradient < 0.0)) | (low & high)
    slope = np.where(held, 0.0, gradient)
    either = held[:, :, None] | held[:, None, :]
    hessian = np.where(either, 0.0, here.hessian)
    hessian[:, range(3), range(3)] += held * np.abs(here.hessian).max(axis=(1, 2))[:, None]
    endless = ~np.isfinite(hessian.sum(axis=(1, 2)) + slope.sum(axis=1))
    hessian[endless], slope[endless] = np.eye(3), 0.0
    values, vectors = np.linalg.eigh(hessian)
    sizes = np.abs(values)
    sizes = np.maximum(sizes, 1e-9 * sizes.max(axis=1, keepdims=True))
    sizes = np.where(sizes > 0.0, sizes, 1.0)
    along = (slope[:, None, :] @ vectors)[:, 0, :] / sizes
    step = -(vectors @ along[:, :, None])[:, :, 0]
    longest = np.abs(step).max(axis=1, keepdims=True)
    return step * np.minimum(1.0, _LONGEST_STEP / np.maximum(longest, 1e-300)), slope


def fairest_fractions(energy: Energy, points: Floats, present: Floats, box: Box) -> Floats:
    """Return the leg fractions (B, 3) of least energy for control points (B, 4, 2).

    ``present`` fractions are one of the starts, and are returned as they are where nothing in the
    box is better.
    """
    if len(points) == 0:
        return present
    own = box.clip(present)
    many = np.concatenate([starts(energy, points, box, _STARTS), own[:, None]], axis=1)
    group = many.shape[1]
    repeated = Box(np.repeat(box.low, group, axis=0), np.repeat(box.high, group, axis=0))
    with np.errstate(all="ignore"):
        search = Descent(energy, np.repeat(points, group, axis=0), repeated, many.reshape(-1, 3))
        search.run(_ROUNDS_BEFORE_MERGING).merge(group)
        search.run()
        order = np.argsort(search.value.reshape(-1, group), axis=1)[:, :_FINALISTS]
        best = np.take_along_axis(search.place.reshape(-1, group, 3), order[..., None], axis=1)
        repeated = Box(*(np.repeat(side, _FINALISTS, axis=0) for side in (box.low, box.high)))
        twice = np.repeat(points, _FINALISTS, axis=0)
        final = Descent(energy, twice, repeated, best.reshape(-1, 3), exact=True).run(_LAST_ROUNDS)
    value = final.value.reshape(-1, _FINALISTS)
    rows = np.arange(len(points))
    winner = np.argmin(value, axis=1)
    best, least = final.place.reshape(-1, _FINALISTS, 3)[rows, winner], value[rows, winner]
    for which in (0, 2):
        _let_rest(energy, points, best, least, which)
    inside = ((present >= box.low) & (present <= box.high)).all(axis=1)
    before = segment_energies(energy, quartics_of(points, present))
    stays = inside & (before <= least * _NO_WORSE + _NOTHING_GAINED)
    return np.where(stays[:, None], present, best)


def _let_rest(
    energy: Energy, points: Floats, fractions: Floats, values: Floats, which: int
) -> None:
    """Set an end fraction that came to its least to 0 where the energy is finite and no higher."""
    low = np.flatnonzero(fractions[:, which] <= 2.0 * LEAST)
    if len(low) == 0:
        return
    rested = fractions[low]
    rested[:, which] = 0.0
    found = segment_energies(energy, quartics_of(points[low], rested))
    good = found <= values[low]
    fractions[low[good], which], values[low[good]] = 0.0, found[good]
