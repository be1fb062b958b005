"""Joints of equal curvature on both sides, on wish."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.tracing.chain import Chain, Layout, slopes
from sgb_core.design.tracing.conditions import Condition, KeepsCurvature, Rows
from sgb_core.design.tracing.search import within
from sgb_core.design.tracing.solver import Cloud, State, least_squares, measured

_ROUNDS = 8
_WEIGHTS = (0.1, 1.0, 10.0, 100.0, 1000.0)
# Newton's steps onto the equations themselves, and when they hold: jumps times the size.
_STEPS, _HOLDS = 12, 1e-11


def with_equal_curvature(state: State, cloud: Cloud, others: list[Condition]) -> State:
    """Return the chain with equal curvatures at all its smooth joints, as near as it can be."""
    joints = _smooth_joints(state.chain.layout)
    if not joints:
        return state
    # Ever heavier: at once, the equations would be all that counts.
    for weight in _WEIGHTS:
        conditions: list[Condition] = [*others, KeepsCurvature(joints, weight)]
        state = least_squares(state, cloud, _ROUNDS, conditions)
    state = within(state, cloud, conditions)
    equal = KeepsCurvature(joints, 1.0)
    chain = state.chain
    for _ in range(_STEPS):
        jumps, rows = _equations(chain, equal)
        if np.abs(jumps).max() <= _HOLDS:
            break
        step = np.linalg.lstsq(rows, jumps, rcond=None)[0]
        chain = chain.moved(np.asarray(-step), chain.layout.numbering())
    return measured(chain, cloud, state.feet)


def _smooth_joints(layout: Layout) -> list[tuple[int, int]]:
    nodes = range(layout.nodes) if layout.closed else range(1, layout.count)
    return [((k - 1) % layout.count, k) for k in nodes if k not in layout.corners]


def _equations(chain: Chain, equal: KeepsCurvature) -> tuple[Floats, Floats]:
    """Return the curvature jumps and their slopes by the unknowns."""
    numbering = chain.layout.numbering()
    rows = Rows(np.zeros((0, 10)), (), slopes(chain.frames, chain.layout.straight), numbering)
    return equal(chain, np.zeros(0), rows)
