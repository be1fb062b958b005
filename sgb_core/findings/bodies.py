"""What is doubtful about a body, and why one cannot be made."""

from __future__ import annotations

from typing import Literal

from sgb_core.findings.finding import Finding
from sgb_core.findings.joints import Gap
from sgb_core.findings.plain import Plain, PlainOfField
from sgb_core.findings.profile import BeyondAxis, Crossing
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass

End = Literal["rim", "foot"]

_WALL = ("solid", "wall")


@dataclass(frozen=True, slots=True)
class DoubtfulPlace(Finding):
    """Base of what is doubtful about a body that can be made, at a place (r, h) to be marked."""

    where: tuple[float, float]

    @property
    def subject(self) -> tuple[object, ...]:
        """What it is apart from its place and amount, which may change from angle to angle."""
        return (type(self),)


@dataclass(frozen=True, slots=True)
class TightCurve(DoubtfulPlace):
    """A segment curves more tightly from s0 to s1, ``span``, than the ``wall`` allows."""

    wall: float
    segment: int
    span: tuple[float, float]

    @property
    def subject(self) -> tuple[object, ...]:
        """What it is apart from its place and amount."""
        return (type(self), self.segment)


@dataclass(frozen=True, slots=True)
class EndCutSquare(DoubtfulPlace):
    """The profile is so flat at its rim or foot that the wall's end is cut square."""

    end: End

    @property
    def subject(self) -> tuple[object, ...]:
        """What it is apart from its place."""
        return (type(self), self.end)


@dataclass(frozen=True, slots=True)
class RimTooShort(DoubtfulPlace):
    """A rim that is to be round is flat, since the profile is too short for it."""


@dataclass(frozen=True, slots=True)
class SealedHollow(DoubtfulPlace):
    """The cavity closes up: a hollow from the height ``low`` up to the place is sealed off."""

    low: float


@dataclass(frozen=True, slots=True)
class LoosePart(DoubtfulPlace):
    """A part of the body that does not hang together with the rest."""

    @property
    def subject(self) -> tuple[object, ...]:
        """What it is apart from its amount: each loose part counts, by its place."""
        return (type(self), *(round(value, 3) for value in self.where))


@dataclass(frozen=True, slots=True)
class TouchingCircle(DoubtfulPlace):
    """The body touches itself along a circle, where edges have four faces instead of two."""

    @property
    def subject(self) -> tuple[object, ...]:
        """What it is apart from its amount: each circle counts, by its place."""
        return (type(self), *(round(value, 3) for value in self.where))


@dataclass(frozen=True, slots=True)
class Crumb(DoubtfulPlace):
    """A crumb beside the body that cutting left, dropped."""


class NoBody(Plain):
    """Why there is no body, where no field is to blame."""

    EMPTY = "the body has no volume: nothing is left of it"
    WEIGHTLESS = "a mesh without a volume has no centre of mass"
    BARE = "a bare surface has no material; choose filled or vessel"
    BEYOND_AXIS = "the profile lies beyond the axis there"


class NoBodyFor(PlainOfField):
    """Why there is no body, for what a field asks."""

    ON_AXIS = ("profile",), "it lies on the axis; a body needs one away from it"
    CROSSES_ITSELF = ("profile",), "the generatrix crosses itself; a body needs one that does not"
    CROSSING_SAMPLES = ("solid",), "the section's samples cross each other; a finer mesh may help"
    END_BARRED = (
        ("solid", "kind"),
        "an end cannot be closed to the axis, since the level line from it crosses the profile",
    )
    NOT_RESOLVED = (
        ("solid",),
        "the edges of wall, floor and hole lie too close to be told apart; change one of them",
    )
    TOO_NARROW = (
        ("revolution", "sweep_deg"),
        "the turn is so narrow that the end faces lie on each other; a mesh needs a wider one",
    )
    TOO_FLAT = (
        ("profile",),
        "it is so flat that both sides of the body lie on each other; a body needs them apart",
    )
    NO_FLOOR = ("solid", "drain_hole"), "there is no floor to drill"


@dataclass(frozen=True, slots=True)
class UnfitProfile(Finding):
    """A profile of which no body can be made for what is wrong with it."""

    fault: Gap | BeyondAxis | Crossing


@dataclass(frozen=True, slots=True)
class WallOutOfReach(Finding):
    """A wall thinner or thicker than a shape of this size can have, ``low`` to ``high``."""

    wall: float
    low: float
    high: float


@dataclass(frozen=True, slots=True)
class WallBeyondEnds(Finding):
    """A wall that does not fit between the planes of foot and rim."""

    wall: float


