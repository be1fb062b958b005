"""Why a profile cannot be made fair as asked for."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoFairing(Plain):
    """What stands in the way of making a profile fair."""

    LAWS = "a surface with laws has no such energy; remove its laws first"


@dataclass(frozen=True, slots=True)
class JointInTheWay(Finding):
    """A joint's rule that cannot be kept along with the rest.

    ``missed`` is by how much at best, as a part of a radian or of the joint's curvature.
    """

    joint: int
    following: int
    rule: str
    missed: float


@dataclass(frozen=True, slots=True)
class MeasureInTheWay(Finding):
    """A measure that cannot be kept along with the rest; ``missed`` is a part of it."""

    measure: str
    missed: float


@say.register
def _(finding: JointInTheWay, reader: Reader = FILE) -> str:
    return _in_the_way(finding, reader)


@say.register
def _(finding: MeasureInTheWay, reader: Reader = FILE) -> str:
    return _in_the_way(finding, reader)


def named(finding: JointInTheWay | MeasureInTheWay, reader: Reader = FILE) -> str:
    """Return what is in the way, in two or three words."""
    if isinstance(finding, MeasureInTheWay):
        return f"the {finding.measure.replace('_', ' ')}"
    return f"{finding.rule} at {reader.joint(finding.joint, finding.following)}"


def _in_the_way(finding: JointInTheWay | MeasureInTheWay, reader: Reader) -> str:
    missed = f"(missed by {finding.missed:.3g} at best)"
    return f"{named(finding, reader)} is in the way: with the rest it cannot be kept {missed}"
