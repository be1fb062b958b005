"""What is wrong with a file as such: its text, its size, or reaching it at all."""

from __future__ import annotations

from sgb_core.findings.finding import Finding, Path
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass

# Of a path that is nested too deep so much is said that its place can be found.
_BEGINNING = 60


class NoContent(Plain):
    """Why nothing can be had from what was read."""

    NO_DOCUMENT = "the entry holds no document"
    NO_SEGMENTS = "the clipboard holds no segments"


@dataclass(frozen=True, slots=True)
class IsTheProject(Finding):
    """A file to write which is the project that it would be made from."""

    file: str


@dataclass(frozen=True, slots=True)
class NotText(Finding):
    """Bytes that are no UTF-8, from number ``byte`` on."""

    byte: int


@dataclass(frozen=True, slots=True)
class NotJson(Finding):
    """A text that is no JSON, and what its parser says of the place."""

    line: int
    column: int
    said: str


@dataclass(frozen=True, slots=True)
class TooDeep(Finding):
    """More than ``most`` lists and objects within each other; ``path`` where that is known."""

    most: int
    path: Path = ()


@dataclass(frozen=True, slots=True)
class TooManyBytes(Finding):
    """A file that is larger than what is read."""

    most: int


@dataclass(frozen=True, slots=True)
class TooManyValues(Finding):
    """A file of more values than are read."""

    most: int


@dataclass(frozen=True, slots=True)
class NotFinite(Finding):
    """A number beyond what can be computed with; ``words`` say how."""

    path: Path
    words: str


@dataclass(frozen=True, slots=True)
class GivenTwice(Finding):
    """A field that its object names twice."""

    path: Path


@dataclass(frozen=True, slots=True)
class HalfCharacterName(Finding):
    """A field whose name no file can hold: it has one half of a surrogate pair."""

    path: Path


@dataclass(frozen=True, slots=True)
class NotReopened(Finding):
    """Why a file that would be written could not be opened again."""

    finding: Finding


@dataclass(frozen=True, slots=True)
class Unread(Finding):
    """A file that cannot be read, and what the system says."""

    file: str
    why: str


@dataclass(frozen=True, slots=True)
class Unwritten(Finding):
    """A file that cannot be written, and why."""

    file: str
    why: Finding


@say.register
def _(finding: IsTheProject, reader: Reader = FILE) -> str:
    return f"{finding.file!r} is the project itself; choose another name"


@say.register
def _(finding: NotText, reader: Reader = FILE) -> str:
    return f"the file is not UTF-8 text (byte {finding.byte})"


@say.register
def _(finding: NotJson, reader: Reader = FILE) -> str:
    place = f"line {finding.line}, column {finding.column}"
    return f"the file is not valid JSON ({place}): {finding.said}"


@say.register
def _(finding: TooDeep, reader: Reader = FILE) -> str:
    place = f"{reader.place(finding.path)[:_BEGINNING]}..." if finding.path else "the file"
    return f"{place} is nested deeper than {finding.most} levels"


@say.register
def _(finding: TooManyBytes, reader: Reader = FILE) -> str:
    return f"the file is larger than {finding.most >> 20} MB, the most that is read"


@say.register
def _(finding: TooManyValues, reader: Reader = FILE) -> str:
    return f"the file holds more than {finding.most} values, the most that is read"


@say.register
def _(finding: NotFinite, reader: Reader = FILE) -> str:
    return f"{reader.place(finding.path)} is {finding.words}; allowed are finite numbers only"


@say.register
def _(finding: GivenTwice, reader: Reader = FILE) -> str:
    return f"{reader.place(finding.path)} is given twice; allowed is once"


@say.register
def _(finding: HalfCharacterName, reader: Reader = FILE) -> str:
    return f"{reader.place(finding.path)} has half a character in its name"


@say.register
def _(finding: NotReopened, reader: Reader = FILE) -> str:
    return f"it could not be opened again: {say(finding.finding, reader)}"


@say.register
def _(finding: Unread, reader: Reader = FILE) -> str:
    return f"cannot read {finding.file}: {finding.why}"


@say.register
def _(finding: Unwritten, reader: Reader = FILE) -> str:
    return f"cannot write {finding.file}: {say(finding.why, reader)}"
