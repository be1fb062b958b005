"""Locks held while a hand changes something else: the mildest change, step by step.

Each round solves the linearised locks and joints' rules for the least change in the unknowns'
costs (Gauss-Newton on the Lagrange conditions), within bounds by an active set; the last rounds
only lead back onto them. What is in the hand stays; where that cannot be it gives way as little as
it can, and the hand stops at the boundary.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, isfinite

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.segment import ShapeParameters
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.joints import JointEquation, joint_equations
from sgb_core.design.locks.columns import Columns, Flags
from sgb_core.design.locks.dimension import Dimension, DimensionKind, Quantity
from sgb_core.design.locks.gauge import NO_SLOPE, Gauge, Reading
from sgb_core.design.locks.readings import Setting, read, rivals
from sgb_core.values import dataclass

# Residuals are parts of the size, of a radian, or of a volume.
EXACT = 1e-11
_MET = 1e-10
# Rounds towards the mildest change, from where the last tick ended and from afar; then rounds
# that only lead back. One is slow that leaves more than this part of what is missed.
_WARM_ROUNDS, _MILD_ROUNDS, _ROUNDS = 2, 6, 24
_SLOW, _MOST_SLOW = 0.2, 4
# Phase two: what is in the hand costs so much more than anything else.
_HAND_COST = 300.0
_RIDGE = 1e-13
# Multiplications in one product; OpenBLAS shares out what has more than 2¹⁸.
_SMALL = 2**17
_ACTIVE_ROUNDS = 8
_IN_THE_WAY = 0.2
_MOVED = 1e-9
# Another place so near a locked height or diameter is held by it too.
_RIVAL = 1e-8


@dataclass(frozen=True, slots=True)
class Lock:
    """A locked dimension, its number in the project, and the value that its model is to have."""

    number: int
    dimension: Dimension
    target: float
    scale: float

    def missed(self, value: float) -> float:
        """Return by how much a value misses the target, as a part of the scale."""
        apart = value - self.target
        if self.dimension.kind is DimensionKind.ANGLE:
            apart = (apart + 180.0) % 360.0 - 180.0
        return apart / self.scale


@dataclass(frozen=True, slots=True)
class Solution:
    """Where a search ended: the chain, the unknowns, and the numbers of locks in the way.

    ``met`` says that all holds there; ``stopped`` that the hand did not get what it asked for.
    """

    chain: Chain
    step: Floats
    met: bool
    stopped: bool
    in_the_way: tuple[int, ...]


def lock_of(number: int, dimension: Dimension, size: float, target: float) -> Lock:
    """Return a lock whose model is to have ``target``, with the scale of its residual."""
    quantity = dimension.facts.quantity
    if quantity is Quantity.ANGLE:
        scale = degrees(1.0)
    elif quantity is Quantity.LENGTH and dimension.kind is not DimensionKind.RADIUS:
        scale = size
    else:
        scale = abs(target) or 1.0
    return Lock(number, dimension, target, scale)


class Holder:
    """Holds locks and joints' rules of one profile, whatever the hand does to it."""

    def __init__(
        self,
        columns: Columns,
        joints: Sequence[JointEquation],
        locks: Sequence[Lock],
        setting: Setting,
    ) -> None:
        self.columns = columns
        self.joints = list(joints)
        self.locks = tuple(locks)
        self.setting = setting
        self._rivals: set[tuple[int, int, int]] = set()
        self._owners: list[int] = []

    def missed(self, chain: Chain) -> Floats:
        """Return the residuals of all locks, each its largest, and of the rules after them."""
        found = self._equations(chain, slopes=False)[0]
        return np.concatenate([self._largest(found), found[len(self._owners) :]])

    def slopes(self, chain: Chain) -> Floats:
        """Return the slopes of all locks and rules at a chain by the unknowns, (k, m)."""
        _, numbers = self._equations(chain, slopes=True)
        if len(numbers):
            return self.columns.gathered(numbers)
        return np.zeros((0, len(self.columns.cost)))

    def _largest(self, rows: Floats) -> Floats:
        """Return the largest size among the rows of each lock."""
        largest = np.zeros(len(self.locks))
        np.maximum.at(largest, self._owners, np.abs(rows[: len(self._owners)]))
        return largest

    def solve(
        self,
        start: Chain,
        edited: Chain,
        shapes: list[ShapeParameters],
        warm: Floats | None = None,
        *,
        yields: bool = False,
    ) -> Solution:
        """Return the chain nearest to ``edited``, made from ``start``, on which all holds.

        With ``yields`` it is known that what is in the hand cannot stay where it is.
        """
        held = self.columns.held(start, edited)
        low, high = self.columns.bounds(edited, held, shapes)
        cost = self.columns.cost
        cold = warm is None or len(warm) != len(cost)
        guess = np.zeros(len(cost)) if warm is None or cold else warm
        rounds = _MILD_ROUNDS if cold else _WARM_ROUNDS
        if not (yields or held.all()):
            fixed = np.where(held, 0.0, guess)
            found, missed, _ = self._search(
                edited, cost, fixed, low * cost, high * cost, ~held, rounds
            )
            chain = self._chain(edited, found / cost)
            if missed <= _MET and self._goes_on(chain):
                return Solution(chain, found, True, False, ())
        if held[~self.columns.fractions].all():
            # The whole shape is in the hand: there is no part of it that could give way.
            return Solution(edited, guess * 0.0, False, True, self._worst(edited))
        dear = np.where(held, _HAND_COST, 1.0)
        found, missed, pull = self._search(
            edited,
            cost * dear,
            guess * dear,
            low * cost * dear,
            high * cost * dear,
            np.ones(len(cost), dtype=bool),
            rounds,
        )
        step = found / dear
        chain = self._chain(edited, step / cost)
        stopped = bool((np.abs(step / cost)[held] > _MOVED).any())
        met = missed <= _MET and self._goes_on(chain)
        return Solution(chain, step, met, stopped, self._named(pull))

    def _goes_on(self, chain: Chain) -> bool:
        """Return whether no smooth joint turns back."""
        if not self.joints:
            return True
        before = chain.points[[each.before for each in self.joints]]
        after = chain.points[[each.after for each in self.joints]]
        along = ((before[:, 3] - before[:, 2]) * (after[:, 1] - after[:, 0])).sum(axis=1)
        return bool((along > 0.0).all())

    def _worst(self, chain: Chain) -> tuple[int, ...]:
        missed = np.abs(self.missed(chain)[: len(self.locks)])
        return tuple(
            lock.number for lock, part in zip(self.locks, missed, strict=True) if part > _MET
        )

    def _named(self, pull: Floats) -> tuple[int, ...]:
        """Return the locks that pull most at what is in the hand."""
        most = float(pull.max(initial=0.0))
        return tuple(
            lock.number
            for lock, part in zip(self.locks, pull.tolist(), strict=True)
            if part > _IN_THE_WAY * most
        )

    def _chain(self, edited: Chain, y: Floats) -> Chain:
        flat = edited.blocks.ravel() + self.columns.spread(y, edited.blocks.size)
        return edited.with_blocks(flat.reshape(edited.blocks.shape))

    def _search(
        self,
        edited: Chain,
        cost: Floats,
        z: Floats,
        low: Floats,
        high: Floats,
        free: Flags,
        mild_rounds: int,
    ) -> tuple[Floats, float, Floats]:
        """Return the unknowns, in their costs, the largest residual and the multipliers."""
        z = np.clip(z, low, high)

        def chain(at: Floats) -> Chain:
            return self._chain(edited, at / cost)

        pull, slope = np.zeros(len(self.locks)), np.zeros((0, len(z)))
        for _ in range(mild_rounds):
            residual, numbers = self._equations(chain(z), slopes=True)
            if not np.isfinite(residual).all():
                return z, np.inf, pull
            slope = self.columns.gathered(numbers) / cost
            z, multipliers = _step(slope, residual, z, low, high, free, mild=True)
            pull = self._largest(multipliers)
        best, least, slow = z, np.inf, 0
        for _ in range(_ROUNDS):
            # Along one slope as long as that leads on quickly; places are looked for anew.
            residual, numbers = self._equations(chain(z), slopes=slow > 0)
            if len(residual) != len(slope):
                # Another side of the axis, or another place, reaches a lock now.
                residual, numbers = self._equations(chain(z), slopes=True)
            missed = float(np.abs(residual).max(initial=0.0))
            slow = slow + 1 if missed > _SLOW * least else 0
            if missed < least:
                best, least = z, missed
            if least <= EXACT or not isfinite(missed) or slow > _MOST_SLOW:
                break
            if len(numbers):
                slope = self.columns.gathered(numbers) / cost
            z, _ = _step(slope, residual, z, low, high, free, mild=False)
        return best, least, pull

    def _equations(self, chain: Chain, *, slopes: bool) -> tuple[Floats, Floats]:
        """Return residuals, infinite where one has no value, and their slopes by all numbers.

        A lock has a row for each place that reaches it, or has reached it. Without ``slopes``
        these are empty.
        """
        gauge = Gauge(chain, slopes=slopes)
        rules = joint_equations(chain, self.joints, second=False)
        owners, residuals, rows = [], [], []
        for k, lock in enumerate(self.locks):
            found = read(gauge, lock.dimension, self.setting)
            readings = [Reading(np.inf, NO_SLOPE) if found is None else found]
            for spot, rival in rivals(gauge, lock.dimension):
                place = (k, spot.segment, int(4.0 * spot.s))
                if rival.value > lock.target - _RIVAL * lock.scale:
                    self._rivals.add(place)
                if place in self._rivals:
                    readings.append(rival)
            for reading in readings:
                owners.append(k)
                residuals.append(lock.missed(reading.value))
                rows.append(reading.slope / lock.scale)
        self._owners = owners
        residual = np.concatenate([residuals, rules.residual])
        if not slopes or not np.isfinite(residual).all():
            return residual, np.zeros((0, 0))
        return residual, np.concatenate(
            [np.array(rows).reshape(-1, chain.blocks.size), rules.slope]
        )


