"""Variants of a document that all keep its locks and joints' rules: by parameters, or by freedom.

Each is a document of its own, measured before it is shown; those that cannot keep what is locked
are left out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from enum import StrEnum
from itertools import product
from math import ceil, isqrt, sqrt

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.profile import SMOOTH_RULES
from sgb_core.curves.segment import PARAMETER_RANGES, ParameterName
from sgb_core.design.demands.chain import Chain
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.measure import profile_energy
from sgb_core.design.locks.columns import Columns
from sgb_core.design.locks.hold import Holder
from sgb_core.design.locks.null_space import displacements, free_directions
from sgb_core.document.dimensions import dimension_value, locked_fact, missed_locks
from sgb_core.document.edits.checks import with_profile
from sgb_core.document.edits.shape import set_shape_parameter
from sgb_core.document.errors import EditError
from sgb_core.document.lock_keeper import LockKeeper
from sgb_core.document.lock_plan import LockPlan, modelled, plan_of
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoEdit
from sgb_core.findings.locks import Shared
from sgb_core.interruption import checkpoint
from sgb_core.values import dataclass

MOST = 48
USUAL = 12
# Directions that are combined, and how far a variant goes along them: the root of the mean square
# of the curve's displacement, in sizes.
_DIRECTIONS = 5
_AMPLITUDES = (0.012, 0.03, 0.075)
# Along a steep direction no unknown goes farther, in its costs, at first.
_FARTHEST = 0.6
# Places on each segment by which variants are told apart. Those that differ by less, in sizes,
# look the same; those that bend so many times as much as the document have cusps.
_PLACES = 9
_APART = 0.002
_CROOKED = 10.0
# Bodies are set right by their models so often, until they differ by no larger part.
_SETTLING_ROUNDS, _SETTLED = 8, 3e-10


class Free(StrEnum):
    """What variants may differ in: shape parameters alone, or control points too."""

    SHAPE = "shape"
    POINTS = "points"


@dataclass(frozen=True, slots=True)
class Swept:
    """A shape parameter that variants go through, of a segment."""

    segment: int
    parameter: ParameterName


@dataclass(frozen=True, slots=True)
class Variant:
    """One variant: ``energy`` is its ∫ κ² dl, ``values`` those of the swept parameters."""

    document: Document
    energy: float
    values: tuple[float, ...] = ()


def shared(document: Document) -> Shared:
    """Return what all variants of a document keep."""
    locks = tuple(
        locked_fact(document, number)
        for number, dimension in enumerate(document.dimensions)
        if dimension.locked and dimension.joint is None
    )
    kept = [each for each in measure_joints(document.profile) if each.holds]
    rules = [(rule.value, sum(each.rule is rule for each in kept)) for rule in SMOOTH_RULES]
    return Shared(locks, tuple((rule, many) for rule, many in rules if many))


def parameter_variants(
    document: Document,
    swept: Sequence[Swept],
    count: int = USUAL,
    report: Callable[[float], object] = lambda _: None,
) -> tuple[Variant, ...]:
    """Return variants over one or two shape parameters, at equal steps of their ranges.

    The least bending energy comes first. What is locked is kept as under a hand; values that
    locks do not allow are left out. Raises EditError for a segment that is not there.
    """
    counts = [count] if len(swept) == 1 else [max(2, ceil(sqrt(count))), max(2, isqrt(count))]
    axes = [
        np.linspace(*PARAMETER_RANGES[axis.parameter], many).tolist()
        for axis, many in zip(swept, counts, strict=True)
    ]
    found = []
    grid = list(product(*axes))
    for number, values in enumerate(grid):
        report(number / len(grid))
        edited = document
        for axis, value in zip(swept, values, strict=True):
            edited = set_shape_parameter(edited, axis.segment, axis.parameter, value)
        try:
            kept = LockKeeper().keep(document, edited, settle=True).document
        except EditError:
            continue
        variant = _measured(document, kept)
        if variant is None or any(
            getattr(variant.document.profile[axis.segment].shape, axis.parameter) != value
            for axis, value in zip(swept, values, strict=True)
        ):
            continue
        found.append(replace(variant, values=values))
    return tuple(sorted(found, key=lambda each: each.energy))


def free_variants(
    document: Document,
    free: Free = Free.SHAPE,
    count: int = USUAL,
    report: Callable[[float], object] = lambda _: None,
) -> tuple[Variant, ...]:
    """Return variants along the directions in which all locks and rules hold.

    These span the null space of the equations at the document; what is taken along them is led
    back onto the equations by the least change, and set right by the body's own measures. Of all,
    those are shown that differ most from the document and from each other, the least bending
    energy first. Raises EditError where nothing is free.
    """
    plan = plan_of((), document, document)
    columns = plan.columns if free is Free.POINTS else _fractions_alone(document, plan)
    holder = Holder(columns, plan.joints, plan.locks, plan.setting)
    moved = displacements(plan.start, columns)
    directions, reach = free_directions(holder.slopes(plan.start), moved, columns.cost, _DIRECTIONS)
    if len(directions) == 0:
        raise EditError(NoEdit.NOTHING_FREE)
    steps = list(_steps(directions, reach, columns.cost))
    chains = []
    for number, step in enumerate(steps):
        report(0.5 * number / len(steps))
        checkpoint()
        chain = _led_back(document, plan, holder, step)
        if chain is not None:
            chains.append(chain)
    return _chosen(document, plan, holder, chains, count, report)


def _fractions_alone(document: Document, plan: LockPlan) -> Columns:
    profile = document.profile
    count = len(profile)
    everything = [(k, i) for k in range(count) for i in range(4)]
    governed = {k for law in document.variation for k in range(count) if law.applies_to(k)}
    return Columns.of(profile, everything, governed)


def _steps(directions: Floats, reach: Floats, cost: Floats) -> Iterator[Floats]:
    """Yield steps of the unknowns: along each direction, and between each two, both ways."""
    count = len(directions)
    ways = [{k: sign} for k in range(count) for sign in (1.0, -1.0)]
    ways += [
        {j: one, k: other}
        for j in range(count)
        for k in range(j)
        for one in (1.0, -1.0)
        for other in (1.0, -1.0)
    ]
    for amplitude in _AMPLITUDES:
        for way in ways:
            step = np.zeros(directions.shape[1])
            for k, sign in way.items():
                step += sign * amplitude / reach[k] / np.sqrt(len(way)) * directions[k]
            farthest = float(np.abs(step * cost).max())
            yield step * min(1.0, _FARTHEST / farthest)


def _led_back(document: Document, plan: LockPlan, holder: Holder, step: Floats) -> Chain | None:
    """Return the chain after a step, back on all equations; None where that fails."""
    start, columns = plan.start, holder.columns
    shapes = [segment.shape for segment in document.profile.segments]
    nothing = np.zeros(len(step), dtype=bool)
    low, high = columns.bounds(start, nothing, shapes)
    flat = start.blocks.ravel() + columns.spread(np.clip(step, low, high), start.blocks.size)
    chain = start.with_blocks(flat.reshape(start.blocks.shape))
    solution = holder.solve(chain, chain, shapes)
    return solution.chain if solution.met else None


def _chosen(
    document: Document,
    plan: LockPlan,
    holder: Holder,
    chains: list[Chain],
    count: int,
    report: Callable[[float], object],
) -> tuple[Variant, ...]:
    """Return variants that lie farthest from the document and from each other."""
    own = profile_energy(document.profile, Energy.BENDING)
    most = float("inf") if own is None else _CROOKED * own
    places = [_curve(chain) for chain in chains]
    present = _curve(plan.start)
    far = [float(np.abs(each - present).max()) for each in places]
    found: list[Variant] = []
    while chains and len(found) < count:
        checkpoint()
        report(0.5 + 0.5 * len(found) / count)
        best = int(np.argmax(far))
        if far[best] < _APART:
            break
        far[best] = 0.0
        variant = _measured(document, _settled(document, plan, holder, chains[best]))
        if variant is None or variant.energy > most:
            continue
        found.append(variant)
        far = [
            min(so_far, float(np.abs(each - places[best]).max()))
            for so_far, each in zip(far, places, strict=True)
        ]
    return tuple(sorted(found, key=lambda each: each.energy))


def _settled(document: Document, plan: LockPlan, holder: Holder, chain: Chain) -> Document | None:
    """Return the document of a chain, its body's own measures as the locks say."""
    rough = modelled(document)
    shapes = [segment.shape for segment in document.profile.segments]
    locks = list(holder.locks)
    for _ in range(_SETTLING_ROUNDS):
        result = with_profile(document, chain.profile(document.profile, plan.start))
        worst = 0.0
        for k, lock in enumerate(locks):
            if lock.dimension.kind not in rough or lock.dimension.value is None:
                continue
            value = dimension_value(result, lock.dimension)
            if value is None:
                return None
            apart = value - lock.dimension.value
            worst = max(worst, abs(apart) / lock.scale)
            locks[k] = replace(lock, target=lock.target - apart)
        if worst <= _SETTLED:
            return result
        again = Holder(holder.columns, plan.joints, locks, plan.setting)
        solution = again.solve(chain, chain, shapes)
        if not solution.met:
            return None
        chain = solution.chain
    return None


def _curve(chain: Chain) -> Floats:
    """Return places on a chain, in sizes."""
    rows = basis.bernstein(4, np.linspace(0.0, 1.0, _PLACES))
    return np.asarray(np.einsum("sq,nqk->nsk", rows, chain.quartics))


def _measured(document: Document, made: Document | None) -> Variant | None:
    """Return what was made as a variant; None where a lock or a rule of the document is broken."""
    if made is None or missed_locks(made):
        return None
    energy = profile_energy(made.profile, Energy.BENDING)
    pairs = zip(measure_joints(document.profile), measure_joints(made.profile), strict=True)
    broken = any(old.holds and not new.holds for old, new in pairs)
    least = min(0.0, float(document.profile.quartics[..., 0].min()))
    if energy is None or broken or made.profile.quartics[..., 0].min() < least:
        return None
    return Variant(made, energy)
