"""The errors that carry a finding."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.line import Line
from sgb_core.findings.words import FILE, Reader, say


class FindingError(ValueError):
    """A finding that stops what was asked for; as text it is what a file's reader is told."""

    def __init__(self, finding: Finding | str) -> None:
        """Carry ``finding``, or a line where there is nothing to tell apart."""
        self.finding = Line(finding) if isinstance(finding, str) else finding
        super().__init__(self.finding)

    def words(self, reader: Reader) -> str:
        """Return the finding in one line for a reader."""
        return say(self.finding, reader)

    def __str__(self) -> str:
        return self.words(FILE)
