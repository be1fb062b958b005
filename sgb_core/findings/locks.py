"""Which locks are in the way of an edit, and which do not hold."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoDimension(Plain):
    """What cannot be dimensioned."""

    NOTHING = "this object has no such dimension"
    ON_AXIS = "the profile closes on the axis there, without a rim or a foot to measure"
    NO_VALUE = "a point and a joint's rule have no value to set"
    SMOOTH = "only a smooth joint, with a rule of G1, C1 or G2 that it keeps, can be locked"


@dataclass(frozen=True, slots=True)
class Locked(Finding):
    """A lock: what it is called, the value that it holds and its unit, if it is a number.

    ``points`` are the (segment, point) that it names, ``joint`` (its number and the segment after
    it) and ``rule`` what it keeps.
    """

    label: str
    value: float | None
    unit: str
    points: tuple[tuple[int, int], ...] = ()
    joint: tuple[int, int] | None = None
    rule: str | None = None


@dataclass(frozen=True, slots=True)
class LocksInTheWay(Finding):
    """Locks that an edit cannot get past, by their numbers and by what they hold.

    ``stopped`` says that the edit went as far as they let it; else it is not done at all.
    """

    numbers: tuple[int, ...]
    locks: tuple[Locked, ...]
    stopped: bool


@dataclass(frozen=True, slots=True)
class Shared(Finding):
    """What all variants of an object keep: its locks, and rules with how many joints keep each."""

    locks: tuple[Locked, ...]
    rules: tuple[tuple[str, int], ...]


@dataclass(frozen=True, slots=True)
class LockMissed(Finding):
    """A lock whose value the object does not have."""

    number: int
    lock: Locked
    found: float | None


@say.register
def _(finding: Locked, reader: Reader = FILE) -> str:
    label = finding.label
    if finding.points:
        names = " and ".join(f"P{i} of {reader.segment(k)}" for k, i in finding.points)
        label = names if len(finding.points) == 1 else f"{label} ({names})"
    if finding.joint is not None:
        label = f"{finding.rule} of {reader.joint(*finding.joint)}"
    return label if finding.value is None else f"{label} {finding.value:.6g}{finding.unit}"


@say.register
def _(finding: LocksInTheWay, reader: Reader = FILE) -> str:
    names = " and ".join(say(lock, reader) for lock in finding.locks)
    many = len(finding.locks) > 1
    if not finding.locks:
        return "the joints' rules and locks exclude this"
    if finding.stopped:
        return f"stopped by {'locks' if many else 'a lock'}: {names}"
    return f"{names} {'are' if many else 'is'} locked and cannot hold with this"


@say.register
def _(finding: Shared, reader: Reader = FILE) -> str:
    parts = [say(lock, reader) for lock in finding.locks]
    parts += [f"{rule} at {n} joint{'s' if n > 1 else ''}" for rule, n in finding.rules]
    if not parts:
        return "no lock and no joint's rule is to be kept"
    return f"all keep {', '.join(parts)}"


@say.register
def _(finding: LockMissed, reader: Reader = FILE) -> str:
    place = reader.place(("dimensions", finding.number))
    found = "is not there" if finding.found is None else f"is {finding.found:.9g}"
    return f"{place}: {say(finding.lock, reader)} is locked but {found}"
