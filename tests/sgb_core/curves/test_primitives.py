"""Lines, cubics and arcs."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.primitives import arc, cubic, line
from sgb_core.curves.segment import NEUTRAL, READY
from tests.sgb_core.curves.strategies import points

S = np.linspace(0.0, 1.0, 2001)


@given(points, points)
def test_a_line_is_straight_and_of_constant_speed(start, end) -> None:
    p, q = np.array(start), np.array(end)
    np.testing.assert_allclose(line(p, q).point(S), p + S[:, None] * (q - p), atol=1e-13)


def test_a_cubic_is_its_control_points() -> None:
    segment = cubic([[0, 0], [1, 2], [3, 4], [5, 6]])
    # The same curve, with every λ in effect.
    assert segment.shape == READY
    assert segment.shape.leg_fractions == NEUTRAL.leg_fractions
    assert segment.points[1].tolist() == [1.0, 2.0]


@given(
    points,
    st.floats(0.1, 100.0),
    st.floats(-7.0, 7.0),
    st.floats(0.01, 1.5 * pi).flatmap(lambda v: st.sampled_from([v, -v])),
)
def test_an_arc_meets_its_ends_and_tangents_and_says_its_deviation(
    center, radius, start, sweep
) -> None:
    segment, deviation = arc(center, radius, start, start + sweep)
    for s, angle in ((0.0, start), (1.0, start + sweep)):
        outward = np.array([np.cos(angle), np.sin(angle)])
        ahead = np.array([-np.sin(angle), np.cos(angle)]) * np.sign(sweep)
        np.testing.assert_allclose(
            segment.point(s), center + radius * outward, atol=1e-11 * radius + 1e-13
        )
        v = segment.derivative(s)
        np.testing.assert_allclose(v / np.hypot(*v), ahead, atol=1e-8)
    error = np.hypot(*(segment.point(S) - np.array(center)).T) - radius
    assert np.abs(error).max() <= deviation * 1.01 + 1e-12 * radius
    assert deviation <= 4e-3 * radius
    assert (segment.curvature(0.0) > 0) == (sweep > 0)


def test_the_semicircle_is_at_the_known_optimum() -> None:
    """The least largest radial error of a symmetric segment, found apart by a simplex search."""
    segment, deviation = arc((0, 1), 1.0, -pi / 2, pi / 2)
    assert deviation == pytest.approx(1.5664e-4, rel=1e-3)
    error = np.hypot(*(segment.point(S) - [0, 1]).T) - 1.0
    extremes = [error[:400].max(), -error.min(), error[800:1200].max()]
    np.testing.assert_allclose(extremes, deviation, rtol=2e-3)


@pytest.mark.parametrize(
    ("radius", "sweep", "message"), [(0.0, 1.0, "radius"), (1.0, 0.0, "sweep"), (1.0, 5.0, "sweep")]
)
def test_impossible_arcs_are_refused(radius, sweep, message) -> None:
    with pytest.raises(ValueError, match=message):
        arc((0, 0), radius, 0.0, sweep)
