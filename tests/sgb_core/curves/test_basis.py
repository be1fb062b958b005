"""The basis (13), the matrix (1) and the quartic form, against each other."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sgb_core.curves import basis
from tests.sgb_core.curves.strategies import parameters, points, shapes

# The basis is linear in each λ and in ω and of degree 4 in s: two values of each parameter and
# five of s decide an identity. These are dyadic, so nothing below is rounded.
GRID = list(product((0.0, 2.0), (0.0, 6.0), (0.0, 2.0), (0.0, 1.0)))
PLACES = np.array([0.0, 0.25, 0.5, 0.75, 1.0])


@pytest.mark.parametrize("values", GRID)
def test_power_matrix_is_the_basis_identically(values) -> None:
    powers = PLACES[:, None] ** np.arange(5)
    np.testing.assert_array_equal(
        powers @ basis.power_matrix(*values), basis.sg_basis(*values, PLACES)
    )


@pytest.mark.parametrize("values", GRID)
def test_quartic_form_is_the_basis_identically(values) -> None:
    polygon = np.array([[1.0, 0.0], [8.0, 32.0], [-4.0, 64.0], [2.0, -16.0]])
    quartic = basis.quartic_points(polygon, basis.leg_fractions(*values))
    np.testing.assert_array_equal(
        basis.bernstein(4, PLACES) @ quartic, basis.sg_basis(*values, PLACES) @ polygon
    )


@given(shapes(), parameters)
def test_basis_is_a_partition_of_unity_without_negative_values(shape, s) -> None:
    values = basis.sg_basis(shape.lambda1, shape.lambda2, shape.lambda3, shape.omega, s)
    assert abs(values.sum() - 1.0) < 1e-14
    assert (values >= -1e-16).all()
    powers = s ** np.arange(5)
    matrix = basis.power_matrix(shape.lambda1, shape.lambda2, shape.lambda3, shape.omega)
    np.testing.assert_allclose(powers @ matrix, values, rtol=0, atol=1e-13)


@given(shapes())
def test_leg_fractions_stay_in_the_unit_cube(shape) -> None:
    assert all(0.0 <= fraction <= 1.0 for fraction in shape.leg_fractions)


@pytest.mark.parametrize("values", GRID)
def test_leg_fraction_rates_are_the_differences(values) -> None:
    by_lambda, by_omega = basis.leg_fraction_rates(*values)
    # The fractions are linear in each parameter: half a unit either way gives the rate.
    for k in range(4):
        low, high = (tuple(v + d * (i == k) for i, v in enumerate(values)) for d in (-0.5, 0.5))
        change = np.subtract(basis.leg_fractions(*high), basis.leg_fractions(*low))
        expected = by_omega if k == 3 else [r * (leg == k) for leg, r in enumerate(by_lambda)]
        np.testing.assert_allclose(change, expected, rtol=0, atol=1e-15)


@given(shapes())
def test_lambda_at_undoes_the_leg_fractions(shape) -> None:
    assume(shape.omega > 0.01)
    solved = [basis.lambda_at(k, f, shape.omega) for k, f in enumerate(shape.leg_fractions)]
    np.testing.assert_allclose(
        solved, (shape.lambda1, shape.lambda2, shape.lambda3), rtol=0, atol=1e-15 / shape.omega * 4
    )


@given(st.lists(points, min_size=4, max_size=4), shapes(), parameters)
def test_quartic_points_give_the_curve_of_the_basis(polygon, shape, s) -> None:
    p = np.array(polygon)
    quartic = basis.quartic_points(p, shape.leg_fractions)
    values = basis.sg_basis(shape.lambda1, shape.lambda2, shape.lambda3, shape.omega, s)
    np.testing.assert_allclose(basis.bernstein(4, s) @ quartic, values @ p, rtol=0, atol=1e-13)


def test_quartic_points_broadcast_over_shapes() -> None:
    polygon = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    a = np.array([0.0, 0.5, 1.0])
    result = basis.quartic_points(polygon, (a, 0.5, 0.75))
    assert result.shape == (3, 5, 2)
    np.testing.assert_array_equal(result[:, 1, 0], a)
