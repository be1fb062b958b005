"""What is to be made fair under which equations, and how it is solved."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.continuity import JointClass, JointReport, measure_joints
from sgb_core.curves.profile import SMOOTH_RULES, JointRule, Profile
from sgb_core.curves.segment import DEGENERATE_LEG
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.joints import JointEquation, equations_of
from sgb_core.design.demands.kept import Kept
from sgb_core.design.demands.unknowns import Unknowns, fraction_unknowns, with_inner_points
from sgb_core.design.fairing.coupled import clusters, solve_together
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.findings import (
    Freedom,
    Keep,
    KeptRule,
    LocksExcludeError,
)
from sgb_core.design.fairing.kept import kept_measures
from sgb_core.design.fairing.measure import segment_energies
from sgb_core.design.fairing.problem import FairProblem
from sgb_core.design.fairing.ranges import Ranges, ranges
from sgb_core.design.fairing.segments import fairest_fractions
from sgb_core.findings.fairing import JointInTheWay, MeasureInTheWay
from sgb_core.surfaces.laws.law import Law
from sgb_core.values import dataclass

# A change that gains less than this is none.
_NO_WORSE = 1.0 + 1e-12
# Residuals up to this hold.
_HELD = 1e-9
# Legs whose directions differ by less than this, in radians, are in line: 1e-6 degrees.
_ALIGNED = 1.7e-8


@dataclass(frozen=True, slots=True)
class Task:
    """The chain to be made fair, what may move, and what is kept.

    ``kept`` are the rules that hold, ``unmet`` those that do not and that nothing free restores.
    """

    start: Chain
    energy: Energy
    free: Freedom
    limits: Ranges
    equations: list[JointEquation]
    measures: list[Kept]
    fixed: frozenset[tuple[int, int]]
    near: Chain | None
    keeps_tangents: bool
    kept: tuple[KeptRule, ...]
    unmet: tuple[KeptRule, ...]

    @classmethod
    def of(
        cls,
        section: Profile,
        energy: Energy,
        free: Freedom,
        chosen: Collection[int],
        keep: Collection[Keep],
        laws: Sequence[Law],
        locks: Sequence[Kept] = (),
        fixed: Collection[tuple[int, int]] = (),
        near: Profile | None = None,
    ) -> Task:
        """Return the task for a profile, its rules sorted into kept and unmet.

        ``fixed`` points (segment, point) stay where they are, whatever is free. Where ``near`` is
        known to be almost the fairest, coupled segments are sought from there alone.
        """
        start = Chain.of(section)
        limits = ranges(start, section, energy, chosen, laws)
        # Points that slide along their legs turn none.
        legs_turn = free is Freedom.POINTS and Keep.TANGENTS not in keep
        rules: dict[int, JointRule] = {}
        kept: list[KeptRule] = []
        unmet: list[KeptRule] = []
        for report in measure_joints(section):
            if report.rule is JointRule.FREE:
                continue
            sides = section.neighbours(report.joint)
            solved = (
                report.rule in SMOOTH_RULES
                and any(limits.moving[side] for side in sides)
                and _can_hold(start, sides, report, legs_turn)
            )
            if solved:
                rules[report.joint] = report.rule
            (kept if solved or report.holds else unmet).append(KeptRule(report.joint, report.rule))
        return cls(
            start,
            energy,
            free,
            limits,
            equations_of(rules, len(start), points_move=legs_turn),
            [*kept_measures(keep, start), *locks],
            frozenset(fixed),
            None if near is None else start.told(near),
            Keep.TANGENTS in keep,
            tuple(kept),
            tuple(unmet),
        )

    def solve(self) -> Chain:
        """Return the fairest chain. Raises LocksExcludeError where nothing keeps all."""
        moving = np.flatnonzero(self.limits.moving).tolist()
        if not moving:
            return self.start
        alone = self.alone(moving)
        if self.free is Freedom.POINTS or self.measures:
            return self._together(moving, alone)
        groups = clusters(self.equations, len(self.start))
        coupled = {k for group in groups for k in group}
        blocks = self.start.blocks.copy()
        single = [k for k in moving if k not in coupled]
        blocks[single] = alone.blocks[single]
        for group in groups:
            blocks[group] = self._together(group, alone).blocks[group]
        return self.start.with_blocks(blocks)

    def alone(self, moving: list[int]) -> Chain:
        """Return the chain with the fractions that each segment would like best by itself."""
        blocks = self.start.blocks.copy()
        points, present = self.start.points[moving], self.start.fractions[moving]
        blocks[moving, :3] = fairest_fractions(
            self.energy, points, present, self.limits.box[moving]
        )
        return self.start.with_blocks(blocks)

    def problem(self, group: list[int]) -> FairProblem:
        """Return the search for some segments together."""
        return FairProblem(
            self._unknowns(group),
            self.energy,
            [k for k in group if self.limits.moving[k]],
            [each for each in self.equations if {each.before, each.after} & set(group)],
            self.measures,
            points_move=self.free is Freedom.POINTS,
            exact=False,
        )

    def _together(self, group: list[int], alone: Chain) -> Chain:
        problem = self.problem(group)
        unknowns = problem.unknowns
        starts = [unknowns.nearest(self.start), unknowns.nearest(alone)]
        if self.free is Freedom.POINTS:
            starts.append(unknowns.nearest(self._by_shape(alone)))
        if self.near is not None:
            starts = [unknowns.nearest(self.near)]
        scatter = self.near is None and self.free is Freedom.SHAPE
        found = solve_together(problem, starts, scatter=scatter)
        if not found.met:
            raise LocksExcludeError(self.obstacle(problem, found.residual))
        chain = unknowns.chain(found.y)
        return self.start if self._is_no_fairer(problem, chain) else chain

    def _by_shape(self, alone: Chain) -> Chain:
        """Return the fairest chain with all points where they are, or the start without any."""
        fixed = [each for each in self.equations if each.part != "tangent"]
        task = replace(self, free=Freedom.SHAPE, equations=fixed)
        try:
            return task.solve()
        except LocksExcludeError:
            return alone

    def _unknowns(self, group: list[int]) -> Unknowns:
        box, low, high = self.limits.box, self.start.fractions.copy(), self.start.fractions.copy()
        low[group], high[group] = box.low[group], box.high[group]
        blocks = self.start.blocks.copy()
        blocks[:, :3] = np.clip(blocks[:, :3], low, high)
        unknowns = fraction_unknowns(self.start.with_blocks(blocks), low, high)
        if self.free is Freedom.SHAPE:
            return unknowns
        moving = [k for k in group if self.limits.moving[k]]
        along = self.keeps_tangents
        return with_inner_points(unknowns, moving, along_tangents=along, fixed=self.fixed)

    def _is_no_fairer(self, problem: FairProblem, chain: Chain) -> bool:
        """Whether the start keeps all that is asked for and is no less fair than ``chain``."""
        if not np.array_equal(problem.unknowns.start.blocks, self.start.blocks):
            return False
        residual = problem.values(np.zeros(len(problem.unknowns.low)))[1]
        chosen = list(problem.segments)
        old, new = (
            float(segment_energies(self.energy, each.quartics[chosen]).sum())
            for each in (self.start, chain)
        )
        return float(np.abs(residual).max(initial=0.0)) <= _HELD and old <= new * _NO_WORSE

    def obstacle(self, problem: FairProblem, residual: Floats) -> JointInTheWay | MeasureInTheWay:
        """Return what a search is farthest from keeping."""
        worst = int(np.argmax(np.abs(residual)))
        missed = float(abs(residual[worst]))
        if worst >= len(problem.joints):
            return MeasureInTheWay(problem.measures[worst - len(problem.joints)].name, missed)
        equation = problem.joints[worst]
        rule = next(each.rule for each in self.kept if each.joint == equation.joint)
        return JointInTheWay(equation.joint, equation.after, rule.value, missed)


def _can_hold(chain: Chain, sides: tuple[int, int], report: JointReport, legs_turn: bool) -> bool:
    """Whether fractions (and points) can make a joint what its rule asks for.

    No fraction turns a leg, and a leg without length has no direction to go by.
    """
    before, after = chain.points[sides[0]], chain.points[sides[1]]
    legs = before[3] - before[2], after[1] - after[0]
    if any(float(np.hypot(leg[0], leg[1])) <= DEGENERATE_LEG for leg in legs):
        return False
    if report.measured is JointClass.GAP:
        return False
    if legs_turn:
        return True
    sine = float(legs[0][0] * legs[1][1] - legs[0][1] * legs[1][0])
    product = float(np.hypot(*legs[0]) * np.hypot(*legs[1]))
    return abs(sine) <= _ALIGNED * product and float(legs[0] @ legs[1]) > 0.0
