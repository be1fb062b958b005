"""Why there is no drawing of a document, and what is drawn otherwise than asked."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoDrawing(Plain):
    """What nothing can be drawn of."""

    POINT = "the profile is a single point: there is nothing to draw"
    ONE_PAGE = "only PDF holds several pages; a section of several files needs PDF"
    NO_INSIDE = "only a vessel has an inside of its wall; choose the outside, or make it a vessel"


@dataclass(frozen=True, slots=True)
class NoDrawingFormat(Finding):
    """A file whose suffix, which may be empty, is none of the ``allowed``."""

    file: str
    allowed: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class DoesNotFit(Finding):
    """A drawing that at a scale is larger (mm) than what a paper has room for."""

    scale: str
    paper: str
    needed: tuple[float, float]
    room: tuple[float, float]


@dataclass(frozen=True, slots=True)
class TooFine(Finding):
    """A picture of a page at a resolution (dpi) beyond the ``most`` that its size allows."""

    dpi: float
    most: int


@dataclass(frozen=True, slots=True)
class TooManyPages(Finding):
    """A template of more pages than are made."""

    pages: int
    most: int


@say.register
def _(finding: NoDrawingFormat, reader: Reader = FILE) -> str:
    allowed = " ".join(finding.allowed)
    return f"{finding.file!r} names no format for drawings; allowed are {allowed}"


@say.register
def _(finding: DoesNotFit, reader: Reader = FILE) -> str:
    needed = " × ".join(f"{value:.0f}" for value in finding.needed)
    room = " × ".join(f"{max(value, 0.0):.0f}" for value in finding.room)
    return (
        f"at {finding.scale} the drawing needs {needed} mm, {finding.paper} has room for {room} "
        "mm; choose a smaller scale or a larger paper"
    )


@say.register
def _(finding: TooFine, reader: Reader = FILE) -> str:
    return f"a page of this size is drawn with at most {finding.most} dpi, not {finding.dpi:g}"


@say.register
def _(finding: TooManyPages, reader: Reader = FILE) -> str:
    return (
        f"at true size it takes {finding.pages} pages; at most {finding.most} are made: choose a "
        "larger paper, or export SVG or DXF"
    )
