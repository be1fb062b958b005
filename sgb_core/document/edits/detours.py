"""Other ways to targets than the straight one, for where that leads nowhere."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from sgb_core.bodies.meridian import SolidError
from sgb_core.design.demands.chain import Chain
from sgb_core.design.solving.along import least_along
from sgb_core.design.solving.goals import Goal
from sgb_core.design.solving.solve import EXACT, Limits, Solved, UnreachableError, at_place
from sgb_core.design.solving.ways import STRETCHES, Slider, Way, place_of, unknowns_by
from sgb_core.document.edits.reach import FEW_ROUNDS, Reach, Try, parts_missed
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.solving import Nearest, Unreachable

# What is gone for in parts is so in no more than these; under laws each takes long.
_PARTS, _PARTS_UNDER_LAWS = 6, 2
# Places along the range of a single unknown.
_PLACES = 49


def reached(task: Reach) -> tuple[Document, Solved]:
    """Return the document that has all values, and what was found.

    Where the straight way ends without anything at its limit there are others: a single unknown
    is looked for along its whole range, points also begin where a stretch of the whole has what is
    wanted, and the values are gone for in parts. Raises UnreachableError with the nearest found.
    """
    values = {**task.held, **task.wanted}
    best = task.sought(values, None)
    single = isinstance(task.way, Slider) or task.way in STRETCHES
    for other in (_along,) if single else (_from_a_stretch, _by_parts):
        if not (best.reached or best.is_certain or task.enough()):
            best = other(task, values, best)
    if not best.reached:
        raise UnreachableError(_nearest(task, best), best.found)
    return task.taken(best.found), best.found


def _from_a_stretch(task: Reach, values: Mapping[Goal, float], straight: Try) -> Try:
    """Return what is found from where a stretch of the whole has what is wanted."""
    best, limits, drawn = straight, task.limits, task.document.profile
    if task.way not in (Way.BOTH, Way.POINTS):
        return best
    for way in STRETCHES:
        stretched = replace(task, way=way, held={}, limits=Limits())
        found = stretched.sought(task.wanted, None, FEW_ROUNDS)
        if not found.reached:
            continue
        place = place_of(found.found.profile, task.way, drawn, limits.fixed, limits.governed)
        here = task.sought(values, place, FEW_ROUNDS)
        if here.reached or here.missed < best.missed:
            best = here
        if best.reached:
            return best
        if not (task.held or limits.kept or limits.fixed):
            # The points of a stretch keep the rules, though others might change less.
            there = at_place(drawn, task.setting(), values, task.way, place)
            measured = task.measured(task.taken(there), {**values, **there.reached})
            if parts_missed(measured, values) <= EXACT:
                return replace(found, found=replace(there, reached=measured))
    return best


def _along(task: Reach, values: Mapping[Goal, float], straight: Try) -> Try:
    """Return what a single unknown reaches, looked for along its whole range."""
    if len(values) > 1 or task.limits.kept or task.document.variation:
        return straight
    profile, setting = task.document.profile, task.setting()
    unknowns = unknowns_by(task.way, profile, Chain.of(profile))
    low, high = float(unknowns.low[0]), float(unknowns.high[0])

    def tried(at: float) -> Try | None:
        found = at_place(profile, setting, values, task.way, np.array([at]))
        try:
            reached = task.measured(task.taken(found), {**values, **found.reached})
        except (EditError, SolidError):
            return None
        missed = parts_missed(reached, values)
        return Try(values, replace(found, reached=reached), None, missed, missed <= EXACT)

    def apart(at: float) -> float:
        found, ((goal, value),) = tried(at), values.items()
        return np.nan if found is None else found.found.reached[goal] / value - 1.0

    if isinstance(task.way, Slider):
        places = np.linspace(low, high, _PLACES)
    else:
        places = np.geomspace(1.0 + low, 1.0 + high, _PLACES) - 1.0
    found = tried(least_along(places, apart))
    return straight if found is None or found.missed > straight.missed else found


def _by_parts(task: Reach, values: Mapping[Goal, float], straight: Try) -> Try:
    """Return what is found by going from what is now to what is wanted in parts."""
    best, present = straight, task.present(values)
    if not all(value > 0.0 for value in present.values()):
        return best
    part, step, place = 0.0, 0.5, None
    for _ in range(_PARTS if not task.document.variation else _PARTS_UNDER_LAWS):
        aim = min(part + step, 1.0)
        between = {
            goal: present[goal] ** (1.0 - aim) * value**aim for goal, value in values.items()
        }
        if task.enough():
            break
        found = task.sought(between, place, FEW_ROUNDS)
        here = replace(found, missed=parts_missed(found.found.reached, values))
        if here.missed < best.missed:
            best = replace(here, reached=False)
        if not found.reached:
            step *= 0.5
            continue
        if aim == 1.0:
            return found
        part, step, place = aim, 2.0 * step, found.found.place
    return best


def _nearest(task: Reach, best: Try) -> Unreachable:
    """Return what is out of reach by the object's own measures."""
    final = not task.enough()
    missed = tuple(
        Nearest(goal.value, value, best.found.reached[goal], final=final)
        for goal, value in task.wanted.items()
        if abs(best.found.reached[goal] - value) > EXACT * value
    )
    finding = best.refused or Unreachable(missed, ())
    held = (*finding.held, *(("wall",) if best.walled else ()))
    return replace(finding, targets=missed, held=held)
