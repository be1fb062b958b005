"""The fan of a parameter: each curve is the segment's own at that value."""

from dataclasses import replace

import numpy as np
import pytest

from sgb_core.curves.parameter_fan import SLID, TOWARDS, parameter_fan
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
