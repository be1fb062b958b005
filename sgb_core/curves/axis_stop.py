"""Points that are moved stop at the axis instead of going through it."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.constraints import PointKey
from sgb_core.curves.profile import Profile


def stops(before: Profile, after: Profile) -> dict[PointKey, Floats]:
    """Return where those points belong that a move has carried through the axis.

    Ends and joints stop on the axis. A handle keeps its direction and becomes so short that it
    just touches the axis; where its end lies on the axis itself it is laid onto the axis. Points
    that lay beyond already are free, and all are where the curve itself lies on both sides.
    """
    old, new = before.control_points, np.array(after.control_points)
    side = 1.0 if old[..., 0].sum() >= 0.0 else -1.0
    crossed = (side * new[..., 0] < 0.0) & (side * old[..., 0] >= 0.0)
    if not crossed.any() or _on_both_sides(before):
        return {}
    found: dict[PointKey, Floats] = {}
    for segment, index in np.argwhere(crossed).tolist():
        if index in (0, 3):
            new[segment, index, 0] = 0.0
            found[segment, index] = new[segment, index]
    for segment, index in np.argwhere(crossed).tolist():
        if index in (1, 2):
            found[segment, index] = _shortened(new[segment, index], new[segment, 3 * (index - 1)])
    return found


def _on_both_sides(profile: Profile) -> bool:
    low, high = profile.bounds()
    return bool(low[0] < 0.0 < high[0])


def _shortened(handle: Floats, end: Floats) -> Floats:
    """Return a handle beyond the axis drawn back along its leg until it touches the axis."""
    if end[0] == 0.0 or (end[0] < 0.0) == (handle[0] < 0.0):
        return np.array((0.0, handle[1]))
    part = end[0] / (end[0] - handle[0])
    return np.array((0.0, end[1] + part * (handle[1] - end[1])))
