"""Why a printer cannot print a document, and what is risky about it."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoPath(Plain):
    """What has no wall that can be printed in one go."""

    PART_TURN = "a part of a turn has no wall that closes; a path needs the sweep to be 360 degrees"
    RING = "a closed profile has no foot and no rim; a path needs an open one"
    TWIST = "the twist turns the wall by more than 30 degrees in a layer; a path needs less"
    GAP = "the profile's segments do not meet; a path needs one chain"
    FALLS_AT_RIM = "the profile does not climb to its upper end; a path needs a wall that does"
    TOO_LOW = "the wall is lower than one layer"
    FINE_RELIEF = "the relief is too fine to be printed; wider edges or fewer repeats help"
    TOO_NARROW = "the wall is narrower than two beads all the way up"


class PathNote(Plain):
    """What is printed otherwise than drawn."""

    FOOT_RING = "the foot ring is left out: the floor above it would hang in the air"
    ROUND_RIM = "the rim is printed level, not rounded"
    OPEN_BOTTOM = "the bottom stays open: no floor layer is printed"
    CLOSED_TOP = "the wall closes at the top; its last turns have little to rest on"
    RELIEF = "the whole wall follows the relief, which shows inside too"
    HOLES = "the holes are left out: the path follows the whole wall"
    NO_ARCS = "arcs are left out: with laws or relief no section is a circle"


@dataclass(frozen=True, slots=True)
class CrossesAxis(Finding):
    """A profile that crosses the axis, at ``s`` of a segment."""

    segment: int
    s: float


@dataclass(frozen=True, slots=True)
class FallingWall(Finding):
    """A wall that falls below the height (mm) from which on it climbs, in a segment."""

    segment: int
    height: float


@dataclass(frozen=True, slots=True)
class BeyondPrinter(Finding):
    """A layer or bead (mm) that a printer cannot print; ``walls`` beads a wall would help."""

    what: str
    value: float
    least: float
    most: float
    printer: str
    walls: int | None = None


@dataclass(frozen=True, slots=True)
class BeyondBed(Finding):
    """A path that takes more room (width, depth, height in mm) than a printer has."""

    needed: tuple[float, float, float]
    room: tuple[float, float, float]
    printer: str


@dataclass(frozen=True, slots=True)
class TooManyPoints(Finding):
    """A path of more points than can be made."""

    points: int
    most: int


@dataclass(frozen=True, slots=True)
class Lean(Finding):
    """Turns whose sideways step is large: how many beads at most, from which height to which (mm).

    ``stops`` tells that a bead has nothing to rest on, which ends the printing unless wanted.
    """

    first: int
    last: int
    low: float
    high: float
    beads: float
    stops: bool = False


@dataclass(frozen=True, slots=True)
class HighLayer(Finding):
    """A layer higher than the bead is wide: it does not hold on to the one below."""

    layer: float
    bead: float


@dataclass(frozen=True, slots=True)
class Floating(Finding):
    """The lowest turn that has a width lies at this height (mm), above what rests on the bed."""

    height: float


@say.register
def _(finding: CrossesAxis, reader: Reader = FILE) -> str:
    place = reader.segment(finding.segment)
    return f"the profile crosses the axis in {place} at s = {finding.s:.3g}; a path needs one side"


@say.register
def _(finding: FallingWall, reader: Reader = FILE) -> str:
    place = reader.segment(finding.segment)
    return (
        f"the wall falls before it climbs from {finding.height:.4g} mm on, in {place}; "
        "a path needs a wall that climbs, or floor layers up to there"
    )


@say.register
def _(finding: BeyondPrinter, reader: Reader = FILE) -> str:
    line = (
        f"a {finding.what} of {finding.value:.4g} mm is beyond {finding.printer}; "
        f"allowed is {finding.least:g} to {finding.most:g} mm"
    )
    if finding.walls is None:
        return line
    return f"{line}, which this wall has with {finding.walls} beads side by side"


@say.register
def _(finding: BeyondBed, reader: Reader = FILE) -> str:
    needed = " × ".join(f"{value:.1f}" for value in finding.needed)
    room = " × ".join(f"{value:g}" for value in finding.room)
    return f"it needs {needed} mm; {finding.printer} has room for {room} mm"


@say.register
def _(finding: TooManyPoints, reader: Reader = FILE) -> str:
    return (
        f"the path would have about {finding.points} points; allowed are {finding.most}: "
        "choose a larger chord or layer"
    )


@say.register
def _(finding: Lean, reader: Reader = FILE) -> str:
    turns = f"turn {finding.first}"
    if finding.last > finding.first:
        turns = f"turns {finding.first} to {finding.last}"
    verb = "leans" if finding.last == finding.first else "lean"
    where = f"{finding.low:.1f} to {finding.high:.1f} mm up"
    line = f"{turns} ({where}) {verb} by up to {finding.beads:.2g} of a bead"
    if finding.stops:
        return f"{line}: the bead has nothing to rest on; a smaller layer or a steeper wall helps"
    return f"{line}: print slower, with a smaller layer, or make the wall steeper there"


@say.register
def _(finding: HighLayer, reader: Reader = FILE) -> str:
    return (
        f"a layer of {finding.layer:g} mm is higher than the bead of {finding.bead:.4g} mm is "
        "wide: the beads hold on to each other badly"
    )


@say.register
def _(finding: Floating, reader: Reader = FILE) -> str:
    return (
        f"the foot is pointed: the first turn that has a width is at {finding.height:.4g} mm; "
        "a flat foot would rest on the bed"
    )
