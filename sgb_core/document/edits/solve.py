"""The edit that reaches several targets together."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from sgb_core.bodies.meridian import SolidError
from sgb_core.design.fairing.findings import Keep
from sgb_core.design.solving.goals import OF_BODY, Goal
from sgb_core.design.solving.solve import Solved, UnreachableError
from sgb_core.design.solving.ways import Slider, Way
from sgb_core.document.edits.checks import positive, segment_number
from sgb_core.document.edits.detours import reached as reached_by
from sgb_core.document.edits.reach import Reach
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoEdit
from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding
from sgb_core.findings.solving import Unreachable

_VOLUMES = OF_BODY | {Goal.VOLUME}


class OutOfReachError(EditError):
    """Targets are out of reach; ``nearest`` is the document that comes nearest to them."""

    def __init__(self, finding: Finding, nearest: Document) -> None:
        super().__init__(finding)
        self.nearest = nearest


def solve_targets(
    document: Document,
    targets: Mapping[Goal, float],
    way: Way | Slider = Way.BOTH,
    keep: Collection[Keep] = (),
) -> tuple[Document, Solved]:
    """Return the document that reaches its targets, each to 1e-9 of it, and what was found.

    Targets are in the document's unit and its powers. Locks hold, one of what is a target takes
    on its value; walls, base and the rest stay; the fill line goes with the height of a stretch.
    Raises OutOfReachError with the nearest that can be had and what is at its limit there, and
    EditError for a body that has no such measure.
    """
    if isinstance(way, Slider):
        segment_number(document, way.segment)
        if any(
            law.parameter == way.parameter and law.applies_to(way.segment)
            for law in document.variation
        ):
            raise EditError(NoEdit.LAWS)
    for goal, value in targets.items():
        positive(value, goal.value)
    task = Reach.of(document, targets, way, keep)
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
