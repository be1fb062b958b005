import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.hand.coordinates import (
    Area,
    DesignPoint,
    GridSteps,
    ScreenPoint,
    Transform,
    decimals_for,
    nice_step,
    number,
)

coordinates = st.floats(-1e4, 1e4)
scales = st.floats(1e-3, 1e5)
transforms = st.builds(Transform, scales, coordinates, coordinates)


@given(transforms, coordinates, coordinates)
def test_screen_and_back_is_the_same_place(transform, x, y):
    there = transform.to_design(ScreenPoint(x, y))
    assert transform.to_screen(there).distance(ScreenPoint(x, y)) < 1e-6


@given(transforms, coordinates, coordinates, st.floats(0.01, 100.0))
def test_zooming_keeps_what_lies_under_the_cursor(transform, x, y, factor):
    at = ScreenPoint(x, y)
    before = transform.to_design(at)
    assert transform.zoomed(factor, at).to_screen(before).distance(at) < 1e-5


@given(coordinates, coordinates, st.floats(0.0, 1e4), st.floats(0.0, 1e4))
def test_a_fitted_box_lies_in_the_area_and_touches_two_of_its_sides(r, h, width, height):
    area = Area(40.0, 0.0, 340.0, 280.0)
    transform = Transform.fitting((r, h), (r + width, h + height), area)
    a = transform.to_screen(DesignPoint(r, h))
    b = transform.to_screen(DesignPoint(r + width, h + height))
    assert area.grown(1e-6 * (1.0 + abs(r) + abs(h)) * transform.scale).contains(a)
    if max(width, height) > 1e-3 * (1.0 + abs(r) + abs(h)):
        assert math.isclose(b.x - a.x, 300.0, rel_tol=1e-6) or math.isclose(
            a.y - b.y, 280.0, rel_tol=1e-6
        )


@given(st.floats(1e-9, 1e9))
def test_steps_are_one_two_five_and_hardly_larger_than_asked(least):
    step = nice_step(least)
    leading = step / 10.0 ** math.floor(math.log10(step) + 1e-9)
    assert min(abs(leading - k) for k in (1, 2, 5)) < 1e-6
    assert least * (1 - 1e-6) <= step <= 2.5 * least * (1 + 1e-6)


@given(scales)
def test_fine_lines_divide_the_numbered_ones_and_are_never_too_dense(scale):
    steps = GridSteps.at(scale)
    assert steps.major / steps.minor == pytest.approx(round(steps.major / steps.minor))
    assert steps.minor * scale > 12.0
    assert 61.9 < steps.major * scale < 156.0


def test_snapped_values_are_the_short_ones():
    steps = GridSteps(0.5, 0.1)
    assert steps.snapped(0.31) == 0.3
    assert steps.snapped(-0.74) == -0.7
    assert GridSteps(20.0, 5.0).snapped(12.6) == 15.0


def test_numbers_have_a_true_minus_and_no_negative_zero():
    assert number(-0.004, 2) == "0.00"
    assert number(-12.5, 1) == "−12.5"
    assert decimals_for(0.02) == 2
    assert decimals_for(50.0) == 0
