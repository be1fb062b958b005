"""The edit that reaches several targets together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sgb_core.bodies.meridian import SolidError
from sgb_core.design.solving.goals import Goal
from sgb_core.design.solving.solve import Solved, solve
from sgb_core.design.solving.ways import Slider, Way
from sgb_core.document.edits.checks import positive, segment_number, with_profile
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoEdit
from sgb_core.findings.errors import FindingError


def solve_targets(
    document: Document, targets: Mapping[Goal, float], way: Way | Slider = Way.BOTH
) -> tuple[Document, Solved]:
    """Return the document that reaches its targets, each to 1e-9 of it, and what was found.

    Targets are in the document's unit and its powers. Walls, base and the rest stay; the fill line
    goes with the height of a stretch. Raises EditError with what is in the way: a target out of
    reach with the nearest that is not, laws, a body that has no such measure.
    """
    if document.variation:
        raise EditError(NoEdit.LAWS)
    if isinstance(way, Slider):
        segment_number(document, way.segment)
    for goal, value in targets.items():
        positive(value, goal.value)
    try:
        found = solve(document.surface, document.solid, targets, way)
    except (FindingError, SolidError) as error:
        raise EditError(error.finding) from None
    result = with_profile(document, found.profile)
    line = document.manufacture.fill.height
    if line is None or found.factor is None or way is Way.WIDTH:
        return result, found
    low = float(document.profile.bounds()[0][1]) if way is Way.HEIGHT else 0.0
    fill = replace(document.manufacture.fill, height=low + (line - low) * found.factor)
    return replace(result, manufacture=replace(document.manufacture, fill=fill)), found
