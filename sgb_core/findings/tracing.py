"""Why points cannot be traced."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoTrace(Plain):
    """Why points are no profile."""

    ONE_PLACE = "all points lie in one place"
    ON_AXIS = "all points lie on the axis; a profile needs a radius"
    FEW_CLOSED = "a closed outline needs at least 4 different points"


@dataclass(frozen=True, slots=True)
class TooFewPoints(Finding):
    """Only ``count`` points."""

    count: int


@dataclass(frozen=True, slots=True)
class NoPoint(Finding):
    """A point, by its number in the data from 0, that is no pair of finite numbers."""

    number: int


@dataclass(frozen=True, slots=True)
class WithinTolerance(Finding):
    """All points lie nearer to each other than the tolerance."""

    tolerance: float


@dataclass(frozen=True, slots=True)
class Scattered(Finding):
    """Points that scatter across any smooth path by a standard deviation of ``noise``."""

    noise: float
    tolerance: float


@say.register
def _(finding: Scattered, reader: Reader = FILE) -> str:
    return (
        f"the points scatter by {finding.noise:.3g} across any smooth path, too much for a "
        f"tolerance of {finding.tolerance:.3g}; take a larger one, or points in their order"
    )


@say.register
def _(finding: TooFewPoints, reader: Reader = FILE) -> str:
    return f"the number of points is {finding.count}; allowed is at least 2"


@say.register
def _(finding: NoPoint, reader: Reader = FILE) -> str:
    return f"point {finding.number} is not a pair of finite numbers"


@say.register
def _(finding: WithinTolerance, reader: Reader = FILE) -> str:
    return f"all points lie within the tolerance of {finding.tolerance:g}"
