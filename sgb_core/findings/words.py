"""The words of every finding, for whoever reads them: a file's reader, or the window's."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import singledispatch
from types import MappingProxyType

from sgb_core.findings.finding import Finding, Path


@dataclass(frozen=True, slots=True)
class Reader:
    """How a reader counts segments and joints, and what fields are called where he reads.

    ``first`` is the number of the first segment; ``names`` maps a field's path, as
    ``solid.wall``, to the name of the control that sets it.
    """

    first: int = 0
    names: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))

    def number(self, index: int) -> int:
        """Return the number by which the reader knows a segment or joint."""
        return index + self.first

    def place(self, path: Path) -> str:
        """Return what the reader calls a field."""
        written = path_text(path)
        return self.names.get(written, written)


# Files, the command line and scripts count from 0 and name a field by its path.
FILE = Reader()


def path_text(path: Path) -> str:
    """Return a path as it is written: ``profile.segments[2].omega``."""
    words = "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path)
    return words.removeprefix(".")


@singledispatch
def say(finding: Finding, reader: Reader = FILE) -> str:
    """Return a finding in one line for a reader."""
    raise TypeError(f"{type(finding).__name__} has no words")
