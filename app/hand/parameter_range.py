"""The whole range of one shape parameter as curves: what both views show as a fan."""

from __future__ import annotations

import numpy as np

from app.state.view_state import Hover
from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import PARAMETER_RANGES, ParameterName

SLIDERS: tuple[ParameterName, ...] = ("lambda1", "lambda2", "lambda3")
# Of each parameter: the quartic points Q1..Q3 (0..2) that it slides, each along the leg of the
# same number, and the circles (1: P1's, 2: P2's) that they near on one side of the range.
MOVED: dict[ParameterName, tuple[int, ...]] = {
    "lambda1": (0,),
    "lambda2": (1,),
    "lambda3": (2,),
    "omega": (0, 1, 2),
}
TOWARDS: dict[ParameterName, tuple[int, ...]] = {
    "lambda1": (1,),
    "lambda2": (1,),
    "lambda3": (2,),
    "omega": (1, 2),
}
FAN = 9


def chosen_segments(profile: Profile, hover: Hover) -> list[int]:
    """Return the segments that a slider acts on: one, or all."""
    count = len(profile)
    if hover.segment is None:
        return list(range(count))
    return [hover.segment] if 0 <= hover.segment < count else []


def fan(profile: Profile, hover: Hover, count: int = FAN) -> Floats:
    """Return quartic points at ``count`` equal steps of a parameter over its whole range.

    Shape (chosen segments, count, 5, 2): the other parameters stay as they are.
    """
    segments = [profile.segments[k] for k in chosen_segments(profile, hover)]
    if not segments:
        return np.zeros((0, count, 5, 2))
    low, high = PARAMETER_RANGES[hover.parameter]
    values = {
        name: np.array([[getattr(s.shape, name)] for s in segments]) for name in PARAMETER_RANGES
    }
    values[hover.parameter] = np.linspace(low, high, count)[None, :]
    fractions = basis.leg_fractions(**values)
    points = np.stack([s.points for s in segments])[:, None]
    quartics = basis.quartic_points(points, fractions)
    return np.broadcast_to(quartics, (len(segments), count, 5, 2))
