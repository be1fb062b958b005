"""What can be wrong with a joint: its ends are apart, or the curve is less than its rule asks."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class Hindrance(Plain):
    """Why the rule of a joint is not kept."""

    POINT_BESIDE = "the segment beside it is a single point"
    NO_LEG = "the leg that should follow has no length"
    STILL_END = "suspended, as an end derivative vanishes there (λ = 4 with ω = 1, or no leg)"
    STILL_BESIDE = "suspended, as the end derivative of the segment beside it vanishes"
    FARTHEST = "held back, as a leg would have to grow by more than ten times its length"
    PLAIN_CUBIC = "ω of the segment that should follow is 0: raise it"
    STRAIGHT = "the polygon that should follow is straight there: bend it"
    OUT_OF_RANGE = "no λ1, λ2 or λ3 in range gives the same curvature; the nearest is kept"
    NONE_IN_RANGE = "no λ1, λ2 or λ3 in range gives the same curvature, on either side of the joint"
    BOTH_SET = "the shape parameters of both sides are being set"
    UNTRIED_STILL_END = (
        "an end derivative vanishes there (λ = 4 with ω = 1, or a leg without length)"
    )
    UNMET_BEFORE = "the points did not satisfy it before either"
    RESTORABLE = "it can be restored, as things are now: choose the rule again"


@dataclass(frozen=True, slots=True)
class Gap(Finding):
    """The ends of two segments that follow each other are ``distance`` apart."""

    joint: int
    following: int
    distance: float


@dataclass(frozen=True, slots=True)
class UnmetRule(Finding):
    """A joint that is ``measured`` as less than its ``rule``, and what stands in the way.

    ``kink_deg`` is the angle between the tangents, None where there is none to measure;
    ``hindrance`` is None where nobody asked.
    """

    joint: int
    following: int
    rule: str
    measured: str
    kink_deg: float | None = None
    hindrance: Hindrance | None = None


@dataclass(frozen=True, slots=True)
class Moved:
    """A shape parameter of a segment and its values, or a control point and its places (r, h).

    ``what`` is ``lambda1`` to ``lambda3``, ``omega``, or ``P0`` to ``P3``.
    """

    segment: int
    what: str
    before: float | tuple[float, float]
    after: float | tuple[float, float]


@dataclass(frozen=True, slots=True)
class RuleMoves(Finding):
    """What moved when a rule was chosen for a joint: nothing where it held or cannot be kept."""

    joint: int
    following: int
    rule: str
    moved: tuple[Moved, ...]


@say.register
def _(finding: Gap, reader: Reader = FILE) -> str:
    place = reader.joint_place(finding.joint, finding.following)
    return f"{place}: the ends are {finding.distance:.6g} apart"


@say.register
def _(finding: UnmetRule, reader: Reader = FILE) -> str:
    if finding.hindrance is None:
        place = reader.joint_place(finding.joint, finding.following)
        kink = "" if finding.kink_deg is None else f" (kink {finding.kink_deg:.4g}°)"
        return (
            f"{place}: the rule is {finding.rule}, "
            f"but the curve is only {finding.measured} there{kink}"
        )
    joint, why = reader.joint(finding.joint, finding.following), say(finding.hindrance, reader)
    if finding.hindrance is Hindrance.UNTRIED_STILL_END and finding.kink_deg is not None:
        why += f", with a kink of {finding.kink_deg:.3g}°"
    return f"{joint} is {finding.measured} now, not {finding.rule}: {why}"


@say.register
def _(finding: RuleMoves, reader: Reader = FILE) -> str:
    moved = "; ".join(
        f"{reader.place((each.what,))} of {reader.segment(each.segment)} "
        f"from {_value(each.before)} to {_value(each.after)}"
        for each in finding.moved
    )
    joint = reader.joint(finding.joint, finding.following)
    return f"{finding.rule} at {joint} moved {moved or 'nothing'}"


def _value(value: float | tuple[float, float]) -> str:
    if isinstance(value, tuple):
        return f"({value[0]:.6g}, {value[1]:.6g})"
    return f"{value:.6g}"
