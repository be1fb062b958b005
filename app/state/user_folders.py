"""The folders in which the program keeps what is the user's but no project file."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QStandardPaths

# As Qt names the program's folders and settings after it.
PROGRAM = "SGB Studio"


def recovery() -> Path:
    """Return the folder of the journals of unsaved work, shared by all windows."""
    return _data() / "recovery"


def thumbnails() -> Path:
    """Return the folder of the pictures of recent files."""
    return _data() / "thumbnails"


def backups() -> Path:
    """Return the folder of the versions before the last, of files that were saved."""
    return _data() / "backups"


def printers() -> Path:
    """Return the folder of the data files of one's own printers."""
    return _data() / "printers"


def log() -> Path:
    """Return the folder of the log."""
    return _state() / "log"


def locks() -> Path:
    """Return the folder of the locks that tell which window works on what."""
    return _state() / "locks"


def _data() -> Path:
    return Path(QStandardPaths.writableLocation(QStandardPaths.StandardLocation.AppDataLocation))


def _state() -> Path:
    return Path(QStandardPaths.writableLocation(QStandardPaths.StandardLocation.StateLocation))
