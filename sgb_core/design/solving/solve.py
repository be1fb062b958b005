"""Reach targets together by the least change that keeps the joints' rules.

Sequential quadratic programming with exact derivatives; what is out of reach is told with the
nearest values that are not.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.continuity import JointClass, measure_joints
from sgb_core.curves.profile import SMOOTH_RULES, JointRule, Profile
from sgb_core.design.demands.chain import BLOCK, Chain
from sgb_core.design.demands.joints import (
    Equations,
    JointEquation,
    equations_of,
    joint_equations,
)
from sgb_core.design.demands.kept import Kept
from sgb_core.design.demands.sqp import Model, minimise
from sgb_core.design.demands.unknowns import Unknowns
from sgb_core.design.fairing.fair import changes
from sgb_core.design.fairing.findings import Change
from sgb_core.design.locks.readings import Setting
from sgb_core.design.solving.goals import Goal, Target, target
from sgb_core.design.solving.ways import STRETCHES, Slider, Way, solved_profile, unknowns_by
from sgb_core.findings.errors import FindingError
from sgb_core.findings.solving import Nearest, Unreachable
from sgb_core.values import dataclass

# Targets are reached to this part of them.
EXACT = 1e-9
_SOLVED = 1e-12
_PARTS = ("a", "b", "c")
_COORDINATES = ("r", "h")
# What pulls less than this part of all that pulls is not in the way.
_PULLS = 0.05


@dataclass(frozen=True, slots=True)
class Limits:
    """What does not change while targets are reached.

    ``kept`` goes on holding, as equations; ``fixed`` points (segment, point) and the shape of
    ``governed`` segments stay.
    """

    kept: Sequence[Kept] = ()
    fixed: Collection[tuple[int, int]] = ()
    governed: Collection[int] = ()


@dataclass(frozen=True, slots=True)
class Solved:
    """The profile that reaches its targets, the values of their models, and what moved.

    ``factor`` is that of a stretch, None where points or parameters moved by themselves;
    ``place`` (m,) are the unknowns, from where another search may go on.
    """

    profile: Profile
    reached: Mapping[Goal, float]
    moved: tuple[Change, ...]
    factor: float | None
    place: Floats


class UnreachableError(FindingError):
    """Nothing that is allowed reaches all targets; ``nearest`` is what comes nearest."""

    finding: Unreachable

    def __init__(self, finding: Unreachable, nearest: Solved) -> None:
        super().__init__(finding)
        self.nearest = nearest


@dataclass(frozen=True, slots=True)
class SolveProblem:
    """The least change under rules, what is kept and targets, or the targets' ``nearest`` miss."""

    unknowns: Unknowns
    joints: Sequence[JointEquation]
    kept: Sequence[Kept]
    targets: Sequence[Target]
    nearest: bool = False

    def values(self, y: Floats) -> tuple[float, Floats]:
        """Return the function and the residuals at y; infinite where there is no body."""
        chain = self.unknowns.chain(y)
        rules, missed = self._rules(chain).residual, self.missed(chain)
        residual = rules if self.nearest else np.concatenate([rules, missed])
        if not (np.isfinite(rules).all() and np.isfinite(missed).all()):
            # Without a measure that is wanted or kept: nowhere for a search to be.
            return np.inf, np.zeros(len(residual))
        value = 0.5 * float(missed @ missed) if self.nearest else 0.5 * float(y @ y)
        return value, residual

    def _rules(self, chain: Chain) -> Equations:
        found = joint_equations(chain, list(self.joints), second=False)
        for each in self.kept:
            found = found + each.equations(chain)
        return found

    def missed(self, chain: Chain) -> Floats:
        """Return by what part of each target a chain misses it."""
        return np.array([each.missed(chain) for each in self.targets])

    def expand(self, y: Floats, multipliers: Floats) -> Model:
        """Return the function and the equations at y to first order, with a convex Hessian."""
        chain, matrix = self.unknowns.chain(y), self.unknowns.matrix
        rules = self._rules(chain)
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

    def in_the_way(self, y: Floats, bound: NDArray[np.bool_]) -> tuple[str, ...]:
        """Return what of the kept holds the targets back at y, ``bound`` unknowns aside.

        There the targets' pull is a sum of the slopes of what is kept and of the rules.
        """
        here = replace(self, nearest=True).expand(y, np.zeros(0))
        slope = here.slope[:, ~bound]
        if not self.kept or not len(here.gradient[~bound]):
            return ()
        parts = np.linalg.lstsq(slope.T, here.gradient[~bound], rcond=None)[0]
        pulls = np.abs(parts) * np.hypot.reduce(slope, axis=1)
        least = _PULLS * float(pulls.max(initial=0.0))
        first = len(self.joints)
        owners = [
            each.name for each in self.kept for _ in each.equations(self.unknowns.chain(y)).residual
        ]
        found = dict.fromkeys(
            name for name, pull in zip(owners, pulls[first:], strict=True) if pull > least > 0.0
        )
        return tuple(found)


