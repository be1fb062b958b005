"""What the document layer raises: each with the finding that says what is wrong, and where."""

from __future__ import annotations

from sgb_core.findings.errors import FindingError
from sgb_core.findings.line import InFile


class FileError(FindingError):
    """A file is at fault or cannot be reached: what, where, and what is allowed."""

    def of_file(self, file: str) -> FileError:
        """Return the error with the file's name."""
        return FileError(InFile(file, self.finding))


class EditError(FindingError):
    """An edit is not allowed on this document; nothing was changed."""
