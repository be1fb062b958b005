"""What the hand can grab or holds, as the scene shows it."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True, eq=False)
class Grips:
    """What the hand can grab or holds, as points of space; empty arrays where there is nothing.

    ``held`` (m, 3) is under the pointer, ``chosen`` (m, 3) the selected points, ``ends`` (m, 3)
    the handles of the turn's start and end and of the axis, ``lines`` what is shown while one
    of these is held. ``segment`` is the one that is pointed at.
    """

    held: Floats
    chosen: Floats
    ends: Floats
    lines: tuple[Floats, ...] = ()
    segment: int | None = None

    def same(self, other: Grips) -> bool:
        """Whether both look the same."""
        mine = (self.held, self.chosen, self.ends, *self.lines)
        theirs = (other.held, other.chosen, other.ends, *other.lines)
        shapes = len(mine) == len(theirs) and all(map(np.array_equal, mine, theirs))
        return shapes and self.segment == other.segment
