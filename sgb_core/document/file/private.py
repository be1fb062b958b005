"""Files that are nobody else's: 0600 in folders of 0700, and no symbolic link is followed."""

from __future__ import annotations

import os
import stat
from contextlib import suppress
from pathlib import Path
from typing import TypeAlias

from filelock import FileLock, Timeout

from sgb_core.document.file import hidden
from sgb_core.document.file.records import write_all

FOLDER_MODE, FILE_MODE = 0o700, 0o600
# Where the system has no links of this kind, or no binary mode, there is nothing to ask for.
_FLAGS = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)

Lock: TypeAlias = FileLock


def make_folder(folder: Path) -> None:
    """Make a private folder, or make an existing one private.

    Raises OSError where the system refuses or something else, a link included, is in its place.
    """
    folder.mkdir(mode=FOLDER_MODE, parents=True, exist_ok=True)
    mode = os.lstat(folder).st_mode
    if not stat.S_ISDIR(mode):
        raise NotADirectoryError(0, "it is a link, which is not followed")
    if stat.S_IMODE(mode) != FOLDER_MODE:
        folder.chmod(FOLDER_MODE)


def create(path: Path) -> int:
    """Return the descriptor of a new private file; raises OSError where there is one already."""
    return os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY | _FLAGS, FILE_MODE)


def append_to(path: Path) -> int:
    """Return the descriptor of an existing file, to be appended to; raises OSError for a link."""
    return os.open(path, os.O_APPEND | os.O_WRONLY | _FLAGS)


def write_new(path: Path, data: bytes) -> None:
    """Write a new private file, there from its first byte, and see it to the disk.

    Its folder is made where it is missing. Raises FileExistsError where something lies there
    already, another OSError where the system refuses; then nothing is left of it.
    """
    make_folder(path.parent)
    descriptor = create(path)
    try:
        try:
            write_all(descriptor, data)
        finally:
            os.close(descriptor)
    except BaseException:
        with suppress(OSError):
            path.unlink()
        raise


def replace(path: Path, data: bytes) -> None:
    """Put a private file, whole and seen to the disk, in place of whatever lies there.

    Its folder is made where it is missing. Raises OSError where the system refuses.
    """
    make_folder(path.parent)
    temporary, descriptor = hidden.new_file(path.parent, FILE_MODE)
    try:
        try:
            write_all(descriptor, data)
        finally:
            os.close(descriptor)
        os.replace(temporary, path)
    except BaseException:
        with suppress(OSError):
            temporary.unlink()
        raise


def read(path: Path, limit: int) -> bytes:
    """Return at most ``limit`` bytes of a regular file; raises OSError for anything else."""
    # Not blocking: a pipe in its place could make us wait for ever.
    flags = os.O_RDONLY | _FLAGS | getattr(os, "O_NONBLOCK", 0)
    with open(os.open(path, flags), "rb") as stream:
        if not stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
            raise OSError(0, "it is not a regular file")
        return stream.read(limit)


def lock(folder: Path, name: str) -> Lock | None:
    """Return the lock of that name, taken; None where another window or program holds it.

    The system gives it back when its holder ends, however that happens. Raises OSError where
    the folder cannot hold locks.
    """
    make_folder(folder)
    taken = FileLock(
        folder / f"{name}.lock",
        mode=FILE_MODE,
        thread_local=False,
        fallback_to_soft=False,
    )
    try:
        taken.acquire(blocking=False)
    except Timeout:
        return None
    return taken


def unlock(taken: Lock | None, *, remove: bool = False) -> None:
    """Give a lock back, if there is one; ``remove`` its file, where nobody takes it again."""
    if taken is None:
        return
    with suppress(OSError):
        if remove:
            os.unlink(taken.lock_file)
    with suppress(OSError):
        taken.release()
