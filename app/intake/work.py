"""A source on its way in: read aside, traced aside, and always the newest options last."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from app.state.jobs import Job, Jobs, Report
from app.state.window_reader import why
from sgb_core.arrays import Floats
from sgb_core.design.tracing.along import deviations_along
from sgb_core.sources import Opened, Options, Taken
from sgb_core.sources.reading import Reading
from sgb_core.sources.uncertainty import Holding, holding
from sgb_core.values import dataclass

# Places along each segment whose deviation is shown.
PLACES = 33
# A trace that takes longer, in milliseconds, makes way for newer options.
PATIENCE = 1500


@dataclass(frozen=True, slots=True, eq=False)
class Traced:
    """What was read and traced with some options, its deviations, and what it holds."""

    options: Options
    reading: Reading
    taken: Taken
    deviations: Floats
    holding: Holding | None


class Intake(QObject):
    """Reads one source and traces it again whenever an option changes.

    ``opened`` is emitted when the file has been read; ``changed`` whenever ``traced``,
    ``problem`` or ``busy`` has changed.
    """

    opened = Signal()
    changed = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.source: Opened | None = None
        self.traced: Traced | None = None
        self.problem = ""
        self._jobs = Jobs(self)
        self._job: Job | None = None
        self._wanted: Options | None = None
        self._read: tuple[Options, Reading] | None = None
        self._patience = QTimer(self, singleShot=True, interval=PATIENCE)
        self._patience.timeout.connect(self._make_way)

    @property
    def busy(self) -> bool:
        """Whether something is being read or traced."""
        return self._job is not None

    def open(self, read: Callable[[], Opened]) -> None:
        """Read a source aside; what was there before stays until it is read."""

        def done(source: Opened) -> None:
            self.source, self.traced, self._read = source, None, None
            self._wanted = None
            self.opened.emit()

        self._wanted = None
        self._start("Reading", lambda _report: read(), done)

    def want(self, options: Options) -> None:
        """Trace with other options as soon as may be; only the newest count."""
        if self.source is None:
            return
        self._wanted = options
        if self._job is None:
            self._trace()
        elif not self._patience.isActive():
            self._patience.start()

    def cancel(self) -> None:
        """Stop what is under way; what was found before stays."""
        self._wanted = None
        if self._job is not None:
            self._job.cancel()

    def refuse(self, problem: str) -> None:
        """Say why options cannot be."""
        self.problem = problem
        self.changed.emit()

    def close(self) -> None:
        """Stop, for ever."""
        self.cancel()
        self._jobs.close()

    def _trace(self) -> None:
        options, source = self._wanted, self.source
        self._wanted = None
        if options is None or source is None:
            return
        known = self._read

        def work(_report: Report) -> Traced:
            if known is not None and _reads(known[0]) == _reads(options):
                reading = known[1]
            else:
                reading = source.reading(options)
            taken = source.traced(reading, options)
            along = deviations_along(taken.trace.profile, taken.points, PLACES)
            return Traced(options, reading, taken, along, holding(taken, reading, options))

        def done(found: Traced) -> None:
            self.traced, self.problem = found, ""
            self._read = (found.options, found.reading)

        self._start("Tracing", work, done)

    def _start(
        self, label: str, work: Callable[[Report], Any], done: Callable[[Any], None]
    ) -> None:
        if self._job is not None:
            self._job.drop()
        self._patience.stop()

        def ended(outcome: Callable[[], None]) -> None:
            self._job = None
            outcome()
            if self._wanted is not None:
                self._trace()
            self.changed.emit()

        def failed(error: Exception) -> None:
            self.problem = why(error)

        job = Job(
            label,
            work,
            lambda result: ended(lambda: done(result)),
            lambda error: ended(lambda: failed(error)),
            lambda: ended(lambda: None),
        )
        self._job = self._jobs.start(job)
        self.changed.emit()

    def _make_way(self) -> None:
        """Stop a long trace that newer options have overtaken."""
        if self._job is not None and self._wanted is not None:
            self._job.cancel()


def _reads(options: Options) -> Options:
    """Return options without those that only the trace depends on."""
    plain = Options()
    return replace(options, tolerance=plain.tolerance, side=plain.side, merge=plain.merge)
