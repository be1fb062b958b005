"""What the document layer raises: one clear line each, fit to show to a person as it is."""

from __future__ import annotations


class FileError(ValueError):
    """A file is at fault or cannot be reached: what, where, and what is allowed."""


class EditError(ValueError):
    """An edit is not allowed on this document; nothing was changed."""
