"""Nearest points against dense sampling, lengths against closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from sgb_core.curves.nearest import arc_length, distances, nearest
from sgb_core.curves.primitives import arc, line
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from tests.sgb_core.curves.strategies import chains, points, segments

DENSE = np.linspace(0.0, 1.0, 4001)


@settings(max_examples=60)
@given(chains(JointRule.G0, most=3), points)
def test_nothing_is_nearer(profile, point) -> None:
    found = nearest(profile, point)
    sampled = np.hypot(*np.moveaxis(profile.sample(1001) - np.array(point), -1, 0)).min()
    assert found.distance <= sampled + 1e-12
    place = profile.point(found.segment, found.s)
    np.testing.assert_allclose(place, found.point, atol=1e-12)
    assert np.hypot(*(place - point)) == pytest.approx(found.distance, abs=1e-12)


@given(segments(), st.floats(0.0, 1.0))
def test_points_of_the_curve_are_at_distance_zero(segment, s) -> None:
    found = nearest(Profile((segment,)), segment.point(s))
    assert found.distance <= 1e-7 * (1 + segment.size)


def test_many_distances_at_once() -> None:
    segment = Segment([[0, 0], [4, 0], [4, 4], [0, 1]], ShapeParameters(0.5, 5, 2, 1))
    rng = np.random.default_rng(4)
    cloud = rng.uniform(-2, 5, size=(40, 2))
    exact = [nearest(Profile((segment,)), p).distance for p in cloud]
    np.testing.assert_allclose(distances(segment, cloud), exact, atol=1e-9)


def test_lengths_with_closed_forms() -> None:
    assert arc_length(line((1, 1), (4, 5))) == pytest.approx(5.0, rel=1e-15)
    assert arc_length(Segment(np.ones((4, 2)))) == 0.0
    # A parabola as a cubic: y = x² over [0, 1].
    parabola = Segment([[0, 0], [1 / 3, 0], [2 / 3, 1 / 3], [1, 1]])
    exact = 0.5 * np.sqrt(5) + 0.25 * np.arcsinh(2)
    assert arc_length(parabola) == pytest.approx(exact, rel=1e-14)
    # The same line run back and forth, with vanishing derivatives at the ends and on the way.
    back = Segment([[0, 0], [4, 0], [-3, 0], [1, 0]], ShapeParameters(4, 3, 4, 1))
    turns = np.abs(np.diff(back.point(DENSE)[:, 0])).sum()
    assert arc_length(back) == pytest.approx(turns, rel=1e-5)
    circle, deviation = arc((0, 0), 1.0, 0.0, np.pi / 2)
    assert arc_length(circle) == pytest.approx(np.pi / 2, abs=4 * deviation)


@settings(max_examples=40)
@given(segments(), st.floats(0.0, 1.0))
@example(Segment([(7.188, 0), (1.602, 0), (0.703, 0), (1.602, 0)]), 0.474609375)
def test_length_is_additive_and_above_every_polyline(segment, s) -> None:
    whole = arc_length(segment)
    parts = arc_length(segment, 0.0, s) + arc_length(segment, s, 1.0)
    assert parts == pytest.approx(whole, rel=1e-12, abs=1e-12)
    polyline = np.hypot(*np.diff(segment.point(DENSE), axis=0).T).sum()
    assert polyline <= whole * (1 + 1e-12) + 1e-10
    assert whole <= polyline * (1 + 1e-5) + 1e-9
