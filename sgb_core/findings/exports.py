"""Why a document cannot be exported in the asked way."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain, PlainOfField
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoExport(Plain):
    """Why there is nothing to write."""

    NO_AREA = "the surface has no area: there is nothing to export"
    POINT = "the profile is a single point: there is nothing to export"


class NoStep(PlainOfField):
    """Why STEP, which holds exact surfaces, cannot hold a body."""

    TOUCHES = ("solid",), "its section touches itself along a circle; STEP needs one that does not"
    NO_FIT = ("solid", "wall"), "no smooth curve follows this wall; choose a mesh, such as 3MF"
    RELIEF = ("appearance",), "STEP holds smooth walls without relief; choose a mesh, such as 3MF"
    BENT_HOLES = (
        ("cut_outs",),
        "STEP holds straight holes alone, neither text nor pictures nor what a twist bends; choose "
        "a mesh, such as 3MF",
    )
    TWIST = (
        ("twist",),
        "the body reaches beyond the heights between which this part of a turn is twisted; choose "
        "a mesh, such as 3MF",
    )
    NO_PATCHES = (
        ("variation",),
        "no smooth patches of a fair number follow what it makes; choose a mesh, such as 3MF",
    )
    CROSSES_AXIS = ("profile",), "it crosses the axis; STEP needs one side of it"
    CROSSES_ITSELF = ("profile",), "it crosses itself; STEP needs a simple one"
    GAPS = ("profile",), "its segments do not meet; STEP needs one chain"


class KernelFailure(Plain):
    """What the CAD kernel lacks or could not do."""

    MISSING = "STEP needs an optional package: pip install 'sgb-studio[cad]'"
    SHAPE = "the CAD kernel could not build this shape; choose a mesh, such as 3MF, instead"
    FILE = "the CAD kernel could not write the STEP file"


@dataclass(frozen=True, slots=True)
class NoFormat(Finding):
    """A file whose suffix, which may be empty, is none of the ``allowed``."""

    file: str
    suffix: str
    allowed: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class SinglePrecision(Finding):
    """Coordinates as large as ``farthest`` that a format of single precision cannot hold.

    They are rounded by ``rounding``, more than the ``allowed``; None where they do not fit at all.
    """

    farthest: float
    rounding: float | None
    allowed: float | None


@say.register
def _(finding: NoFormat, reader: Reader = FILE) -> str:
    has = f"has the suffix {finding.suffix!r}" if finding.suffix else "has no suffix"
    allowed = " ".join(finding.allowed)
    return f"{finding.file!r} {has}, which names no format; allowed are {allowed}"


@say.register
def _(finding: SinglePrecision, reader: Reader = FILE) -> str:
    start = f"STL holds single precision: at {finding.farthest:.4g} from the origin it"
    if finding.rounding is None or finding.allowed is None:
        return f"{start} has no number; make the object smaller or move it nearer"
    return (
        f"{start} rounds by {finding.rounding:.3g}, more than the tolerance of "
        f"{finding.allowed:.3g}; move it nearer, or choose OBJ, 3MF or GLB"
    )
