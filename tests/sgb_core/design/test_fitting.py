"""Fits against independent measurements and an independent optimisation."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import differential_evolution

from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.fitting import Freedom, deviation, fit
from sgb_core.design.target_curves import SuperellipseArc

PAPER_POLYGON = ((0.0, 0.0), (1.2, 0.0), (1.2, 2.0), (0.0, 2.0))


def paper_profile(lambdas, omega):
    return Profile((Segment(PAPER_POLYGON, ShapeParameters(*lambdas, omega)),))


def brute_distance(target, points):
    dense = target.points(200_001)
    return np.array([np.hypot(*(dense - p).T).min() for p in points])


@settings(max_examples=25)
@given(
    b=st.floats(0.2, 3.0),
    exponent=st.sampled_from([2.0, 1.5, 3.0, 5.0]),
    r=st.floats(0.0, 4.0),
    h=st.floats(-3.0, 3.0),
)
def test_distance_to_a_superellipse_is_to_its_nearest_point(b, exponent, r, h):
    target = SuperellipseArc(b=b, a=1.0, centre=0.3, exponent=exponent)
    point = np.array([[r, h]])
    found = target.signed_distance(point)[0]
    # The brute force lays its points at equal angles: sparse where the curve is flat.
    assert abs(found) == pytest.approx(brute_distance(target, point)[0], abs=5e-4)
    inside = (r / b) ** exponent + abs(h - 0.3) ** exponent <= 1.0
    assert found == 0.0 or (found < 0.0) == inside


def test_a_circle_is_measured_radially():
    target = SuperellipseArc(b=2.0, a=2.0, centre=1.0)
    points = np.array([[3.0, 1.0], [0.0, 1.0], [0.0, 4.0]])
    assert target.signed_distance(points).tolist() == [1.0, -2.0, 1.0]


def test_the_published_semicircle_deviates_by_over_three_percent():
    found = deviation(paper_profile((0, 3, 0), 0.671), SuperellipseArc(1.0, 1.0, 1.0))
    assert 0.03 < found.largest < 0.034
    points = paper_profile((0, 3, 0), 0.671).sample(5001)[0]
    radial = np.abs(np.hypot(points[:, 0], points[:, 1] - 1.0) - 1.0)
    assert found.largest == pytest.approx(radial.max(), rel=1e-5)


@pytest.mark.parametrize("b", [1.0, 0.8, 0.6])
def test_each_freedom_comes_nearer(b):
    target = SuperellipseArc(b=b, a=1.0, centre=1.0)
    profile = paper_profile((0, 3, 0) if b == 1.0 else (4, 3, 4), 0.5)
    results = [fit(profile, target, freedom) for freedom in Freedom]
    largest = [result.deviation.largest for result in results]
    # The best ω alone may already be the best of all parameters, to the search's accuracy.
    assert largest[1] <= largest[0] * 1.001
    assert largest[2] < largest[1]
    assert largest[2] < 2e-4
    if b == 1.0:
        # What other optimisers find, with distances and a search of their own.
        assert largest[1:] == pytest.approx([0.02124, 7.124e-5], rel=1e-3)
    assert np.array_equal(results[1].profile.control_points, profile.control_points)
    ends = results[2].profile.control_points[0, [0, 3]]
    assert np.array_equal(ends, target.ends)


@pytest.mark.parametrize("b", [1.0, 0.6])
def test_the_best_shape_is_that_of_an_independent_search(b):
    target = SuperellipseArc(b=b, a=1.0, centre=1.0)
    profile = paper_profile((4, 3, 4), 0.5)

    def largest(fractions):
        points = (
            profile.segments[0]
            .with_shape(ShapeParameters.from_leg_fractions(*fractions))
            .point(np.linspace(0, 1, 201))
        )
        return np.abs(target.signed_distance(points)).max()

    other = differential_evolution(largest, [(0.0, 1.0)] * 3, seed=1, tol=1e-10, maxiter=60)
    assert fit(profile, target, Freedom.SHAPE).deviation.largest <= other.fun * 1.002


def test_a_chain_is_fitted_with_its_joint_kept_smooth():
    target = SuperellipseArc(b=1.0, a=1.0, centre=1.0, exponent=2.5)
    lower = Segment(((0, 0), (0.7, 0), (1, 0.3), (1, 1)))
    upper = Segment(((1, 1), (1, 1.7), (0.7, 2), (0, 2)))
    start = Profile.of([lower, upper], ["G1"])
    result = fit(start, target, Freedom.POLYGON, starts=1)
    assert result.deviation.largest < 0.25 * deviation(start, target).largest
    first, second = result.profile.control_points
    assert np.array_equal(first[3], second[0])
    legs = first[3] - first[2], second[1] - second[0]
    cross = legs[0][0] * legs[1][1] - legs[0][1] * legs[1][0]
    assert abs(cross) < 1e-12
    assert legs[0] @ legs[1] > 0.0


def test_a_closed_polygon_has_no_open_target():
    ring = Profile.of(
        [Segment(((2, 0), (3, 0), (3, 2), (2, 2))), Segment(((2, 2), (1, 2), (1, 0), (2, 0)))],
        closed=True,
    )
    with pytest.raises(ValueError, match="closed"):
        fit(ring, SuperellipseArc(1.0, 1.0), Freedom.POLYGON)


@pytest.mark.parametrize(("b", "a", "exponent"), [(0, 1, 2), (1, -1, 2), (1, 1, 0.5)])
def test_impossible_targets_are_refused(b, a, exponent):
    with pytest.raises(ValueError, match=r"half|exponent"):
        SuperellipseArc(b=b, a=a, exponent=exponent)


def ring(count: int) -> Profile:
    """Return a coarse ring of straight sides around a torus's circle, to be kept smooth."""
    angle = np.linspace(0.0, 2.0 * np.pi, count + 1)
    corners = np.stack([4.0 + np.cos(angle), 1.0 + np.sin(angle)], axis=1)
    corners[-1] = corners[0]
    parts = np.linspace(0.0, 1.0, 4)[:, None]
    sides = [Segment(p + parts * (q - p)) for p, q in pairwise(corners)]
    return Profile.of(sides, ["G1"] * count, closed=True)


