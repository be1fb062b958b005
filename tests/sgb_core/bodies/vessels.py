"""Random and named vessels for the tests of solid bodies."""

from __future__ import annotations

from math import pi

import numpy as np
from hypothesis import strategies as st

from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from tests.sgb_core.surfaces.chains import SHAPES, chain

TUBE = chain([[(20, 0), (20, 20), (20, 40), (20, 60)]])
CONE = chain([[(20, 0), (80 / 3, 20), (100 / 3, 40), (40, 60)]])
VESSEL = Solid(BodyKind.VESSEL, 3.0, WallSide.INSIDE, 4.0)


def vessel(**changes: object) -> Solid:
    from dataclasses import replace

    return replace(VESSEL, **changes)


@st.composite
def pots(draw: st.DrawFn) -> RevolutionSurface:
    """Draw pots of one to three segments that rise all the way, in any size and direction."""
    count = draw(st.integers(1, 3))
    scale = draw(st.sampled_from([0.02, 1.0, 30.0]))
    radii = [draw(st.floats(18.0, 60.0)) for _ in range(3 * count + 1)]
    if draw(st.booleans()):
        radii[0] = 0.0
    steps = [draw(st.floats(5.0, 20.0)) for _ in range(3 * count)]
    heights = np.concatenate([[0.0], np.cumsum(steps)])
    points = scale * np.stack([radii, heights], axis=1)
    if draw(st.booleans()):
        points = points[::-1]
    segments = [Segment(points[3 * k : 3 * k + 4] * (1.0, 1.0), draw(SHAPES)) for k in range(count)]
    return RevolutionSurface(
        Profile(tuple(segments)),
        draw(st.sampled_from(Axis)),
        draw(st.floats(-3.0, 3.0)),
        draw(st.sampled_from([2.0 * pi, 4.0, 1.5])),
    )


@st.composite
def bodies(draw: st.DrawFn, size: float) -> Solid:
    """Draw what a pot of this size may be made into."""
    wall = size * draw(st.floats(0.004, 0.06))
    return Solid(
        draw(st.sampled_from([BodyKind.VESSEL, BodyKind.VESSEL, BodyKind.FILLED])),
        wall,
        draw(st.sampled_from(WallSide)),
        draw(st.sampled_from([0.0, 0.5, 2.0])) * wall,
        draw(st.sampled_from(Rim)),
        draw(st.sampled_from([0.0, wall])),
    )
