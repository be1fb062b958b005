"""A journal of unsaved work: what a crash would lose can be offered again afterwards."""

from __future__ import annotations

import os
import secrets
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from sgb_core.document.errors import FileError
from sgb_core.document.file import json_text, project_file
from sgb_core.document.file.atomic import reason, shown, write_whole
from sgb_core.document.model import Document

SUFFIX = ".recovery"
ASIDE = "set-aside"


@dataclass(frozen=True, slots=True)
class Recoverable:
    """Unsaved work found in a journal folder.

    ``target`` is the project file it belongs to, None where it was never saved; ``seconds`` is
    when it was written, as a Unix time.
    """

    entry: Path
    document: Document
    target: Path | None
    seconds: float


class Journal:
    """The unsaved work of one window, kept as one file in a folder that windows share."""

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        """Use ``folder``; it is made when something is first written."""
        self._folder = Path(folder)
        self._entry = self._folder / f"{os.getpid()}-{secrets.token_hex(4)}{SUFFIX}"
        self._written: Document | None = None

    @property
    def entry(self) -> Path:
        """The file that this journal writes."""
        return self._entry

    def write(self, document: Document, target: str | os.PathLike[str] | None = None) -> bool:
        """Keep a document, whole or not at all; return whether there was anything new.

        Raises FileError where the system refuses.
        """
        if document is self._written:
            return False
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise FileError(f"cannot make {shown(self._folder)}: {reason(error)}") from error
        place = None if target is None else os.path.abspath(target)
        data = json_text.dump({"target": place, "document": project_file.tree_of(document)})

        def writer(stream: BinaryIO) -> None:
            stream.write(data)

        write_whole(self._entry, writer)
        self._written = document
        return True

    def adopt(self, item: Recoverable) -> bool:
        """Make found work this journal's own; return False where another window has taken it.

        From then on a crash of this program leaves it to be found again.
        """
        try:
            item.entry.replace(self._entry)
        except OSError:
            return False
        self._written = item.document
        return True

    def clear(self) -> None:
        """Forget the work: it was saved, or thrown away on purpose."""
        self._written = None
        with suppress(OSError):
            self._entry.unlink()


def recoverable(folder: str | os.PathLike[str]) -> list[Recoverable]:
    """Return the unsaved work in a folder, newest first; nothing where it cannot be looked into.

    Entries of programs that still run, this one included, are left out. What cannot be read is
    moved to the folder ASIDE in it, where it is not looked at again.
    """
    found = []
    try:
        entries = sorted(Path(folder).glob(f"*{SUFFIX}"))
    except OSError:
        return []
    for entry in entries:
        if _owner_runs(entry):
            continue
        try:
            found.append(_read(entry))
        except (OSError, ValueError):
            _set_aside(entry)
    return sorted(found, key=lambda item: item.seconds, reverse=True)


def aside(folder: str | os.PathLike[str]) -> list[Path]:
    """Return the entries of a folder that could not be read and were set aside."""
    return sorted(Path(folder, ASIDE).glob("*"))


def _set_aside(entry: Path) -> None:
    with suppress(OSError):
        (entry.parent / ASIDE).mkdir(exist_ok=True)
        entry.replace(entry.parent / ASIDE / entry.name)


def _read(entry: Path) -> Recoverable:
    with open(entry, "rb") as stream:
        tree = json_text.parse(stream.read(json_text.MAX_BYTES + 1))
    if not isinstance(tree, dict):
        raise FileError("the entry holds no document")
    target = tree.get("target")
    return Recoverable(
        entry,
        # Read as the project file that it is, with all its checks.
        project_file.loads(json_text.dump(tree.get("document"))),
        Path(target) if isinstance(target, str) else None,
        entry.stat().st_mtime,
    )


def _owner_runs(entry: Path) -> bool:
    number = entry.name.partition("-")[0]
    if not number.isdigit():
        return False
    if int(number) == os.getpid():
        return True
    # Elsewhere a signal 0 is no question but ends the other program.
    if os.name != "posix":
        return False
    try:
        os.kill(int(number), 0)
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:
        return True
    return True