@pytest.mark.parametrize(("count", "least"), [(2, 1.57e-4), (4, 6.3e-7)])
def test_a_circle_off_the_axis_is_fitted_by_a_smooth_ring(count, least):
    target = SuperellipseArc(1.0, 1.0, 1.0, radius=4.0)
    result = fit(ring(count), target, Freedom.POLYGON, starts=0)
    assert result.deviation.largest < least
    points = result.profile.sample(501).reshape(-1, 2)
    radial = np.abs(np.hypot(points[:, 0] - 4.0, points[:, 1] - 1.0) - 1.0)
    assert radial.max() == pytest.approx(result.deviation.largest, rel=1e-3)
    assert all(report.kink_deg < 1e-6 for report in measure_joints(result.profile))


@pytest.mark.parametrize(("keep", "least"), [(True, 1.21e-4), (False, 6.1e-5)])
def test_poles_that_slide_come_nearer_to_the_sphere(keep, least):
    target = SuperellipseArc(1.0, 1.0, 1.0)
    profile = paper_profile((0, 3, 0), 0.5)
    result = fit(profile, target, Freedom.POLYGON, starts=2, keep_ends=keep, slide_poles=True)
    assert result.deviation.largest < least
    points = result.profile.control_points[0]
    assert points[0, 0] == points[3, 0] == 0.0
    np.testing.assert_allclose(points[::-1] * (1, -1) + (0, 2), points, atol=1e-12)


def test_least_squares_are_no_more_than_those_of_the_least_largest():
    target = SuperellipseArc(0.8, 1.0, 1.0)
    profile = paper_profile((1, 3, 1), 0.5)
    for freedom in Freedom:
        largest = fit(profile, target, freedom, starts=2).deviation
        squares = fit(profile, target, freedom, starts=2, squares=True).deviation
        assert squares.rms <= largest.rms * (1.0 + 1e-6)
        assert squares.largest >= largest.largest * (1.0 - 1e-3)


def test_ten_segments_come_to_an_end_from_a_poor_start():
    rng = np.random.default_rng(3)
    heights = np.linspace(0.0, 2.0, 11)
    ends = np.stack([np.abs(rng.normal(1.0, 0.4, 11)), heights], axis=1)
    segments = [
        Segment([p, p + rng.normal(0, 0.3, 2), q + rng.normal(0, 0.3, 2), q])
        for p, q in pairwise(ends)
    ]
    start = Profile.of(segments, ["G1"] * 9)
    result = fit(start, SuperellipseArc(1.0, 1.0, 1.0), Freedom.POLYGON, starts=0)
    assert result.deviation.largest < 1e-8
