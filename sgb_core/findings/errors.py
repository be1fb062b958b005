"""The errors that carry a finding."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.words import FILE, say


class FindingError(ValueError):
    """A finding that stops what was asked for; as text it is what a file's reader is told."""

    def __init__(self, finding: Finding) -> None:
        """Carry ``finding``."""
        super().__init__(finding)
        self.finding = finding

    def __str__(self) -> str:
        return say(self.finding, FILE)
