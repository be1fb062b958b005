"""Polynomials in Bernstein form: their roots, extremes and products."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves import basis
from sgb_core.curves.roots import dot, evaluate, extremes, real_roots, slow_points
from tests.sgb_core.curves.strategies import segments


@given(st.lists(st.integers(0, 1000), min_size=1, max_size=6, unique=True))
def test_real_roots_finds_separate_roots(numbers) -> None:
    wanted = np.sort(np.array(numbers) / 1000.0)
    # The product of linear factors, in Bernstein form.
    coefficients = np.array([1.0])
    for root in wanted:
        n = len(coefficients)
        k = np.arange(n + 1)
        low = np.append(coefficients, 0.0) * (n - k) / n
        high = np.append(0.0, coefficients) * k / n
        coefficients = -root * low + (1.0 - root) * high
    found = real_roots(coefficients.tolist())
    assert min(abs(evaluate(coefficients.tolist(), s)) for s in [*found, 0.5]) < 1e-12
    for root in wanted:
        assert min(abs(s - root) for s in found) < 1e-2
        # Neighbouring roots make a root ill-conditioned; the value is what is tested then.


def test_real_roots_of_special_polynomials() -> None:
    assert real_roots([0.0, 0.0, 0.0]) == []
    assert real_roots([1.0, 1.0]) == []
    assert real_roots([1.0, 2.0, 3.0]) == []
    assert real_roots([2.0]) == []
    assert real_roots([-1.0, 1.0]) == [0.5]
    # A double root touches zero without changing sign.
    assert real_roots([0.25, -0.25, 0.25]) == pytest.approx([0.5])


@given(st.lists(st.floats(0.05, 0.95), min_size=1, max_size=4, unique=True))
def test_roots_are_found_in_bernstein_form(roots: list[float]) -> None:
    s = np.linspace(0, 1, len(roots) + 1)
    values = np.prod(s[:, None] - np.array(roots), axis=1)
    coefficients = np.linalg.solve(basis.bernstein(len(roots), s), values)
    found = np.array(real_roots(coefficients.tolist()))
    for root in roots:
        assert np.abs(found - root).min() < 1e-3
    assert real_roots([0.0] * 5) == []


@given(st.lists(st.floats(-5.0, 5.0), min_size=1, max_size=8))
def test_extremes_bound_the_values_and_are_reached(coefficients: list[float]) -> None:
    low, high = extremes(coefficients)
    s = np.linspace(0.0, 1.0, 2001)
    values = basis.bernstein(len(coefficients) - 1, s) @ coefficients
    assert low - 1e-12 <= values.min() <= low + 1e-3
    assert high - 1e-3 <= values.max() <= high + 1e-12


@given(segments(), st.floats(0.0, 1.0))
def test_dot_is_the_product_of_the_curves(segment, s: float) -> None:
    slopes = np.diff(segment.quartic, axis=0)
    product = evaluate(dot(segment.quartic, slopes), s)
    scale = 1.0 + float(np.abs(segment.quartic).max()) ** 2
    assert product == pytest.approx(
        float(segment.point(s) @ segment.derivative(s)) / 4.0, abs=1e-12 * scale
    )


def test_slow_points_are_where_the_speed_is_least() -> None:
    # Symmetric about s = 1/2, with a cusp there: the legs of the polygon cross.
    cusp = np.array([[0, 0], [3, 2], [1.5, 3], [0, 2], [3, 0]], dtype=float)
    assert 0.5 in [pytest.approx(s) for s in slow_points(cusp)]
    even = np.linspace([0.0, 0.0], [4.0, 8.0], 5)
    assert slow_points(even) == []
