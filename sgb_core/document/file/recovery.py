"""A journal of unsaved work: what a crash would lose can be offered again afterwards.

An entry is a file of records (:mod:`sgb_core.document.file.records`), one appended for each step
of the work. A step holds the sections that changed since the one before, of a profile's segments
those alone that changed, so that it is short however large the document is; pictures stand in
records of their own, once. What follows a torn record is lost, and nothing before it.
"""

from __future__ import annotations

import os
import secrets
import time
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.appearance.picture_file import PICTURE, Picture
from sgb_core.document.errors import FileError
from sgb_core.document.file import hidden, json_text, private, project_file
from sgb_core.document.file.atomic import reason, shown
from sgb_core.document.file.records import record, records, write_all
from sgb_core.document.file.shared_pictures import pictures_of, share
from sgb_core.document.model import Document
from sgb_core.fields.record import codec_of, table_of
from sgb_core.findings.files import NoContent, Unwritten
from sgb_core.findings.line import Line

SUFFIX = ".recovery"
ASIDE = "set-aside"
# An entry is begun anew, with one step, once it is this large and this many times its first size.
LARGE, GROWN = 8 << 20, 4
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


@dataclass(slots=True)
class _Written:
    """What an entry holds, how long it is, and how long it was at first; sizes in bytes."""

    document: Document
    pictures: set[str]
    size: int = 0
    first: int = 0


class Journal:
    """The unsaved work of one window, kept as one file in a folder that windows share.

    ``locks`` is the folder of the locks that tell whose window still runs.
    """

    def __init__(self, folder: str | os.PathLike[str], locks: str | os.PathLike[str]) -> None:
        """Use ``folder``; it is made when something is first written."""
        self._folder, self._locks = Path(folder), Path(locks)
        self._entry = self._folder / f"{secrets.token_hex(8)}{SUFFIX}"
        self._lock: private.Lock | None = None
        self._written: _Written | None = None
        self._steps = 0
        self._prepared: tuple[_Written, bytes] | None = None

    @property
    def entry(self) -> Path:
        """The file that this journal writes."""
        return self._entry

    def prepare(self, document: Document) -> None:
        """Make ready what the entry begins with: the document that work is going to change."""
        written = _Written(document, set())
        self._prepared = written, _step(document, None, 0, written, whole=True)

    def write(self, document: Document, target: str | os.PathLike[str] | None = None) -> bool:
        """Append a step, seen to the disk; return whether there was anything new.

        Raises FileError where the system refuses: then the entry is as it was, but for a torn end.
        """
        if self._written is not None and document is self._written.document:
            return False
        place = None if target is None else os.path.abspath(target)
        try:
            if self._lock is None:
                self._lock = private.lock(self._locks, self._entry.stem)
            self._steps += 1
            if not self._append(document, place):
                self._begin(document, place)
        except OSError as error:
            raise FileError(Unwritten(shown(self._entry), Line(reason(error)))) from error
        return True

    def _append(self, document: Document, target: str | None) -> bool:
        """Append to the entry; return whether it was there, whole, and not too large."""
        written = self._written
        if written is None or written.size > max(LARGE, GROWN * written.first):
            return False
        # Whatever fails from here on, the next step begins anew.
        self._written = None
        data = _step(document, target, self._steps, written)
        try:
            descriptor = private.append_to(self._entry)
        except OSError:
            # Somebody has taken the file or the whole folder away.
            return False
        try:
            if os.fstat(descriptor).st_size != written.size:
                return False
            write_all(descriptor, data)
        finally:
            os.close(descriptor)
        written.size += len(data)
        written.document = document
        self._written = written
        return True

    def _begin(self, document: Document, target: str | None) -> None:
        """Write a new entry of one step, whole, in place of whatever lies there."""
        prepared, self._prepared = self._prepared, None
        if prepared is None:
            written = _Written(document, set())
            data = _step(document, target, self._steps, written, whole=True)
        else:
            written, data = prepared
            data += _step(document, target, self._steps, written)
            written.document = document
        private.replace(self._entry, data)
        written.size = written.first = len(data)
        self._written = written

    def adopt(self, item: Recoverable) -> bool:
        """Make found work this journal's own; return False where another window has taken it.

        From then on a crash of this program leaves it to be found again.
        """
        with suppress(OSError, FileError):
            taken = private.lock(self._locks, item.entry.stem)
            try:
                if taken is not None and item.entry.exists():
                    # Its own first: a crash between the two leaves both, and nothing is lost.
                    self._written, self._steps = None, max(0, item.steps - 1)
                    self.write(item.document, item.target)
                    item.entry.unlink()
                    return True
            finally:
                private.unlock(taken, remove=True)
        return False

    def clear(self) -> None:
        """Forget the work: it was saved, or thrown away on purpose."""
        self._written, self._steps = None, 0
        with suppress(OSError):
            self._entry.unlink()
        self.close()

    def close(self) -> None:
        """Leave the work to be found by whoever looks next."""
        private.unlock(self._lock, remove=True)
        self._lock = None


