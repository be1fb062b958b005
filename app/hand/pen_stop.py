"""The pen stops at the axis: what it places, and the handles that it draws out."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.hand.coordinates import DesignPoint
from app.hand.snapping import Landing
from app.state import preferences
from sgb_core.curves.profile import Profile
from sgb_core.design.pen import Anchor, PenPath


def side_of(profile: Profile | None, path: PenPath) -> float:
    """Return on which side of the axis the pen draws, 1 or −1; 0 where it may draw on both.

    That is where the run and the profile that it goes on from lie, unless these already cross the
    axis or the preferences let points through it. Before there is any, both are free.
    """
    if preferences.current().cross_axis:
        return 0.0
    r = np.array([anchor.place[0] for anchor in path.anchors])
    if profile is not None:
        r = np.concatenate([r, profile.control_points[..., 0].ravel()])
    if len(r) == 0 or r.min() < 0.0 < r.max():
        return 0.0
    return float(np.sign(r.sum()))


def stopped(landing: Landing, start: DesignPoint | None, side: float) -> Landing:
    """Return a landing that goes no farther than the axis, along its guide where it has one."""
    r, h = landing.point.pair
    if side * r >= 0.0:
        return landing
    if landing.guide is not None and start is not None and landing.guide[0] != 0.0:
        h = start.h - start.r * landing.guide[1] / landing.guide[0]
    aligned = (None, landing.aligned[1])
    return replace(landing, point=DesignPoint(0.0, h), on_axis=True, aligned=aligned)


def leg_stopped(
    anchor: Anchor, tip: DesignPoint, side: float, *, leaves: bool, arrives: bool
) -> DesignPoint:
    """Return where a handle that is drawn out ends, as short as the axis makes it.

    ``leaves`` says that the tip is the handle of what comes next, ``arrives`` that its mirror image
    is that of the last segment.
    """
    (r, h), along = anchor.place, tip.r - anchor.place[0]
    share = 1.0
    for counts, step in ((leaves, along), (arrives, -along)):
        if counts and side * (r + step) < 0.0:
            share = min(share, -r / step)
    return DesignPoint(r + share * along, h + share * (tip.h - h))
