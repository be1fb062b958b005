from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.transfinite import (
    closed_form,
    half_turn_cosine_sine,
    half_turn_parameter,
    interpolant,
    samelson_inverse,
    turn_angle,
    turn_parameter,
)
from tests.sgb_core.surfaces.chains import TOWER, chain


@pytest.mark.parametrize("axis", Axis)
@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_construction_closed_form_and_surface_agree(axis: Axis, sense: float) -> None:
    surface = RevolutionSurface(chain(TOWER, (4, 3, 4, 0.7)), axis)
    s, t = np.meshgrid(np.linspace(0, 1, 17), np.linspace(0, 1, 33), indexing="ij")
    for segment in range(3):
        start, quarter, half = (surface.point(segment, s, sense * a) for a in (0.0, pi / 2, pi))
        built = interpolant(start, quarter, half, t)
        np.testing.assert_allclose(built, closed_form(start, quarter, half, t), rtol=0, atol=1e-12)
        turned = surface.point(segment, s, sense * turn_angle(t))
        np.testing.assert_allclose(built, turned, rtol=0, atol=1e-12)


@given(st.floats(0.0, 2 * pi))
def test_the_rational_parameter_measures_the_angle(theta: float) -> None:
    u = turn_parameter(theta)
    assert turn_angle(u) == pytest.approx(theta, abs=1e-14)
    cosine, sine = half_turn_cosine_sine(1.0 - np.abs(1.0 - u))
    assert cosine == pytest.approx(np.cos(theta), abs=1e-14)
    assert np.copysign(sine, np.sin(theta)) == pytest.approx(np.sin(theta), abs=1e-14)


def test_theta_over_pi_is_right_only_at_its_three_points() -> None:
    np.testing.assert_allclose(half_turn_parameter([0.0, pi / 2, pi]), [0.0, 0.5, 1.0], atol=1e-15)
    assert abs(half_turn_parameter(pi / 4) - 0.25) > 0.03


def test_on_the_axis_only_the_closed_form_is_defined() -> None:
    point = np.array([1.0, 0.0, 0.0])
    np.testing.assert_array_equal(closed_form(point, point, point, 0.3), point)
    with pytest.raises(ValueError, match="undefined"):
        interpolant(point, point, point, 0.3)
    np.testing.assert_array_equal(samelson_inverse([0.0, 2.0]), [0.0, 0.5])
