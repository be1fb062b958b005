"""Says in the notice bar, once a gesture, that a joint has become less than its rule asks for."""

from __future__ import annotations

from app.state.presenter import Frame, Presenter
from app.state.window_reader import sentence
from sgb_core.curves.continuity import JointReport, unmet_rule
from sgb_core.curves.unmet import hindrance_at


class JointFindings:
    """Watches frames; compares each with how the joints were when the hand last rested."""

    def __init__(self, presenter: Presenter) -> None:
        self._presenter = presenter
        self._rested: tuple[JointReport, ...] = ()
        self._generation: int | None = None
        self._told = False

    def refresh(self, frame: Frame) -> None:
        """Speak up where a rule that held does not hold any more."""
        reports = frame.evaluation.joints
        known = frame.generation == self._generation and len(reports) == len(self._rested)
        if known and not self._told:
            for before, now in zip(self._rested, reports, strict=True):
                if before.rule == now.rule and before.holds and not now.holds:
                    self._tell(frame, now)
                    break
        if not frame.dragging:
            self._generation, self._rested, self._told = frame.generation, reports, False

    def _tell(self, frame: Frame, report: JointReport) -> None:
        self._told = True
        profile = frame.document.profile
        hindrance = hindrance_at(profile, report.joint, report)
        self._presenter.notify(sentence(unmet_rule(profile, report, hindrance)), "warning")