def _step(
    slope: Floats,
    residual: Floats,
    z: Floats,
    low: Floats,
    high: Floats,
    free: Flags,
    *,
    mild: bool,
) -> tuple[Floats, Floats]:
    """Return the unknowns on the linearised equations, and the multipliers.

    Where ``mild`` those nearest to no change at all, else those nearest to ``z``.
    """
    base = np.where(free, 0.0, z) if mild else z
    moving, result = free.copy(), base.copy()
    multipliers = np.zeros(len(residual))
    for _ in range(_ACTIVE_ROUNDS):
        # What the unknowns at their bounds leave to the others.
        wanted = slope @ (z - result) - residual
        part = slope[:, moving]
        norms = np.sqrt((part**2).sum(axis=1))
        norms[norms <= 1e-12] = 1.0
        unit = part / norms[:, None]
        square = _gram(unit)
        square[np.diag_indices(len(square))] += _RIDGE
        try:
            scaled = np.linalg.solve(square, wanted / norms)
        except np.linalg.LinAlgError:
            scaled = np.linalg.lstsq(square, wanted / norms, rcond=None)[0]
        multipliers = scaled / norms
        trial = result.copy()
        trial[moving] += unit.T @ scaled
        outside = moving & ((trial < low) | (trial > high))
        if not outside.any():
            return trial, multipliers
        result[outside] = np.clip(trial, low, high)[outside]
        moving &= ~outside
        result[moving] = base[moving]
    return np.clip(trial, low, high), multipliers


def _gram(rows: Floats) -> Floats:
    """Return rows · rowsᵀ, in products so small that BLAS starts no threads for them."""
    width = max(1, _SMALL // max(1, len(rows) ** 2))
    total = np.zeros((len(rows), len(rows)))
    for start in range(0, rows.shape[1], width):
        part = rows[:, start : start + width]
        total += part @ part.T
    return total
