"""Why an edit is not allowed on a document, and by how much one was not exact."""

from __future__ import annotations

from typing import Literal

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoEdit(Plain):
    """What stands in the way of an edit."""

    RING_HAS_NO_END = "a ring has no end to add a segment to; open the profile first"
    RING_HAS_NO_MIRROR = "a ring has no end to mirror at; open the profile first"
    RING_HAS_NO_ROOM = "a ring has no room for more segments; open the profile first"
    RING_HAS_NO_TARGET = "a closed profile has no ends to put on the target; open it first"
    OPEN_AND_TARGET_CLOSED = "a closed target needs a closed profile; close it first"
    RING_HOLDS_TOGETHER = "the joint that closes a ring cannot be free; open the profile instead"
    CLOSED_ALREADY = "the profile is closed already"
    OPEN_ALREADY = "the profile is open already"
    ONLY_SEGMENT = "the only segment cannot be removed; a profile has at least one"
    NONE_TO_MERGE = "there is only one segment; nothing to merge it with"
    NONE_ON_THAT_SIDE = "there is no segment on that side to change places with"
    NO_HEAD_TO_TAIL = "no reversing of parts makes the ends of this profile meet"
    TOO_FAR = "this would move a point farther than 1e9 from the origin"
    FLAT = "a flat profile has no height to scale"
    ON_AXIS = "a profile on the axis has no diameter to scale"
    GAPS = "the profile has gaps; join its segments first"
    LAWS = "laws vary the profile with the angle; remove them first"
    ONLY_KEY = "the only key cannot be removed; a keyframe curve has at least one"
    RING_AND_OPEN = "one is a ring and the other is open"
    OTHER_AXIS = "they turn about different axes"
    NO_WALL = "no wall fits this profile, however thin"
    OTHER_LAWS = "one has other laws over the angle than the other"
    NOTHING_FREE = "nothing is free: locks, rules and laws hold all that could change"


class NoFit(Plain):
    """Why a profile cannot be fitted."""

    EXPONENT = "--exponent is for a superellipse only"
    OPEN_AND_CLOSED = "the polygon of a closed profile cannot be fitted to an open target"


class NoSize(Plain):
    """Why no size gives a measure the wanted value."""

    NO_RIM = "a body without a rim holds nothing; open the profile at its top"
    JUMPS = "the measure jumps there; no size gives this value"
    TOO_LARGE = "no size gives this value: it cannot be made so large"
    TOO_SMALL = "no size gives this value: it cannot be made so small"


# What there may be too many of, and how many of it a project holds.
_MOST = {
    "segments": "a profile has at most {} segments",
    "pictures": "a project holds at most {} pictures",
    "dimensions": "a project keeps at most {} dimensions",
    "guides": "a project keeps at most {} guides",
    "states": "there are {} states, the most that a file keeps",
}
_IN_SEGMENT = {"legs": "0, 1 and 2", "points": "0 to 3"}


@dataclass(frozen=True, slots=True)
class Deviation(Finding):
    """An edit was not exact: the curve moved, at most by ``largest`` in a unit."""

    largest: float
    unit: str


@dataclass(frozen=True, slots=True)
class TooLarge(Finding):
    """An edit is not done, as the curve would move by more than a ``most`` part of the size."""

    largest: float
    unit: str
    size: float
    most: float


@dataclass(frozen=True, slots=True)
class NoSuch(Finding):
    """There is no segment, joint, law, layer, ... with a number; there are ``count``."""

    what: Literal["segment", "joint", "law", "dimension", "guide", "layer", "texture", "pattern"]
    number: int
    count: int


@dataclass(frozen=True, slots=True)
class NoSuchKey(Finding):
    """A law has no key with a number; it has ``count``."""

    number: int
    count: int


@dataclass(frozen=True, slots=True)
class NoPlace(Finding):
    """No segment can get a number by being inserted; there are ``count`` segments."""

    number: int
    count: int


@dataclass(frozen=True, slots=True)
class NotOfSegment(Finding):
    """No segment has a leg or control point with a number; they count from 0 for all readers."""

    what: Literal["legs", "points"]
    number: int


@dataclass(frozen=True, slots=True)
class TwoRadii(Finding):
    """A circle is to have a half height other than its half width."""

    a: float
    b: float


@dataclass(frozen=True, slots=True)
class BackwardRun(Finding):
    """A run of segments whose last comes before its first."""

    first: int
    last: int


@dataclass(frozen=True, slots=True)
class LastSegment(Finding):
    """An open profile has no segment after its last to merge it with."""

    segment: int


@dataclass(frozen=True, slots=True)
class NotJoined(Finding):
    """Two segments do not meet and cannot be merged."""

    first: int
    second: int


@dataclass(frozen=True, slots=True)
class NoChord(Finding):
    """The ends of a segment coincide, so that it cannot be mirrored on its chord."""

    segment: int


@dataclass(frozen=True, slots=True)
class PulledApart(Finding):
    """A joint that is to hold would come apart."""

    joint: int
    following: int


@dataclass(frozen=True, slots=True)
class TooMany(Finding):
    """There would be more of something than the ``most`` that a project holds."""

    what: Literal["segments", "pictures", "states", "dimensions", "guides"]
    most: int


