"""The project file: suffix ``.sgb``, UTF-8 JSON, version 1; ``resources`` has its schema."""

from __future__ import annotations

import os
import stat
from collections.abc import Mapping
from dataclasses import replace
from math import inf
from typing import BinaryIO

from sgb_core.document.appearance.picture_file import Picture
from sgb_core.document.errors import FileError
from sgb_core.document.file import json_text
from sgb_core.document.file import profile as _profile  # noqa: F401  says how profiles stand
from sgb_core.document.file.atomic import reason, shown, write_whole
from sgb_core.document.file.shared_pictures import share, unshare
from sgb_core.document.findings import check
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Range, Said
from sgb_core.fields.record import table_of
from sgb_core.findings.files import Unread, Unwritten
from sgb_core.findings.refusal import MISSING, RefusalError
from sgb_core.findings.words import say

__all__ = ["FileError", "dumps", "load", "loads", "save", "tree_of", "warnings"]

FORMAT = "sgb-document"
VERSION = 1
# What a file says of itself before its sections.
HEAD = {"format": FORMAT, "version": VERSION}


def load(path: str | os.PathLike[str]) -> Document:
    """Return the document in a project file.

    Raises FileError, one line that begins with the path, where the file cannot be read or holds
    no project.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.save(cylinder, "cylinder.sgb")
    >>> sgb.load("cylinder.sgb") == cylinder
    True
    """
    try:
        data = _read(path)
    except (OSError, ValueError) as error:
        why = reason(error) if isinstance(error, OSError) else str(error)
        raise FileError(Unread(shown(path), why)) from error
    try:
        return loads(data)
    except FileError as error:
        raise error.of_file(shown(path)) from None


def _read(path: str | os.PathLike[str]) -> bytes:
    mode = os.stat(path).st_mode
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(0, "it is a folder")
    # A pipe could make us wait for ever, a device never end.
    if not stat.S_ISREG(mode):
        raise OSError(0, "it is not a regular file")
    with open(path, "rb") as stream:
        return stream.read(json_text.MAX_BYTES + 1)


def loads(data: bytes) -> Document:
    """Return the document in the bytes of a project file.

    Raises FileError, one line that says what is wrong, where, and what is allowed. Nothing is
    moved or repaired; :func:`warnings` tells what is allowed but doubtful.

    >>> sgb.loads(b'{"format": "sgb-document", "version": 2}')
    Traceback (most recent call last):
        ...
    sgb_core.document.errors.FileError: version is 2; allowed is at most 1: ...
    """
    try:
        return document_of(json_text.parse(data))
    except RefusalError as error:
        raise FileError(error.finding) from None


def document_of(tree: object, pictures: Mapping[str, Picture] | None = None) -> Document:
    """Return the document in a file's tree of plain values; raises RefusalError.

    ``pictures`` are those that the tree names and does not hold, by their names.
    """
    if not isinstance(tree, dict):
        raise Said("an object {...}").refusal(tree, ())
    if tree.get("format") != FORMAT:
        no_project = Said(f'"{FORMAT}": this is no SGB Studio project')
        raise no_project.refusal(tree.get("format", MISSING), ("format",))
    _check_version(tree.get("version", MISSING))
    sections = {key: value for key, value in tree.items() if key not in HEAD}
    document: Document = table_of(Document).from_plain(unshare(sections, pictures or {}), ())
    return document


def _check_version(version: object) -> None:
    known = Range(1, VERSION, whole=True, said=f"a whole number from 1 to {VERSION}")
    if replace(known, high=inf, whole=False).take(version, ("version",)) > VERSION:
        newer = Said(f"at most {VERSION}: a newer SGB Studio wrote this file")
        raise newer.refusal(version, ("version",))
    known.take(version, ("version",))


def tree_of(document: Document) -> dict[str, object]:
    """Return the file's tree: known keys in the order of the tables, then unknown ones.

    Sections that say nothing but the defaults are left out, except those that every file has.
    Each picture stands in it once, see :mod:`sgb_core.document.file.shared_pictures`.
    """
    return {**HEAD, **share(document, table_of(Document).to_plain(document), set())}


def warnings(document: Document) -> list[str]:
    """Return what is allowed in a document but doubtful, a line each that says what and where."""
    return [say(finding) for finding in check(document)]


def dumps(document: Document) -> bytes:
    """Return a document as the bytes of a project file; ``loads`` gives it back exactly.

    Raises FileError where the file would be too large or nested too deep to be opened again.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.loads(sgb.dumps(cylinder)) == cylinder
    True
    """
    return json_text.dump(tree_of(document))


def save(document: Document, path: str | os.PathLike[str]) -> None:
    """Write a project file whole or not at all.

    Raises FileError where the system refuses, or where the file would be too large or nested too
    deep to be opened again; the old file is then as it was.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.save(cylinder, "cylinder.sgb")
    """
    try:
        data = dumps(document)
    except FileError as error:
        raise FileError(Unwritten(shown(path), error.finding)) from None

    def writer(stream: BinaryIO) -> None:
        stream.write(data)

    write_whole(path, writer)
