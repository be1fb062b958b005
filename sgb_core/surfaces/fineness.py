"""How finely a mesh is asked for: a tolerance, or numbers of intervals; checked in one place."""

from __future__ import annotations

from math import isfinite

from sgb_core.fields.kinds import Said
from sgb_core.findings.errors import FindingError
from sgb_core.findings.refusal import Argument
from sgb_core.findings.surfaces import NoFineness
from sgb_core.values import dataclass

# Part of the size within which a mesh follows the surface where nothing else is asked.
DEFAULT_TOLERANCE = 1e-3
_TOLERANCE = Said("a finite number above 0")
_SAMPLES = Said("1 or more")


@dataclass(frozen=True, slots=True)
class Fineness:
    """A tolerance, or ``samples`` (intervals per segment and around), or neither of them.

    Raises FindingError, a ValueError, for both at once, a tolerance that is not finite and above
    0, or samples below 1.
    """

    tolerance: float | None = None
    samples: tuple[int, int] | None = None

    def __post_init__(self) -> None:
        if self.tolerance is not None:
            if self.samples is not None:
                raise FindingError(NoFineness.BOTH)
            check_tolerance(self.tolerance)
        for count in self.samples or ():
            if count < 1:
                raise FindingError(Argument("the number of samples", count, _SAMPLES))

    def within(self, size: float) -> float:
        """Return the tolerance for a profile of a size: where none is given, 1e-3 of the size."""
        return DEFAULT_TOLERANCE * size if self.tolerance is None else self.tolerance


def check_tolerance(tolerance: float) -> None:
    """Raise FindingError, a ValueError, unless a tolerance is finite and above 0."""
    if not (isfinite(tolerance) and tolerance > 0.0):
        raise FindingError(Argument("the tolerance", tolerance, _TOLERANCE))
