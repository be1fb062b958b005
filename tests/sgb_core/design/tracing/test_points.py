"""Corners, outliers, noise and the order of points."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sgb_core.arrays import Floats
from sgb_core.design.tracing.corners import Corner, corners_of, noise_of, scatter_of
from sgb_core.design.tracing.errors import TraceError
from sgb_core.design.tracing.guide import guide_of
from sgb_core.design.tracing.ordering import ordered
from sgb_core.design.tracing.outliers import isolated_outliers
from sgb_core.design.tracing.result import distances
from sgb_core.design.tracing.tracer import trace
from tests.sgb_core.design.tracing.paths import polyline, semicircle, wavy


def _corners(points: Floats, tolerance: float) -> list[Corner]:
    noise = noise_of(points)
    guide = guide_of(points, min(4.0 * noise, tolerance))
    return corners_of(points, guide.along, tolerance, noise)


@settings(max_examples=30, deadline=None)
@given(turn=st.floats(0.0, 150.0), count=st.integers(60, 900), shift=st.floats(0.0, 1.0))
def test_a_turn_is_a_corner_above_thirty_degrees(turn: float, count: int, shift: float) -> None:
    tip = (50.0 + shift, 0.0)
    end = (tip[0] + 60.0 * np.cos(np.radians(turn)), 60.0 * np.sin(np.radians(turn)))
    points = polyline([(0.0, 0.0), tip, end], count)
    # The corner itself need not be among the points.
    points = np.delete(points, int(np.argmin(np.hypot(*(points - tip).T))), axis=0)
    found = _corners(points, 0.1)
    if turn > 30.5:
        assert len(found) == 1
        assert found[0].turn_deg == pytest.approx(turn, abs=0.5)
        np.testing.assert_allclose(found[0].place, tip, atol=0.05)
    elif turn < 29.5:
        assert found == []


@pytest.mark.parametrize(("radius", "sharp"), [(1.0, True), (8.0, False), (16.0, False)])
def test_a_bend_is_a_corner_where_it_is_as_small_as_the_tolerance(
    radius: float, sharp: bool
) -> None:
    angle = np.linspace(0.0, np.pi / 2, 60)[1:-1]
    bend = np.stack([50 - radius + radius * np.sin(angle), radius - radius * np.cos(angle)], 1)
    points = np.concatenate(
        [
            polyline([(0, 0), (50 - radius, 0)], 100),
            bend,
            polyline([(50, radius), (50, 60)], 100),
        ]
    )
    assert bool(_corners(points, 1.0)) == sharp


def test_neither_smooth_curves_nor_noise_on_them_have_corners() -> None:
    rng = np.random.default_rng(2)
    for clean in (semicircle(50.0, 400), wavy(1500)):
        assert _corners(clean, 0.1) == []
        assert _corners(clean + 0.02 * rng.normal(size=clean.shape), 0.1) == []


def test_noise_is_measured_and_smooth_curves_have_none() -> None:
    clean = wavy(1000)
    assert noise_of(clean) < 1e-3
    noisy = clean + 0.3 * np.random.default_rng(4).normal(size=clean.shape)
    assert noise_of(noisy) == pytest.approx(0.3, rel=0.15)


def test_tips_of_corners_and_coarse_points_are_no_outliers() -> None:
    square = polyline([(10, 10), (60, 10), (60, 60), (10, 60)], 20)
    assert len(isolated_outliers(square, 0.1)) == 0
    assert len(isolated_outliers(semicircle(50.0, 8), 0.05)) == 0


def test_two_neighbours_away_together_are_data() -> None:
    points = semicircle(50.0, 200)
    points[80] *= 1.1
    assert isolated_outliers(points, 0.5).tolist() == [80]
    points[81] *= 1.1
    assert isolated_outliers(points, 0.5).tolist() == []


def test_every_one_of_many_outliers_in_a_long_row_is_found() -> None:
    rng = np.random.default_rng(8)
    points = semicircle(500.0, 6000) + rng.normal(0.0, 0.02, (6000, 2))
    # Some on one side and some on the other, some of them with others near.
    away = np.sort(np.concatenate([np.arange(40, 5900, 23), np.arange(44, 5900, 230)]))
    points[away] *= 1.0 + 0.1 * rng.choice([-1.0, 1.0], (len(away), 1))
    assert isolated_outliers(points, 1.0).tolist() == away.tolist()


def test_shuffled_points_come_back_in_order() -> None:
    clean = semicircle(50.0, 150)
    shuffled = np.random.default_rng(6).permutation(len(clean))
    np.testing.assert_array_equal(clean[shuffled][ordered(clean[shuffled])], clean)


def test_a_path_that_turns_back_in_height_is_chained() -> None:
    path = polyline([(0, 0), (40, 0), (40, 30), (20, 30), (20, 10), (5, 10)], 200)
    shuffled = path[np.random.default_rng(7).permutation(len(path))]
    found = shuffled[ordered(shuffled)]
    length = np.hypot(*np.diff(found, axis=0).T).sum()
    assert length == pytest.approx(40 + 30 + 20 + 20 + 15, rel=0.01)


def test_an_order_that_makes_a_path_is_kept() -> None:
    path = polyline([(20, 30), (20, 10), (5, 10)], 60)
    assert ordered(path).tolist() == list(range(len(path)))


def _pure_noise(kind: str) -> Floats:
    rng = np.random.default_rng(3)
    level = np.linspace(0.0, 100.0, 1500)
    return {
        "cloud": 100.0 * rng.random((1500, 2)),
        "walk": np.cumsum(rng.normal(size=(1500, 2)), axis=0) + 200.0,
        "line": np.stack([50.0 + rng.normal(0.0, 3.0, 1500), level], axis=1),
        "zigzag": np.stack([50.0 + 20.0 * (np.arange(1500) % 2), level], axis=1),
    }[kind]


@pytest.mark.parametrize("kind", ["cloud", "walk", "line", "zigzag"])
def test_what_follows_no_path_is_said_at_once(kind: str) -> None:
    with pytest.raises(TraceError, match="scatter"):
        trace(_pure_noise(kind))


def test_few_points_without_a_path_get_an_answer_and_it_says_how_far_it_is() -> None:
    found = trace(100.0 * np.random.default_rng(4).random((90, 2)))
    assert found.largest_deviation > found.tolerance


def _astray(count: int, order: str) -> tuple[Floats, Floats]:
    """Return noisy points of a wave, 6 % of them anywhere, and which ones are far from it."""
    rng = np.random.default_rng(5)
    heights = np.linspace(0.0, 100.0, count)
    points = np.stack([40.0 + 15.0 * np.sin(heights / 16.0), heights], axis=1)
    points += rng.normal(0.0, 0.05, (count, 2))
    away = rng.choice(count, int(0.06 * count), replace=False)
    points[away] = rng.uniform([0.0, 0.0], [80.0, 100.0], (len(away), 2))
    if order == "shuffled":
        points = rng.permutation(points)
    off = np.abs(points[:, 0] - 40.0 - 15.0 * np.sin(points[:, 1] / 16.0))
    return points, off


@pytest.mark.parametrize("order", ["in order", "shuffled"])
def test_many_points_astray_are_left_out_and_the_rest_is_a_few_segments(order: str) -> None:
    points, off = _astray(3000, order)
    found = trace(points[ordered(points)], 0.5)
    assert len(found.profile) <= 3
    # The wave falls by 45 degrees at most: no distance is less than this part of the offset.
    far = points[ordered(points)][np.asarray(found.outliers)]
    assert np.abs(far[:, 0] - 40.0 - 15.0 * np.sin(far[:, 1] / 16.0)).min() > 1.5
    assert len(found.outliers) >= 0.9 * (off > 2.5).sum()
    assert found.largest_deviation <= 1.5
    heights = np.linspace(2.0, 98.0, 50)
    wave = np.stack([40.0 + 15.0 * np.sin(heights / 16.0), heights], axis=1)
    assert distances(found.profile, wave).max() < 0.5


def test_many_scattered_points_are_ordered_along_their_strand() -> None:
    rng = np.random.default_rng(9)
    clean = polyline([(0, 0), (40, 0), (40, 60), (20, 60), (20, 20), (5, 20)], 20_000)
    points = rng.permutation(clean + rng.normal(0.0, 0.1, clean.shape))
    found = points[ordered(points)]
    off = np.hypot(*(found - clean).T)
    # Each is about where its place along the path is: nothing is left for a second strand.
    assert min(off.max(), np.hypot(*(found - clean[::-1]).T).max()) < 1.5


def test_points_alone_nearer_than_outliers_are_missed_where_none_can_reach_them() -> None:
    points = semicircle(50.0, 1500)
    points[400] *= 1.04
    points[1000] *= 0.96
    found = trace(points, 0.8)
    assert found.outliers == ()
    assert len(found.profile) <= 3
    assert 1.0 < found.largest_deviation < 2.1


def test_the_scatter_of_a_smooth_path_is_that_of_its_noise() -> None:
    rng = np.random.default_rng(5)
    clean = wavy(2000)
    assert scatter_of(clean) < 1e-3
    # Also where it is much more than the points are apart.
    for noise in (0.01, 0.3, 3.0):
        found = scatter_of(clean + rng.normal(0.0, noise, clean.shape))
        assert found == pytest.approx(noise, rel=0.15)
