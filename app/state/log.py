"""The log: private, in the platform's place, never large; and how a crash is noticed afterwards.

While the program runs it holds a fault file, into which Python writes where it stood should the
process die of a fault. Whoever finds one that nobody holds knows that its program did not end.
"""

from __future__ import annotations

import faulthandler
import logging
import os
import secrets
import sys
from contextlib import suppress
from io import TextIOWrapper
from logging.handlers import RotatingFileHandler
from pathlib import Path

from app.state import user_folders
from sgb_core.document.file import private

NAME = "sgb-studio"
FAULT = ".fault"
LARGEST, OLDER = 1_000_000, 2
# More than a fault's traceback ever takes.
LONGEST_FAULT = 100_000


class _PrivateHandler(RotatingFileHandler):
    """Writes files that nobody else can read, through no link."""

    def _open(self) -> TextIOWrapper:
        path = Path(self.baseFilename)
        private.make_folder(path.parent)
        if not os.path.lexists(path):
            os.close(private.create(path))
        return open(private.append_to(path), "a", encoding="utf-8")


class Log:
    """The log of one process, from its start to its end."""

    def __init__(self) -> None:
        """Begin; where no log can be kept there is none, and nothing else is different."""
        self.path = user_folders.log() / f"{NAME}.log"
        self._logger = logging.getLogger(NAME)
        self._logger.propagate = False
        self._handler: logging.Handler = logging.NullHandler()
        self._fault: Path | None = None
        self._lock: private.Lock | None = None
        with suppress(OSError):
            handler = _PrivateHandler(
                self.path, maxBytes=LARGEST, backupCount=OLDER, encoding="utf-8"
            )
            handler.setFormatter(logging.Formatter("%(asctime)s %(message)s"))
            self._handler = handler
        self._logger.addHandler(self._handler)
        self._logger.setLevel(logging.INFO)
        self.crashes = self._crashes()
        with suppress(OSError):
            self._watch()

    def write(self, text: str) -> None:
        """Write a line, or several."""
        self._logger.info(text)

    def close(self) -> None:
        """End the log of a program that ends as it should."""
        if self._fault is not None:
            faulthandler.disable()
            self._stream.close()
            with suppress(OSError):
                self._fault.unlink()
        private.unlock(self._lock, remove=True)
        self._logger.removeHandler(self._handler)
        self._handler.close()

    def _watch(self) -> None:
        name = secrets.token_hex(8)
        self._lock = private.lock(user_folders.locks(), name)
        fault = self.path.with_name(f"{name}{FAULT}")
        # Open to the end: it is written to when nothing else works any more.
        self._stream = open(private.create(fault), "w")  # noqa: SIM115
        self._fault = fault
        faulthandler.enable(self._stream)

    def _crashes(self) -> int:
        """Return how many programs have not ended as they should; what is known goes to the log."""
        count = 0
        with suppress(OSError):
            for fault in sorted(self.path.parent.glob(f"*{FAULT}")):
                with suppress(OSError):
                    taken = private.lock(user_folders.locks(), fault.stem)
                    if taken is None:
                        continue
                    known = private.read(fault, LONGEST_FAULT).decode(errors="replace")
                    self.write(f"a program did not end as it should\n{known}".rstrip())
                    fault.unlink()
                    private.unlock(taken, remove=True)
                    count += 1
        return count


def started(program: str) -> str:
    """Return the line of the log that a start begins with."""
    return f"start of {program}, Python {sys.version.split()[0]} on {sys.platform}"
