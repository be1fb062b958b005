"""What a kill could leave at any instant of a piece of work, by stopping it at each system call.

SIGKILL changes nothing on the disk: what lies there between two system calls is what a kill
between them leaves. So one run, looked at wherever something has changed, stands for a kill at
each of its instants.
"""

from __future__ import annotations

import ctypes
import os
import shutil
import signal
import traceback
from collections.abc import Callable
from pathlib import Path

_TRACEME, _SYSCALL = 0, 24
_LIBC = ctypes.CDLL(None, use_errno=True)


def _ptrace(request: int, child: int) -> None:
    nothing = ctypes.c_void_p(0)
    if _LIBC.ptrace(ctypes.c_long(request), ctypes.c_long(child), nothing, nothing) < 0:
        raise OSError(ctypes.get_errno(), "ptrace")


def at_every_call(work: Callable[[], object], look: Callable[[], object]) -> None:
    """Run ``work`` in a child of this process, and ``look`` at each stop and at its end.

    For processes of one thread; raises AssertionError where the work fails.
    """
    child = os.fork()
    if child == 0:
        try:
            _ptrace(_TRACEME, 0)
            os.kill(os.getpid(), signal.SIGSTOP)
            work()
        except BaseException:
            traceback.print_exc()
            os._exit(1)
        os._exit(0)
    passed = 0
    try:
        os.waitpid(child, 0)
        while True:
            _LIBC.ptrace(ctypes.c_long(_SYSCALL), ctypes.c_long(child), None, ctypes.c_long(passed))
            _, status = os.waitpid(child, 0)
            if not os.WIFSTOPPED(status):
                break
            stop = os.WSTOPSIG(status)
            # Its own signals, of a child that ended say, go through.
            passed = 0 if stop == signal.SIGTRAP else stop
            look()
    except BaseException:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        raise
    look()
    assert os.waitstatus_to_exitcode(status) == 0


class Left:
    """The states of a folder that a kill could leave, each looked at once."""

    def __init__(self, folder: Path, see: Callable[[Path], int]) -> None:
        """``see`` checks a copy as the next start finds it, and returns how much it cleaned."""
        self._folder, self._see = folder, see
        self._seen: object = None
        self.states = 0
        self.half = 0

    def look(self) -> None:
        """See what is there, if it is not as it was."""
        seen = _looks(self._folder)
        if seen == self._seen:
            return
        self._seen = seen
        self.states += 1
        after = self._folder.with_name(f"{self._folder.name} after a kill")
        shutil.rmtree(after, ignore_errors=True)
        shutil.copytree(self._folder, after)
        self.half += self._see(after)


def _looks(folder: Path) -> object:
    found = []
    for place, _, names in os.walk(folder):
        for name in names:
            try:
                facts = os.lstat(os.path.join(place, name))
            except FileNotFoundError:
                continue
            found.append((place, name, facts.st_ino, facts.st_size, facts.st_mtime_ns))
    return found
