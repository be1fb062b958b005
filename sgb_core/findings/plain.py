"""Findings that have nothing to count or to measure: the members' values are their words."""

from __future__ import annotations

from enum import Enum

from sgb_core.findings.finding import Finding
from sgb_core.findings.words import FILE, Reader, say


class Plain(Finding, Enum):
    """Base of findings whose values are the words."""


class PlainOfField(Finding, Enum):
    """Base of findings about a field, whose values are its path and the words."""


@say.register
def _(finding: Plain, reader: Reader = FILE) -> str:
    return str(finding.value)


@say.register
def _(finding: PlainOfField, reader: Reader = FILE) -> str:
    path, words = finding.value
    return f"{reader.place(path)}: {words}"
