"""Work that takes longer than a fifth of a second, off the GUI thread, on frozen values."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, QRunnable, Qt, QThreadPool, Signal, Slot

from app.state.unforeseen import tell_unforeseen
from sgb_core.interruption import interruptible

Report = Callable[[float], None]


class Cancelled(Exception):  # noqa: N818 - an outcome, not an error
    """Raised inside a job at its next report or checkpoint after it was cancelled."""


class Stop(threading.Event):
    """Set by whoever no longer wants a piece of work; the work asks at its checkpoints."""

    def ask(self) -> None:
        """Raise Cancelled once it is set."""
        if self.is_set():
            raise Cancelled


class Job(QObject):
    """One piece of work: ``work(report)`` runs aside and may call ``report(0..1)``."""

    progressed = Signal(float)
    ended = Signal(object)

    def __init__(
        self,
        label: str,
        work: Callable[[Report], Any],
        on_done: Callable[[Any], object],
        on_failed: Callable[[Exception], object],
        on_cancelled: Callable[[], object] = lambda: None,
    ) -> None:
        super().__init__()
        self.label = label
        self._work = work
        self._on_done = on_done
        self._on_failed = on_failed
        self._on_cancelled = on_cancelled
        self._stop = Stop()
        self._dropped = False
        self._outcome: Callable[[], object] = on_cancelled

    def cancel(self) -> None:
        """Ask the work to stop at its next report of progress or checkpoint."""
        self._stop.set()

    def drop(self) -> None:
        """Cancel, and call none of the three callbacks: a result may be on its way already."""
        self.cancel()
        self._dropped = True

    def report(self, fraction: float) -> None:
        """Take the work's progress; raises Cancelled once the job is cancelled."""
        self._stop.ask()
        self.progressed.emit(fraction)

    def execute(self) -> None:
        """Run the work to its end; called on the worker thread."""
        try:
            with interruptible(self._stop.ask):
                result = self._work(self.report)
        except Cancelled:
            self._outcome = self._on_cancelled
        except Exception as error:
            failure = error
            self._outcome = lambda: self._fail(failure)
        else:
            self._outcome = lambda: self._on_done(result)
        self.ended.emit(self)

    def _fail(self, error: Exception) -> None:
        self._on_failed(error)
        # Last, as the window says one thing at a time: that the work is safe is what counts.
        tell_unforeseen(error)

    def conclude(self) -> None:
        """Call the one of the three callbacks that applies; on the GUI thread."""
        if not self._dropped:
            self._outcome()


class _Runner(QRunnable):
    def __init__(self, job: Job) -> None:
        super().__init__()
        self._job = job

    def run(self) -> None:
        self._job.execute()


class Jobs(QObject):
    """Runs jobs one after another and tells, on the GUI thread, how each ended."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._pool = QThreadPool(self)
        self._pool.setMaxThreadCount(1)
        self.running: list[Job] = []
        self._closed = False

    def start(self, job: Job) -> Job:
        """Run ``job`` after those started before it; none starts once they are closed."""
        if self._closed:
            return job
        self.running.append(job)
        # A bound method of this object: queued to the GUI thread, where a lambda would not be.
        job.ended.connect(self._ended, Qt.ConnectionType.QueuedConnection)
        self._pool.start(_Runner(job))
        self.changed.emit()
        return job

    def cancel_all(self) -> None:
        """Cancel whatever runs or waits."""
        for job in self.running:
            job.cancel()

    def drop_all(self) -> None:
        """Drop whatever runs or waits; its callbacks are not called."""
        for job in self.running:
            job.drop()

    def wait(self) -> None:
        """Block until nothing runs."""
        self._pool.waitForDone()

    def close(self) -> None:
        """Block until nothing runs, and let nothing start; for leaving.

        A job that a timer began while Qt deletes the pool would hold it up for ever: the pool's
        end waits for a thread that waits for Python.
        """
        self._closed = True
        self.wait()

    @Slot(object)
    def _ended(self, job: Job) -> None:
        self.running.remove(job)
        self.changed.emit()
        job.conclude()
