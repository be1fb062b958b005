"""Write a file whole or not at all: a failure leaves the old file as it was."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from sgb_core.document.errors import FileError
from sgb_core.document.file import hidden
from sgb_core.findings.files import Unwritten
from sgb_core.findings.line import Line


def shown(path: str | os.PathLike[str]) -> str:
    """Return a path as one printable line."""
    text = os.fsdecode(path)
    return text if text.isprintable() else repr(text)


def reason(error: OSError) -> str:
    """Return why the system refused, without the path and the error number."""
    return error.strerror or str(error) or type(error).__name__


def write_whole(path: str | os.PathLike[str], writer: Callable[[BinaryIO], object]) -> None:
    """Call ``writer`` on a new file and put that file at ``path`` when it is complete.

    The bytes go to a hidden file in the same folder, are flushed to the disk and renamed onto
    ``path`` in one step. An existing file keeps its permissions; a symbolic link stays one and
    its target is replaced. A device or pipe cannot be replaced and is written directly. On any
    failure, an interrupt included, the hidden file is removed and the old file is untouched.

    Raises FileError, one line with the path, where the system refuses; whatever else
    ``writer`` raises passes through.
    """
    if "\0" in os.fsdecode(path):
        raise FileError(Unwritten(shown(path), Line("not a file name")))
    target = Path(os.path.realpath(path))
    try:
        mode = _mode(target)
        if mode is not None and not stat.S_ISREG(mode):
            with open(target, "wb") as stream:
                writer(stream)
        else:
            _replace(target, mode, writer)
    except OSError as error:
        raise FileError(Unwritten(shown(path), Line(reason(error)))) from error


def _mode(target: Path) -> int | None:
    """Return the mode of an existing file, None where there is none."""
    try:
        mode = os.stat(target).st_mode
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(0, "it is a folder")
    # A rename would replace a write-protected file without asking.
    if not os.access(target, os.W_OK):
        raise PermissionError(0, "it is write-protected")
    return mode


def _replace(target: Path, mode: int | None, writer: Callable[[BinaryIO], object]) -> None:
    if not target.parent.is_dir():
        raise FileNotFoundError(0, f"there is no folder {shown(target.parent)}")
    # What a killed program left here goes; who holds its own is still writing.
    hidden.clean(target.parent)
    # A new file gets the usual permissions; what is to have others is nobody else's until then.
    temporary, descriptor = hidden.new_file(target.parent, 0o666 if mode is None else 0o600)
    try:
        with open(descriptor, "wb") as stream:
            writer(stream)
            stream.flush()
            os.fsync(descriptor)
        if mode is not None:
            os.chmod(temporary, stat.S_IMODE(mode))
        os.replace(temporary, target)
    except BaseException:
        with suppress(OSError):
            temporary.unlink()
        raise
    _flush_folder(target.parent)


def _flush_folder(folder: Path) -> None:
    """Make the rename itself survive a power cut, where the system knows how to."""
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
