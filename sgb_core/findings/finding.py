"""What a finding is, and where in a project it lies."""

from __future__ import annotations

# The keys and numbers that lead to a field of the project file: ("profile", "segments", 2).
Path = tuple[str | int, ...]


class Finding:
    """Base of all findings: frozen values of what, which segment or joint, where, how much."""

    __slots__ = ()
