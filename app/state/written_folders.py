"""The folders that are written to: a program that is killed leaves half a file there.

Those of projects are known as recent files; where exports went, and a project in the middle of its
first save, nothing else knows.
"""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QSettings

from app.state.stored import stored_words

KEY = "written_folders"
LIMIT = 20


def paths() -> list[Path]:
    """Return the folders that were written to last, newest first."""
    return [Path(name) for name in stored_words(KEY)]


def note(target: Path) -> None:
    """Remember the folder of a file that is about to be written, before it is."""
    name = str(target.absolute().parent)
    known = stored_words(KEY)
    if name not in known:
        settings = QSettings()
        settings.setValue(KEY, [name, *known][:LIMIT])
        # On the disk at once: a kill during the writing is what it is for.
        settings.sync()
