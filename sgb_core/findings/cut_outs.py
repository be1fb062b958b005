"""Why a pattern of holes cannot be cut through a wall."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import PlainOfField
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoCutOuts(PlainOfField):
    """Why nothing can be cut out of a body."""

    NO_VESSEL = ("cut_outs",), "only the wall of a vessel can be pierced; choose the body vessel"
    RING = ("cut_outs",), "a closed profile has neither foot nor rim to keep holes away from"
    BROKEN = ("cut_outs",), "holes meet each other or what lies behind the wall; space them wider"


@dataclass(frozen=True, slots=True)
class NoRoomForHoles(Finding):
    """Holes are ``height`` high; between the margins at foot and rim the wall is ``room`` long."""

    pattern: int
    height: float
    room: float


@dataclass(frozen=True, slots=True)
class HolesTooNear(Finding):
    """Holes of a row leave ``bridge`` between them and the next, less than the ``least``.

    A negative bridge is how far they overlap. ``row`` counts from 0 at the foot.
    """

    pattern: int
    row: int
    bridge: float
    least: float


@dataclass(frozen=True, slots=True)
class HoleTooLarge(Finding):
    """A hole of a row is ``width`` wide, where the body is only ``diameter`` wide."""

    pattern: int
    row: int
    width: float
    diameter: float


@dataclass(frozen=True, slots=True)
class IslandsFallOut(Finding):
    """Shapes enclose parts of the wall that no bridge of the ``bridge`` asked for can hold."""

    pattern: int
    bridge: float


@dataclass(frozen=True, slots=True)
class NothingToCut(Finding):
    """A ``text`` without letters, or a picture without dark parts that are worth a hole."""

    pattern: int
    text: bool


@dataclass(frozen=True, slots=True)
class TooManyHoles(Finding):
    """A pattern would cut ``count`` holes of such outlines, more than can be cut."""

    pattern: int
    count: int


@dataclass(frozen=True, slots=True)
class NoPatternWord(Finding):
    """A word of a pattern, as one types it, that is no ``what``; ``allowed`` are others."""

    word: str
    what: str
    allowed: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class NoPatternValue(Finding):
    """A setting of a pattern whose value, as one types it, is none; ``wanted`` says of what."""

    setting: str
    wanted: str


@say.register
def _(finding: NoPatternWord, reader: Reader = FILE) -> str:
    allowed = ", ".join(finding.allowed)
    return f"{finding.word!r} is no {finding.what} of holes; allowed are {allowed}"


@say.register
def _(finding: NoPatternValue, reader: Reader = FILE) -> str:
    return f"{finding.setting!r}: allowed is {finding.wanted}"


@say.register
def _(finding: NoRoomForHoles, reader: Reader = FILE) -> str:
    place = reader.place(("cut_outs", finding.pattern, "height"))
    room = f"only {finding.room:.4g} of wall lies" if finding.room > 0.0 else "no wall lies"
    return f"{place}: for holes {finding.height:g} high {room} between the margins at foot and rim"


@say.register
def _(finding: HolesTooNear, reader: Reader = FILE) -> str:
    place = reader.place(("cut_outs", finding.pattern, "bridge"))
    row = f"holes of row {finding.row + 1}"
    if finding.bridge <= 0.0:
        return f"{place}: {row} overlap; make them fewer or smaller"
    return (
        f"{place}: {row} leave a bridge of {finding.bridge:.4g}, less than the {finding.least:g} "
        "asked for; make them fewer or smaller"
    )


@say.register
def _(finding: HoleTooLarge, reader: Reader = FILE) -> str:
    place = reader.place(("cut_outs", finding.pattern, "width"))
    return (
        f"{place}: a hole {finding.width:g} wide is too wide for row {finding.row + 1}, where the "
        f"body is {finding.diameter:.4g} wide"
    )


@say.register
def _(finding: IslandsFallOut, reader: Reader = FILE) -> str:
    place = reader.place(("cut_outs", finding.pattern, "bridge"))
    if finding.bridge == 0.0:
        return f"{place}: what the shapes enclose would fall out; ask for a bridge to hold it"
    return (
        f"{place}: bridges of {finding.bridge:g} cannot hold what the shapes enclose; make them "
        "narrower, or the shapes larger"
    )


@say.register
def _(finding: NothingToCut, reader: Reader = FILE) -> str:
    if finding.text:
        place = reader.place(("cut_outs", finding.pattern, "text"))
        return f"{place}: no letter is left to cut; write some, larger, or with narrower bridges"
    place = reader.place(("cut_outs", finding.pattern, "picture"))
    return f"{place}: nothing in it is dark enough to cut; raise the threshold, or make it larger"


@say.register
def _(finding: TooManyHoles, reader: Reader = FILE) -> str:
    place = reader.place(("cut_outs", finding.pattern, "around"))
    return f"{place}: {finding.count} holes of such shapes are more than can be cut; ask for fewer"
