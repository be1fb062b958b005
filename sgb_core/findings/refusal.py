"""Values that cannot be: where they were given, and what is allowed there."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import isfinite
from typing import Protocol, TypeVar

import numpy as np

from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding, Path
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass

F = TypeVar("F", bound="FieldFinding")


class Allowed(Protocol):
    """What a value may be, in words."""

    @property
    def words(self) -> str:
        """As a file's reader is told: "a number from 0 to 4"."""

    @property
    def brief(self) -> str:
        """As whoever calls a function is told: "0 to 4"."""


class _Missing:
    """Stands for a value that was not given."""


MISSING = _Missing()


class FieldFinding(Finding):
    """Base of what is wrong with a field; ``path`` begins at the value that has the field."""

    __slots__ = ()
    path: Path

    def unwritten(self) -> FieldFinding:
        """Return the finding for a field that the file leaves to its default."""
        return self


def moved(finding: F, place: Path, depth: int) -> F:
    """Return a finding for a value that stands at ``place``, instead of its first steps."""
    return replace(finding, path=(*place, *finding.path[depth:]))  # type: ignore[type-var]


class RefusalError(FindingError):
    """A value cannot be: the field, what was given, and what is allowed."""

    finding: FieldFinding


@dataclass(frozen=True, slots=True)
class Refusal(FieldFinding):
    """A field cannot have this value."""

    path: Path
    value: object
    allowed: Allowed

    def unwritten(self) -> Refusal:
        """Return that the value is missing."""
        return replace(self, value=MISSING)


@dataclass(frozen=True, slots=True)
class HalfCharacter(FieldFinding):
    """A text that no file can hold: it has one half of a surrogate pair."""

    path: Path


@dataclass(frozen=True, slots=True)
class Taken(FieldFinding):
    """A name that an earlier item of the list has."""

    path: Path
    owner: str


@dataclass(frozen=True, slots=True)
class SameAngle(FieldFinding):
    """Two keys of a curve at one angle, in degrees."""

    path: Path
    degrees: float


@dataclass(frozen=True, slots=True)
class Apart(FieldFinding):
    """Two segments whose ends a rule holds together are ``gap`` apart.

    ``default`` tells that the rule is not given but the usual one.
    """

    path: Path
    rule: str
    segments: tuple[int, int]
    gap: float
    default: bool = False

    def unwritten(self) -> Apart:
        """Return that the rule is the usual one."""
        return replace(self, default=True)


@dataclass(frozen=True, slots=True)
class OpenRing(FieldFinding):
    """A closed profile whose last point is ``gap`` from its first."""

    path: Path
    gap: float


@dataclass(frozen=True, slots=True)
class Argument(Finding):
    """A function cannot take this value for one of its arguments."""

    name: str
    value: object
    allowed: Allowed


@dataclass(frozen=True, slots=True)
class Unknown(Finding):
    """There is nothing of a kind, such as a "unit", that is called so."""

    what: str
    name: object
    allowed: Allowed


@say.register
def _refusal(finding: Refusal, reader: Reader = FILE) -> str:
    place = reader.place(finding.path)
    what = "missing" if finding.value is MISSING else shown(finding.value)
    return f"{place} is {what}; allowed is {finding.allowed.words}"


@say.register
def _half(finding: HalfCharacter, reader: Reader = FILE) -> str:
    return f"{reader.place(finding.path)} holds half a character (a lone surrogate)"


@say.register
def _taken(finding: Taken, reader: Reader = FILE) -> str:
    place = reader.place(finding.path)
    return f"{place} is that of an earlier {finding.owner}; allowed is a name of its own"


@say.register
def _same_angle(finding: SameAngle, reader: Reader = FILE) -> str:
    place = reader.place(finding.path)
    return f"{place} has two keys at {finding.degrees:g} degrees; allowed is one for each angle"


@say.register
def _apart(finding: Apart, reader: Reader = FILE) -> str:
    first, second = (reader.number(index) for index in finding.segments)
    default = " (the default)" if finding.default else ""
    return (
        f'{reader.place(finding.path)} is "{finding.rule}"{default}, but segments {first} and '
        f'{second} are {finding.gap:.6g} apart; allowed is "free", or ends that meet'
    )


@say.register
def _open_ring(finding: OpenRing, reader: Reader = FILE) -> str:
    return (
        f"{reader.place(finding.path)} is true, but the last point is {finding.gap:.6g} from the "
        "first; allowed is true only where they meet"
    )


@say.register
def _argument(finding: Argument, reader: Reader = FILE) -> str:
    value = finding.value
    plain = isinstance(value, (int, float)) and not isinstance(value, bool) and isfinite(value)
    name = reader.names.get(finding.name, finding.name)
    return f"{name} is {f'{value:g}' if plain else repr(value)}; allowed is {finding.allowed.brief}"


@say.register
def _unknown(finding: Unknown, reader: Reader = FILE) -> str:
    return f"there is no {finding.what} {finding.name!r}; allowed is {finding.allowed.brief}"


def shown(value: object) -> str:
    """Return a value as one short line of JSON, fit for a message."""
    if isinstance(value, np.ndarray) and value.ndim:
        return f"an array of shape {value.shape}"
    if isinstance(value, np.generic | np.ndarray):
        value = value.item()
    if isinstance(value, Mapping):
        return "an object"
    if isinstance(value, Sequence) and not isinstance(value, str | bytes):
        return f"a list of {len(value)}"
    if isinstance(value, float) and not isfinite(value):
        return "too large" if abs(value) == float("inf") else "NaN"
    try:
        text = json.dumps(value)
    except (TypeError, ValueError):
        text = " ".join(repr(value).split())
    return text if len(text) <= 40 else f"{text[:37]}..."
