"""Why targets cannot be reached."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoTarget(Plain):
    """What a profile or body cannot be asked for."""

    NO_BODY = "a bare surface has no capacity and no material; make it a vessel first"
    NO_CAPACITY = "only a vessel with a rim has a capacity"
    NO_LINE = "without a fill line nothing is held to it; set one first"
    NO_ENDS = "a ring has no rim and no foot"
    FLAT = "a measure that is 0 or has no size cannot be a target here"


@dataclass(frozen=True, slots=True)
class Nearest(Finding):
    """A target that is out of reach, and the nearest value that all targets together allow.

    People read ``scale`` times the values, with a ``unit`` behind. One that is not ``final`` is
    the nearest of a search that was ended before its end.
    """

    target: str
    wanted: float
    nearest: float
    scale: float = 1.0
    unit: str = ""
    final: bool = True


@dataclass(frozen=True, slots=True)
class Unreachable(Finding):
    """Targets that nothing allowed reaches, and the shape parameters and points at their limits.

    ``limits`` holds (segment, what) pairs; ``held`` names what is kept or locked and in the way.
    """

    targets: tuple[Nearest, ...]
    limits: tuple[tuple[int, str], ...]
    held: tuple[str, ...] = ()


@say.register
def _(finding: Nearest, reader: Reader = FILE) -> str:
    name = finding.target.replace("_", " ")
    wanted, nearest = finding.scale * finding.wanted, finding.scale * finding.nearest
    # As many digits as tell the two apart.
    digits = next((d for d in range(6, 17) if f"{wanted:.{d}g}" != f"{nearest:.{d}g}"), 17)
    told, near = f"{wanted:.{digits}g}{finding.unit}", f"{nearest:.{digits}g}{finding.unit}"
    if not finding.final:
        return f"{name} {told} is not reached so far, the nearest is {near}"
    return f"{name} {told} is out of reach, the nearest is {near}"


@say.register
def _(finding: Unreachable, reader: Reader = FILE) -> str:
    words = "; ".join(say(target, reader) for target in finding.targets)
    if finding.held:
        words += f"; in the way: {', '.join(finding.held).replace('_', ' ')}"
    elif not finding.limits and all(target.final for target in finding.targets):
        return f"{words}; nothing else is free to move"
    if not finding.limits:
        return words
    named = [f"{what} of {reader.segment(segment)}" for segment, what in finding.limits[:4]]
    more = ", …" if len(finding.limits) > 4 else ""
    return f"{words}; at its limit: {', '.join(named)}{more}"
