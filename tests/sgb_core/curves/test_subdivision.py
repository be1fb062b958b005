"""Split keeps the curve; merge undoes it; what has no exact form says so."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.spatial import KDTree

from sgb_core.curves.conversion import Leg, to_segment
from sgb_core.curves.primitives import line
from sgb_core.curves.segment import NEUTRAL, Segment, ShapeParameters
from sgb_core.curves.subdivision import merge, split
from tests.sgb_core.curves.strategies import points, segments, shapes

CORNERS = st.tuples(*(st.sampled_from([0.0, 1.0]) for _ in range(3))).map(
    lambda f: ShapeParameters.from_leg_fractions(*f)
)
PLACES = st.floats(0.02, 0.98)
S = np.linspace(0.0, 1.0, 33)


def assert_same_curve(segment: Segment, s: float) -> None:
    result = split(segment, s)
    assert result.exact
    tolerance = 1e-12 * segment.size
    np.testing.assert_allclose(result.first.point(S), segment.point(s * S), rtol=0, atol=tolerance)
    np.testing.assert_allclose(
        result.second.point(S), segment.point(s + (1 - s) * S), rtol=0, atol=tolerance
    )
    np.testing.assert_array_equal(result.first.points[3], result.second.points[0])
    np.testing.assert_array_equal(result.first.points[0], segment.points[0])
    np.testing.assert_array_equal(result.second.points[3], segment.points[3])


@pytest.fixture(scope="module")
def rng() -> np.random.Generator:
    return np.random.default_rng(20)


def test_split_keeps_the_curve_of_random_segments(rng) -> None:
    for _ in range(150):
        shape = ShapeParameters(*(rng.uniform(size=4) * [4, 6, 4, 1]))
        assert_same_curve(Segment(rng.normal(size=(4, 2)), shape), rng.uniform(0.02, 0.98))


@settings(max_examples=60)
@given(segments(CORNERS), PLACES)
def test_split_deviation_is_the_truth_at_the_corners_of_the_range(segment, s) -> None:
    result = split(segment, s)
    gap = np.abs(result.first.point(S) - segment.point(s * S)).max()
    gap = max(gap, np.abs(result.second.point(S) - segment.point(s + (1 - s) * S)).max())
    assert gap <= result.deviation * (1 + 1e-6) + 1e-14 * (10.0 + segment.size)
    assert result.exact == (result.deviation <= 1e-12 * segment.size)


@pytest.mark.parametrize("fractions", [(0, 0.5, 0), (0, 0.5, 1), (1, 0.5, 0), (0, 0, 0.5)])
def test_at_vanishing_derivatives_control_points_stay_along_the_legs(fractions) -> None:
    shape = ShapeParameters.from_leg_fractions(*fractions)
    segment = Segment([[0.2, 0.2], [0.9, 0.0], [0.9, 1.0], [0.2, 0.8]], shape)
    for s in (0.2, 0.5, 0.8):
        assert_same_curve(segment, s)
        result = split(segment, s)
        for old, new in (
            (segment.points[:2], result.first.points[:2]),
            (segment.points[:1:-1], result.second.points[:1:-1]),
        ):
            leg, kept = old[1] - old[0], new[1] - new[0]
            assert abs(leg[0] * kept[1] - leg[1] * kept[0]) < 1e-12
            assert leg @ kept > 1e-5 * (leg @ leg)
        assert (result.first.shape.leg_fractions[0] == 0) == (fractions[0] == 0)
        assert (result.second.shape.leg_fractions[2] == 0) == (fractions[2] == 0)


@pytest.mark.parametrize("a", [0.4, 0.75, 1.0])
def test_parallel_end_legs(a) -> None:
    # The half of a symmetric arch: its end legs are parallel after the cut at the middle.
    arch = Segment([[0, 0], [1, 0], [1, 2], [0, 2]], ShapeParameters.from_leg_fractions(a, 0.5, a))
    assert_same_curve(arch, 0.5)
    wave = Segment([[0, 0], [1, 0], [2, 1], [3, 1]], ShapeParameters.from_leg_fractions(a, 0.5, a))
    for s in (0.1, 0.5, 0.7):
        assert_same_curve(wave, s)


def test_straight_lines_coincident_points_and_single_points() -> None:
    assert_same_curve(line((0, 0), (3, 1)), 0.4)
    assert_same_curve(Segment([[0, 0], [3, 3], [1, 1], [2, 2]], ShapeParameters(2, 5, 0.5, 1)), 0.3)
    assert_same_curve(Segment([[0, 0], [0, 0], [3, 1], [3, 1]], ShapeParameters(2, 5, 0, 1)), 0.6)
    assert_same_curve(Segment([[0, 0], [0, 0], [3, 1], [4, 3]], ShapeParameters(4, 5, 0, 1)), 0.6)
    assert_same_curve(Segment(np.ones((4, 2))), 0.5)


@pytest.mark.parametrize("s", [1e-6, 1e-4, 1.0 - 1e-4, 1.0 - 1e-6])
@pytest.mark.parametrize("fractions", [(0, 0, 0), (0, 0.4, 0), (0.6, 1, 0), (0, 0.7, 0.8)])
def test_a_cut_close_to_an_end_with_a_vanishing_derivative(fractions, s, rng) -> None:
    # Of the two legs of a half one is then about s, or s², times the other.
    shape = ShapeParameters.from_leg_fractions(*fractions)
    # A half's control points may lie a thousand times as far out, and no farther than 1e9.
    for scale in (1e-6, 1.0, 1e5):
        free = rng.normal(size=(4, 2))
        legless = free[[0, 0, 3, 3]]
        loop = np.array([[0.0, 0.0], [3.0, 1.0], [-2.0, 1.0], [1.0, 0.1]])
        for polygon in (free, legless, loop):
            assert_same_curve(Segment(scale * polygon, shape), s)


def test_a_cut_at_a_cusp() -> None:
    cusp = Segment([[0, 0], [1, 1], [0, 1], [1, 0]])
    assert np.hypot(*cusp.derivative(0.5)) < 1e-12
    assert_same_curve(cusp, 0.5)


@given(st.lists(points, min_size=4, max_size=4), PLACES)
@example([(0.0, 0.0), (1.0, 1.0), (1.0, 1.0), (0.0, 0.0)], 0.5)
@example([(0.0, 0.0), (0.0, 1.0), (0.0, 1.0), (0.0, 0.0)], 0.5)
def test_halves_of_a_cubic_are_cubics(polygon, s) -> None:
    result = split(Segment(np.array(polygon), NEUTRAL), s)
    assert result.first.shape == NEUTRAL
    assert result.second.shape == NEUTRAL


def test_the_member_nearest_the_cubic_is_taken(rng) -> None:
    """Oracle: walk along the family, found by solving for P1 and P2 with b given."""
    tried = 0
    while tried < 20:
        segment = Segment(
            rng.normal(size=(4, 2)), ShapeParameters(*(rng.uniform(size=4) * [4, 6, 4, 1]))
        )
        first = split(segment, 0.4).first
        q = first.quartic
        u, v = q[1] - q[0], q[3] - q[4]
        best = np.inf
        for b in np.linspace(1e-4, 1 - 1e-4, 4001):
            p, r = np.linalg.solve(np.column_stack([u, v]), q[2] - b * q[0] - (1 - b) * q[4])
            a, c = b / p, (1 - b) / r
            if 0 < a <= 1 and 0 < c <= 1:
                best = min(best, (a - 0.75) ** 2 + (b - 0.5) ** 2 + (c - 0.75) ** 2)
        a, b, c = first.shape.leg_fractions
        assert (a - 0.75) ** 2 + (b - 0.5) ** 2 + (c - 0.75) ** 2 <= best + 1e-9
        tried += 1


def test_a_quartic_that_is_no_segment_is_fitted_with_its_ends_kept() -> None:
    # Q2 lies far behind both end legs: no P1 and P2 reach it.
    quartic = np.array([[0.0, 0.0], [1.0, 0.0], [2.0, -3.0], [3.0, 0.0], [4.0, 0.0]])
    legs = Leg(quartic[1] - quartic[0], 1.0), Leg(quartic[3] - quartic[4], 1.0)
    segment, error = to_segment(quartic, *legs)
    np.testing.assert_allclose(error[[0, 1, 3, 4]], 0.0, atol=1e-12)
    assert np.hypot(*error[2]) == pytest.approx(3.0)
    assert all(0 <= f <= 1 for f in segment.shape.leg_fractions)


@pytest.mark.parametrize("s", [0.0, 1.0, -1.0, float("nan")])
def test_the_cut_has_to_be_inside(s) -> None:
    with pytest.raises(ValueError, match="above 0 and below 1"):
        split(line((0, 0), (1, 1)), s)


def test_merge_puts_together_what_split_cut(rng) -> None:
    for k in range(25):
        low, high = (0.0, 1.0) if k % 2 else (0.1, 0.9)
        shape = ShapeParameters(*(rng.uniform(low, high, size=4) * [4, 6, 4, 1]))
        segment = Segment(rng.normal(size=(4, 2)), shape)
        result = split(segment, rng.uniform(0.15, 0.85))
        merged, deviation = merge(result.first, result.second)
        assert deviation < 1e-9 * segment.size
        np.testing.assert_allclose(merged.point(S), segment.point(S), atol=1e-9 * segment.size)


@settings(max_examples=10, deadline=None)
@given(segments(shapes(0.1, 0.9)), segments(shapes(0.1, 0.9)))
def test_merge_keeps_ends_and_tangents_and_measures_its_deviation(first, second) -> None:
    shifted = second.with_points(second.points + (first.points[3] - second.points[0]))
    merged, deviation = merge(first, shifted)
    np.testing.assert_array_equal(merged.points[0], first.points[0])
    np.testing.assert_array_equal(merged.points[3], shifted.points[3])
    leg, kept = first.points[1] - first.points[0], merged.points[1] - merged.points[0]
    size = 1.0 + np.hypot(*leg) * np.hypot(*kept)
    assert abs(leg[0] * kept[1] - leg[1] * kept[0]) < 1e-9 * size
    dense = merged.point(np.linspace(0, 1, 2001))
    for part in (first, shifted):
        for point in part.point(np.linspace(0, 1, 9)):
            assert np.hypot(*(dense - point).T).min() <= deviation * 1.05 + 0.02


def test_the_deviation_of_a_merge_is_the_distance_between_the_curves_both_ways(rng) -> None:
    # Oracle: distances between dense points. In the second pair the merged curve swings farther
    # out than the corner that it replaces.
    wave = Segment(rng.normal(size=(4, 2)))
    corner = Segment([[0, 0], [0.2, 1], [0.4, 1.5], [1, 2]], ShapeParameters(4, 6, 4, 1))
    hook = Segment([[1, 2], [1.2, 1], [2.5, 0.5], [2, 0]], ShapeParameters(0, 1, 4, 1))
    for first, second in (
        (wave, wave.with_points(wave.points[3] + rng.normal(size=(4, 2)))),
        (corner, hook),
    ):
        second = second.with_points(second.points + (first.points[3] - second.points[0]))
        merged, deviation = merge(first, second)
        dense = np.linspace(0.0, 1.0, 4001)
        old = np.concatenate([first.point(dense), second.point(dense)])
        new = merged.point(np.linspace(0.0, 1.0, 8001))
        there, back = KDTree(new).query(old)[0].max(), KDTree(old).query(new)[0].max()
        assert deviation == pytest.approx(max(there, back), rel=1e-4)


def test_merging_single_points() -> None:
    point = Segment(np.ones((4, 2)))
    merged, deviation = merge(point, point)
    assert deviation == 0.0
    assert merged == point
