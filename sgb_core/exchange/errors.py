"""What the exchange layer raises: one clear line."""

from __future__ import annotations


class ExportError(ValueError):
    """A document cannot be written in the asked way; nothing was written."""