@dataclass(frozen=True, slots=True)
class TooManyToFit(Finding):
    """The control points of ``count`` segments cannot be fitted, only those of ``most``."""

    count: int
    most: int


@dataclass(frozen=True, slots=True)
class TooManyWaves(Finding):
    """A law has more waves than can be drawn with the ``most`` keys of a curve."""

    waves: int
    most: int


@dataclass(frozen=True, slots=True)
class WrongPanelCount(Finding):
    """A figure plate has no panel or more than the ``most``."""

    count: int
    most: int


@dataclass(frozen=True, slots=True)
class OtherLength(Finding):
    """Two profiles have different numbers of segments."""

    one: int
    other: int


@dataclass(frozen=True, slots=True)
class NoState(Finding):
    """There is no saved state of a name."""

    name: str


@dataclass(frozen=True, slots=True)
class StateTaken(Finding):
    """Another saved state has a name already."""

    name: str


@dataclass(frozen=True, slots=True)
class StateNameLength(Finding):
    """The name of a state is empty or longer than ``most`` characters."""

    most: int


@say.register
def _(finding: Deviation, reader: Reader = FILE) -> str:
    return f"largest deviation: {finding.largest:.6g} {finding.unit}"


@say.register
def _(finding: TooLarge, reader: Reader = FILE) -> str:
    return (
        f"this would move the curve by {finding.largest:.6g} {finding.unit}, "
        f"{finding.largest / finding.size:.3%} of the size; allowed is {finding.most:.0%}"
    )


_OWNERS = {"law": "document", "layer": "drawing", "texture": "look"}


@say.register
def _(finding: NoSuch, reader: Reader = FILE) -> str:
    none = f"there is no {finding.what} {reader.number(finding.number)}"
    if finding.count == 0:
        owner = _OWNERS.get(finding.what, "profile")
        return f"{none}; the {owner} has no {finding.what}s"
    return f"{none}; allowed is {_range(reader, finding.count)}"


@say.register
def _(finding: NoSuchKey, reader: Reader = FILE) -> str:
    return f"there is no key {reader.number(finding.number)}; the law has {finding.count}"


@say.register
def _(finding: NoPlace, reader: Reader = FILE) -> str:
    number, allowed = reader.number(finding.number), _range(reader, finding.count + 1)
    return f"a segment cannot be inserted at {number}; allowed is {allowed}"


@say.register
def _(finding: NotOfSegment, reader: Reader = FILE) -> str:
    return f"a segment has the {finding.what} {_IN_SEGMENT[finding.what]}, not {finding.number!r}"


@say.register
def _(finding: TwoRadii, reader: Reader = FILE) -> str:
    return f"a circle has one radius; a is {finding.a!r} and b is {finding.b!r}"


@say.register
def _(finding: BackwardRun, reader: Reader = FILE) -> str:
    first, last = reader.number(finding.first), reader.number(finding.last)
    return f"a run goes from a segment to a later one, not from {first} to {last}"


@say.register
def _(finding: LastSegment, reader: Reader = FILE) -> str:
    return f"{reader.segment(finding.segment)} is the last; there is none after it to merge with"


@say.register
def _(finding: NotJoined, reader: Reader = FILE) -> str:
    first, second = reader.number(finding.first), reader.number(finding.second)
    return f"segments {first} and {second} do not meet; close the gap first"


@say.register
def _(finding: NoChord, reader: Reader = FILE) -> str:
    segment = reader.segment(finding.segment)
    return f"the ends of {segment} coincide; there is no chord to mirror on"


@say.register
def _(finding: PulledApart, reader: Reader = FILE) -> str:
    joint = reader.joint(finding.joint, finding.following)
    return f"this would pull {joint} apart; its rule must be free for that"


@say.register
def _(finding: TooMany, reader: Reader = FILE) -> str:
    return _MOST[finding.what].format(finding.most)


@say.register
def _(finding: TooManyToFit, reader: Reader = FILE) -> str:
    return (
        f"control points can be fitted for at most {finding.most} segments, not {finding.count}; "
        "fit ω or the shape parameters alone"
    )


@say.register
def _(finding: TooManyWaves, reader: Reader = FILE) -> str:
    return f"{finding.waves} waves are too many for at most {finding.most} keys"


@say.register
def _(finding: WrongPanelCount, reader: Reader = FILE) -> str:
    return f"the plate has {finding.count} panels; allowed is 1 to {finding.most}"


@say.register
def _(finding: OtherLength, reader: Reader = FILE) -> str:
    return f"one has {finding.one} segments and the other {finding.other}"


@say.register
def _(finding: NoState, reader: Reader = FILE) -> str:
    return f"there is no state {finding.name!r}"


@say.register
def _(finding: StateTaken, reader: Reader = FILE) -> str:
    return f"there is a state {finding.name!r} already"


@say.register
def _(finding: StateNameLength, reader: Reader = FILE) -> str:
    return f"a state's name has 1 to {finding.most} characters"


def _range(reader: Reader, count: int) -> str:
    return f"{reader.number(0)} to {reader.number(count - 1)}"
