"""Whole traces: few segments, within the tolerance, with joints as they are."""

from __future__ import annotations

from time import process_time

import numpy as np
import pytest

import resources
from sgb_core.curves.continuity import JointClass
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.design.tracing import TraceError, trace
from sgb_core.document.file.project_file import loads
from tests.sgb_core.design.tracing.paths import (
    farthest,
    frusta,
    polyline,
    semicircle,
    sign_changes,
    volume,
    wavy,
)


def test_a_semicircle_is_one_segment_level_at_its_poles() -> None:
    found = trace(semicircle(50.0, 181), 0.05)
    (segment,) = found.profile.segments
    assert found.largest_deviation < 0.02
    assert segment.points[[0, 3], 0].tolist() == [0.0, 0.0]
    assert segment.points[0, 1] == segment.points[1, 1]
    assert segment.points[2, 1] == segment.points[3, 1]
    assert volume(found.profile) == pytest.approx(4 / 3 * np.pi * 50.0**3, rel=1e-5)


def test_a_circle_is_a_ring_of_two_smooth_segments() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 200)
    found = trace(np.stack([30 + 5 * np.cos(angle), 5 * np.sin(angle)], axis=1), 0.01)
    assert found.profile.closed
    assert len(found.profile) == 2
    assert all(joint.measured != JointClass.G0 for joint in found.joints)


def test_corners_stay_sharp_and_sides_straight() -> None:
    corners = [(0.0, 0.0), (30.0, 0.0), (35.0, 60.0), (25.0, 80.0), (28.0, 100.0)]
    found = trace(polyline(corners, 300), 0.1)
    assert len(found.profile) == 4
    assert [joint.measured for joint in found.joints] == [JointClass.G0] * 3
    ends = [segment.points[3] for segment in found.profile.segments]
    np.testing.assert_allclose(ends, corners[1:], atol=1e-6)


@pytest.mark.parametrize("start", [0, 25])
def test_a_square_outline_has_its_four_corners_wherever_it_begins(start: int) -> None:
    side = [(10.0, 10.0), (20.0, 10.0), (20.0, 20.0), (10.0, 20.0), (10.0, 10.0)]
    points = np.roll(polyline(side, 200)[:-1], start, axis=0)
    found = trace(points, 0.02)
    assert found.profile.closed
    assert [joint.measured for joint in found.joints] == [JointClass.G0] * 4
    assert found.largest_deviation < 1e-6


@pytest.mark.parametrize("tolerance", [1.0, 0.1])
def test_a_shape_of_many_bends_keeps_its_inflections_and_no_more(tolerance: float) -> None:
    points = wavy(400)
    found = trace(points, tolerance)
    assert found.largest_deviation <= tolerance
    assert len(found.profile) <= 7
    assert sign_changes(found.profile) <= 8
    assert volume(found.profile) == pytest.approx(frusta(points), rel=3e-4)


@pytest.mark.parametrize("seed", range(3))
def test_noise_below_the_tolerance_grows_neither_segments_nor_wiggles(seed: int) -> None:
    clean = semicircle(50.0, 300)
    noise = 0.25 * np.random.default_rng(seed).normal(size=clean.shape)
    noise[[0, -1]] = 0.0
    found = trace(clean + noise, 1.0)
    assert len(found.profile) == 1
    assert sign_changes(found.profile) == 0
    assert farthest(found.profile, clean) < 0.3


def test_noise_on_a_line_leaves_a_line() -> None:
    clean = polyline([(10.0, 0.0), (40.0, 60.0)], 60)
    noise = 0.02 * np.random.default_rng(1).normal(size=clean.shape)
    found = trace(clean + noise, 0.1)
    assert len(found.profile) == 1
    assert sign_changes(found.profile) == 0


def test_the_deviations_stated_are_true() -> None:
    points = wavy(400) + 0.2 * np.random.default_rng(5).normal(size=(400, 2))
    found = trace(points, 1.0)
    assert found.outliers == ()
    assert farthest(found.profile, points) == pytest.approx(found.largest_deviation, rel=0.01)
    worst = points[found.farthest]
    assert found.farthest_point == tuple(worst)
    assert farthest(found.profile, worst[None]) == pytest.approx(found.largest_deviation, rel=0.01)


def test_symmetric_points_give_a_symmetric_chain() -> None:
    angle = np.linspace(-np.pi / 2, np.pi / 2, 81)
    r = 80.0 * (1.0 + 0.3 * np.cos(3.0 * angle)) * np.cos(angle)
    found = trace(np.stack([r, 100.0 * np.sin(angle)], axis=1), 0.1)
    quartics = found.profile.quartics
    mirrored = quartics[::-1, ::-1] * [1.0, -1.0]
    assert len(quartics) > 1
    np.testing.assert_allclose(quartics, mirrored, atol=1e-9)


@pytest.mark.parametrize("factor", [1e-6, 1e6])
def test_the_scale_does_not_matter(factor: float) -> None:
    base = trace(wavy(200), 0.5).profile.quartics
    scaled = trace(factor * wavy(200), factor * 0.5).profile.quartics
    np.testing.assert_allclose(scaled / factor, base, atol=1e-6)


def test_joints_of_equal_curvature_on_wish() -> None:
    found = trace(wavy(300), 0.5, smoothness=JointRule.G2)
    smooth = [joint for joint in found.joints if joint.rule != JointRule.G0]
    assert smooth
    assert {joint.measured for joint in smooth} == {JointClass.G2}
    assert found.largest_deviation <= 0.5


