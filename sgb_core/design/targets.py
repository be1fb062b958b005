"""Solve for a number: which size makes a measure have a wanted value."""

from __future__ import annotations

from collections.abc import Callable

from sgb_core.fields.kinds import Range
from sgb_core.findings.edits import NoSize
from sgb_core.findings.errors import FindingError
from sgb_core.findings.refusal import Argument

# Relative to the wanted value; measures are exact to less.
EXACT = 1e-9
# How far from the present size a solution is looked for, as a factor either way.
REACH = 1e4


class TargetError(FindingError):
    """No size gives the wanted value, with the finding why."""


def solve_factor(measure: Callable[[float], float], wanted: float) -> float:
    """Return the factor x > 0 with ``measure(x)`` equal to ``wanted`` to 1e-9 of it.

    ``measure`` is continuous; the factors nearest to 1 are looked at first, in steps that double.
    Then Brent's method. A measure that raises ValueError has no value there, which bounds the
    search. Raises TargetError where no bracket is found between 1/10 000 and 10 000.
    """
    if not wanted > 0.0:
        raise TargetError(Argument("the wanted value", wanted, Range(above=0.0)))
    here = measure(1.0)
    if abs(here - wanted) <= EXACT * wanted:
        return 1.0
    low, high = _bracket(measure, wanted, here)

    def miss(factor: float) -> float:
        return measure(factor) / wanted - 1.0

    # Imported late: it takes longer to load than all the rest of the core.
    from scipy.optimize import brentq

    found = float(brentq(miss, low, high, xtol=1e-15, rtol=8.9e-16, maxiter=200))
    if abs(miss(found)) > EXACT:
        raise TargetError(NoSize.JUMPS)
    return found


def _bracket(measure: Callable[[float], float], wanted: float, here: float) -> tuple[float, float]:
    """Return two neighbouring factors between which the wanted value lies."""
    grows = here < wanted
    edge, step = 1.0, 1.25
    while 1.0 / REACH < edge < REACH:
        after = edge * step if grows else edge / step
        try:
            value = measure(after)
        except ValueError:
            # Half the way, until the edge of what can be made is known well enough.
            step = step**0.5
            if step < 1.0 + 1e-12:
                break
            continue
        if (value >= wanted) == grows:
            return min(edge, after), max(edge, after)
        edge = after
        step = min(step * step, 2.0)
    raise TargetError(NoSize.TOO_LARGE if grows else NoSize.TOO_SMALL)
