"""The error of what cannot be drawn as asked."""

from __future__ import annotations

from sgb_core.findings.errors import FindingError


class DrawingError(FindingError):
    """There is no drawing, with the finding why."""
