"""What the exchange layer raises, with the finding that says why."""

from __future__ import annotations

from sgb_core.findings.errors import FindingError


class ExportError(FindingError):
    """A document cannot be written in the asked way; nothing was written."""
