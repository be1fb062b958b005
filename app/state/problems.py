"""Problems that one step can mend: what is wrong, in words, and the button that mends it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

from app.state.presenter import Edit, Frame, Presenter
from app.state.window_reader import sentence
from sgb_core.curves.continuity import JointClass, JointReport, gap_at, unmet_rule
from sgb_core.curves.head_to_tail import joined_head_to_tail
from sgb_core.curves.profile import JointRule
from sgb_core.curves.unmet import hindrance_at
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.findings.bodies import (
    AtAngle,
    HoleTooWide,
    NoBodyFor,
    NoCavity,
    NoRoomForRing,
    RimTooShort,
    SealedHollow,
    TightCurve,
    WallBeyondEnds,
    WallOutOfReach,
)
from sgb_core.findings.finding import Finding
from sgb_core.findings.joints import Hindrance
from sgb_core.values import dataclass

_FIT = "Largest wall that fits"
_WALLS = (NoCavity, WallBeyondEnds, WallOutOfReach)


@dataclass(frozen=True, slots=True)
class Problem:
    """One problem: ``key`` is its cause, whatever its amount; ``edit`` mends it."""

    key: tuple[object, ...]
    text: str
    action: str
    edit: Edit


def problems(frame: Frame) -> tuple[Problem, ...]:
    """Return what is wrong in a frame and can be mended in one step, the worst first."""
    return (*_of_profile(frame), *_of_body(frame), *_of_joints(frame))


def _of_profile(frame: Frame) -> Iterator[Problem]:
    beyond = frame.evaluation.axis_crossings
    if beyond:
        text = f"Segment {beyond[0].segment + 1} goes through the axis."
        yield Problem(("axis",), text, "Push inside", edits.push_inside_axis)


def _of_body(frame: Frame) -> Iterator[Problem]:
    state = frame.body
    if state is None or state.document.solid != frame.document.solid:
        return
    for doubt in state.doubts:
        if isinstance(doubt, SealedHollow):
            yield Problem(("hollow",), sentence(doubt), _FIT, edits.fit_wall)
        elif isinstance(doubt, TightCurve):
            yield Problem(("tight", doubt.segment), sentence(doubt), _FIT, edits.fit_wall)
        elif isinstance(doubt, RimTooShort):
            yield Problem(("rim",), sentence(doubt), "Flat rim", edits.flat_rim)
    if state.error is None:
        return
    found: Finding = state.error
    cause = found.finding if isinstance(found, AtAngle) else found
    if isinstance(cause, _WALLS):
        yield Problem(("wall",), sentence(found), _FIT, edits.fit_wall)
    elif isinstance(cause, HoleTooWide) or cause is NoBodyFor.NO_FLOOR:
        yield Problem(("hole",), sentence(found), "No drain hole", edits.no_drain_hole)
    elif isinstance(cause, NoRoomForRing):
        yield Problem(("ring",), sentence(found), "No foot ring", edits.no_foot_ring)


def _of_joints(frame: Frame) -> Iterator[Problem]:
    profile = frame.document.profile
    apart = [each for each in frame.evaluation.joints if each.measured is JointClass.GAP]
    # Halves that run in opposite directions are joined by another offer.
    if apart and joined_head_to_tail(profile) is None:
        joint = apart[0].joint
        text = sentence(gap_at(profile, apart[0]))
        yield Problem(("gap", joint), text, "Join the gap", partial(_ruled, joint, JointRule.G0))
    for report in frame.evaluation.joints:
        if report.measured is not JointClass.GAP and not report.holds:
            yield _unmet(frame, report)


def _unmet(frame: Frame, report: JointReport) -> Problem:
    profile, joint = frame.document.profile, report.joint
    hindrance = hindrance_at(profile, joint, report)
    text = sentence(unmet_rule(profile, report, hindrance))
    if hindrance is Hindrance.RESTORABLE:
        action, rule = f"Make it {report.rule}", report.rule
    else:
        rule = JointRule.G1 if report.measured is JointClass.G2 else JointRule(report.measured)
        action = f"Ask only for {rule}"
    return Problem(("rule", joint, report.rule), text, action, partial(_ruled, joint, rule))


def _ruled(joint: int, rule: JointRule, document: Document) -> Document:
    return edits.set_rule(document, joint, rule)


class Problems:
    """Watches frames at rest; says each problem once, when it comes up, with its button."""

    def __init__(self, presenter: Presenter) -> None:
        self._presenter = presenter
        self._known: frozenset[tuple[object, ...]] = frozenset()
        self._shown: tuple[object, ...] | None = None

    def refresh(self, frame: Frame) -> None:
        """Speak up where a problem is there that was not."""
        if frame.dragging:
            return
        parts = (frame.evaluation, frame.body, frame.generation)
        if self._shown is not None and all(a is b for a, b in zip(parts, self._shown, strict=True)):
            return
        self._shown = parts
        found = problems(frame)
        fresh = [each for each in found if each.key not in self._known]
        self._known = frozenset(each.key for each in found)
        if fresh:
            self._say(fresh[0])

    def _say(self, problem: Problem) -> None:
        presenter = self._presenter
        presenter.notify(
            problem.text,
            "warning",
            problem.action,
            lambda: presenter.do(problem.action, problem.edit),
            holds=_still(problem.key),
        )


def _still(key: tuple[object, ...]) -> Callable[[Frame], bool]:
    return lambda frame: any(each.key == key for each in problems(frame))
