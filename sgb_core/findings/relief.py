"""What is doubtful about a relief, and why it cannot be made."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class ReliefPierces(Finding):
    """A relief sunk by ``depth`` into a wall or a floor of only ``wall``."""

    depth: float
    wall: float


@dataclass(frozen=True, slots=True)
class ReliefMeets(Finding):
    """A relief raised by ``depth`` meets another part of the surface, at a height of the body."""

    depth: float
    height: float


@dataclass(frozen=True, slots=True)
class ThinUnderRelief(Finding):
    """A sunk relief leaves only ``left`` of a wall of ``wall``."""

    left: float
    wall: float


@dataclass(frozen=True, slots=True)
class ReliefHeldBack(Finding):
    """Where the surface bends too tightly the relief is up to ``missing`` less deep than asked."""

    missing: float


@dataclass(frozen=True, slots=True)
class EdgeWidened(Finding):
    """Edges of ``asked`` width are finer than a relief is taken apart: they are ``made`` wide."""

    asked: float
    made: float


@say.register
def _(finding: ReliefPierces, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(('appearance',))}: a relief sunk by {finding.depth:.4g} pierces the wall "
        f"of {finding.wall:.4g}; make it shallower or the wall thicker"
    )


@say.register
def _(finding: ReliefMeets, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(('appearance',))}: a relief raised by {finding.depth:.4g} fills the narrow "
        f"place at the height {finding.height:.4g}; make it lower or keep it away from there"
    )


@say.register
def _(finding: ThinUnderRelief, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(('appearance',))}: the sunk relief leaves only {finding.left:.3g} of the "
        f"wall of {finding.wall:.4g}"
    )


@say.register
def _(finding: EdgeWidened, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(('appearance',))}: soft edges of {finding.asked:.3g} are made "
        f"{finding.made:.3g} wide, the narrowest there are on an object of this size"
    )


@say.register
def _(finding: ReliefHeldBack, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(('appearance',))}: where the surface bends tightly the relief is up to "
        f"{finding.missing:.3g} less deep than asked for"
    )
