"""The profile of one window made fair, aside, and what is said of it."""

from __future__ import annotations

from app.state.jobs import Job, Jobs, Report
from app.state.presenter import Presenter
from app.state.window_reader import WINDOW, reason
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.findings import Change, Faired, Freedom, Keep, Status
from sgb_core.document.edits.fair import fair_profile
from sgb_core.document.model import Document
from sgb_core.values import dataclass

LABEL = "Make fair"
SYMBOLS = {
    Energy.BENDING: "∫κ² dl",
    Energy.VARIATION: "∫(dκ/dl)² dl",
    Energy.SURFACE: "∬(κm² + κp²) dA",
}
_UNITS = {Energy.BENDING: " 1/{}", Energy.VARIATION: " 1/{}³", Energy.SURFACE: ""}


@dataclass(frozen=True, slots=True)
class FairChoice:
    """How a profile is made fair: least of what, by what, and what is kept.

    ``selection`` restricts it to the segments of the selected points, where there are any.
    """

    energy: Energy = Energy.BENDING
    freedom: Freedom = Freedom.SHAPE
    selection: bool = True
    keep: frozenset[Keep] = frozenset()


class Fairing:
    """Makes the profile of one window fair, aside, as it was last asked for."""

    def __init__(self, presenter: Presenter, jobs: Jobs) -> None:
        self._choice = FairChoice()
        self._presenter = presenter
        self._jobs = jobs
        self._job: Job | None = None

    @property
    def choice(self) -> FairChoice:
        """What was last asked for."""
        return self._choice

    def choose(self, choice: FairChoice) -> None:
        """Make fair from now on as ``choice`` says."""
        self._choice = choice
        if self._presenter.view.live_fair is not None:
            self._presenter.set_view(live_fair=choice.energy.value)

    def toggle_live(self) -> None:
        """Let segments beside what is dragged keep themselves fair, or let them be."""
        on = self._presenter.view.live_fair is not None
        self._presenter.set_view(live_fair=None if on else self._choice.energy.value)

    def start(self) -> None:
        """Begin; what is found for a document that has changed meanwhile is dropped."""
        if self._job is not None:
            self._job.cancel()
        presenter, choice = self._presenter, self._choice
        document, segments = presenter.document, self.segments()

        def work(_report: Report) -> tuple[Document, Faired]:
            return fair_profile(
                document, choice.energy, choice.freedom, segments=segments, keep=choice.keep
            )

        def done(result: tuple[Document, Faired]) -> None:
            if presenter.document is document and not presenter.session.in_gesture:
                self._take(*result)

        job = Job(LABEL, work, done, lambda error: presenter.notify(reason(error), "warning"))
        self._job = self._jobs.start(job)

    def segments(self) -> list[int] | None:
        """Return the segments that are meant, None for all."""
        chosen = sorted({segment for segment, _ in self._presenter.view.points})
        return chosen if self._choice.selection and chosen else None

    def _take(self, faired: Document, found: Faired) -> None:
        presenter, before = self._presenter, self._presenter.document
        said = told(found, str(before.unit))
        if not found.moved:
            presenter.notify(said, "info")
            return
        if presenter.do(LABEL, lambda _: faired):
            presenter.notify(said, "info", "Undo", presenter.undo)
            presenter.set_view(before=before)


def told(found: Faired, unit: str) -> str:
    """Return what fairing found, in one line."""
    symbol = SYMBOLS[found.energy]
    if found.moved:
        line = f"Fairer: {symbol} {_number(found.before)} → {_number(found.after)}"
        line += f"{_UNITS[found.energy].format(unit)}; {moved_words(found.moved)}."
    else:
        line = f"Nothing fairer keeps what is asked for: {symbol} stays {_number(found.before)}."
    if found.status is Status.ENDLESS:
        numbers = ", ".join(str(WINDOW.number(segment)) for segment in found.endless)
        line += f" It is infinite in segment {numbers}, whatever the shape parameters."
    if found.unmet:
        joints = ", ".join(str(WINDOW.number(rule.joint)) for rule in found.unmet)
        line += f" No shape parameter restores the rule of joint {joints}."
    return line


def moved_words(changes: tuple[Change, ...]) -> str:
    """Return how many shape parameters and points of how many segments have moved."""
    points = {(c.segment, c.parameter.partition(".")[0]) for c in changes if "." in c.parameter}
    parameters = sum("." not in change.parameter for change in changes)
    segments = len({change.segment for change in changes})
    where = f"{segments} segments" if segments > 1 else WINDOW.segment(changes[0].segment)
    what = f"{parameters} shape parameter{'s' if parameters != 1 else ''} of {where} moved"
    if not points:
        return f"{what}, no control point"
    inner = all(int(point[1]) in (1, 2) for _, point in points)
    kind = "inner control point" if inner else "control point"
    return f"{what} and {len(points)} {kind}{'s' if len(points) > 1 else ''}"


def _number(value: float | None) -> str:
    return "∞" if value is None else f"{value:.4g}"
