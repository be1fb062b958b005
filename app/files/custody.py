"""Whose file it is: the lock of the window that works on it, and the version it began from."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from app.state import user_folders
from sgb_core.document.file import private
from sgb_core.document.file.versions import Version, keep_backup, lock_name, version_of


class Custody:
    """What one window knows of its file."""

    def __init__(self) -> None:
        self.path: Path | None = None
        self.base: Version | None = None
        self._lock: private.Lock | None = None

    def take(self, path: Path | None, base: Version | None) -> bool:
        """Work on another file, or none; return whether no other window works on it."""
        if path is None or self.path is None or lock_name(path) != lock_name(self.path):
            self.release()
        self.path, self.base = path, base
        return path is None or self.holds(path)

    def holds(self, path: Path) -> bool:
        """Return whether the file is this window's alone, taking it where it is free."""
        if self.path is not None and lock_name(path) == lock_name(self.path):
            if self._lock is None:
                with suppress(OSError):
                    self._lock = private.lock(user_folders.locks(), lock_name(path))
                    return self._lock is not None
            # Where no lock can be made, none is asked for.
            return True
        with suppress(OSError):
            other = private.lock(user_folders.locks(), lock_name(path))
            private.unlock(other)
            return other is not None
        return True

    def foreign(self, path: Path) -> Version | None:
        """Return the version on the disk where it is not the one that this window began from."""
        now = version_of(path)
        mine = self.path is not None and lock_name(path) == lock_name(self.path)
        return None if now is None or not mine or now.same(self.base) else now

    def back_up(self, path: Path) -> None:
        """Keep what the file holds as a backup; without one, saving goes on."""
        with suppress(OSError):
            keep_backup(path, user_folders.backups())

    def release(self) -> None:
        """Let other windows have the file."""
        private.unlock(self._lock)
        self._lock = None
