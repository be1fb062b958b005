"""Reaches targets of a whole document: models searched, the object's own measures set right."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from math import hypot

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.meridian import SolidError
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.directions import KeptDirections
from sgb_core.design.demands.kept import Kept
from sgb_core.design.fairing.findings import Keep
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.locks.readings import Setting
from sgb_core.design.locks.secants import Secants
from sgb_core.design.solving.goals import DIMENSIONS, OF_BODY, Goal, target
from sgb_core.design.solving.solve import (
    EXACT,
    Limits,
    Solved,
    UnreachableError,
    solve,
)
from sgb_core.design.solving.ways import (
    STRETCHES,
    Slider,
    Way,
)
from sgb_core.document.dimensions import dimension_value, setting_of
from sgb_core.document.edits.checks import with_profile
from sgb_core.document.errors import EditError
from sgb_core.document.lock_plan import lock_equations, locked_points
from sgb_core.document.model import Document
from sgb_core.findings.solving import NoTarget, Unreachable
from sgb_core.values import dataclass

_ROUNDS = 16
# A search whose way there is already known, or that only looks whether there is one, has so many.
FEW_ROUNDS = 6
_ALIKE = 1e-7
_NAMES = frozenset(goal.value for goal in Goal)
# A round that leaves more than this part of what was missed comes no nearer; so many end it.
_NEARER, _MOST_IDLE = 0.9, 4
_MEASURES = frozenset(Keep) - {Keep.ENDS, Keep.TANGENTS}


def never() -> bool:
    """Return that it is never enough: what is sought is sought to the end."""
    return False


def goal_value(document: Document, goal: Goal) -> float | None:
    """Return what a goal measures now, in the document's unit; None where there is no such."""
    return dimension_value(document, DIMENSIONS[goal])


