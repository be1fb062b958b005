"""Keeps a document's locks through every edit: what a hand asks for, as far as they allow it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.joints import JointEquation, joint_equations
from sgb_core.design.locks.dimension import DimensionKind
from sgb_core.design.locks.hold import Holder, Lock, Solution
from sgb_core.document.dimensions import (
    STORED,
    dimension_value,
    locked_fact,
    missed_locks,
    setting_of,
)
from sgb_core.document.errors import EditError
from sgb_core.document.lock_plan import LockPlan, at_one_place, modelled, plan_of
from sgb_core.document.model import Document
from sgb_core.findings.locks import LocksInTheWay
from sgb_core.values import dataclass

_K = DimensionKind
# A rule that an edit misses by more is one that it could not keep, and not the locks' business.
_KEPT = 1e-6
_MET = 1e-10
# A model that misses less may be a little wrong itself.
_NEARLY = 1e-5
_SETTLED, _WRONG = 3e-10, 5e-9
_SETTLING_ROUNDS = 8
# How much less or more a body may answer to a change than its model.
_LEAST_RATE = 0.3
_PART_ROUNDS, _LEAST_PART = 5, 0.02
# While the hand moves its next place is seldom far from the last that could be had.
_TICK_ROUNDS = 2


@dataclass(frozen=True, slots=True)
class Kept:
    """A document on which all locks hold; ``in_the_way`` says what stopped the hand, if it did."""

    document: Document
    in_the_way: LocksInTheWay | None = None


class LockKeeper:
    """Holds the locks of one session's document.

    A gesture's ticks share what does not change from one to the next, and each search starts from
    where the last one ended. Where an edit cannot be had as a whole, the hand stops between the
    last place of the gesture that could be and the one it asks for.
    """

    def __init__(self) -> None:
        self._plan: LockPlan | None = None
        self._warm: Floats | None = None
        self._last: tuple[Chain, Document] | None = None

    def begin(self) -> None:
        """Begin a gesture: where the hand of the one before could go is no longer of use."""
        self._last = None

    def keep(
        self,
        start: Document,
        edited: Document,
        *,
        settle: bool = False,
        hand: bool = True,
        settled: bool = False,
    ) -> Kept:
        """Return ``edited``, made from ``start``, with all locks held.

        With ``settle`` bodies are measured themselves, not by their model alone. Without ``hand``
        nothing that the edit has changed is in it, all may give way. An edit that is ``settled``
        says that it has kept the locks itself, which is only measured. Raises EditError with the
        locks that exclude the edit.
        """
        if not any(dimension.locked for dimension in edited.dimensions):
            return Kept(edited)
        if not settle and _same(start, edited):
            return Kept(edited)
        if settled and not missed_locks(edited):
            return Kept(edited)
        restored, barred = _restored(start, edited)
        plan = self._planned(start, restored)
        chain = plan.start.told(restored.profile)
        held, points_barred = _with_fixed(plan, restored, chain, start)
        barred += points_barred
        before = plan.start if hand else held
        task = _Task(plan, restored, chain, before, _kept_joints(plan, held))
        missed = self._missed(task, held, plan.locks)
        # An edit that has kept the locks itself is right by the measures, which take their time.
        nearly = not barred and _MET < missed <= _NEARLY
        # One of the whole, such as a dimension's new value, is far from where the models are right.
        whole = (
            not barred
            and missed > _MET
            and bool((chain.blocks != plan.start.blocks).any(axis=1).all())
        )
        if (whole or (nearly and settle)) and not missed_locks(restored):
            return Kept(restored)
        try:
            document, stopping = self._reached(task, held, settle=settle, missed=missed)
        except EditError as error:
            if nearly and not settle and not missed_locks(restored):
                return Kept(restored)
            part = self._part_way(task, held, settle=settle)
            if part is None or not isinstance(error.finding, LocksInTheWay):
                raise
            # Without a hand in it a part of the way is as good as the whole.
            document, stopping = part, error.finding.numbers if hand else ()
        else:
            self._last = held, document
        numbers = tuple(sorted({*barred, *stopping}))
        return Kept(document, _in_the_way(edited, numbers, stopped=True) if numbers else None)

    @staticmethod
    def _missed(task: _Task, chain: Chain, locks: Sequence[Lock]) -> float:
        """Return by how much a chain misses most what is to hold."""
        holder = Holder(task.plan.columns, task.joints, locks, task.plan.setting)
        return float(np.abs(holder.missed(chain)).max(initial=0.0))

    def _reached(
        self, task: _Task, held: Chain, *, settle: bool, missed: float | None = None
    ) -> tuple[Document, tuple[int, ...]]:
        """Return the document on which all holds, and the locks that stopped the hand.

        ``missed`` is by how much the edit misses the locks; None for a part of one that cannot be.
        """
        solution = self._solved(task, held, task.plan.locks, missed, yields=missed is None)
        document = _taken(task.edited, task.chain, solution.chain)
        if settle:
            document = self._settled(task, held, document)
        return document, solution.in_the_way if solution.stopped else ()

    def _part_way(self, task: _Task, held: Chain, *, settle: bool) -> Document | None:
        """Return how far towards the edit all can hold, None where no part of it can be had."""
        (start, found), least, most = self._last or (task.plan.start, None), 0.0, 1.0
        reached = start
        for _ in range(_PART_ROUNDS if self._last is None else _TICK_ROUNDS):
            part = 0.5 * (least + most)
            between = _between(start, held, part)
            try:
                found, _stopping = self._reached(task, between, settle=False)
            except EditError:
                most = part
            else:
                least, reached = part, between
        if found is not None:
            self._last = reached, found
        if not settle:
            return found
        start, part = task.plan.start, 1.0
        while found is not None and part > _LEAST_PART:
            try:
                return self._reached(task, _between(start, reached, part), settle=True)[0]
            except EditError:
                part *= 0.5
        return None

    def _planned(self, start: Document, edited: Document) -> LockPlan:
        same = len(start.profile) == len(edited.profile)
        base = start if same else edited
        key = (
            id(base.profile),
            edited.dimensions,
            edited.profile.rules,
            edited.solid,
            edited.variation,
            setting_of(edited),
        )
        if self._plan is None or self._plan.key != key:
            self._plan = plan_of(key, base, edited)
            self._warm = self._last = None
        return self._plan

    def _solved(
        self,
        task: _Task,
        chain: Chain,
        locks: Sequence[Lock],
        missed: float | None = None,
        *,
        yields: bool = False,
    ) -> Solution:
        plan = task.plan
        holder = Holder(plan.columns, task.joints, locks, plan.setting)
        if (self._missed(task, chain, locks) if missed is None else missed) <= _MET:
            return Solution(chain, np.zeros(0), True, False, ())
        shapes = [segment.shape for segment in task.edited.profile.segments]
        solution = holder.solve(task.start, chain, shapes, self._warm, yields=yields)
        if not solution.met:
            raise EditError(_in_the_way(task.edited, solution.in_the_way, stopped=False))
        self._warm = solution.step
        return solution

    def _settled(self, task: _Task, held: Chain, document: Document) -> Document:
        """Return the document with its body's own measures as the locks say."""
        locks = list(task.plan.locks)
        rough = modelled(task.edited)
        last: dict[int, tuple[float, float]] = {}
        best, least = document, np.inf
        for _ in range(_SETTLING_ROUNDS):
            worst = 0.0
            for place, lock in enumerate(locks):
                if lock.dimension.kind not in rough or lock.dimension.value is None:
                    continue
                value = dimension_value(document, lock.dimension)
                if value is None:
                    raise EditError(_in_the_way(task.edited, (lock.number,), stopped=False))
                apart = value - lock.dimension.value
                worst = max(worst, abs(apart) / lock.scale)
                # The secant of what the model was to have and what the body then had.
                rate = 1.0
                if place in last and lock.target != last[place][0]:
                    rate = (apart - last[place][1]) / (lock.target - last[place][0])
                last[place] = lock.target, apart
                rate = rate if _LEAST_RATE <= rate <= 1.0 / _LEAST_RATE else 1.0
                locks[place] = replace(lock, target=lock.target - apart / rate)
            if worst < least:
                best, least = document, worst
            if least <= _SETTLED:
                break
            solution = self._solved(task, held, locks)
            document = _taken(task.edited, task.chain, solution.chain)
        if least > _WRONG:
            numbers = tuple(each.number for each in locks if each.dimension.kind in rough)
            raise EditError(_in_the_way(task.edited, numbers, stopped=False))
        return best


