"""What fairing is asked for and what it found, as values."""

from __future__ import annotations

from enum import StrEnum

from sgb_core.curves.profile import JointRule, Profile
from sgb_core.design.fairing.energy import Energy
from sgb_core.findings.errors import FindingError
from sgb_core.findings.fairing import JointInTheWay, MeasureInTheWay
from sgb_core.values import dataclass


class Freedom(StrEnum):
    """What may move: the shape parameters alone, or the inner control points too."""

    SHAPE = "shape"
    POINTS = "points"


class Keep(StrEnum):
    """What may be kept besides the joints' rules."""

    CAPACITY = "capacity"
    VOLUME = "volume"
    HEIGHT = "height"
    MAX_DIAMETER = "max_diameter"
    RIM_DIAMETER = "rim_diameter"
    FOOT_DIAMETER = "foot_diameter"
    ENDS = "ends"
    TANGENTS = "tangents"


class Status(StrEnum):
    """How fairing ended.

    FAIRER: the energy fell. UNCHANGED: nothing fairer keeps what is asked for. ENDLESS: some
    segments have an infinite energy whatever is done; the others are as fair as they can be.
    """

    FAIRER = "fairer"
    UNCHANGED = "unchanged"
    ENDLESS = "endless"


@dataclass(frozen=True, slots=True)
class Change:
    """A number of a segment before and after: a shape parameter, or "P1.r", "P1.h", "P2.r", …."""

    segment: int
    parameter: str
    before: float
    after: float


@dataclass(frozen=True, slots=True)
class KeptRule:
    """The rule of a joint."""

    joint: int
    rule: JointRule


class LocksExcludeError(FindingError):
    """Nothing keeps all that is asked for; the finding is what is in the way."""

    finding: JointInTheWay | MeasureInTheWay


@dataclass(frozen=True, slots=True)
class Faired:
    """The fairest profile found.

    ``before`` and ``after`` are its energies, None where infinite; ``kept`` what was held,
    ``unmet`` the rules that did not hold before and that no fraction can restore, ``endless`` the
    segments whose energy is infinite whatever is done.
    """

    profile: Profile
    energy: Energy
    before: float | None
    after: float | None
    moved: tuple[Change, ...]
    kept: tuple[KeptRule | Keep, ...]
    unmet: tuple[KeptRule, ...]
    endless: tuple[int, ...]
    status: Status
