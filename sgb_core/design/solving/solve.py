"""Reach targets together by the least change that keeps the joints' rules.

Sequential quadratic programming with exact derivatives; what is out of reach is told with the
nearest values that are not.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import Solid
from sgb_core.curves.continuity import JointClass, measure_joints
from sgb_core.curves.profile import SMOOTH_RULES, JointRule, Profile
from sgb_core.design.demands.chain import BLOCK, Chain
from sgb_core.design.demands.joints import (
    Equations,
    JointEquation,
    equations_of,
    joint_equations,
)
from sgb_core.design.demands.kept import KeptMeasure
from sgb_core.design.demands.sqp import Model, minimise
from sgb_core.design.demands.unknowns import Unknowns
from sgb_core.design.fairing.fair import changes
from sgb_core.design.fairing.findings import Change
from sgb_core.design.solving.goals import Goal, GoalMeasure, goal_measure
from sgb_core.design.solving.ways import Slider, Way, solved_profile, unknowns_by
from sgb_core.findings.errors import FindingError
from sgb_core.findings.solving import Nearest, NoTarget, Unreachable
from sgb_core.surfaces.revolution import RevolutionSurface

# Targets are reached to this part of them.
EXACT = 1e-9
_SOLVED = 1e-12
_PARTS = ("a", "b", "c")
_COORDINATES = ("r", "h")


@dataclass(frozen=True, slots=True)
class Solved:
    """The profile that reaches its targets, the values reached, and what moved.

    ``factor`` is that of a stretch, None where points or parameters moved by themselves.
    """

    profile: Profile
    reached: Mapping[Goal, float]
    moved: tuple[Change, ...]
    factor: float | None


class UnreachableError(FindingError):
    """Nothing that is allowed reaches all targets."""

    finding: Unreachable


@dataclass(frozen=True, slots=True)
class SolveProblem:
    """The least change under rules and targets or, where ``nearest``, the targets' least miss."""

    unknowns: Unknowns
    joints: Sequence[JointEquation]
    targets: Sequence[KeptMeasure]
    measures: Sequence[GoalMeasure]
    nearest: bool = False

    def values(self, y: Floats) -> tuple[float, Floats]:
        """Return the function and the residuals at y; infinite where there is no body."""
        chain = self.unknowns.chain(y)
        rules = joint_equations(chain, list(self.joints), second=False).residual
        try:
            missed = self.missed(chain)
        except SolidError:
            return np.inf, np.concatenate(
                [rules, np.zeros(0 if self.nearest else len(self.targets))]
            )
        if self.nearest:
            return 0.5 * float(missed @ missed), rules
        return 0.5 * float(y @ y), np.concatenate([rules, missed])

    def missed(self, chain: Chain) -> Floats:
        """Return by what part of each target a chain misses it."""
        return np.array(
            [
                (measure.value(chain) - target.value) / target.scale
                for measure, target in zip(self.measures, self.targets, strict=True)
            ]
        )

    def expand(self, y: Floats, multipliers: Floats) -> Model:
        """Return the function and the equations at y to first order, with a convex Hessian."""
        chain, matrix = self.unknowns.chain(y), self.unknowns.matrix
        rules = joint_equations(chain, list(self.joints), second=False)
        targets = Equations.none(chain.blocks.size)
        for each in self.targets:
            targets = targets + each.equations(chain)
        if self.nearest:
            slope = targets.slope @ matrix
            hessian = slope.T @ slope
            hessian[np.diag_indices(len(y))] += 1e-9 * max(float(np.abs(hessian).max()), 1e-9)
            value = 0.5 * float(targets.residual @ targets.residual)
            pull = slope.T @ targets.residual
            return Model(value, pull, hessian, rules.residual, rules.slope @ matrix)
        both = rules + targets
        return Model(
            0.5 * float(y @ y), y.copy(), np.eye(len(y)), both.residual, both.slope @ matrix
        )


def solve(
    surface: RevolutionSurface,
    solid: Solid,
    targets: Mapping[Goal, float],
    way: Way | Slider = Way.BOTH,
) -> Solved:
    """Return the profile of a surface that reaches its targets, each to 1e-9 of it.

    Targets are in the document's unit and above 0. Raises UnreachableError where they cannot be
    reached together, FindingError for a target that this body does not have, SolidError where the
    body as it is cannot be made.
    """
    start = Chain.of(surface.profile)
    wanted: list[KeptMeasure] = []
    goals: list[GoalMeasure] = []
    for goal, value in targets.items():
        measure = goal_measure(goal, surface, solid, start)
        if not measure.value(start) > 0.0:
            raise FindingError(NoTarget.FLAT)
        goals.append(measure)
        wanted.append(KeptMeasure(goal.value, measure, value, value))
    unknowns = unknowns_by(way, surface.profile, start)
    points_move = way in (Way.POINTS, Way.BOTH)
    rules = {} if isinstance(way, Way) and way in _STRETCHES else _rules(surface.profile)
    joints = equations_of(rules, len(start), points_move=points_move)
    problem = SolveProblem(unknowns, joints, wanted, goals)
    found = minimise(problem, np.zeros(len(unknowns)), exactness=_SOLVED)
    y = found.y
    if not np.abs(found.residual).max(initial=0.0) <= EXACT / 2.0:
        raise UnreachableError(_nearest(problem, way, y))
    chain = unknowns.chain(y)
    profile = solved_profile(way, surface.profile, unknowns, y)
    return Solved(
        profile,
        {g: m.value(chain) for g, m in zip(targets, goals, strict=True)},
        changes(surface.profile, profile),
        1.0 + float(y[0]) if isinstance(way, Way) and way in _STRETCHES else None,
    )


_STRETCHES = (Way.ALL, Way.HEIGHT, Way.WIDTH)


def _rules(profile: Profile) -> dict[int, JointRule]:
    """Return what goes on holding: rules that hold now, of others G1 where the joint is smooth."""
    kept = {}
    for report in measure_joints(profile):
        if report.rule not in SMOOTH_RULES or report.measured in (JointClass.GAP, JointClass.G0):
            continue
        kept[report.joint] = report.rule if report.holds else JointRule.G1
    return kept


def _nearest(problem: SolveProblem, way: Way | Slider, y: Floats) -> Unreachable:
    """Return how near the targets can be reached, and what is at its limit there."""
    nearest = replace(problem, nearest=True)
    zero = np.zeros(len(y))
    found = min(
        (minimise(nearest, place) for place in (zero, y)),
        key=lambda each: (not each.met, each.value),
    )
    chain = problem.unknowns.chain(found.y)
    missed = problem.missed(chain)
    targets = tuple(
        Nearest(t.name, t.value, t.value * (1.0 + float(part)))
        for t, part in zip(problem.targets, missed, strict=True)
        if abs(part) > EXACT
    )
    if isinstance(way, Slider):
        held = found.y[0] <= problem.unknowns.low[0] or found.y[0] >= problem.unknowns.high[0]
        return Unreachable(targets, ((way.segment, way.parameter),) if held else ())
    if way in _STRETCHES:
        return Unreachable(targets, ())
    bound = (found.y <= problem.unknowns.low) | (found.y >= problem.unknowns.high)
    rows = np.abs(problem.unknowns.matrix[:, bound]).argmax(axis=0)
    return Unreachable(targets, tuple(_named(int(row)) for row in rows))


def _named(row: int) -> tuple[int, str]:
    segment, place = divmod(row, BLOCK)
    if place < 3:
        return segment, f"leg fraction {_PARTS[place]}"
    point, axis = divmod(place - 3, 2)
    return segment, f"P{point}.{_COORDINATES[axis]}"
