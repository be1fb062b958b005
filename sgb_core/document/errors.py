"""What the document layer raises: one clear line each, fit to show to a person as it is."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.words import FILE, Reader, say


class _ToldError(ValueError):
    """What is wrong: as a finding, which every reader is told in his words, or as a line."""

    def __init__(self, told: Finding | str, before: str = "") -> None:
        """Tell a finding or a line, after the words ``before``."""
        super().__init__(told, before)
        self._told = told
        self._before = before

    @property
    def finding(self) -> Finding | None:
        """What is wrong as a value, None where it is a line alone."""
        return self._told if isinstance(self._told, Finding) else None

    def words(self, reader: Reader) -> str:
        """Return the line for a reader."""
        told = self._told
        return self._before + (say(told, reader) if isinstance(told, Finding) else told)

    def __str__(self) -> str:
        return self.words(FILE)


class FileError(_ToldError):
    """A file is at fault or cannot be reached: what, where, and what is allowed."""

    def of_file(self, name: str) -> FileError:
        """Return the error with the file's name before it."""
        return FileError(self._told, f"{name}: {self._before}")


class EditError(_ToldError):
    """An edit is not allowed on this document; nothing was changed."""
