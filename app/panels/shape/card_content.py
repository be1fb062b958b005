"""What the card of a segment is told, as a value that says whether it has to show anything new."""

from __future__ import annotations

from collections.abc import Sequence

from sgb_core.curves.continuity import JointReport
from sgb_core.curves.segment import Segment
from sgb_core.findings.joints import Hindrance
from sgb_core.surfaces.variation import Law
from sgb_core.values import dataclass


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

    def has_values_of(self, other: CardContent) -> bool:
        """Whether the sliders show what they showed of the other."""
        same = self.segment is other.segment and self.laws is other.laws
        return same and (self.index, self.name) == (other.index, other.name)

    def has_joint_of(self, other: CardContent) -> bool:
        """Whether the joint shows what it showed of the other."""
        kept = (self.joint, self.following, self.unmet, self.earlier_yields)
        return kept == (other.joint, other.following, other.unmet, other.earlier_yields)

    def follows(self, other: CardContent | None) -> bool:
        """Whether the segment and the joint after it are the very ones of the other."""
        return other is not None and self.joint is other.joint and self.has_values_of(other)
