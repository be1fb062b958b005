"""Says, once a gesture, that a joint broke its rule, or what a G2 joint moved to keep its own."""

from __future__ import annotations

from app.state.presenter import Frame, Presenter
from app.state.window_reader import sentence
from sgb_core.curves.continuity import JointReport, unmet_rule
from sgb_core.curves.moved import moved
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import PARAMETERS
from sgb_core.curves.unmet import hindrance_at
from sgb_core.findings.joints import Moved, RuleMoves


class JointFindings:
    """Watches frames; compares each with how the joints were when the hand last rested."""

    def __init__(self, presenter: Presenter) -> None:
        self._presenter = presenter
        self._rested: tuple[JointReport, ...] = ()
        self._profile: Profile | None = None
        self._dragged = False
        self._generation: int | None = None
        self._told = False

    def refresh(self, frame: Frame) -> None:
        """Speak up where a rule that held does not hold any more."""
        reports = frame.evaluation.joints
        known = frame.generation == self._generation and len(reports) == len(self._rested)
        if known and not self._told:
            for before, now in zip(self._rested, reports, strict=True):
                # Of many joints a hand that drags changes one or two.
                same = before is now or before.rule != now.rule
                if not same and before.holds and not now.holds:
                    self._tell(frame, now)
                    break
        self._dragged = self._dragged or frame.dragging
        if not frame.dragging:
            if known and self._dragged and not self._told:
                self._tell_followers(frame)
            self._generation, self._rested, self._told = frame.generation, reports, False
            self._profile, self._dragged = frame.document.profile, False

    def _tell_followers(self, frame: Frame) -> None:
        """Say which shape parameters a gesture moved that the hand did not hold."""
        before, now = self._profile, frame.document.profile
        if before is None or before is now or frame.view.all_segments:
            return
        followed = _followed(moved(before, now), frame.view.segment)
        joints = [
            joint
            for joint in now.joints
            if now.rules[joint] is JointRule.G2
            and {each.segment for each in followed} & set(now.neighbours(joint))
        ]
        if joints:
            rule = RuleMoves(*now.neighbours(joints[0]), now.rules[joints[0]].value, followed)
            self._presenter.notify(sentence(rule), "info")

    def _tell(self, frame: Frame, report: JointReport) -> None:
        self._told = True
        profile = frame.document.profile
        hindrance = hindrance_at(profile, report.joint, report)
        self._presenter.notify(sentence(unmet_rule(profile, report, hindrance)), "warning")


def _followed(moves: tuple[Moved, ...], held: int) -> tuple[Moved, ...]:
    """Return the shape parameters that moved by a rule: a slider of ``held`` moved by the hand.

    Where points moved, the hand held these and no slider.
    """
    shapes = tuple(each for each in moves if each.what in PARAMETERS)
    by_points = len(shapes) < len(moves)
    return tuple(each for each in shapes if by_points or each.segment != held)
