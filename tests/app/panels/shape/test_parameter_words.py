"""What the sliders say they do is what they do."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.panels.shape import parameter_words
from app.panels.shape.parameter_words import (
    direction,
    effect,
    hint,
    tooltip,
    without_effect,
)
from sgb_core.curves.segment import PARAMETER_RANGES, PARAMETERS, SYMBOLS, Segment, ShapeParameters
from sgb_core.surfaces.variation import Law

BULGE = np.array([(10.0, 0.0), (30.0, 5.0), (30.0, 35.0), (10.0, 40.0)])
coordinates = st.floats(-50, 50)
polygons = st.lists(st.tuples(coordinates, coordinates), min_size=4, max_size=4)
shapes = st.builds(
    ShapeParameters,
    *(st.floats(*PARAMETER_RANGES[name]) for name in PARAMETERS),
)


@given(polygons, shapes, st.sampled_from(PARAMETERS))
def test_the_effect_is_the_derivative_of_the_curve(points, shape, parameter):
    low, high = PARAMETER_RANGES[parameter]
    values = {name: getattr(shape, name) for name in PARAMETERS}
    # The curve is linear in each parameter, so any difference is the derivative.
    ends = [
        Segment(points, ShapeParameters(**{**values, parameter: value})).point(0.5)
        for value in (low, high)
    ]
    slope = (ends[1] - ends[0]) / (high - low)
    assert effect(Segment(points, shape), parameter) == pytest.approx(slope, abs=1e-9)


@given(polygons, shapes, st.sampled_from(PARAMETERS))
def test_what_is_said_to_have_no_effect_has_none(points, shape, parameter):
    segment = Segment(points, shape)
    if without_effect(segment, parameter):
        size = max(segment.size, 1.0)
        assert effect(segment, parameter) == pytest.approx((0.0, 0.0), abs=1e-9 * size)


def test_why_a_slider_does_nothing():
    cubic = Segment(BULGE)
    # Its slider sets ω to 1 with the first tick.
    assert without_effect(cubic, "lambda1") == ""
    assert "sets it to 1" in tooltip(cubic, 0, "lambda1")
    assert "λ = 1, 3, 1" in without_effect(cubic, "omega")
    assert without_effect(Segment(BULGE, ShapeParameters(2, 3, 1, 0.5)), "omega") == ""
    assert without_effect(Segment(BULGE, ShapeParameters(omega=0.5)), "lambda2") == ""
    stuck = Segment([BULGE[0], BULGE[0], BULGE[2], BULGE[3]], ShapeParameters(omega=1.0))
    assert "P0 and P1 coincide" in without_effect(stuck, "lambda1")


def test_the_hint_in_the_card():
    assert hint(Segment(BULGE)) == "Plain cubic: moving a λ sets ω to 1."
    assert hint(Segment(BULGE, ShapeParameters(2, 3, 1, 0))) == hint(Segment(BULGE))
    assert hint(Segment(BULGE, ShapeParameters(omega=1))) == "ω has no effect while λ = 1, 3, 1."
    assert hint(Segment(BULGE, ShapeParameters(2, 3, 1, 1))) == ""


@pytest.mark.parametrize(
    ("vector", "words"),
    [
        ((1, 0), "outwards"),
        ((-1, 0.1), "inwards"),
        ((0, 2), "up"),
        ((1, -1), "outwards and down"),
        ((0, 0), ""),
    ],
)
def test_directions_in_words(vector, words):
    assert direction(vector) == words


def test_tooltips_name_end_circle_direction_and_range():
    segment = Segment(BULGE, ShapeParameters(1, 3, 1, 0.5))
    first = tooltip(segment, 2, "lambda1")
    assert "lower end of segment 3 (λ1)" in first
    assert "Less: Q1 slides towards P1’s circle (✱), outwards" in first
    assert "0 to 4, neutral 1" in first
    assert "More: Q2 slides towards P1’s circle" in tooltip(segment, 0, "lambda2")
    third = tooltip(segment, 0, "lambda3")
    assert "upper end" in third
    assert "P2’s circle (○), outwards" in third
    assert "0 to 1, neutral 0" in tooltip(segment, 0, "omega")


@pytest.mark.parametrize(
    ("shape", "words"),
    [
        ((2, 3, 2, 0.5), "above 1: away from the corners P1 and P2. More: Q1 to P0, Q3 to P3;"),
        ((0.5, 3, 0.5, 0.5), "below 1: into the corners P1 and P2. More: Q1 to P1, Q3 to P2;"),
        ((0.5, 4, 2, 0.5), "one below. More: Q1 to P1, Q2 to P1, Q3 to P3"),
        ((0.5, 3, 1, 0.5), "λ1 alone off neutral. More: Q1 to P1; the middle moves outwards"),
        ((1, 3, 2, 0.5), "λ3 alone off neutral. More: Q3 to P3; the middle moves inwards"),
        ((1, 2, 1, 0.5), "λ1 and λ3 neutral. More: Q2 to P2"),
        ((1, 3, 1, 0.5), "no effect while λ = 1, 3, 1"),
    ],
)
def test_omega_names_the_case_and_what_each_q_does(shape, words):
    assert words in tooltip(Segment(BULGE, ShapeParameters(*shape)), 0, "omega")


@given(polygons, shapes)
def test_each_q_goes_where_the_tooltip_of_omega_says(points, shape):
    segment = Segment(points, shape)
    text = tooltip(segment, 0, "omega")
    less, more = (
        Segment(points, replace(shape, omega=value)).quartic[1:4] for value in (0.25, 0.75)
    )
    for number, name in enumerate(("Q1", "Q2", "Q3")):
        for k, goal in enumerate(segment.points):
            if f"{name} to P{k}" in text:
                near, far = (np.linalg.norm(q[number] - goal) for q in (more, less))
                assert near <= far + 1e-9


def test_ends_are_named_by_where_they_lie():
    assert parameter_words.end_name(Segment(BULGE), True) == "lower end"
    assert parameter_words.end_name(Segment(BULGE[::-1]), True) == "upper end"
    floor = Segment([(0, 0), (1, 0), (2, 0), (3, 0)])
    assert parameter_words.end_name(floor, True) == "inner end"
    assert parameter_words.end_name(floor, False) == "outer end"
    assert parameter_words.end_name(Segment(np.ones((4, 2))), False) == "end"


def test_a_law_is_said():
    law = Law("omega", "raised-cosine", 0.0, 1.0, segments=(1,))
    assert parameter_words.law_note((law,), 0, "omega") == ""
    assert "from 0 to 1 (raised-cosine)" in parameter_words.law_note((law,), 1, "omega")
    assert SYMBOLS["omega"] == "ω"
