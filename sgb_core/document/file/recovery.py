"""What a crash would have lost is found again: the unsaved work in a folder of journals.

An entry is a file of records (:mod:`sgb_core.document.file.records`), one appended for each step
of the work (:mod:`sgb_core.document.file.steps`). What follows a torn record is lost, and nothing
before it.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from sgb_core.document.appearance.picture_file import PICTURE, Picture
from sgb_core.document.errors import FileError
from sgb_core.document.file import hidden, json_text, private, project_file
from sgb_core.document.file.records import is_torn, records
from sgb_core.document.file.steps import replay
from sgb_core.document.model import Document
from sgb_core.findings.files import NoContent
from sgb_core.values import dataclass

SUFFIX = ".recovery"
ASIDE = "set-aside"
# No entry is read beyond this; none of a document that can be saved gets there.
MAX_BYTES = 16 * json_text.MAX_BYTES


@dataclass(frozen=True, slots=True)
class Recoverable:
    """Unsaved work found in a journal folder.

    ``target`` is the project file it belongs to, None where it was never saved; ``seconds`` is
    when its last step was written, as a Unix time, and ``steps`` how many there were.
    """

    entry: Path
    document: Document
    target: Path | None
    seconds: float
    steps: int = 1


def recoverable(folder: str | os.PathLike[str], locks: str | os.PathLike[str]) -> list[Recoverable]:
    """Return the unsaved work in a folder, newest first; nothing where it cannot be looked into.

    Entries of windows that still run, those of this program included, are left out. What cannot
    be read is moved to the folder ASIDE in it, where it is not looked at again; what a kill left
    before its first step was whole is removed.
    """
    found = []
    try:
        entries = sorted(Path(folder).glob(f"*{SUFFIX}"))
    except OSError:
        return []
    for entry in entries:
        taken = None
        try:
            taken = private.lock(Path(locks), entry.stem)
            if taken is not None:
                item = _read(entry)
                if item is None:
                    entry.unlink()
                else:
                    found.append(item)
        except FileNotFoundError:
            continue
        except (OSError, ValueError, RecursionError):
            _set_aside(entry)
        finally:
            private.unlock(taken, remove=True)
    return sorted(found, key=lambda item: item.seconds, reverse=True)


def clean(folder: str | os.PathLike[str], locks: str | os.PathLike[str]) -> None:
    """Remove what killed programs left behind that holds no work: half entries and free locks."""
    hidden.clean(folder)
    with suppress(OSError):
        # No two journals have one name, so that a lock can go when its holder has.
        for left in Path(locks).glob(f"{'?' * 16}.lock"):
            with suppress(OSError):
                private.unlock(private.lock(Path(locks), left.stem), remove=True)


def aside(folder: str | os.PathLike[str]) -> list[Path]:
    """Return the entries of a folder that could not be read and were set aside."""
    return sorted(Path(folder, ASIDE).glob("*"))


def _set_aside(entry: Path) -> None:
    with suppress(OSError):
        private.make_folder(entry.parent / ASIDE)
        entry.replace(entry.parent / ASIDE / entry.name)


def _read(entry: Path) -> Recoverable | None:
    """Return the work in an entry, None where a kill left it before its first step was whole."""
    data = private.read(entry, MAX_BYTES)
    if data.startswith(b"{"):
        return _read_whole(entry, data)
    sections: dict[str, Any] = {}
    pictures: dict[str, Picture] = {}
    last: Mapping[str, Any] = {}
    for text in records(data):
        value = json_text.parse(text, bounded=False)
        if isinstance(value, dict) and "picture" in value:
            picture = PICTURE.from_plain(value["picture"], ("picture",))
            pictures[picture.name] = picture
        elif isinstance(value, dict) and isinstance(value.get("sections"), dict):
            replay(sections, value)
            last = value
    if not last and is_torn(data):
        return None
    tree = {**project_file.HEAD}
    for section in sections.values():
        tree.update(section)
    document = project_file.document_of(tree, pictures)
    target, seconds, steps = (last.get(key) for key in ("target", "seconds", "step"))
    return Recoverable(
        entry,
        document,
        Path(target) if isinstance(target, str) else None,
        seconds if isinstance(seconds, float) and 0 <= seconds < 1e10 else entry.stat().st_mtime,
        steps if isinstance(steps, int) else 1,
    )


def _read_whole(entry: Path, data: bytes) -> Recoverable:
    """Return the work in an entry of the first version, which was one JSON text."""
    tree = json_text.parse(data, bounded=False)
    if not isinstance(tree, dict):
        raise FileError(NoContent.NO_DOCUMENT)
    target = tree.get("target")
    return Recoverable(
        entry,
        project_file.document_of(tree.get("document")),
        Path(target) if isinstance(target, str) else None,
        entry.stat().st_mtime,
    )
