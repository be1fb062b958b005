"""One end of the turn in the hand, and the angle that may be typed for it."""

from __future__ import annotations

from dataclasses import replace

from app.hand.coordinates import ScreenPoint
from app.hand.turn import LEAST_DEG, TurnAngles, TurnEnd
from app.hand.typed import Typed, TypedField
from app.widgets.number_kind import NumberKind
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class TurnDrag:
    """A drag of one end of the turn: the angle under the hand, its turns counted."""

    end: TurnEnd
    press: ScreenPoint
    before: TurnAngles
    grabbed: float
    angle: float
    moved: bool = False
    typed: Typed | None = None

    @property
    def numbers(self) -> Typed:
        """The angle that can be typed."""
        if self.typed is not None:
            return self.typed
        low, high = (LEAST_DEG, 360.0) if self.end is TurnEnd.END else (-360.0, 360.0)
        return Typed.of((TypedField(self.end.label, NumberKind(low, high, "deg")),))

    def typed_angles(self) -> TurnAngles | None:
        """Return the turn with the angle that is typed, None while there is none."""
        value = next(iter(self.numbers.values.values()), None)
        if value is None:
            return None
        if self.end is TurnEnd.END:
            return replace(self.before, sweep=value)
        return replace(self.before, start=value)
