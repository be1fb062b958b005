"""The words of every finding, for whoever reads them: a file's reader, or the window's.

How each finding reads stands beside it, in the room's module of its subject.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import field
from functools import singledispatch
from types import MappingProxyType

from sgb_core.findings.finding import Finding, Path
from sgb_core.values import dataclass


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
            return path_text(path) or "the file"
        return name.format(*(self.number(step) for step in path if isinstance(step, int)))

    def segment(self, segment: int) -> str:
        """Return a segment within a sentence: ``segment 2``."""
        return f"segment {self.number(segment)}"

    def joint(self, joint: int, following: int) -> str:
        """Return the joint before the segment ``following`` within a sentence.

        Paths number joints; who knows controls knows a joint by the two segments that meet there.
        """
        first = self.number(joint)
        return f"joint {first}–{self.number(following)}" if self.names else f"joint {first}"

    def joint_place(self, joint: int, following: int) -> str:
        """Return what the reader calls a joint where a line is about it."""
        if self.names:
            return self.joint(joint, following).capitalize()
        return path_text(("profile", "joints", joint))


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
    """Return a finding in one line for a reader.

    >>> walls = [sgb.line((20, 0), (20, 30)), sgb.line((20, 31), (20, 60))]
    >>> apart = sgb.Document(sgb.Profile.of(walls, ["free"]))
    >>> sgb.say(sgb.check(apart)[0])
    'profile.joints[0]: the ends are 1 apart'
    """
    raise TypeError(f"{type(finding).__name__} has no words")
