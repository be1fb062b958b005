"""Along the arc length: against closed forms of lines and arcs, and against the curve itself."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from sgb_core.curves.along import along
from sgb_core.curves.nearest import arc_length
from sgb_core.curves.primitives import arc, line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters

BENT = Segment([(20, 0), (45, 5), (50, 30), (35, 50)], ShapeParameters(2.0, 4.0, 0.5, 0.9))


def test_a_line_is_straight_and_its_own_cubic() -> None:
    (found,) = along(Profile.of([line((0, 0), (30, 40))]), 11)
    assert found.length == pytest.approx(np.linspace(0.0, 50.0, 11))
    assert np.abs(found.curvature).max() < 1e-12
    assert np.abs(found.deviation).max() < 1e-9


def test_an_arc_has_its_length_and_curvature() -> None:
    quarter, off = arc((0, 0), 10.0, 0.0, pi / 2)
    (found,) = along(Profile.of([quarter]), 101)
    assert found.length[-1] == pytest.approx(5.0 * pi, abs=off)
    assert found.curvature == pytest.approx(np.full(101, 0.1), rel=0.02)


def test_lengths_go_on_from_segment_to_segment() -> None:
    profile = Profile.of([BENT, line((35, 50), (35, 80))])
    first, last = along(profile, 9)
    assert first.length[-1] == pytest.approx(arc_length(BENT), rel=1e-12)
    assert last.length[0] == pytest.approx(first.length[-1], rel=1e-12)
    assert last.length[-1] - last.length[0] == pytest.approx(30.0)
    for s, length in zip(first.s.tolist(), first.length.tolist(), strict=True):
        assert length == pytest.approx(arc_length(BENT, 0.0, s), rel=1e-6, abs=1e-9)


def test_the_deviation_is_that_from_the_plain_cubic() -> None:
    (found,) = along(Profile.of([BENT]), 21)
    plain = BENT.with_shape(ShapeParameters()).point(np.linspace(0.0, 1.0, 20_001))
    gaps = np.hypot(*(found.points[:, None] - plain[None]).transpose(2, 0, 1)).min(axis=1)
    assert found.deviation == pytest.approx(gaps, abs=1e-3)
    assert found.deviation.max() > 0.5


def test_an_end_without_a_derivative_has_no_curvature() -> None:
    still = BENT.with_shape(ShapeParameters(4.0, 3.0, 1.0, 1.0))
    (found,) = along(Profile.of([still]), 5)
    assert np.isnan(found.curvature[0])
    assert np.isfinite(found.curvature[1:]).all()
