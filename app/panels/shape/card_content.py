"""What the card of a segment is told, as a value that says whether it has to show anything new."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sgb_core.curves.continuity import JointReport
from sgb_core.curves.segment import Segment
from sgb_core.findings.joints import Hindrance
from sgb_core.surfaces.variation import Law


@dataclass(frozen=True, slots=True)
class CardContent:
    """What a card shows; ``joint`` leads to segment ``following``, both None at an open end.

    ``unmet`` is why the joint's rule does not hold, None where it does; ``earlier_yields`` that
    this segment moves for it, not the next.
    """

    index: int
    name: str
    segment: Segment
    laws: Sequence[Law]
    joint: JointReport | None
    following: int | None
    unmet: Hindrance | None = None
    earlier_yields: bool = False
