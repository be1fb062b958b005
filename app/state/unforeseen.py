"""What nobody foresaw, in one part: told and logged by the program's hook, and gone on from."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import ParamSpec

from sgb_core.findings.errors import FindingError

P = ParamSpec("P")
# What work that was asked for may end with; whoever asked is told why. All else is a mistake.
FORESEEN = (FindingError, OSError, MemoryError)


def tell(error: Exception) -> None:
    """Hand an exception to ``sys.excepthook``, as if nobody had caught it."""
    sys.excepthook(type(error), error, error.__traceback__)


def tell_unforeseen(error: Exception) -> None:
    """Tell of an exception that is a mistake of the program, not an answer to the user."""
    if not isinstance(error, FORESEEN):
        tell(error)


def guarded(call: Callable[P, object]) -> Callable[P, None]:
    """Return ``call`` so that what it raises is told, and stops nobody who comes after it."""

    def guarding(*args: P.args, **options: P.kwargs) -> None:
        try:
            call(*args, **options)
        except Exception as error:
            tell(error)

    return guarding