def solve(
    profile: Profile,
    setting: Setting,
    targets: Mapping[Goal, float],
    way: Way | Slider = Way.BOTH,
    limits: Limits | None = None,
    place: Floats | None = None,
) -> Solved:
    """Return the profile that reaches its targets, each to 1e-9 of it by its model.

    The search begins at ``place``, by default at the profile as it is. Targets are in the
    document's unit and above 0. Raises UnreachableError where they cannot be reached together,
    FindingError for a target that there is not with this ``setting``.
    """
    problem = _problem(profile, setting, targets, way, limits or Limits())
    begin = np.zeros(len(problem.unknowns)) if place is None else place
    found = minimise(problem, begin, exactness=_SOLVED)
    if np.abs(found.residual).max(initial=0.0) <= EXACT / 2.0:
        return _solved(problem, profile, way, found.y)
    near = _nearest_place(problem, found.y)
    raise UnreachableError(_nearest(problem, way, near), _solved(problem, profile, way, near))


def at_place(
    profile: Profile, setting: Setting, targets: Mapping[Goal, float], way: Way | Slider, at: Floats
) -> Solved:
    """Return what a place (m,) of the unknowns comes to, whatever it reaches."""
    return _solved(_problem(profile, setting, targets, way, Limits()), profile, way, at)


def _problem(
    profile: Profile,
    setting: Setting,
    targets: Mapping[Goal, float],
    way: Way | Slider,
    limits: Limits,
) -> SolveProblem:
    start = Chain.of(profile)
    wanted = [target(goal, setting, value, start) for goal, value in targets.items()]
    stretches = isinstance(way, Way) and way in STRETCHES
    unknowns = unknowns_by(way, profile, start, limits.fixed, limits.governed)
    points_move = way in (Way.POINTS, Way.BOTH)
    rules = {} if stretches else _rules(profile)
    joints = equations_of(rules, len(start), points_move=points_move)
    return SolveProblem(unknowns, joints, limits.kept, wanted)


def _solved(problem: SolveProblem, profile: Profile, way: Way | Slider, y: Floats) -> Solved:
    chain = problem.unknowns.chain(y)
    found = solved_profile(way, profile, problem.unknowns, y)
    return Solved(
        found,
        {each.goal: each.value * (1.0 + each.missed(chain)) for each in problem.targets},
        changes(profile, found),
        1.0 + float(y[0]) if isinstance(way, Way) and way in STRETCHES else None,
        y,
    )


def _rules(profile: Profile) -> dict[int, JointRule]:
    """Return what goes on holding: rules that hold now, of others G1 where the joint is smooth."""
    kept = {}
    for report in measure_joints(profile):
        if report.rule not in SMOOTH_RULES or report.measured in (JointClass.GAP, JointClass.G0):
            continue
        kept[report.joint] = report.rule if report.holds else JointRule.G1
    return kept


def _nearest_place(problem: SolveProblem, y: Floats) -> Floats:
    """Return where the targets are missed by the least, sought from the start and from y."""
    nearest = replace(problem, nearest=True)
    found = min(
        (minimise(nearest, place) for place in (np.zeros(len(y)), y)),
        key=lambda each: (not each.met, each.value),
    )
    return found.y


def _nearest(problem: SolveProblem, way: Way | Slider, y: Floats) -> Unreachable:
    """Return how near the targets can be reached, and what is at its limit there."""
    missed = problem.missed(problem.unknowns.chain(y))
    targets = tuple(
        Nearest(t.name, t.value, t.value * (1.0 + float(part)))
        for t, part in zip(problem.targets, missed, strict=True)
        if abs(part) > EXACT
    )
    bound = (y <= problem.unknowns.low) | (y >= problem.unknowns.high)
    held = problem.in_the_way(y, bound)
    if isinstance(way, Slider):
        return Unreachable(targets, ((way.segment, way.parameter),) if bound[0] else (), held)
    if way in STRETCHES:
        return Unreachable(targets, (), held)
    rows = np.abs(problem.unknowns.matrix[:, bound]).argmax(axis=0)
    return Unreachable(targets, tuple(_named(int(row)) for row in rows), held)


def _named(row: int) -> tuple[int, str]:
    segment, place = divmod(row, BLOCK)
    if place < 3:
        return segment, f"leg fraction {_PARTS[place]}"
    point, axis = divmod(place - 3, 2)
    return segment, f"P{point}.{_COORDINATES[axis]}"
