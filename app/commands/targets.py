"""Targets of one window's object: what they measure now, and the search for them, aside."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field, replace
from math import inf
from time import monotonic
from typing import TYPE_CHECKING

from app.state.jobs import Job, Jobs, Report
from sgb_core.design.fairing.findings import Keep
from sgb_core.design.solving.goals import Goal
from sgb_core.design.solving.solve import Solved
from sgb_core.design.solving.ways import Slider, Way
from sgb_core.document.body_measures import mass_in_grams
from sgb_core.document.edits.reach import goal_value
from sgb_core.document.edits.solve import solve_targets, worked_material
from sgb_core.document.model import Document
from sgb_core.values import dataclass

if TYPE_CHECKING:
    from sgb_core.document.body_state import BodyState

LABEL = "Reach targets"
# Seconds that a person waits for an answer; then the nearest so far is one.
PATIENCE = 2.0


@dataclass(frozen=True, slots=True)
class Line:
    """One thing that can be asked for: the goal, its words, and its unit ("": a length).

    ``tip`` is what it is. A mass is a material that weighs so much.
    """

    goal: Goal
    words: str
    unit: str
    tip: str
    mass: bool = False

    def unit_in(self, document: Document) -> str:
        """Return the unit that its field counts in."""
        return self.unit or str(document.unit)

    def factor(self, document: Document) -> float:
        """Return by what a value in the document's unit is multiplied for its field."""
        if self.mass:
            return mass_in_grams(document, 1.0)
        return document.unit.millilitres if self.unit == "ml" else 1.0


LINES = (
    Line(Goal.CAPACITY, "Capacity", "ml", "What the vessel holds to the brim"),
    Line(Goal.FILLED, "To the fill line", "ml", "What the vessel holds to its fill line"),
    Line(Goal.VOLUME, "Volume", "ml", "What the drawn surface encloses"),
    Line(Goal.MATERIAL, "Material", "ml", "The volume of the material"),
    Line(Goal.MATERIAL, "Mass", "g", "The mass of the material", mass=True),
    Line(Goal.HEIGHT, "Height", "", "From the lowest to the highest place of the profile"),
    Line(Goal.MAX_DIAMETER, "Greatest diameter", "", "Where the profile is widest"),
    Line(Goal.RIM_DIAMETER, "Rim diameter", "", "At the upper end of the profile"),
    Line(
        Goal.FOOT_DIAMETER,
        "Foot diameter",
        "",
        "Where it stands: at its lower end, or where a closed bottom ends",
    ),
)
WAYS: Mapping[Way, str] = {
    Way.BOTH: "The mildest change of points and shape",
    Way.SHAPE: "Shape parameters alone",
    Way.POINTS: "Control points alone",
    Way.ALL: "The size as a whole",
    Way.HEIGHT: "The height alone",
    Way.WIDTH: "The width alone",
}


@dataclass(frozen=True, slots=True)
class Asked:
    """What is asked for of a document: targets in its unit, by what, and what stays."""

    document: Document
    targets: Mapping[Goal, float]
    way: Way | Slider
    keep: frozenset[Keep]
    patience: float = field(default_factory=lambda: PATIENCE)

    @property
    def to_the_end(self) -> Asked:
        """The same, looked for however long it takes."""
        return replace(self, patience=inf)


def values_now(document: Document, body: BodyState | None = None) -> dict[Goal, float]:
    """Return what can be a target of a document, and its value; ``body`` is what was made of it."""
    found = {goal: goal_value(document, goal) for goal in Goal}
    material = found[Goal.MATERIAL]
    if material is not None:
        made = None if body is None or body.document is not document else body.measures
        found[Goal.MATERIAL] = (
            material + worked_material(document) if made is None else made.vessel.material_volume
        )
    return {goal: value for goal, value in found.items() if value is not None and value > 0.0}


class Search:
    """Looks for targets aside, one search at a time: the newest question is the one answered."""

    def __init__(
        self,
        jobs: Jobs,
        found: Callable[[Asked, Document, Solved], object],
        refused: Callable[[Asked, Exception], object],
        stopped: Callable[[], object],
    ) -> None:
        self._jobs = jobs
        self._found = found
        self._refused = refused
        self._stopped = stopped
        self._job: Job | None = None

    @property
    def busy(self) -> bool:
        """Whether an answer is still to come."""
        return self._job is not None

    def start(self, asked: Asked) -> None:
        """Look for what is asked; an older search is dropped."""
        self.drop()

        def work(report: Report) -> tuple[Document, Solved]:
            began = monotonic()

            def enough() -> bool:
                part = (monotonic() - began) / asked.patience
                report(min(part, 1.0))
                return part >= 1.0

            return solve_targets(
                asked.document, asked.targets, asked.way, asked.keep, enough=enough
            )

        def done(result: tuple[Document, Solved]) -> None:
            self._job = None
            self._found(asked, *result)

        def failed(error: Exception) -> None:
            self._job = None
            self._refused(asked, error)

        def cancelled() -> None:
            self._job = None
            self._stopped()

        self._job = self._jobs.start(Job(LABEL, work, done, failed, cancelled))

    def drop(self) -> None:
        """Ask for nothing any more."""
        job, self._job = self._job, None
        if job is not None:
            job.drop()
