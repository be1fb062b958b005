"""The project file: suffix ``.sgb``, UTF-8 JSON, version 1; ``resources`` has its schema."""

from __future__ import annotations

import os
import stat
from dataclasses import replace
from typing import BinaryIO

from sgb_core.document.errors import FileError
from sgb_core.document.file import json_text, reader
from sgb_core.document.file.appearance import read_appearance
from sgb_core.document.file.atomic import reason, shown, write_whole
from sgb_core.document.file.fields import Fields, Node
from sgb_core.document.file.manufacture import read_manufacture
from sgb_core.document.file.plate import read_plate
from sgb_core.document.file.states import read_states
from sgb_core.document.file.writer import FORMAT, VERSION, tree_of
from sgb_core.document.findings import check
from sgb_core.document.model import Document, Unit
from sgb_core.findings.words import say

__all__ = ["FileError", "dumps", "load", "loads", "save", "warnings"]


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
        raise FileError(f"cannot read {shown(path)}: {why}") from error
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
    fields = Node(json_text.parse(data), "").object()
    _check_version(fields)
    document = _document(fields, fields["name"].text("Untitled"))
    states = read_states(fields["states"], _document)
    plate = read_plate(fields["plate"])
    return replace(document, states=states, plate=plate, extra=fields.rest())


def _document(fields: Fields, name: str) -> Document:
    """Return what a document and a state of it alike consist of."""
    profile = reader.read_profile(fields["profile"])
    return Document(
        profile=profile,
        name=name,
        unit=fields["unit"].choice(Unit, Unit.MM),
        revolution=reader.read_revolution(fields["revolution"].object()),
        variation=reader.read_variation(fields["variation"], len(profile)),
        solid=reader.read_solid(fields["solid"].object()),
        placement=reader.read_placement(fields["placement"].object()),
        appearance=read_appearance(fields["appearance"].object()),
        manufacture=read_manufacture(fields),
    )


def warnings(document: Document) -> list[str]:
    """Return what is allowed in a document but doubtful, a line each that says what and where."""
    return [say(finding) for finding in check(document)]


def dumps(document: Document) -> bytes:
    """Return a document as the bytes of a project file; ``loads`` gives it back exactly.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.loads(sgb.dumps(cylinder)) == cylinder
    True
    """
    return json_text.dump(tree_of(document))


def save(document: Document, path: str | os.PathLike[str]) -> None:
    """Write a project file whole or not at all.

    Raises FileError where the system refuses; the old file is then as it was.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.save(cylinder, "cylinder.sgb")
    """
    data = dumps(document)

    def writer(stream: BinaryIO) -> None:
        stream.write(data)

    write_whole(path, writer)


def _check_version(fields: Fields) -> None:
    if fields["format"].value != FORMAT:
        fields["format"].fail(f'"{FORMAT}": this is no SGB Studio project')
    node = fields["version"]
    allowed = f"a whole number from 1 to {VERSION}"
    if node.number(allowed, 1) > VERSION:
        node.fail(f"at most {VERSION}: a newer SGB Studio wrote this file")
    node.integer(allowed, 1, VERSION)
