"""One segment: derivatives, curvature, tangents, reversal, invariance."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves import basis
from sgb_core.curves.segment import LAMBDAS, NEUTRAL, NO_EXTRA, Segment, ShapeParameters
from tests.sgb_core.curves.strategies import parameters, segments

SPHERE = np.array([[0.0, 0.0], [1.2, 0.0], [1.2, 2.0], [0.0, 2.0]])


@given(segments())
def test_the_fast_quartic_is_the_reference_quartic(segment) -> None:
    expected = basis.quartic_points(segment.points, segment.shape.leg_fractions)
    np.testing.assert_array_equal(segment.quartic, expected)


@given(segments(), st.floats(0.05, 0.95))
def test_derivatives_match_finite_differences(segment, s) -> None:
    step = 1e-3
    stencil = segment.point([s - 2 * step, s - step, s, s + step, s + 2 * step])
    first = np.array([1, -8, 0, 8, -1]) @ stencil / (12 * step)
    second = np.array([-1, 16, -30, 16, -1]) @ stencil / (12 * step**2)
    np.testing.assert_allclose(segment.derivative(s), first, rtol=0, atol=1e-8)
    np.testing.assert_allclose(segment.derivative(s, 2), second, rtol=0, atol=1e-6)


def test_derivatives_beyond_the_fourth_vanish_and_negative_orders_are_refused() -> None:
    segment = Segment(SPHERE, ShapeParameters(4, 1, 2, 1))
    third = segment.derivative([0.0, 1.0], 3)
    np.testing.assert_allclose(segment.derivative(0.3, 4), third[1] - third[0], atol=1e-12)
    np.testing.assert_array_equal(segment.derivative([0.1, 0.2], 5), np.zeros((2, 2)))
    with pytest.raises(ValueError, match="order"):
        segment.derivative(0.5, -1)


def test_curvature_is_positive_towards_plus_h_and_undefined_where_the_derivative_vanishes() -> None:
    left_turn = Segment([[0, 0], [1, 0], [2, 1], [2, 2]])
    assert (left_turn.curvature(np.linspace(0, 1, 9)) > 0).all()
    flat = left_turn.with_shape(ShapeParameters(4, 3, 4, 1))
    assert np.isnan(flat.curvature([0.0, 1.0])).all()


def test_true_tangents_of_degenerate_ends() -> None:
    flat = Segment(SPHERE, ShapeParameters(4, 3, 4, 1))
    toward = np.array([1.2, 1.0])
    np.testing.assert_allclose(flat.start_tangent(), toward / np.hypot(*toward))
    coincident = Segment([[0, 0], [0, 0], [0, 3], [0, 3]], NEUTRAL)
    np.testing.assert_array_equal(coincident.start_tangent(), [0, 1])
    np.testing.assert_array_equal(coincident.end_tangent(), [0, 1])
    point = Segment(np.ones((4, 2)))
    np.testing.assert_array_equal(point.start_tangent(), [0, 0])
    assert np.isnan(point.curvature([0.0, 0.5])).all()


@given(segments(), parameters)
def test_reversal_is_the_same_curve_run_backwards(segment, s) -> None:
    backwards = segment.reversed()
    np.testing.assert_allclose(backwards.point(1.0 - s), segment.point(s), rtol=0, atol=1e-12)
    assert backwards.reversed().shape.lambda1 == segment.shape.lambda1
    np.testing.assert_array_equal(backwards.reversed().points, segment.points)


@given(segments(), parameters, st.floats(-3, 3), st.floats(-5, 5))
def test_affine_maps_commute_with_evaluation(segment, s, shear, shift) -> None:
    matrix = np.array([[2.0, shear], [0.5, -1.0]])
    mapped = segment.with_points(segment.points @ matrix + shift)
    expected = segment.point(s) @ matrix + shift
    np.testing.assert_allclose(mapped.point(s), expected, rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    "shape", [NEUTRAL, ShapeParameters(1, 3, 1, 0.7), ShapeParameters(4, 0, 2)]
)
def test_neutral_settings_are_the_cubic(shape) -> None:
    s = np.linspace(0, 1, 33)
    np.testing.assert_allclose(
        Segment(SPHERE, shape).point(s), basis.bernstein(3, s) @ SPHERE, atol=1e-15
    )


@given(segments())
def test_any_fractions_of_the_unit_cube_are_reached_at_full_omega(segment) -> None:
    fractions = segment.shape.leg_fractions
    again = ShapeParameters.from_leg_fractions(*fractions).leg_fractions
    np.testing.assert_allclose(again, fractions, rtol=0, atol=1e-15)


@pytest.mark.parametrize(
    "values", [(5, 3, 1, 0), (1, -1, 1, 0), (1, 3, 4.1, 0), (1, 3, 1, 2), (float("nan"), 3, 1, 0)]
)
def test_parameters_out_of_range_are_refused(values) -> None:
    with pytest.raises(ValueError, match="allowed is"):
        ShapeParameters(*values)


def test_bad_control_points_are_refused_and_good_ones_copied() -> None:
    with pytest.raises(ValueError, match="shape"):
        Segment(np.zeros((3, 2)))
    with pytest.raises(ValueError, match="finite"):
        Segment(np.array([[0, 0], [1, np.inf], [2, 2], [3, 3]]))
    mine = SPHERE.copy()
    segment = Segment(mine)
    mine[0] = 9.0
    assert segment.points[0, 0] == 0.0
    with pytest.raises(ValueError, match="read-only"):
        segment.points[0, 0] = 1.0


def test_equality_hash_and_pickling_are_by_value() -> None:
    one, two = Segment(SPHERE), Segment(SPHERE.copy())
    assert one == two
    assert hash(one) == hash(two)
    assert one != Segment(SPHERE, ShapeParameters(omega=1))
    assert one != "a segment"
    assert pickle.loads(pickle.dumps(one)) == one
    assert dict(NO_EXTRA) == {}
    with pytest.raises(KeyError):
        NO_EXTRA["anything"]


@pytest.mark.parametrize("name", LAMBDAS)
def test_neutral_is_what_leaves_omega_nothing_to_do(name):
    assert ShapeParameters(omega=0.5).is_neutral
    shaped = ShapeParameters(**{name: 0.5, "omega": 0.5})
    assert not shaped.is_neutral
    assert shaped.leg_fractions != NEUTRAL.leg_fractions
