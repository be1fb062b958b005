"""Which version of a file lies on the disk, and the one before it, kept once as a backup."""

from __future__ import annotations

import hashlib
import os
from contextlib import suppress
from pathlib import Path

from sgb_core.document.file import json_text, private
from sgb_core.values import dataclass

# So many files have a backup; the oldest go.
MAX_BACKUPS = 50


@dataclass(frozen=True, slots=True)
class Version:
    """What a file held when it was looked at: the SHA-256 of its bytes.

    ``seconds``, when it was written, as a Unix time, is no part of what tells versions apart.
    """

    digest: str
    seconds: float

    def same(self, other: Version | None) -> bool:
        """Return whether the other is the same version of the file."""
        return other is not None and other.digest == self.digest


def version_of(path: str | os.PathLike[str]) -> Version | None:
    """Return the version on the disk, None where there is no file that can be read."""
    try:
        data = _read(path)
        return Version(hashlib.sha256(data).hexdigest(), os.stat(path).st_mtime)
    except (OSError, ValueError):
        return None


def lock_name(path: str | os.PathLike[str]) -> str:
    """Return the name of the lock of whoever works on a file, whatever way leads to it."""
    return f"file-{_name(path)}"


def backup_place(path: str | os.PathLike[str], folder: Path) -> Path:
    """Return where in a folder the backup of a file lies."""
    return folder / f"{_name(path)}-{Path(path).stem[:60]}.sgb"


def keep_backup(path: str | os.PathLike[str], folder: Path) -> None:
    """Keep what a file holds, privately, in place of its backup of before; nothing for no file.

    Raises OSError where the system refuses.
    """
    try:
        data = _read(path)
    except FileNotFoundError:
        return
    private.replace(backup_place(path, folder), data)
    kept = sorted(folder.glob("*.sgb"), key=lambda each: each.stat().st_mtime)
    for old in kept[:-MAX_BACKUPS]:
        with suppress(OSError):
            old.unlink()


def _read(path: str | os.PathLike[str]) -> bytes:
    return private.read(Path(os.path.realpath(path)), json_text.MAX_BYTES + 1)


def _name(path: str | os.PathLike[str]) -> str:
    return hashlib.sha256(os.fsencode(os.path.realpath(path))).hexdigest()[:24]
