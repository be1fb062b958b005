"""What a source raises."""

from __future__ import annotations

from sgb_core.findings.errors import FindingError


class SourceError(FindingError):
    """A source, or an option for it, is at fault, with the finding that says why."""