@dataclass(frozen=True, slots=True)
class NoCavity(Finding):
    """A wall, with its base unless the profile is a ring, that leaves nothing hollow."""

    wall: float
    base: float | None


@dataclass(frozen=True, slots=True)
class HoleTooWide(Finding):
    """A drain hole wider than the floor."""

    diameter: float


@dataclass(frozen=True, slots=True)
class NoRoomForRing(Finding):
    """A foot ring as wide as the wall that has no room below a floor of radius ``edge``."""

    wall: float
    edge: float


@dataclass(frozen=True, slots=True)
class ChangingSection(Finding):
    """Laws change what the section is made of, for the first time at ``theta_deg``."""

    theta_deg: float


@dataclass(frozen=True, slots=True)
class AtAngle(Finding):
    """A finding about the section at one angle, ``theta_deg`` from the start."""

    finding: Finding
    theta_deg: float


@dataclass(frozen=True, slots=True)
class BodyFailure(Finding):
    """A body that was not made for a reason nobody foresaw, in the words of what failed."""

    why: str


@say.register
def _(finding: TightCurve, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(_WALL)}: {finding.wall:g} is more than the curvature of "
        f"{reader.segment(finding.segment)} allows at height {finding.where[1]:.4g}; "
        "the wall is thicker there"
    )


@say.register
def _(finding: EndCutSquare, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(_WALL)}: the profile is so flat at its {finding.end} that the wall's "
        "end is cut square there"
    )


@say.register
def _(finding: RimTooShort, reader: Reader = FILE) -> str:
    place = reader.place(("solid", "rim"))
    return f"{place}: the profile is too short for a round rim; it is flat"


@say.register
def _(finding: SealedHollow, reader: Reader = FILE) -> str:
    low, high = finding.low, finding.where[1]
    return (
        f"{reader.place(_WALL)}: the cavity closes up at height {high:.4g}; a hollow from "
        f"{low:.4g} to {high:.4g} is sealed off"
    )


@say.register
def _(finding: LoosePart, reader: Reader = FILE) -> str:
    r, h = finding.where
    return (
        f"a part of the body around r = {r:.4g}, h = {h:.4g} hangs loose; a thicker base or wall "
        "may join it to the rest"
    )


@say.register
def _(finding: TouchingCircle, reader: Reader = FILE) -> str:
    r, h = finding.where
    return (
        f"the body touches itself along the circle at r = {r:.4g}, h = {h:.4g}, without a joint "
        "there; other programs may take it for several bodies"
    )


@say.register
def _(finding: Crumb, reader: Reader = FILE) -> str:
    r, h = finding.where
    return f"a crumb left by cutting at r = {r:.4g}, h = {h:.4g} is dropped"


@say.register
def _(finding: UnfitProfile, reader: Reader = FILE) -> str:
    needed = {
        Gap: "without gaps",
        BeyondAxis: "on one side of the axis",
        Crossing: "that does not cross itself",
    }[type(finding.fault)]
    return f"{say(finding.fault, reader)}; a body needs a profile {needed}"


@say.register
def _(finding: WallOutOfReach, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(_WALL)}: a wall of {finding.wall:g} is not possible for a shape of this "
        f"size; allowed is {finding.low:.3g} to {finding.high:.4g}"
    )


@say.register
def _(finding: WallBeyondEnds, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(_WALL)}: a wall of {finding.wall:g} does not fit between the planes of "
        "foot and rim; nothing is left"
    )


@say.register
def _(finding: NoCavity, reader: Reader = FILE) -> str:
    place, wall = reader.place(_WALL), finding.wall
    if finding.base is None:
        return f"{place}: {wall:g} fills the ring; no hollow is left"
    return (
        f"{place}: a wall of {wall:g} with a base of {finding.base:g} fills the whole body; "
        "no cavity is left"
    )


@say.register
def _(finding: HoleTooWide, reader: Reader = FILE) -> str:
    place = reader.place(("solid", "drain_hole"))
    return f"{place}: a hole of {finding.diameter:g} is wider than the floor"


@say.register
def _(finding: NoRoomForRing, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(('solid', 'foot_ring'))}: a ring as wide as the wall, {finding.wall:g}, "
        f"has no room below the floor, whose underside ends at r = {finding.edge:.4g}"
    )


@say.register
def _(finding: ChangingSection, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(_WALL)}: the section changes its make-up round the turn, for the first "
        f"time at {finding.theta_deg:.4g}°; a thinner wall or base may help"
    )


@say.register
def _(finding: AtAngle, reader: Reader = FILE) -> str:
    return f"{say(finding.finding, reader)} (at {finding.theta_deg:.4g}°)"


@say.register
def _(finding: BodyFailure, reader: Reader = FILE) -> str:
    return f"the body cannot be made: {finding.why}"