@dataclass(frozen=True, slots=True)
class _Task:
    """One edit to be brought within the locks.

    What differs from ``start`` is in the hand; ``joints`` are the rules that the edit itself keeps.
    """

    plan: LockPlan
    edited: Document
    chain: Chain
    start: Chain
    joints: list[JointEquation]


def _between(start: Chain, end: Chain, part: float) -> Chain:
    return end.with_blocks(start.blocks + part * (end.blocks - start.blocks))


def _same(start: Document, edited: Document) -> bool:
    """Return whether nothing that a dimension depends on has changed."""
    return (
        start.profile is edited.profile
        and start.dimensions is edited.dimensions
        and start.solid is edited.solid
        and start.manufacture is edited.manufacture
        and start.revolution is edited.revolution
        and start.variation is edited.variation
    )


def _restored(start: Document, edited: Document) -> tuple[Document, list[int]]:
    """Return the document with the locked numbers and rules that stand in it as they are locked."""
    barred = []
    for number, dimension in enumerate(edited.dimensions):
        if not dimension.locked:
            continue
        value = dimension.value
        if dimension.kind in STORED and value is not None:
            if dimension_value(edited, dimension) == value:
                continue
            edited = _with_stored(edited, dimension.kind, value)
        elif dimension.joint is not None and dimension.rule is not None:
            rules = edited.profile.rules
            if rules[dimension.joint] is dimension.rule:
                continue
            kept = tuple(
                dimension.rule if k == dimension.joint else rule for k, rule in enumerate(rules)
            )
            edited = replace(edited, profile=replace(edited.profile, rules=kept))
        else:
            continue
        if start.dimensions is edited.dimensions:
            barred.append(number)
    return edited, barred


