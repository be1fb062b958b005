"""What is doubtful about a profile: where it crosses the axis or itself, or runs both ways."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class BeyondAxis(Finding):
    """A segment lies on the far side of the axis from ``s0`` to ``s1``."""

    segment: int
    s0: float
    s1: float


@dataclass(frozen=True, slots=True)
class TurnsBeyondAxis(Finding):
    """Laws carry a segment beyond the axis, farthest by ``depth`` at ``theta_deg`` from the start.

    The surface cuts through itself there.
    """

    segment: int
    depth: float
    theta_deg: float


@dataclass(frozen=True, slots=True)
class Crossing(Finding):
    """A point (r, h) that the profile passes twice, with segment and parameter of each pass.

    ``touches`` says that two joints lie there, which need not cross.
    """

    segment_a: int
    s_a: float
    segment_b: int
    s_b: float
    point: tuple[float, float]
    touches: bool = False


@dataclass(frozen=True, slots=True)
class SegmentIsPoint(Finding):
    """All control points of a segment are one ``point`` (r, h)."""

    segment: int
    point: tuple[float, float]


@dataclass(frozen=True, slots=True)
class LegsWithoutLength(Finding):
    """Neighbouring control points of some segments coincide, though these are no points."""

    segments: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class MoreCrossings(Finding):
    """The profile crosses itself in more places than are named: ``count`` more."""

    count: int


@dataclass(frozen=True, slots=True)
class OpposedParts(Finding):
    """Parts of the chain run in opposite directions; reversed, their ends would meet."""


@say.register
def _(finding: BeyondAxis, reader: Reader = FILE) -> str:
    place = reader.place(("profile", "segments", finding.segment))
    return f"{place}: beyond the axis from s = {finding.s0:.4g} to {finding.s1:.4g}"


@say.register
def _(finding: TurnsBeyondAxis, reader: Reader = FILE) -> str:
    place, segment = reader.place(("variation",)), reader.segment(finding.segment)
    return (
        f"{place}: {segment} goes beyond the axis as it turns, farthest by {finding.depth:.4g} "
        f"at θ = {finding.theta_deg:.4g}°; the surface cuts through itself there"
    )


@say.register
def _(finding: Crossing, reader: Reader = FILE) -> str:
    place = reader.place(("profile", "segments", finding.segment_a))
    other, (r, h) = reader.segment(finding.segment_b), finding.point
    verb = "touches" if finding.touches else "crosses"
    return f"{place}: {verb} {other} at r = {r:.6g}, h = {h:.6g}"


@say.register
def _(finding: SegmentIsPoint, reader: Reader = FILE) -> str:
    place, (r, h) = reader.place(("profile", "segments", finding.segment)), finding.point
    return f"{place}: is a single point, at r = {r:.6g}, h = {h:.6g}"


@say.register
def _(finding: LegsWithoutLength, reader: Reader = FILE) -> str:
    which = ", ".join(str(reader.number(segment)) for segment in finding.segments)
    segments = "segment" if len(finding.segments) == 1 else "segments"
    return (
        f"{reader.place(('profile',))}: a leg of the control polygon has no length in "
        f"{segments} {which}"
    )


@say.register
def _(finding: MoreCrossings, reader: Reader = FILE) -> str:
    return f"{reader.place(('profile',))}: crosses itself in {finding.count} more places"


@say.register
def _(finding: OpposedParts, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(('profile',))}: parts of the chain run in opposite directions; "
        "put head to tail they meet end to end"
    )
