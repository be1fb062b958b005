"""What a shape parameter slides, and the curves over its whole range, which views show as a fan."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import PARAMETER_RANGES, READY, ParameterName, Segment

# Of each parameter: the quartic points Q1..Q3 (0..2) that it slides, each along the leg of the
# same number, and the control points (1: P1, 2: P2) that they near on one side of the range.
SLID: Mapping[ParameterName, tuple[int, ...]] = MappingProxyType(
    {"lambda1": (0,), "lambda2": (1,), "lambda3": (2,), "omega": (0, 1, 2)}
)
TOWARDS: Mapping[ParameterName, tuple[int, ...]] = MappingProxyType(
    {"lambda1": (1,), "lambda2": (1,), "lambda3": (2,), "omega": (1, 2)}
)
STEPS = 9
# Where the reach of a parameter is looked for.
_PLACES = np.linspace(0.0, 1.0, 33)


def parameter_fan(
    segments: Sequence[Segment], parameter: ParameterName, count: int = STEPS
) -> Floats:
    """Return quartic points at ``count`` equal steps of a parameter over its whole range.

    Shape (len(segments), count, 5, 2): the other parameters stay as they are, but where ω is 0 a
    λ is shown as it will show, with ω = 1 and the other λ neutral. A curve is affine in each of
    its parameters, so those of the two ends of the range give all between.
    """
    ends = np.empty((len(segments), 2, 5, 2))
    for number, segment in enumerate(segments):
        for end, value in enumerate(PARAMETER_RANGES[parameter]):
            idle = segment.shape.omega == 0.0 and parameter != "omega"
            shape = replace(READY if idle else segment.shape, **{parameter: value})
            ends[number, end] = segment.with_shape(shape).quartic
    share = np.linspace(0.0, 1.0, count)[:, None, None]
    return np.asarray((1.0 - share) * ends[:, :1] + share * ends[:, 1:])


def reach(segment: Segment, parameter: ParameterName) -> float:
    """Return how far a parameter over its whole range moves a segment across itself at most.

    Looked for at equal steps of s; what runs along the curve is not seen and does not count.
    """
    (fan,) = parameter_fan([segment], parameter, 2)
    spread = basis.bernstein(4, _PLACES) @ (fan[1] - fan[0])
    along = segment.derivative(_PLACES)
    speed = np.hypot(along[:, 0], along[:, 1])
    across = np.abs(along[:, 0] * spread[:, 1] - along[:, 1] * spread[:, 0])
    # Where the curve halts it has no direction, and all of the way is seen.
    whole = np.hypot(spread[:, 0], spread[:, 1])
    return float(np.divide(across, speed, out=whole, where=speed > 0.0).max())


def most_telling(profile: Profile, parameter: ParameterName = "lambda2") -> int:
    """Return the segment on which most of a parameter is seen."""
    return max(range(len(profile)), key=lambda k: reach(profile.segments[k], parameter))
