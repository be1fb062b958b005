"""Segments that equations couple, made fair together from several starts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.design.demands.joints import JointEquation
from sgb_core.design.demands.sqp import Solution, minimise
from sgb_core.design.fairing.problem import FairProblem

# Random starts by the number of coupled segments: the more there are, the longer each takes.
_STARTS = ((3, 8), (6, 5), (12, 3))
_FEW_STARTS = 1
_MOST_MEASURED = 6
_SEED = 7
# A search counts what it gains down to this part; the best is then followed to the end.
_PRECISION = 1e-5


def clusters(equations: Sequence[JointEquation], count: int) -> list[list[int]]:
    """Return the groups of segments that equations couple, those that none couples left out."""
    group = list(range(count))

    def root(k: int) -> int:
        while group[k] != k:
            k = group[k]
        return k

    for each in equations:
        group[root(each.before)] = root(each.after)
    members: dict[int, list[int]] = {}
    coupled = {k for each in equations for k in (each.before, each.after)}
    for k in sorted(coupled):
        members.setdefault(root(k), []).append(k)
    return list(members.values())


def solve_together(problem: FairProblem, starts: Sequence[Floats], scatter: bool) -> Solution:
    """Return the best that the search finds from some starts, and from random ones.

    Where nothing meets all equations, what comes nearest to it. Among the starts, those of
    infinite energy are passed over.
    """
    best: Solution | None = None
    for y in _all_starts(problem, starts, scatter):
        if not np.isfinite(problem.values(y)[0]):
            continue
        found = minimise(problem, y, precision=_PRECISION, exactness=1e-9)
        if best is None or _key(found) < _key(best):
            best = found
    if best is None:
        y = np.clip(
            np.zeros(len(problem.unknowns.low)), problem.unknowns.low, problem.unknowns.high
        )
        value, residual = problem.values(y)
        return Solution(y, value, residual, met=False)
    if not best.met:
        return best
    exact = minimise(replace(problem, exact=True), best.y, rounds=20)
    return exact if exact.met else best


def _key(solution: Solution) -> tuple[float, float]:
    missed = float(np.abs(solution.residual).max(initial=0.0))
    return (0.0, solution.value) if solution.met else (missed, solution.value)


def _all_starts(problem: FairProblem, starts: Sequence[Floats], scatter: bool) -> Iterator[Floats]:
    yield from starts
    if not scatter:
        return
    count = len(problem.segments)
    if count > _MOST_MEASURED and not problem.joints:
        # Measures alone make no new valleys, and many segments are seldom in a wrong one.
        return
    number = next((many for most, many in _STARTS if count <= most), _FEW_STARTS)
    rng = np.random.default_rng(_SEED)
    for _ in range(number):
        part: NDArray[np.float64] = rng.uniform(0.1, 0.95, len(problem.unknowns.low))
        yield problem.unknowns.low + part * (problem.unknowns.high - problem.unknowns.low)