def test_a_cone_keeps_its_tip() -> None:
    found = trace(polyline([(0.0, 0.0), (30.0, 5.0), (30.0, 40.0)], 120), 0.1)
    first = found.profile.segments[0]
    np.testing.assert_allclose(first.start_tangent(), np.array([30.0, 5.0]) / np.hypot(30, 5))


def test_an_end_within_the_tolerance_of_the_axis_becomes_a_pole() -> None:
    points = semicircle(50.0, 100)[1:]
    points[0, 0] = 0.4
    found = trace(points, 0.5)
    assert found.profile.segments[0].points[0, 0] == 0.0


def test_isolated_points_are_left_out_and_listed() -> None:
    points = wavy(300)
    points[100] += (4.0, -6.0)
    points[200] -= (7.0, 0.0)
    found = trace(points, 0.5)
    assert found.outliers == (100, 200)
    assert found.largest_deviation <= 0.5
    assert found.points == 300


def test_weights_draw_the_curve() -> None:
    points = semicircle(50.0, 101)
    points[1::2, 0] += 0.4
    heavy = np.where(np.arange(101) % 2 == 0, 100.0, 1.0)
    plain, weighted = trace(points, 1.0), trace(points, 1.0, weights=heavy)
    assert farthest(weighted.profile, points[::2]) < 0.5 * farthest(plain.profile, points[::2])


def test_a_known_corner_is_one_however_flat() -> None:
    points = polyline([(20.0, 0.0), (30.0, 50.0), (37.0, 100.0)], 100)
    at = int(np.argmin(np.hypot(*(points - [30.0, 50.0]).T)))
    assert JointRule.G0 not in trace(points, 0.5).profile.rules
    found = trace(points, 0.5, corners=[at])
    assert [joint.rule for joint in found.joints] == [JointRule.G0]


@pytest.mark.parametrize(
    ("points", "message"),
    [
        (np.zeros((0, 2)), "points is 0; allowed is at least 2"),
        ([[1, 1]], "points is 1"),
        ([[1, 1]] * 5, "in one place"),
        ([[0, k] for k in range(9)], "on the axis"),
        ([[1, 1], [2, np.nan], [3, 3]], "point 1 is not a pair of finite numbers"),
        ([[1, 1], [2, 1e10]], "coordinate is 1e"),
        ([1, 2, 3], "allowed is"),
        ([[1, 0], [1.01, 0.01]], "within the tolerance"),
    ],
)
def test_what_is_no_profile_is_told(points: object, message: str) -> None:
    with pytest.raises(TraceError, match=message):
        trace(points, 1.0)  # type: ignore[arg-type]


@pytest.mark.parametrize("tolerance", [0.0, -1.0, float("nan"), float("inf")])
def test_a_tolerance_is_above_zero(tolerance: float) -> None:
    with pytest.raises(TraceError, match="tolerance"):
        trace([[1, 0], [2, 5]], tolerance)


def test_two_points_are_a_line_and_few_a_curve_through_them() -> None:
    assert len(trace([[1, 0], [2, 5]], 0.1).profile) == 1
    points = np.array([[1, 0], [2, 5], [3, 6], [1, 9]])
    assert trace(np.repeat(points, 3, axis=0), 0.1).largest_deviation <= 0.1


def test_a_spike_and_a_stroke_that_comes_back_are_followed() -> None:
    spike = polyline([(20, 0), (20, 30), (50, 30), (20, 31.5), (20, 60)], 240)
    found = trace(spike, 0.2)
    assert found.largest_deviation <= 0.2
    back = trace(polyline([(10, 0), (40, 30), (10, 0)], 100), 0.2)
    assert not back.profile.closed
    assert back.largest_deviation <= 0.2


def _sampled(profile: Profile, count: int) -> np.ndarray:
    dense = profile.sample(300).reshape(-1, 2)
    dense = dense[np.append(True, np.hypot(*np.diff(dense, axis=0).T) > 1e-12)]
    along = np.append(0.0, np.cumsum(np.hypot(*np.diff(dense, axis=0).T)))
    marks = np.linspace(0.0, along[-1], count)
    return np.stack([np.interp(marks, along, dense[:, k]) for k in range(2)], axis=1)


@pytest.mark.parametrize("name", ["amphora", "bowl", "ceramic-pot", "plant-pot", "tower", "vase"])
def test_presets_come_back_with_no_more_segments_than_they_have(name: str) -> None:
    profile = loads(resources.load_preset(name)).profile
    points = _sampled(profile, 500)
    found = trace(points)
    assert found.largest_deviation <= found.tolerance
    assert len(found.profile) <= len(profile)
    assert volume(found.profile) == pytest.approx(frusta(points), rel=1e-3)


def test_two_thousand_points_are_quick() -> None:
    points = wavy(2000) + 0.2 * np.random.default_rng(3).normal(size=(2000, 2))
    trace(points[::40], 1.0)
    start = process_time()
    found = trace(points, 1.0)
    assert found.largest_deviation <= 1.0
    # A live slider wants 0.3 s of a machine of its own.
    assert process_time() - start < 2.0


@pytest.mark.parametrize("tolerance", [0.3, 1.0, 3.0])
def test_shape_parameters_at_their_bound_are_there_exactly(tolerance: float) -> None:
    for points in (wavy(400), polyline([(0, 0), (40, 0), (60, 90), (30, 120)], 300)):
        found = trace(points, tolerance).profile
        values = np.array(
            [(s.shape.lambda1, s.shape.lambda2, s.shape.lambda3) for s in found.segments]
        )
        assert ((values == 0.0) | (values > 1e-12)).all()
