"""The fan of a parameter: each curve is the segment's own at that value."""

from dataclasses import replace

import numpy as np
import pytest

from sgb_core.curves.nearest import farthest
from sgb_core.curves.parameter_fan import SLID, TOWARDS, most_telling, parameter_fan, reach
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import PARAMETER_RANGES, PARAMETERS, Segment, ShapeParameters

SEGMENTS = (
    Segment([[1, 0], [4, 2], [3, 5], [6, 9]], ShapeParameters(0.5, 4.0, 2.0, 0.7)),
    Segment([[6, 9], [5, 11], [2, 12], [0, 12]], ShapeParameters(3.0, 1.0, 0.0, 0.2)),
)


@pytest.mark.parametrize("parameter", PARAMETERS)
def test_every_curve_of_the_fan_is_the_segments_own(parameter):
    found = parameter_fan(SEGMENTS, parameter, 7)
    assert found.shape == (2, 7, 5, 2)
    for segment, curves in zip(SEGMENTS, found, strict=True):
        values = np.linspace(*PARAMETER_RANGES[parameter], 7)
        for value, quartic in zip(values.tolist(), curves, strict=True):
            shape = replace(segment.shape, **{parameter: value})
            np.testing.assert_allclose(quartic, segment.with_shape(shape).quartic, atol=1e-14)


@pytest.mark.parametrize("parameter", PARAMETERS)
def test_what_a_parameter_slides_and_nears(parameter):
    (first, *_, last) = parameter_fan(SEGMENTS[:1], parameter)[0]
    moved = [k for k in range(3) if not np.allclose(first[k + 1], last[k + 1])]
    assert tuple(moved) == SLID[parameter]
    for point in TOWARDS[parameter]:
        target = SEGMENTS[0].points[point]
        reach = [np.linalg.norm(ends[1:4] - target, axis=1).min() for ends in (first, last)]
        assert reach[0] != pytest.approx(reach[1])


def test_without_segments_there_is_no_fan():
    assert parameter_fan((), "omega").shape == (0, 9, 5, 2)


def test_at_omega_0_a_lambda_is_shown_as_it_will_show():
    points = SEGMENTS[0].points
    idle = Segment(points, ShapeParameters(2.0, 5.0, 3.0, 0.0))
    for parameter in ("lambda1", "lambda2", "lambda3"):
        awake = parameter_fan([Segment(points, ShapeParameters(omega=1.0))], parameter)
        np.testing.assert_array_equal(parameter_fan([idle], parameter), awake)
    assert np.ptp(parameter_fan([idle], "lambda2"), axis=1).max() > 0.1


def test_most_is_seen_where_the_curve_moves_farthest_across_itself():
    bulge = Segment([[20, 0], [55, 10], [50, 60], [25, 80]])
    straight = Segment([[25, 80], [25, 180], [25, 280], [25, 380]])
    assert reach(straight, "lambda2") == pytest.approx(0.0, abs=1e-9)
    (low, high) = parameter_fan([bulge], "lambda2", 2)[0]
    # Q2 weighs 3/8 in the middle, and slides along the whole of the middle leg.
    assert np.hypot(*(high[2] - low[2])) == pytest.approx(np.hypot(5, 50))
    assert 0.0 < reach(bulge, "lambda2") <= 0.375 * np.hypot(5, 50) + 1e-9
    assert most_telling(Profile.of([straight, bulge.reversed()], ["free"])) == 1


@pytest.mark.parametrize("omega", [0.5, 1.0])
def test_the_reach_is_how_far_the_two_ends_of_the_range_lie_apart(omega):
    # An even arch: in its middle λ2 moves the curve along itself, beside it across.
    arch = Segment([[10, 0], [40, 10], [40, 50], [10, 60]], ShapeParameters(omega=omega))
    ends = [arch.with_shape(replace(arch.shape, lambda2=value)) for value in (0.0, 6.0)]
    apart = farthest(ends[:1], ends[1:])
    assert apart > 2.0
    assert reach(arch, "lambda2") == pytest.approx(apart, rel=0.05)


def test_where_a_curve_halts_all_of_the_way_is_seen():
    point = Segment(np.full((4, 2), 5.0))
    assert reach(point, "lambda2") == 0.0
