"""Quartics as cubics: within the tolerance, tangent at the seams, exact where possible."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.basis import bernstein
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.surfaces.cubics import cubic_pieces, stretch

POINTS = st.lists(st.tuples(st.floats(-10, 10), st.floats(-10, 10)), min_size=4, max_size=4).map(
    np.array
)
FRACTION = st.floats(0, 1)


@given(POINTS, st.tuples(FRACTION, FRACTION, FRACTION), st.sampled_from([1e-2, 1e-4, 1e-7]))
def test_the_cubics_stay_within_the_tolerance(points, fractions, tolerance):
    segment = Segment(points, ShapeParameters.from_leg_fractions(*fractions))
    pieces = cubic_pieces(segment.quartic, tolerance)
    s = np.linspace(0, 1, 41)
    for k, piece in enumerate(pieces):
        true = segment.point((k + s) / len(pieces))
        assert np.abs(bernstein(3, s) @ piece - true).max() <= tolerance + 1e-12


@given(POINTS)
def test_a_plain_cubic_is_one_piece_with_its_own_points(points):
    (piece,) = cubic_pieces(Segment(points).quartic, 1e-9)
    assert np.allclose(piece, points, rtol=0, atol=1e-13 * 10)


def test_a_tolerance_of_zero_is_refused():
    with pytest.raises(ValueError, match="above 0"):
        cubic_pieces(np.zeros((5, 2)), 0.0)


@pytest.mark.parametrize(("start", "end"), [(0.0, 1.0), (0.2, 0.7), (0.9, 0.1), (0.0, 0.4)])
def test_a_stretch_is_the_same_curve(start: float, end: float) -> None:
    quartic = np.random.default_rng(3).normal(size=(5, 2))
    part = stretch(quartic, start, end)
    u = np.linspace(0.0, 1.0, 17)
    expected = bernstein(4, start + (end - start) * u) @ quartic
    assert np.allclose(bernstein(4, u) @ part, expected, atol=1e-12)
