"""Has a program kill itself in the middle of writing a file, at a system call that was asked for.

Python's own calls are wrapped, in this process alone; of the bytes of a write that the process
dies in, a part comes to the disk.
"""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from io import BufferedWriter, FileIO
from pathlib import Path
from typing import Any, Protocol

from sgb_core.document.file import atomic

# Where what is written lies, by what it is: its folder's name, and how its own name ends.
KINDS = {
    "append": ("recovery", ".recovery"),
    "rewrite": ("recovery", ".tmp"),
    "save": ("project", ".tmp"),
    "backup": ("backups", ".tmp"),
    "export": ("exports", ".tmp"),
}


class Put(Protocol):
    """Puts bytes into a file; returns how many."""

    def __call__(self, data: bytes) -> int: ...


class Death:
    """Comes at the n-th system call on files of one kind, with ``part`` of its bytes written."""

    def __init__(self, kind: str, number: int, part: float) -> None:
        self._folder, self._end = KINDS[kind]
        self._left, self._part = number, part
        self._open: dict[int, object] = {}

    def prepare(self) -> None:
        """Wrap the calls by which files are written."""
        opens, writes, closes = os.open, os.write, os.close

        def opened(path: Any, *rest: Any, **named: Any) -> int:
            self._comes(path)
            descriptor = opens(path, *rest, **named)
            self._open[descriptor] = path
            return descriptor

        def closed(descriptor: int) -> None:
            self._comes(self._open.pop(descriptor, ""))
            closes(descriptor)

        os.open, os.close = opened, closed
        os.write = lambda descriptor, data: self._write(
            self._open.get(descriptor, ""), data, lambda some: writes(descriptor, some)
        )
        for name in ("replace", "unlink", "chmod"):
            setattr(os, name, self._of_path(getattr(os, name)))
        for name in ("fsync", "fdatasync"):
            setattr(os, name, self._of_descriptor(getattr(os, name)))
        # Streams write without Python's calls.
        atomic.open = self._stream  # type: ignore[attr-defined]

    def _of_path(self, call: Callable[..., Any]) -> Callable[..., Any]:
        def wrapped(path: Any, *rest: Any, **named: Any) -> Any:
            self._comes(path)
            return call(path, *rest, **named)

        return wrapped

    def _of_descriptor(self, call: Callable[[int], None]) -> Callable[[int], None]:
        def wrapped(descriptor: int) -> None:
            self._comes(self._open.get(descriptor, ""))
            call(descriptor)

        return wrapped

    def _stream(self, descriptor: int, mode: str) -> BufferedWriter:
        path, write = self._open.get(descriptor, ""), self._write

        class Stream(BufferedWriter):
            """A stream that dies like all else."""

            def write(self, data: Any) -> int:
                def put(some: bytes) -> int:
                    done = BufferedWriter.write(self, some)
                    self.flush()
                    return done

                return write(path, data, put)

        return Stream(FileIO(descriptor, mode))

    def _write(self, path: object, data: Any, put: Put) -> int:
        if self._counts(path):
            put(bytes(data)[: int(self._part * len(data))])
            _die()
        return put(data)

    def _comes(self, path: object) -> None:
        if self._counts(path):
            _die()

    def _counts(self, path: object) -> bool:
        """Count a call; return whether it is the one to die at."""
        place = Path(os.fsdecode(path)) if isinstance(path, (str, Path)) else Path()
        if place.parent.name != self._folder or not place.name.endswith(self._end):
            return False
        self._left -= 1
        return self._left == 0


def _die() -> None:
    os.writev(1, [f"0 {time.monotonic_ns()} dies\n".encode()])
    os.kill(os.getpid(), signal.SIGKILL)
