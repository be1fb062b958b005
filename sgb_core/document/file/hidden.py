"""Hidden files and folders for what is not whole yet, known again where a kill leaves them.

Each is held by its program, as the system knows it, until that ends, however that happens: so
what is left over is told from what is being written.
"""

from __future__ import annotations

import os
import re
import secrets
import shutil
import stat
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

_BEFORE, _AFTER = ".sgb-", ".tmp"
_PATTERN = re.compile(r"\.sgb-[0-9a-f]{16}\.tmp")
# Where the system has no links of this kind, or no binary mode, there is nothing to ask for.
_NEW = os.O_CREAT | os.O_EXCL | os.O_WRONLY | getattr(os, "O_BINARY", 0)
# Not blocking: a pipe of such a name could make us wait for ever.
_OLD = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)


def new_file(folder: Path, mode: int) -> tuple[Path, int]:
    """Return a new hidden file in a folder and its descriptor, which holds it until it is closed.

    Raises OSError where the system refuses.
    """
    while True:
        # A short name of its own, so that beside the longest allowed name it still works.
        path = folder / f"{_BEFORE}{secrets.token_hex(8)}{_AFTER}"
        descriptor = os.open(path, _NEW, mode)
        held = True
        # Where files cannot be held, none is taken for left over either.
        with suppress(OSError):
            held = _hold(descriptor)
        # Before it was held, another program may have taken it for left over.
        if held and _is(path, descriptor):
            return path, descriptor
        os.close(descriptor)


@contextmanager
def new_folder(beside: Path | None = None) -> Iterator[Path]:
    """Yield a new hidden folder, private, that goes with all it holds in the end.

    It lies in the folder ``beside``, by default where the system wants what is temporary. Raises
    OSError where the system refuses.
    """
    path = (beside or _temporary()) / f"{_BEFORE}{secrets.token_hex(8)}{_AFTER}"
    path.mkdir(mode=0o700)
    descriptor = None
    try:
        with suppress(OSError):
            descriptor = os.open(path, _OLD)
            _hold(descriptor)
        yield path
    finally:
        if descriptor is not None:
            os.close(descriptor)
        shutil.rmtree(path, ignore_errors=True)


def clean(folder: str | os.PathLike[str] | None = None) -> int:
    """Remove what killed programs left in a folder; return how many files and folders.

    What a program still writes is held by it and stays, and so do links and what belongs to
    others. By default the folder is the one where the system wants what is temporary.
    """
    removed = 0
    place = _temporary() if folder is None else Path(folder)
    with suppress(OSError):
        for name in sorted(os.listdir(place)):
            if _PATTERN.fullmatch(name) is not None:
                with suppress(OSError):
                    removed += _removed(place / name)
    return removed


def _removed(left: Path) -> bool:
    descriptor = os.open(left, _OLD)
    try:
        found = os.fstat(descriptor)
        if not _hold(descriptor) or found.st_uid != _user(found.st_uid):
            return False
    finally:
        os.close(descriptor)
    if stat.S_ISDIR(found.st_mode):
        shutil.rmtree(left)
    else:
        left.unlink()
    return True


def _user(usual: int) -> int:
    """Return whose this program is; the super user's may be anybody's."""
    user = os.getuid() if sys.platform != "win32" else usual
    return user or usual


def _temporary() -> Path:
    return Path(tempfile.gettempdir())


def _is(path: Path, descriptor: int) -> bool:
    """Return whether the open file is still the one at its path."""
    try:
        return os.path.samestat(os.lstat(path), os.fstat(descriptor))
    except FileNotFoundError:
        return False


def _hold(descriptor: int) -> bool:
    """Hold an open file until it is closed; return False where another program holds it.

    Windows lets no open file be removed, which is as good. Raises OSError where files cannot be
    held.
    """
    if sys.platform != "win32":
        import fcntl

        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
    return True
