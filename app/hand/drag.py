"""The profile editor's gestures: their states, and where the hand's movement leads.

Everything is computed from how things were when the gesture began, so nothing adds up.
"""

from __future__ import annotations

from enum import Enum, auto

import numpy as np

from app.hand.coordinates import DesignPoint, ScreenPoint
from app.hand.hit_test import Handle, PointId, Target
from app.hand.typed import Typed
from sgb_core.curves.basis import LEGS
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.values import dataclass

START_DISTANCE = 3.0
NOWHERE = ScreenPoint(0.0, 0.0)


class State(Enum):
    """What the hand is doing."""

    IDLE = auto()
    ARMED = auto()  # pressed, not yet moved: a click until it moves
    MOVING = auto()
    SLIDING = auto()
    BOXING = auto()
    PANNING = auto()
    NUDGING = auto()
    FILLING = auto()
    SCALING = auto()
    MEASURING = auto()
    SHAPING = auto()  # a feature of the body or its paint


@dataclass(frozen=True, slots=True)
class Gesture:
    """A state and how everything was when it began.

    ``offset`` is how far the hand was from what it grabbed, where that is kept; ``scales`` says
    whether a joint keeps its legs in proportion instead of carrying them; ``typed`` are the numbers
    that are being typed meanwhile.
    """

    state: State = State.IDLE
    press: ScreenPoint = NOWHERE
    handle: Handle | None = None
    profile: Profile | None = None
    points: tuple[PointId, ...] = ()
    offset: tuple[float, float] = (0.0, 0.0)
    scales: bool = False
    typed: Typed | None = None

    @property
    def edits(self) -> bool:
        """Whether the gesture changes the document, and so has to be committed or cancelled."""
        return self.steered or self.state in (
            State.NUDGING,
            State.FILLING,
            State.MEASURING,
            State.SHAPING,
        )

    @property
    def steered(self) -> bool:
        """Whether modifier keys change where the hand's movement leads."""
        return self.state in (State.MOVING, State.SLIDING, State.SCALING)

    @property
    def start(self) -> DesignPoint | None:
        """Where the point in the hand was when the gesture began."""
        if self.profile is None or self.handle is None:
            return None
        if self.handle.target in (Target.GRIP, Target.DIMENSION, Target.FEATURE):
            return None
        segment = self.profile.segments[self.handle.segment]
        return DesignPoint.of(segment.points[self.handle.index])


IDLE = Gesture()


def leg_ends(segment: Segment, which: int) -> tuple[DesignPoint, DesignPoint]:
    """Return where Q1, Q2 or Q3 (``which`` 0, 1, 2) lies at leg fraction 0 and at 1."""
    near, far = LEGS[which]
    return DesignPoint.of(segment.points[near]), DesignPoint.of(segment.points[far])


def slide_fraction(segment: Segment, which: int, cursor: DesignPoint) -> float:
    """Return the leg fraction whose point is nearest to the cursor, in [0, 1]."""
    near, far = leg_ends(segment, which)
    leg = np.array((far.r - near.r, far.h - near.h))
    squared = float(leg @ leg)
    if squared == 0.0:
        return float(segment.shape.leg_fractions[which])
    reached = float(leg @ (cursor.r - near.r, cursor.h - near.h)) / squared
    return min(1.0, max(0.0, reached))
