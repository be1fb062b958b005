"""What tracing raises."""

from __future__ import annotations

from sgb_core.findings.errors import FindingError


class TraceError(FindingError):
    """The points cannot be traced, with the finding that says why."""
