"""The words of every finding, for whoever reads them: a file's reader, or the window's."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import singledispatch
from types import MappingProxyType

from sgb_core.findings.finding import Finding, Path


@dataclass(frozen=True, slots=True)
class Reader:
    """How a reader counts segments and joints, and what fields are called where he reads.

    ``first`` is the number of the first segment; ``names`` maps a field's path, numbers left out
    as in ``profile.segments[].omega``, to the name of the control that sets it, in which ``{}``
    stands for each number. Without names fields are called by their paths.
    """

    first: int = 0
    names: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))

    def number(self, index: int) -> int:
        """Return the number by which the reader knows a segment or joint."""
        return index + self.first

    def place(self, path: Path) -> str:
        """Return what the reader calls a field."""
        name = self.names.get(path_text(path, numbered=False))
        if name is None:
            return path_text(path)
        return name.format(*(self.number(step) for step in path if isinstance(step, int)))


# Files, the command line and scripts count from 0 and name a field by its path.
FILE = Reader()


def path_text(path: Path, numbered: bool = True) -> str:
    """Return a path as it is written, ``profile.segments[2].omega``, or with its numbers left out.

    The numbers leave their brackets: ``profile.segments[].omega``.
    """
    index = "[{}]" if numbered else "[]"
    words = "".join(
        index.format(step) if isinstance(step, int) else f".{_key(step)}" for step in path
    )
    return words.removeprefix(".")


def _key(key: str) -> str:
    if key.isidentifier():
        return key
    text = json.dumps(key)
    return text if len(text) <= 40 else f"{text[:37]}..."


@singledispatch
def say(finding: Finding, reader: Reader = FILE) -> str:
    """Return a finding in one line for a reader."""
    raise TypeError(f"{type(finding).__name__} has no words")
