"""The errors that carry a finding."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.words import FILE, Reader, say


class FindingError(ValueError):
    """A finding that stops what was asked for; as text it is what a file's reader is told."""

    def __init__(self, finding: Finding) -> None:
        """Carry ``finding``."""
        super().__init__(finding)
        self.finding = finding

    def words(self, reader: Reader) -> str:
        """Return the finding in one line for a reader."""
        return say(self.finding, reader)

    def __str__(self) -> str:
        return self.words(FILE)