def _step(
    document: Document,
    target: str | None,
    number: int,
    written: _Written,
    *,
    whole: bool = False,
) -> bytes:
    """Return the records of a step from what is written to a document, and note them there."""
    table, before = table_of(Document), written.document
    changed: dict[str, object] = {}
    new: list[bytes] = []
    segments = {} if whole else _changed_segments(before.profile, document.profile)
    for row in table.written:
        if row.name == "profile" and segments:
            continue
        if whole or getattr(document, row.name) is not getattr(before, row.name):
            changed[row.name] = _shared(document, table.part(document, row), written, new)
    if whole or document.extra is not before.extra:
        changed["extra"] = dict(document.extra)
    step: dict[str, object] = {
        "step": number,
        "seconds": time.time(),
        "target": target,
        "sections": changed,
    }
    if segments:
        step["segments"] = segments
    return b"".join([*new, record(step)])


def _changed_segments(before: Profile, after: Profile) -> dict[str, object]:
    """Return the segments that changed, by their numbers, where nothing else of a profile did."""
    rest = (each.name for each in fields(Profile) if each.name != "segments")
    if len(before) != len(after) or any(getattr(before, k) != getattr(after, k) for k in rest):
        return {}
    pairs = enumerate(zip(before.segments, after.segments, strict=True))
    return {str(k): codec_of(Segment).to_plain(new) for k, (old, new) in pairs if new is not old}


def _shared(
    document: Document, part: dict[str, object], written: _Written, new: list[bytes]
) -> dict[str, object]:
    """Return a part of a document's tree without pictures, which become records of their own."""
    if part.keys().isdisjoint(("appearance", "states", "reference")):
        return part
    for picture in pictures_of(document):
        if picture.name not in written.pictures:
            written.pictures.add(picture.name)
            new.append(record({"picture": PICTURE.to_plain(picture)}))
    return share(document, part, set(written.pictures))


def recoverable(folder: str | os.PathLike[str], locks: str | os.PathLike[str]) -> list[Recoverable]:
    """Return the unsaved work in a folder, newest first; nothing where it cannot be looked into.

    Entries of windows that still run, those of this program included, are left out. What cannot
    be read is moved to the folder ASIDE in it, where it is not looked at again.
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
                found.append(_read(entry))
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


def _read(entry: Path) -> Recoverable:
    data = private.read(entry, MAX_BYTES)
    if data.startswith(b"{"):
        return _read_whole(entry, data)
    sections: dict[str, Mapping[str, object]] = {}
    pictures: dict[str, Picture] = {}
    last: Mapping[str, Any] = {}
    for text in records(data):
        value = json_text.parse(text, bounded=False)
        if isinstance(value, dict) and "picture" in value:
            picture = PICTURE.from_plain(value["picture"], ("picture",))
            pictures[picture.name] = picture
        elif isinstance(value, dict) and isinstance(value.get("sections"), dict):
            sections.update(value["sections"])
            _put_segments(sections, value.get("segments", {}))
            last = value
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


def _put_segments(sections: Mapping[str, Any], changed: object) -> None:
    """Put the segments of a step into the profile; raises ValueError where they do not fit."""
    if not isinstance(changed, dict):
        raise FileError(NoContent.NO_DOCUMENT)
    for number, segment in changed.items():
        try:
            sections["profile"]["profile"]["segments"][int(number)] = segment
        except (LookupError, TypeError):
            raise FileError(NoContent.NO_DOCUMENT) from None


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
