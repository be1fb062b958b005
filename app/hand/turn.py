"""The two ends of the turn about the axis, and how a hand on one of them changes it."""

from __future__ import annotations

from enum import Enum, auto
from math import degrees, radians

from sgb_core.values import dataclass

# The handles stand so far inside the turn's ends: those of a full turn do not lie on each other.
INSIDE = radians(5.0)
SNAP_DEG = 15.0
LEAST_DEG = 1.0


class TurnEnd(Enum):
    """An end of the turn about the axis."""

    START = auto()
    END = auto()

    @property
    def label(self) -> str:
        """What the end changes, the undo entry's name."""
        return "Sweep" if self is TurnEnd.END else "Start angle"


def handle_angles(start: float, sweep: float) -> tuple[float, float]:
    """Return where the handles of a turn's two ends stand, in radians as the turn is."""
    inside = min(INSIDE, sweep / 4.0)
    return start + inside, start + sweep - inside


@dataclass(frozen=True, slots=True)
class TurnAngles:
    """The turn about the axis in degrees, and how a hand on one of its ends changes it."""

    start: float
    sweep: float

    def dragged(self, end: TurnEnd, moved: float, *, snap: bool, hold: bool = False) -> TurnAngles:
        """Return the turn after one end moved by ``moved`` radians about the axis.

        The end changes the sweep, from 1° to 360°; the start turns the whole, or with ``hold``
        leaves the end where it is. ``snap`` rounds what changes to 15°.
        """
        step = degrees(moved)
        if end is TurnEnd.END:
            return TurnAngles(self.start, _sweep(self.sweep + step, snap))
        start = self.start + step
        if snap:
            start = SNAP_DEG * round(start / SNAP_DEG)
        sweep = _sweep(self.sweep - (start - self.start), False) if hold else self.sweep
        if hold:
            start = self.start + self.sweep - sweep
        return TurnAngles(_wrapped(start), sweep)


def _sweep(wanted: float, snap: bool) -> float:
    if snap:
        wanted = max(SNAP_DEG, SNAP_DEG * round(wanted / SNAP_DEG))
    return min(360.0, max(LEAST_DEG, wanted))


def _wrapped(angle: float) -> float:
    """Return an angle as the panel writes it: above −180° and at most 180°."""
    turned = (angle + 180.0) % 360.0 - 180.0
    return 180.0 if turned == -180.0 else turned
