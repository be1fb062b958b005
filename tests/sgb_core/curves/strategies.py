"""Random segments and chains, from the corners of the parameter range to its inside."""

from __future__ import annotations

import numpy as np
from hypothesis import strategies as st

from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters

coordinates = st.floats(-10.0, 10.0, allow_subnormal=False).map(lambda v: round(v, 3))
points = st.tuples(coordinates, coordinates)
parameters = st.floats(0.0, 1.0, allow_subnormal=False)


def shapes(low: float = 0.0, high: float = 1.0) -> st.SearchStrategy[ShapeParameters]:
    part = st.floats(low, high, allow_subnormal=False)
    return st.builds(
        lambda a, b, c, w: ShapeParameters(4.0 * a, 6.0 * b, 4.0 * c, w), part, part, part, part
    )


def segments(shape: st.SearchStrategy[ShapeParameters] | None = None) -> st.SearchStrategy[Segment]:
    polygon = st.lists(points, min_size=4, max_size=4).map(np.array)
    return st.builds(Segment, polygon, shapes() if shape is None else shape)


@st.composite
def chains(draw: st.DrawFn, rule: JointRule, closed: bool | None = None, most: int = 5) -> Profile:
    """A joined chain without degenerate ends; its rules are asked for, not yet satisfied."""
    is_closed = draw(st.booleans()) if closed is None else closed
    count = draw(st.integers(1 if is_closed else 2, most))
    seed = draw(st.integers(0, 2**32 - 1))
    rng = np.random.default_rng(seed)
    ends = rng.normal(size=(count + 1, 2)) * 3.0
    if is_closed:
        ends[-1] = ends[0]
    made = []
    for k in range(count):
        inner = rng.normal(size=(2, 2)) * 3.0
        shape = draw(shapes(0.05, 0.95))
        made.append(Segment(np.array([ends[k], *inner, ends[k + 1]]), shape))
    joints = count if is_closed else count - 1
    return Profile(tuple(made), (rule,) * joints, is_closed)
