"""Many joints at once are what each of them is alone."""

from __future__ import annotations

from math import log

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.continuity import (
    EQUAL_CURVATURES,
    KINK_DEG,
    JointClass,
    JointReport,
    end_view,
    measure_ends,
    start_view,
)
from sgb_core.curves.many_joints import RANKS, ManyEnds, ManyJoints, measure_many
from sgb_core.curves.profile import JointRule
from sgb_core.curves.segment import Segment, ShapeParameters

# Legs and fractions that vanish, and points that lie on one another, often.
PLACES = st.sampled_from([-1.0, 0.0, 1.0]) | st.floats(-3.0, 3.0).map(lambda v: round(v, 3))
POLYGONS = st.lists(st.tuples(PLACES, PLACES), min_size=4, max_size=4)
END = st.sampled_from([0.0, 1.0, 4.0]) | st.floats(0.0, 4.0)
SHAPES = st.builds(
    ShapeParameters,
    END,
    st.sampled_from([0.0, 3.0, 6.0]) | st.floats(0.0, 6.0),
    END,
    st.sampled_from([0.0, 1.0]) | st.floats(0.0, 1.0),
)
SEGMENTS = st.builds(lambda points, shape: Segment(np.array(points), shape), POLYGONS, SHAPES)


@st.composite
def pairs(draw: st.DrawFn) -> tuple[Segment, Segment]:
    """Two segments, mostly joined, often by the same slope or as mirror images."""
    first, second = draw(SEGMENTS), draw(SEGMENTS)
    kind = draw(st.sampled_from(["apart", "joined", "smooth", "mirror"]))
    if kind == "mirror":
        end = first.points[3]
        return first, Segment((2.0 * end - first.points)[::-1], first.shape.reversed())
    points = second.points.copy()
    if kind != "apart":
        points += first.points[3] - points[0]
    if kind == "smooth":
        points[1] = points[0] + (first.points[3] - first.points[2])
    return first, Segment(points, second.shape)


def ends(views) -> ManyEnds:
    return ManyEnds(
        np.array([view.at for view in views]),
        np.array([view.legs for view in views]).transpose(1, 0, 2),
        np.array([view.fraction for view in views]),
        np.array([view.weight for view in views]),
        np.array([view.far_fraction for view in views]),
    )


def on_a_border(report: JointReport, jump: float, size: float) -> bool:
    """Whether rounding alone may decide about the class, or about whether a value is one."""
    kink = report.kink_deg
    near = kink is not None and abs(kink - KINK_DEG) < 1e-8
    return near or 0.0 < jump * size < 10.0 * EQUAL_CURVATURES


def compare(found: ManyJoints, place: int, report: JointReport) -> None:
    jump, ratio = report.curvature_jump, report.speed_ratio
    expected = {
        "kink": report.kink_deg,
        "jump": None if jump is None else abs(jump),
        "off": None if not ratio else abs(log(ratio)),
    }
    for name, value in expected.items():
        other = getattr(found, name)[place]
        assert np.isnan(other) == (value is None)
        if value is not None:
            assert other == pytest.approx(value, rel=1e-12, abs=1e-12)
    assert bool(found.degenerate[place]) is report.degenerate


@given(st.lists(pairs(), min_size=1, max_size=8))
def test_they_are_what_each_is_alone(some: list[tuple[Segment, Segment]]) -> None:
    views = [(end_view(first), start_view(second)) for first, second in some]
    size = 5.0
    found = measure_many(ends([one for one, _ in views]), ends([two for _, two in views]), size)
    for k, (before, after) in enumerate(views):
        report = measure_ends(before, after, 0, JointRule.G0, size)
        compare(found, k, report)
        if not on_a_border(report, float(found.jump[k]), size):
            assert RANKS[found.rank[k]] is report.measured


def test_every_class_is_among_them() -> None:
    wall = Segment([(5, 13), (6, 12), (3, 10), (2, 8)])
    quick = Segment([(2, 8), (1.5, 7), (2, 3), (5, -1)])
    bow = Segment([(2, 12), (1, 11), (0, 9), (0, 8)])
    mirror = Segment([(0, 8), (0, 7), (1, 5), (2, 4)])
    bent = Segment([(2, 8), (5, 6), (2, 3), (5, -1)])
    far = Segment([(9, 8), (1, 6), (2, 3), (5, -1)])
    even = Segment([(2, 8), (1, 6), (2, 3), (5, -1)])
    views = [(end_view(wall), start_view(each)) for each in (far, bent, quick, even)]
    views.append((end_view(bow), start_view(mirror)))
    found = measure_many(ends([one for one, _ in views]), ends([two for _, two in views]), 20.0)
    alone = [measure_ends(*pair, 0, JointRule.G0, 20.0).measured for pair in views]
    assert [RANKS[rank] for rank in found.rank] == alone == list(JointClass)
