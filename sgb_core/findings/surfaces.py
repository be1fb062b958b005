"""Why a surface cannot be made, or not as finely as asked."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoSurface(Plain):
    """Why turning a section gives no surface."""

    POINT = "the section is a single point: there is no surface"
    ON_AXIS = "the section lies on the axis: there is no surface"


class NoFineness(Plain):
    """Why a mesh cannot be made as finely as asked."""

    BOTH = "tolerance and samples exclude each other"


@dataclass(frozen=True, slots=True)
class TooManyTriangles(Finding):
    """A fineness that needs ``count`` triangles where at most ``most`` are made."""

    count: float
    most: int


@dataclass(frozen=True, slots=True)
class TooFewAround(Finding):
    """Intervals around of which one would reach half a turn; ``needed`` are the fewest."""

    count: int
    needed: int


@say.register
def _(finding: TooManyTriangles, reader: Reader = FILE) -> str:
    return f"this fineness needs {finding.count:.3g} triangles; at most {finding.most:,} are made"


@say.register
def _(finding: TooFewAround, reader: Reader = FILE) -> str:
    return f"{finding.count} intervals around are too few; this sweep needs {finding.needed}"
