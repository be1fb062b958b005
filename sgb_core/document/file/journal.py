"""Writes the journal of one window's unsaved work, step by step.

An entry is a file of records (:mod:`sgb_core.document.file.records`), one appended for each step
of the work (:mod:`sgb_core.document.file.steps`), and read again by
:mod:`sgb_core.document.file.recovery`.
"""

from __future__ import annotations

import os
import secrets
from contextlib import suppress
from pathlib import Path

from sgb_core.document.errors import FileError
from sgb_core.document.file import private
from sgb_core.document.file.atomic import reason, shown
from sgb_core.document.file.records import write_all
from sgb_core.document.file.recovery import SUFFIX, Recoverable
from sgb_core.document.file.steps import Written, step
from sgb_core.document.model import Document
from sgb_core.findings.files import Unwritten
from sgb_core.findings.line import Line

# An entry is begun anew, with one step, once it is this large and this many times its first size.
LARGE, GROWN = 8 << 20, 4


class Journal:
    """The unsaved work of one window, kept as one file in a folder that windows share.

    ``locks`` is the folder of the locks that tell whose window still runs.
    """

    def __init__(self, folder: str | os.PathLike[str], locks: str | os.PathLike[str]) -> None:
        """Use ``folder``; it is made when something is first written."""
        self._folder, self._locks = Path(folder), Path(locks)
        self._entry = self._folder / f"{secrets.token_hex(8)}{SUFFIX}"
        self._lock: private.Lock | None = None
        self._written: Written | None = None
        self._steps = 0
        self._prepared: tuple[Written, bytes] | None = None

    @property
    def entry(self) -> Path:
        """The file that this journal writes."""
        return self._entry

    def prepare(self, document: Document) -> None:
        """Make ready what the entry begins with: the document that work is going to change."""
        written = Written(document, set())
        self._prepared = written, step(document, None, 0, written, whole=True)

    def write(self, document: Document, target: str | os.PathLike[str] | None = None) -> bool:
        """Append a step, seen to the disk; return whether there was anything new.

        Raises FileError where the system refuses: then the entry is as it was, but for a torn end.
        """
        if self._written is not None and document is self._written.document:
            return False
        place = None if target is None else os.path.abspath(target)
        try:
            if self._lock is None:
                self._lock = private.lock(self._locks, self._entry.stem)
            self._steps += 1
            if not self._append(document, place) or self._is_long():
                # A step is appended before its entry is made shorter: that takes a while.
                self._begin(document, place)
        except OSError as error:
            raise FileError(Unwritten(shown(self._entry), Line(reason(error)))) from error
        return True

    def _append(self, document: Document, target: str | None) -> bool:
        """Append to the entry; return whether it was there and whole."""
        written = self._written
        if written is None:
            return False
        # Whatever fails from here on, the next step begins anew.
        self._written = None
        data = step(document, target, self._steps, written)
        try:
            descriptor = private.append_to(self._entry)
        except OSError:
            # Somebody has taken the file or the whole folder away.
            return False
        try:
            if os.fstat(descriptor).st_size != written.size:
                return False
            write_all(descriptor, data)
        finally:
            os.close(descriptor)
        written.size += len(data)
        written.document = document
        self._written = written
        return True

    def _is_long(self) -> bool:
        written = self._written
        return written is not None and written.size > max(LARGE, GROWN * written.first)

    def _begin(self, document: Document, target: str | None) -> None:
        """Write a new entry of one step, whole, in place of whatever lies there."""
        prepared, self._prepared = self._prepared, None
        if prepared is None:
            written = Written(document, set())
            data = step(document, target, self._steps, written, whole=True)
        else:
            written, data = prepared
            data += step(document, target, self._steps, written)
            written.document = document
        try:
            # Not aside and then renamed: a kill before the disk has it all would lose the step.
            private.write_new(self._entry, data)
        except FileExistsError:
            private.replace(self._entry, data)
        written.size = written.first = len(data)
        self._written = written

    def adopt(self, item: Recoverable) -> bool:
        """Make found work this journal's own; return False where another window has taken it.

        From then on a crash of this program leaves it to be found again.
        """
        with suppress(OSError, FileError):
            taken = private.lock(self._locks, item.entry.stem)
            try:
                if taken is not None and item.entry.exists():
                    # Its own first: a crash between the two leaves both, and nothing is lost.
                    self._written, self._steps = None, max(0, item.steps - 1)
                    self.write(item.document, item.target)
                    item.entry.unlink()
                    return True
            finally:
                private.unlock(taken, remove=True)
        return False

    def clear(self) -> None:
        """Forget the work: it was saved, or thrown away on purpose."""
        self._written, self._steps = None, 0
        with suppress(OSError):
            self._entry.unlink()
        self.close()

    def close(self) -> None:
        """Leave the work to be found by whoever looks next."""
        private.unlock(self._lock, remove=True)
        self._lock = None
