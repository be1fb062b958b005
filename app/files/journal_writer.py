"""A journal written off the GUI thread: what is put in comes to the disk in its order, at once."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from queue import SimpleQueue

from sgb_core.document.errors import FileError
from sgb_core.document.file.journal import Journal
from sgb_core.document.model import Document

Task = Callable[[], object]
# How long the end of a window waits for a disk that does not answer.
PATIENCE_SECONDS = 10.0


class JournalWriter:
    """One thread per window; nothing that is put in is skipped for what comes after it."""

    def __init__(self, journal: Journal, failed: Callable[[FileError], object]) -> None:
        """``failed`` is called, on the writer's thread, with each step that was not written."""
        self._journal = journal
        self._failed = failed
        self._tasks: SimpleQueue[Task | None] = SimpleQueue()
        self._thread = threading.Thread(target=self._run, name="journal", daemon=True)
        self._thread.start()

    def put(self, document: Document, target: Path | None) -> None:
        """Have a step written; returns at once."""
        self._tasks.put(lambda: self._journal.write(document, target))
        # Lets the writer begin before this thread draws, which holds the interpreter for long.
        time.sleep(0)

    def prepare(self, document: Document) -> None:
        """Make ready for work on a document, so that its first step is written at once."""
        self._tasks.put(lambda: self._journal.prepare(document))

    def clear(self) -> None:
        """Forget the work, after whatever was put in before."""
        self._tasks.put(self._journal.clear)
        self.flush()

    def flush(self) -> bool:
        """Wait until all that was put in is on the disk; return whether it is."""
        done = threading.Event()
        self._tasks.put(done.set)
        return done.wait(PATIENCE_SECONDS)

    def close(self) -> None:
        """Write what was put in, and leave it to be found."""
        self._tasks.put(self._journal.close)
        self._tasks.put(None)
        self._thread.join(PATIENCE_SECONDS)

    def _run(self) -> None:
        while (task := self._tasks.get()) is not None:
            try:
                task()
            except FileError as error:
                self._failed(error)
            except Exception:
                # Whatever it was, the next step is written.
                sys.excepthook(*sys.exc_info())