def _with_stored(document: Document, kind: DimensionKind, value: float) -> Document:
    if kind is _K.FILL_LINE:
        fill = replace(document.manufacture.fill, height=value)
        return replace(document, manufacture=replace(document.manufacture, fill=fill))
    solid = document.solid
    if kind is _K.WALL:
        return replace(document, solid=replace(solid, wall=value))
    return replace(document, solid=replace(solid, base=value))


def _with_fixed(
    plan: LockPlan, edited: Document, chain: Chain, start: Document
) -> tuple[Chain, list[int]]:
    """Return the chain with locked points back in their places, and the locks this concerns.

    A locked end that was moved has carried its legs, which go back with it.
    """
    barred = []
    blocks = chain.blocks.copy()
    points, before = blocks[:, 3:].reshape(-1, 4, 2), plan.start.points
    for number, dimension in enumerate(edited.dimensions):
        if not dimension.locked or dimension.kind is not _K.POINT:
            continue
        for k, i in at_one_place(start.profile, dimension.points[0]):
            away = points[k, i] - before[k, i]
            if not away.any():
                continue
            barred.append(number)
            points[k, i] = before[k, i]
            if i in (0, 3):
                points[k, 1 if i == 0 else 2] -= away
    blocks[:, 3:] = points.reshape(-1, 8)
    return chain.with_blocks(blocks), barred


def _kept_joints(plan: LockPlan, chain: Chain) -> list[JointEquation]:
    """Return the equations of rules that an edit keeps itself, and of those that are locked."""
    residual = joint_equations(chain, list(plan.joints), second=False).residual
    return [
        each
        for each, part in zip(plan.joints, np.abs(residual).tolist(), strict=True)
        if part <= _KEPT or each.joint in plan.locked_joints
    ]


def _taken(edited: Document, chain: Chain, found: Chain) -> Document:
    """Return the document with what the search has changed."""
    if found is chain or np.array_equal(found.blocks, chain.blocks):
        return edited
    return replace(edited, profile=found.profile(edited.profile, chain))


def _in_the_way(document: Document, numbers: tuple[int, ...], *, stopped: bool) -> LocksInTheWay:
    facts = tuple(locked_fact(document, number) for number in numbers)
    return LocksInTheWay(numbers, facts, stopped)
