"""Progress of a file that is being written, and how many bytes one would have."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any, BinaryIO

Report = Callable[[float], None]


def untold(_: float) -> None:
    """Tell nobody."""


def rising(report: Report) -> Report:
    """Return what passes on to ``report`` only parts larger than all before."""
    most = -1.0

    def tell(part: float) -> None:
        nonlocal most
        if part > most:
            most = part
            report(part)

    return tell


# A first guess of the bytes of a file; progress stays sensible for any.
GUESS = 1_000_000


class ReportedStream(io.RawIOBase):
    """A stream that tells ``report`` after each write which part of the file is written.

    The part is that of ``expected`` bytes, and never quite 1: the end is for the caller to tell.
    Whatever ``report`` raises passes through the writer, which ends it.
    """

    def __init__(self, stream: BinaryIO, report: Report, expected: int = GUESS) -> None:
        super().__init__()
        self._stream = stream
        self._report = report
        self._expected = max(expected, 1)
        self._written = 0

    def write(self, data: Any, /) -> int:
        """Write all of ``data`` and report."""
        count = int(self._stream.write(data))
        self._written += count
        # Beyond what was expected the rest shrinks with each write and is never used up.
        done = self._written / self._expected
        self._report(0.95 * done if done < 1.0 else 1.0 - 0.05 / done)
        return count

    def seek(self, offset: int, whence: int = io.SEEK_SET, /) -> int:
        """Go to a place, as the stream underneath does."""
        return self._stream.seek(offset, whence)

    def tell(self) -> int:
        """Return the place in the stream underneath."""
        return self._stream.tell()

    def flush(self) -> None:
        """Hand on what the stream underneath still holds."""
        if not self._stream.closed:
            self._stream.flush()

    def writable(self) -> bool:
        """Return True."""
        return True

    def seekable(self) -> bool:
        """Whether the stream underneath is; a pipe is not."""
        return self._stream.seekable()


class CountingStream(io.RawIOBase):
    """A stream that keeps nothing but the size that a file would have."""

    def __init__(self) -> None:
        super().__init__()
        self._at = 0
        self.size = 0

    def write(self, data: Any, /) -> int:
        """Count ``data``."""
        count = memoryview(data).nbytes
        self._at += count
        self.size = max(self.size, self._at)
        return count

    def seek(self, offset: int, whence: int = io.SEEK_SET, /) -> int:
        """Go to a place, so that what is written over is not counted twice."""
        self._at = offset + {io.SEEK_SET: 0, io.SEEK_CUR: self._at, io.SEEK_END: self.size}[whence]
        return self._at

    def tell(self) -> int:
        """Return the place."""
        return self._at

    def writable(self) -> bool:
        """Return True."""
        return True

    def seekable(self) -> bool:
        """Return True."""
        return True
