"""Findings of what is told in words that are not ours, and of the file that it is about."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class Line(Finding):
    """A line as the system or a parser says it, which has no number or field of ours in it."""

    words: str


@dataclass(frozen=True, slots=True)
class InFile(Finding):
    """What is wrong in a file of a name."""

    file: str
    finding: Finding


@say.register
def _(finding: Line, reader: Reader = FILE) -> str:
    return finding.words


@say.register
def _(finding: InFile, reader: Reader = FILE) -> str:
    return f"{finding.file}: {say(finding.finding, reader)}"
