"""The error of what cannot be printed as asked."""

from __future__ import annotations

from sgb_core.findings.errors import FindingError


class ToolpathError(FindingError):
    """There is no path, with the finding why."""
