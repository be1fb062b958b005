"""Random and named profiles for the tests of surfaces."""

from __future__ import annotations

from math import pi

import numpy as np
from hypothesis import strategies as st

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.variation import Law

TOWER = [
    [[5, 13], [6, 12], [3, 10], [2, 8]],
    [[2, 8], [1, 6], [2, 3], [5, -1]],
    [[5, -1], [8, -5], [5, -9], [8, -10]],
]
BALL = [[[0, 0], [1.2, 0], [1.2, 2], [0, 2]]]
RING = [[[2, 0], [3.2, 0], [3.2, 2], [2, 2]], [[2, 2], [0.8, 2], [0.8, 0], [2, 0]]]
CROSSING = [[[1, 0], [1, 0.5], [-1, 1.5], [-1, 2.5]]]
PLACED = Placement((10.0, 20.0, 30.0), (1.0, -2.0, 3.0))

PAPER = Law("omega", "paper", 0.0, 1.0)
WAVE = Law("lambda1", "cosine", 0.0, 4.0, count=3)
KEYS = Law("lambda2", "keyframes", 1.0, 6.0, keyframes=((0.0, 0.0), (90.0, 1.0), (200.0, 0.3)))


def chain(
    points: object, shape: tuple[float, float, float, float] = (1, 3, 1, 0), closed: bool = False
) -> Profile:
    segments = [Segment(np.array(p, float), ShapeParameters(*shape)) for p in points]
    return Profile(tuple(segments), closed=closed)


def degenerate_count(mesh: Mesh) -> int:
    """Return how many triangles repeat a position or have an area of exactly 0."""
    faces = mesh.faces
    repeats = (faces == np.roll(faces, -1, axis=1)).any(axis=1)
    return int(np.count_nonzero(repeats | (mesh.areas == 0.0)))


# Values that coincide often: coincident control points and touching the axis are the point.
RADII = st.sampled_from([0.0, 0.5, 1.0]) | st.floats(0.05, 2.0)
HEIGHTS = st.sampled_from([0.0, 1.0, 2.0]) | st.floats(-2.0, 3.0)
END = st.sampled_from([0.0, 1.0, 4.0]) | st.floats(0.0, 4.0)
MIDDLE = st.sampled_from([0.0, 3.0, 6.0]) | st.floats(0.0, 6.0)
SHAPES = st.builds(
    ShapeParameters, END, MIDDLE, END, st.sampled_from([0.0, 1.0]) | st.floats(0.0, 1.0)
)
FACTORS = st.floats(0.6, 1.5)
RADIUS_LAWS = st.one_of(
    st.builds(
        Law,
        st.just("radius"),
        st.just("lobes"),
        FACTORS,
        FACTORS,
        count=st.integers(1, 7),
        sharp=st.sampled_from([0.0, 1.0]) | st.floats(0.0, 1.0),
    ),
    st.builds(
        Law,
        st.just("radius"),
        st.just("polygon"),
        st.sampled_from([0.0, 0.5]),
        st.just(1.0),
        count=st.integers(3, 7),
        round=st.sampled_from([0.0, 1.0]) | st.floats(0.05, 0.9),
    ),
    st.builds(
        Law,
        st.just("radius"),
        st.sampled_from(["square", "sawtooth"]),
        FACTORS,
        FACTORS,
        count=st.integers(1, 5),
        flank=st.floats(5.0, 90.0),
    ),
)
SHAPE_LAW = st.one_of(
    st.builds(Law, st.just("omega"), st.just("paper"), st.floats(0, 1), st.floats(0, 1)),
    st.builds(Law, st.just("lambda2"), st.just("raised-cosine"), st.floats(0, 6), MIDDLE),
    st.builds(
        Law,
        st.sampled_from(["lambda1", "lambda3"]),
        st.just("cosine"),
        END,
        END,
        count=st.integers(1, 4),
    ),
    st.builds(
        Law,
        st.just("lambda2"),
        st.just("keyframes"),
        MIDDLE,
        MIDDLE,
        keyframes=st.just(KEYS.keyframes),
    ),
)
SHAPE_LAWS = st.lists(SHAPE_LAW, min_size=1, max_size=2).map(tuple)
LAWS = st.lists(st.one_of(RADIUS_LAWS, SHAPE_LAW), min_size=1, max_size=2).map(tuple)


@st.composite
def profiles(
    draw: st.DrawFn, ends: tuple[float, float] | None = None, radii: st.SearchStrategy = RADII
) -> Profile:
    """A joined chain of one to three segments; ``ends`` fixes the first and last radius."""
    count = draw(st.integers(1, 3))
    points = [(draw(radii), draw(HEIGHTS)) for _ in range(3 * count + 1)]
    if ends is not None:
        points[0] = (ends[0], points[0][1])
        points[-1] = (ends[1], points[-1][1])
    segments = [Segment(np.array(points[3 * k : 3 * k + 4]), draw(SHAPES)) for k in range(count)]
    return Profile(tuple(segments))


@st.composite
def surfaces(draw: st.DrawFn, laws: bool = False, **kind: object) -> RevolutionSurface:
    return RevolutionSurface(
        draw(profiles(**kind)),
        draw(st.sampled_from(Axis)),
        draw(st.floats(-7.0, 7.0)),
        draw(st.just(2.0 * pi) | st.floats(0.2, 6.2)),
        draw(LAWS) if laws else (),
        draw(st.sampled_from([Placement(), PLACED])),
    )
