"""Fair while a hand moves points: one short descent for each place that the hand comes to."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.design.demands.kept import Kept
from sgb_core.design.demands.projected import follow
from sgb_core.design.demands.sqp import minimise
from sgb_core.design.fairing.coupled import clusters
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.fair import stored
from sgb_core.design.fairing.findings import Freedom
from sgb_core.design.fairing.measure import segment_energies
from sgb_core.design.fairing.segments import Descent
from sgb_core.design.fairing.task import Task
from sgb_core.surfaces.laws.law import RADIUS
from sgb_core.surfaces.revolution import RevolutionSurface

# A part of the energy for which the hand's own valley is left when it lets go.
_WORTH = 1e-4
# Steps of the coupled search from afar, and from the last tick's end; when the hand lets go.
_STEPS, _WARM_STEPS, _LAST_ROUNDS = 6, 3, 40
_HELD = 1e-10
_NO_WORSE = 1.0 + 1e-9


def fair_beside(
    surface: RevolutionSurface,
    energy: Energy,
    segments: Collection[int],
    locks: Sequence[Kept],
    near: Floats | None,
    *,
    final: bool,
) -> tuple[Profile, Floats]:
    """Return a surface's profile with some segments made fair, and their chain's leg fractions.

    Only shape parameters move. The search goes down from the fractions ``near`` (n, 3), those of
    the last place of the hand. Segments that nothing couples are looked for everywhere where there
    are none, and once more when the hand lets go, ``final``: the valley of ``near`` is only left
    for one that is lower. Rules that hold and ``locks``, told in the size of the profile, go on
    holding; where no fairer shape is found that keeps them, it stays.
    """
    surface = replace(surface, laws=tuple(law for law in surface.laws if law.parameter != RADIUS))
    section = surface.profile_at(surface.start)
    held = tuple(each.rule if each.holds else JointRule.G0 for each in measure_joints(section))
    kept = replace(section, rules=held)
    task = Task.of(kept, energy, Freedom.SHAPE, segments, (), surface.laws, locks)
    moving = np.flatnonzero(task.limits.moving).tolist()
    groups = [moving] if locks else clusters(task.equations, len(section))
    groups = [group for group in groups if task.limits.moving[group].any()]
    coupled = {k for group in groups for k in group}
    single = [k for k in moving if k not in coupled]
    fractions = task.start.fractions.copy()
    if single:
        fractions[single] = _alone(task, single, near, look=final or near is None)
    for group in groups:
        fractions[group] = _together(task, group, near, final=final)
    blocks = task.start.blocks.copy()
    blocks[:, :3] = fractions
    found = task.start.with_blocks(blocks)
    return stored(surface, found.profile(section, task.start)), fractions


def _alone(task: Task, single: list[int], near: Floats | None, *, look: bool) -> Floats:
    """Return the fractions of segments of which each is a search of its own."""
    points = task.start.points[single]
    if near is None:
        return task.alone(single).fractions[single]
    with np.errstate(all="ignore"):
        followed = Descent(task.energy, points, task.limits.box[single], near[single]).run().place
    if not look:
        return followed
    everywhere = task.alone(single)
    blocks = task.start.blocks.copy()
    blocks[single, :3] = followed
    here, there = (
        segment_energies(task.energy, chain.quartics[single])
        for chain in (task.start.with_blocks(blocks), everywhere)
    )
    lower = there < here * (1.0 - _WORTH)
    return np.where(lower[:, None], everywhere.fractions[single], followed)


def _together(task: Task, group: list[int], near: Floats | None, *, final: bool) -> Floats:
    """Return the fractions of segments that rules or locks couple."""
    problem = replace(task.problem(group), exact=final)
    blocks = task.start.blocks.copy()
    if near is not None:
        blocks[:, :3] = near
    y = problem.unknowns.nearest(task.start.with_blocks(blocks))
    if final:
        solution = minimise(problem, y, rounds=_LAST_ROUNDS)
        y, met = solution.y, solution.met
    else:
        y, missed = follow(problem, problem.equations, y, _STEPS if near is None else _WARM_STEPS)
        met = missed <= _HELD
    present = problem.value(problem.unknowns.nearest(task.start))
    fairer = met and problem.value(y) <= present * _NO_WORSE
    return (problem.unknowns.chain(y) if fairer else task.start).fractions[group]