@dataclass(frozen=True, slots=True)
class Reach:
    """A document, the values that it is to have, by what, and what stays.

    ``wanted`` holds the values of targets, ``held`` those of what is locked or kept. Once
    ``enough`` says so the nearest so far is what is found.
    """

    document: Document
    wanted: Mapping[Goal, float]
    held: Mapping[Goal, float]
    way: Way | Slider
    limits: Limits
    enough: Callable[[], bool] = never

    @classmethod
    def of(
        cls,
        document: Document,
        targets: Mapping[Goal, float],
        way: Way | Slider,
        keep: Collection[Keep],
        enough: Callable[[], bool] = never,
    ) -> Reach:
        """Return the task, its locks and what is kept sorted into values and equations."""
        profile = document.profile
        held: dict[Goal, float] = {}
        fixed = locked_points(document)
        for each in document.dimensions:
            goal = _goal_of(each)
            if goal is not None and each.value is not None:
                grams = setting_of(document).grams if each.kind is DimensionKind.MASS else 1.0
                held.setdefault(goal, each.value / grams)
        for goal in (Goal(name.value) for name in keep if name in _MEASURES):
            value = goal_value(document, goal)
            if value is None:
                raise EditError(NoTarget.FLAT)
            held.setdefault(goal, value)
        if Keep.ENDS in keep and not profile.closed:
            fixed += [(0, 0), (len(profile) - 1, 3)]
        kept: list[Kept] = [
            each for each in lock_equations(document) if _goal_of(each.lock.dimension) is None
        ]
        if Keep.TANGENTS in keep:
            kept.append(KeptDirections.of(Chain.of(profile)))
        governed = frozenset(
            k for law in document.variation for k in range(len(profile)) if law.applies_to(k)
        )
        held = {goal: value for goal, value in held.items() if goal not in targets}
        limits = Limits(kept, frozenset(fixed), governed)
        return cls(document, targets, held, way, limits, enough)

    @property
    def _line_is_locked(self) -> bool:
        return any(
            each.locked and each.kind is DimensionKind.FILL_LINE
            for each in self.document.dimensions
        )

    def setting(self) -> Setting:
        """Return what measures depend on; in a stretch a fill line goes with the whole."""
        setting = setting_of(self.document)
        stretches = isinstance(self.way, Way) and self.way in STRETCHES
        if setting.fill is None or not stretches or self._line_is_locked:
            return setting
        low, high = (float(corner[1]) for corner in self.document.profile.bounds())
        return replace(setting, share=(setting.fill - low) / (high - low) if high > low else None)

    def sought(
        self, values: Mapping[Goal, float], place: Floats | None, rounds: int = _ROUNDS
    ) -> Try:
        """Return what has all values, or what comes nearest, sought from a place of the unknowns.

        The search goes by the models of bodies; by how much their own measures differ from what
        the models were asked for is asked for besides the next time (a secant's step). Where a
        model leads to walls that do not fit it is asked for half the way; where no round comes
        nearer any more the nearest so far is what can be had.
        """
        document, setting = self.document, self.setting()
        start, asked, last = Chain.of(document.profile), dict(values), Secants()
        present = self.present(values)
        now = Solved(document.profile, present, (), None, np.zeros(0))
        best = Try(present, now, None, parts_missed(present, values))
        idle, walled = 0, False
        refused = None
        for _ in range(rounds):
            if self.enough():
                break
            refused = None
            targets = {goal: asked[goal] for goal in self.wanted}
            held = [target(goal, setting, asked[goal], start) for goal in self.held]
            limits = replace(self.limits, kept=[*self.limits.kept, *held])
            try:
                found = solve(document.profile, setting, targets, self.way, limits, place)
            except UnreachableError as error:
                refused, found = error.finding, error.nearest
            models = {**asked, **found.reached}
            try:
                reached = self.measured(self.taken(found), models)
            except (EditError, SolidError):
                walled, idle = True, idle + 1
                if idle >= _MOST_IDLE:
                    break
                asked = {goal: 0.5 * (value + best.asked[goal]) for goal, value in asked.items()}
                continue
            here = Try(
                asked, replace(found, reached=reached), refused, parts_missed(reached, values)
            )
            if all(abs(reached[goal] - value) <= EXACT * value for goal, value in values.items()):
                return replace(here, reached=True)
            idle = idle + 1 if here.missed > _NEARER * best.missed else 0
            best = min(best, here, key=lambda each: each.missed)
            apart = {goal: reached[goal] - value for goal, value in values.items()}
            # A value of 0 or less is none: half the way there leads on.
            following = {
                goal: max(last.following(goal, models[goal], part), 0.5 * asked[goal])
                for goal, part in apart.items()
            }
            if idle >= _MOST_IDLE or (refused is not None and _alike(asked, following)):
                break
            asked = following
        return replace(best, refused=best.refused or refused, walled=walled)

    def present(self, values: Mapping[Goal, float]) -> dict[Goal, float]:
        """Return what the document measures now, 0 for what it has not."""
        return {goal: goal_value(self.document, goal) or 0.0 for goal in values}

    def measured(self, result: Document, models: Mapping[Goal, float]) -> dict[Goal, float]:
        """Return the values that the object itself has, for those of its models."""
        values = dict(models)
        for goal in models:
            if goal in OF_BODY or (goal is Goal.VOLUME and result.variation):
                value = goal_value(result, goal)
                if value is None:
                    # The model knows nothing of walls that do not fit.
                    cross_section(replace(result.surface, laws=()), result.solid)
                    raise EditError(NoTarget.FLAT)
                values[goal] = value
        return values

    def taken(self, found: Solved) -> Document:
        """Return the document with a profile that was found."""
        result = with_profile(self.document, found.profile)
        line = self.document.manufacture.fill.height
        stays = self.way is Way.WIDTH or self._line_is_locked
        if line is None or found.factor is None or stays:
            return result
        low = float(self.document.profile.bounds()[0][1]) if self.way is Way.HEIGHT else 0.0
        fill = replace(self.document.manufacture.fill, height=low + (line - low) * found.factor)
        return replace(result, manufacture=replace(self.document.manufacture, fill=fill))

    def with_locks(self, result: Document, targets: Mapping[Goal, float]) -> Document:
        """Return the document whose locks of what was a target hold the new value."""

        def held(dimension: Dimension) -> Dimension:
            goal = _goal_of(dimension)
            if dimension.value is None or goal is None or goal not in targets:
                return dimension
            grams = dimension.kind is DimensionKind.MASS
            per = setting_of(self.document).grams if grams else 1.0
            return dimension.held_at(targets[goal] * per)

        dimensions = tuple(held(each) for each in result.dimensions)
        return result if dimensions == result.dimensions else replace(result, dimensions=dimensions)


@dataclass(frozen=True, slots=True)
class Try:
    """What was asked of the models, what was found and refused, and by how much it misses.

    ``walled`` says that the search was led to walls that do not fit.
    """

    asked: Mapping[Goal, float]
    found: Solved
    refused: Unreachable | None
    missed: float
    reached: bool = False
    walled: bool = False

    @property
    def is_certain(self) -> bool:
        """Whether something is at its limit or in the way, so that nothing else can be nearer."""
        return (
            not self.walled
            and self.refused is not None
            and bool(self.refused.limits or self.refused.held)
        )


def parts_missed(reached: Mapping[Goal, float], values: Mapping[Goal, float]) -> float:
    """Return by what parts of them values are missed, as the root of the sum of squares."""
    return hypot(*(reached[goal] / value - 1.0 for goal, value in values.items()))


def _alike(one: Mapping[Goal, float], other: Mapping[Goal, float]) -> bool:
    """Return whether nothing else would be asked for than was refused."""
    return all(abs(value - other[goal]) <= _ALIKE * value for goal, value in one.items())


def _goal_of(dimension: Dimension) -> Goal | None:
    """Return what a dimension is as a target, None where it is none."""
    if dimension.kind is DimensionKind.MASS:
        return Goal.MATERIAL
    return Goal(dimension.kind.value) if dimension.kind.value in _NAMES else None
