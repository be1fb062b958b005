"""What follows from a document: computed once, when asked for, and reused while it holds.

``evaluate`` itself does next to nothing, so it can be called on each tick of a slider. What a
view asks for is computed then and kept; the evaluation of the next document takes over
whatever depends only on parts that are the very same values as before.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from functools import cached_property

from sgb_core.arrays import Floats, frozen
from sgb_core.curves.continuity import JointReport, measure_joints
from sgb_core.curves.crossings import (
    BeyondAxis,
    Certificates,
    Crossing,
    axis_crossings,
    certificates,
    self_intersections,
)
from sgb_core.curves.profile import Profile
from sgb_core.document.findings import findings_of
from sgb_core.document.model import Document
from sgb_core.findings.finding import Finding
from sgb_core.surfaces import measures
from sgb_core.surfaces.bounds import section_reach
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.turning_joints import measure_turning_joints
from sgb_core.values import dataclass

_ASKED_FOR = (
    *("quartics", "sample", "size", "axis_crossings"),
    *("self_intersections", "joints", "certificates", "findings"),
)
# Points per segment of the polyline that the profile editor draws, ends included.
SAMPLES = 33


@dataclass(frozen=True, eq=False)
class ProfileFacts:
    """What follows from the profile alone; each value is computed when first asked for."""

    profile: Profile
    # The profile before, where its joints have been measured, and what they were.
    known: tuple[Profile, tuple[JointReport, ...]] | None = field(default=None, repr=False)

    def followed_by(self, profile: Profile) -> ProfileFacts:
        """Return the facts of the profile after an edit, which may take over some of these."""
        measured = self.__dict__.get("joints")
        return ProfileFacts(profile, None if measured is None else (self.profile, measured))

    @cached_property
    def quartics(self) -> Floats:
        """The quartic Bézier points, read-only, shape (n, 5, 2)."""
        return frozen(self.profile.quartics)

    @cached_property
    def sample(self) -> Floats:
        """Points at equal steps of s, read-only, shape (n, SAMPLES, 2)."""
        return frozen(self.profile.sample(SAMPLES))

    @cached_property
    def joints(self) -> tuple[JointReport, ...]:
        """What each joint truly is."""
        return measure_joints(self.profile, self.known)

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """The lower and upper corner (r, h) of the generatrix's box, each shape (2,)."""
        return self.profile.bounds()

    @property
    def size(self) -> tuple[float, float]:
        """The height and the largest diameter of the generatrix."""
        low, high = self.bounds
        return float(high[1] - low[1]), 2.0 * max(abs(float(low[0])), abs(float(high[0])))

    @cached_property
    def certificates(self) -> Certificates:
        """What no slider can break, from the control polygon alone."""
        return certificates(self.profile)

    @cached_property
    def axis_crossings(self) -> tuple[BeyondAxis, ...]:
        """The stretches that lie beyond the axis."""
        return axis_crossings(self.profile)

    @cached_property
    def self_intersections(self) -> tuple[Crossing, ...]:
        """Where the generatrix crosses itself."""
        return self_intersections(self.profile)


@dataclass(frozen=True, eq=False)
class Evaluation:
    """A document and what follows from it. Identity of parts tells what has changed."""

    document: Document
    surface: RevolutionSurface
    facts: ProfileFacts
    # The last surface under laws whose joints have been measured, and what they were.
    known: tuple[RevolutionSurface, tuple[JointReport, ...]] | None = field(
        default=None, repr=False
    )

    @property
    def quartics(self) -> Floats:
        """The quartic Bézier points, shape (n, 5, 2)."""
        return self.facts.quartics

    @property
    def sample(self) -> Floats:
        """Points of the generatrix at equal steps of s, shape (n, SAMPLES, 2)."""
        return self.facts.sample

    @cached_property
    def joints(self) -> tuple[JointReport, ...]:
        """What each joint truly is, under laws over the whole turn."""
        if not self.surface.laws:
            return self.facts.joints
        return measure_turning_joints(self.surface, self.known)

    @property
    def newest_joints(self) -> tuple[RevolutionSurface, tuple[JointReport, ...]] | None:
        """The newest surface under laws whose joints have been measured, with what they are."""
        measured = self.__dict__.get("joints")
        return (self.surface, measured) if measured and self.surface.laws else self.known

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """The lower and upper corner (r, h) of the generatrix's box, each shape (2,)."""
        return self.facts.bounds

    @cached_property
    def size(self) -> tuple[float, float]:
        """The height and the largest diameter of the drawn surface, over all sections."""
        if not self.surface.laws:
            return self.facts.size
        (inner, outer), (low, high) = section_reach(self.surface)
        return high - low, 2.0 * max(abs(inner), abs(outer))

    @property
    def certificates(self) -> Certificates:
        """What no slider can break, from the control polygon alone."""
        return self.facts.certificates

    @property
    def axis_crossings(self) -> tuple[BeyondAxis, ...]:
        """The stretches that lie beyond the axis."""
        return self.facts.axis_crossings

    @property
    def self_intersections(self) -> tuple[Crossing, ...]:
        """Where the generatrix crosses itself."""
        return self.facts.self_intersections

    @cached_property
    def volume(self) -> float:
        """The volume of the drawn surface in unit³, without end faces, whatever the body is."""
        return measures.volume(self.surface)

    @cached_property
    def findings(self) -> tuple[Finding, ...]:
        """What is doubtful about the document's profile and laws."""
        facts = self.facts
        return findings_of(
            self.document, self.joints, facts.axis_crossings, facts.self_intersections
        )


def evaluate(document: Document, previous: Evaluation | None = None) -> Evaluation:
    """Return the evaluation of a document.

    ``previous`` is the evaluation of any other document, most usefully of the one before the
    last edit: what depends only on parts that are the same objects is taken over from it.
    """
    if previous is None:
        return Evaluation(document, document.surface, ProfileFacts(document.profile))
    old = previous.document
    if old is document:
        return previous
    facts, known = previous.facts, previous.newest_joints
    if document.profile is not old.profile:
        return Evaluation(document, document.surface, facts.followed_by(document.profile), known)
    if (
        document.revolution is old.revolution
        and document.variation is old.variation
        and document.twist is old.twist
        and document.placement is old.placement
    ):
        return Evaluation(document, previous.surface, facts, known)
    return Evaluation(document, document.surface, facts, known)


def prepared(
    document: Document, report: Callable[[float], object] = lambda _part: None
) -> Evaluation:
    """Return the evaluation of a document with all that every view asks for computed.

    ``report`` is told which part, 0 to 1, is done; what it raises ends the work.
    """
    evaluation = evaluate(document)
    for number, name in enumerate(_ASKED_FOR, start=1):
        getattr(evaluation, name)
        report(number / len(_ASKED_FOR))
    return evaluation
