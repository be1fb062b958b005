"""Why a file gives no profile, and what is to be said of one that does."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass

_LONGEST = 100


class NoSource(Plain):
    """Why a file gives no profile."""

    EMPTY = "the file is empty"
    NOT_TEXT = "the file is not text"
    NO_COLUMNS = "the text has no two columns of numbers"
    NO_PATH = "the drawing has no lines or curves"
    ENTITIES = "the file defines entities, which are not read"
    USES_ITSELF = "the drawing uses itself"
    NOT_FINITE = "a coordinate is too large to be one"
    ON_AXIS = "the path lies on the axis; a profile needs a radius"
    NO_SIDE = "nothing lies beside the axis"
    ONE_PLACE = "all points lie in one place"
    NO_TRIANGLES = "the mesh has no triangles"
    NO_CORNER = "a triangle names a point that the mesh does not have"
    NO_AREA = "the triangles of the mesh have no area"
    FLAT = "the mesh is flat; it turns about no axis"
    NO_SCALE = "a picture needs a scale: the height, the scale or a scale bar"
    NO_AXIS = "a line followed by clicks needs the abscissa of its axis"
    NO_HEIGHT = "what the picture shows has no height"
    ONE_COLOUR = "the picture is of one colour"
    NOTHING_SEEN = "nothing stands out from the ground of the picture"
    FAR_CLICKS = "two clicks are too far apart; one more between them helps"
    SCALES = "the height, the scale and the scale bar exclude each other; give one of them"


class Sides(Plain):
    """What is to be said of the sides of a profile."""

    CUT = "the picture's edge cuts the outline; the cut was left out"
    ONE = "the source has only the other side; it was taken"


@dataclass(frozen=True, slots=True)
class Unreadable(Finding):
    """A file that is not of its kind, such as "SVG", or is damaged, with its parser's reason."""

    kind: str
    reason: str


@dataclass(frozen=True, slots=True)
class TooMuch(Finding):
    """More of something, such as "points", than the ``most`` that are read."""

    what: str
    most: int


@dataclass(frozen=True, slots=True)
class TooLarge(Finding):
    """A file of more megabytes than the ``most`` that are read of its kind."""

    megabytes: float
    most: float


@dataclass(frozen=True, slots=True)
class NoNumbers(Finding):
    """A line of a table, numbered as text editors do, that has no two numbers."""

    line: int
    text: str


@dataclass(frozen=True, slots=True)
class SeveralPaths(Finding):
    """A drawing of ``count`` separate paths, of which the likely one was taken."""

    count: int


@dataclass(frozen=True, slots=True)
class NoUnit(Finding):
    """A file that names no unit: its numbers were taken in the ``unit`` asked for."""

    unit: str


@dataclass(frozen=True, slots=True)
class Wall(Finding):
    """A half section's wall: its median thickness, and the spread of the middle half of it."""

    median: float
    spread: float
    unit: str


@dataclass(frozen=True, slots=True)
class OutOfRound(Finding):
    """How far a mesh departs from a surface of revolution."""

    rms: float
    largest: float
    unit: str


@dataclass(frozen=True, slots=True)
class PictureSize(Finding):
    """A picture of more pixels than are read: at most ``side`` each way, ``area`` in all."""

    width: int
    height: int
    side: int
    area: int


@dataclass(frozen=True, slots=True)
class TinyPicture(Finding):
    """A picture of too few pixels to show anything."""

    width: int
    height: int


@say.register
def _(finding: Unreadable, reader: Reader = FILE) -> str:
    reason = " ".join(finding.reason.split())
    reason = reason if len(reason) <= _LONGEST else f"{reason[: _LONGEST - 3]}..."
    return f"the file is no {finding.kind} that can be read" + (f": {reason}" if reason else "")


@say.register
def _(finding: TooMuch, reader: Reader = FILE) -> str:
    return f"there are more than {finding.most} {finding.what}"


@say.register
def _(finding: TooLarge, reader: Reader = FILE) -> str:
    return (
        f"the file has {finding.megabytes:.0f} MB; at most {finding.most:.0f} MB of this kind "
        "are read"
    )


@say.register
def _(finding: NoNumbers, reader: Reader = FILE) -> str:
    return (
        f"line {finding.line} has no two numbers: {finding.text[:40]!r}; "
        "allowed are two columns, r and h"
    )


@say.register
def _(finding: SeveralPaths, reader: Reader = FILE) -> str:
    return f"the drawing has {finding.count} separate paths; the longest was taken"


@say.register
def _(finding: NoUnit, reader: Reader = FILE) -> str:
    return f"the file names no unit; its numbers were taken as {finding.unit}"


@say.register
def _(finding: Wall, reader: Reader = FILE) -> str:
    return (
        f"the section has a wall of {finding.median:.4g} {finding.unit} (median; half of it varies "
        f"by {finding.spread:.2g}); the outer line was taken"
    )


@say.register
def _(finding: OutOfRound, reader: Reader = FILE) -> str:
    return (
        f"the object is out of round by {finding.rms:.3g} {finding.unit} rms, "
        f"{finding.largest:.3g} at most"
    )


@say.register
def _(finding: PictureSize, reader: Reader = FILE) -> str:
    return (
        f"the picture has {finding.width} × {finding.height} pixels; allowed are at most "
        f"{finding.side} a side and {finding.area / 1e6:g} million in all"
    )


@say.register
def _(finding: TinyPicture, reader: Reader = FILE) -> str:
    return f"the picture has only {finding.width} × {finding.height} pixels"
