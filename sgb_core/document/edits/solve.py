"""The edit that reaches several targets together."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace

from sgb_core.bodies.meridian import SolidError
from sgb_core.design.fairing.findings import Keep
from sgb_core.design.solving.goals import OF_BODY, Goal
from sgb_core.design.solving.solve import Solved, UnreachableError
from sgb_core.design.solving.ways import Slider, Way
from sgb_core.document.edits.checks import positive, segment_number
from sgb_core.document.edits.detours import reached as reached_by
from sgb_core.document.edits.reach import Reach, never
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoEdit
from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding
from sgb_core.findings.solving import Nearest, Unreachable

# Relief and holes are of a mesh, whose volume is known to this part alone.
_WORKED_ROUNDS, _WORKED_EXACT = 8, 1e-4
_VOLUMES = OF_BODY | {Goal.VOLUME}


class OutOfReachError(EditError):
    """Targets are out of reach; ``nearest`` is the document that comes nearest to them."""

    def __init__(self, finding: Finding, nearest: Document) -> None:
        super().__init__(finding)
        self.nearest = nearest

    @property
    def is_final(self) -> bool:
        """Whether all was looked through; else more time may come nearer."""
        return not isinstance(self.finding, Unreachable) or all(
            each.final for each in self.finding.targets
        )


def solve_targets(
    document: Document,
    targets: Mapping[Goal, float],
    way: Way | Slider = Way.BOTH,
    keep: Collection[Keep] = (),
    enough: Callable[[], bool] = never,
) -> tuple[Document, Solved]:
    """Return the document that reaches its targets, each to 1e-9 of it, and what was found.

    Targets are in the document's unit and its powers. Locks hold, one of what is a target takes
    on its value; walls, base and the rest stay; the fill line goes with the height of a stretch.
    Material with relief or holes, which a mesh tells, is reached to 1e-4 of it. Raises
    OutOfReachError with the nearest that can be had and what is at its limit there, or with the
    nearest so far once ``enough`` says so, and EditError for a body that has no such measure.
    """
    for goal, value in targets.items():
        positive(value, goal.value)
    if Goal.MATERIAL not in targets:
        return _smooth(document, targets, way, keep, enough)
    wanted, result, more = targets[Goal.MATERIAL], document, worked_material(document)
    reached = wanted
    if more == 0.0:
        return _smooth(document, targets, way, keep, enough)
    for _ in range(_WORKED_ROUNDS):
        # A value of 0 or less is none.
        asked = {**targets, Goal.MATERIAL: max(wanted - more, 0.5 * wanted)}
        try:
            result, found = _smooth(document, asked, way, keep, enough)
        except OutOfReachError as error:
            raise OutOfReachError(_with_more(error.finding, more), error.nearest) from None
        before, more = more, worked_material(result)
        reached = found.reached[Goal.MATERIAL] + more
        if abs(more - before) <= _WORKED_EXACT * wanted:
            return result, replace(found, reached={**found.reached, Goal.MATERIAL: reached})
    nearest = Nearest(Goal.MATERIAL.value, wanted, reached)
    raise OutOfReachError(_in_units(document, Unreachable((nearest,), ())), result)


def worked_material(document: Document) -> float:
    """Return how much material relief adds and holes take, in unit³; less than 0 where they take.

    Raises EditError where they cannot be made.
    """
    body = document.body()
    if body.relief is None and not body.patterns:
        return 0.0
    try:
        return body.worked.added - body.worked.removed
    except FindingError as error:
        raise EditError(error.finding) from None


def _with_more(finding: Finding, more: float) -> Finding:
    """Return what is out of reach with the material that relief and holes make of it."""
    assert isinstance(finding, Unreachable)
    return replace(
        finding,
        targets=tuple(
            replace(each, wanted=each.wanted + more, nearest=each.nearest + more)
            if each.target == Goal.MATERIAL
            else each
            for each in finding.targets
        ),
    )


def _smooth(
    document: Document,
    targets: Mapping[Goal, float],
    way: Way | Slider,
    keep: Collection[Keep],
    enough: Callable[[], bool],
) -> tuple[Document, Solved]:
    """Return the document that reaches its targets without its relief and holes."""
    if isinstance(way, Slider):
        segment_number(document, way.segment)
        if any(
            law.parameter == way.parameter and law.applies_to(way.segment)
            for law in document.variation
        ):
            raise EditError(NoEdit.LAWS)
    task = Reach.of(document, targets, way, keep, enough)
    try:
        result, found = reached_by(task)
    except UnreachableError as error:
        nearest = task.taken(error.nearest)
        raise OutOfReachError(_in_units(document, error.finding), nearest) from None
    except (FindingError, SolidError) as error:
        raise EditError(error.finding) from None
    reached = {goal: value for goal, value in found.reached.items() if goal in targets}
    return task.with_locks(result, targets), replace(found, reached=reached)


def _in_units(document: Document, finding: Unreachable) -> Unreachable:
    """Return a finding with its values as people read them: volumes in millilitres."""
    unit = document.unit
    return replace(
        finding,
        targets=tuple(
            replace(each, scale=unit.millilitres, unit=" ml")
            if Goal(each.target) in _VOLUMES
            else replace(each, unit=f" {unit}")
            for each in finding.targets
        ),
    )
