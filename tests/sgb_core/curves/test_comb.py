"""The curvature comb against the segments' own curvature."""

from __future__ import annotations

import numpy as np
import pytest

from sgb_core.curves.comb import comb
from sgb_core.curves.nearest import arc_length
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters

PROFILE = Profile(
    (
        Segment([[0, 3], [0, 1], [1, 0], [3, 0]], ShapeParameters(4, 3, 1, 1)),
        Segment([[3, 0], [5, 0], [7, 1], [7, 3]], ShapeParameters(1, 2, 3, 0.5)),
    )
)


def test_comb_matches_the_segments() -> None:
    result = comb(PROFILE, 33)
    s = np.linspace(0.0, 1.0, 33)
    for k, segment in enumerate(PROFILE.segments):
        np.testing.assert_allclose(result.positions[k], segment.point(s), atol=1e-15)
        np.testing.assert_allclose(result.curvature[k], segment.curvature(s), rtol=1e-10)
        along = (result.normals[k] * segment.derivative(s)).sum(axis=1)
        np.testing.assert_allclose(along[1:], 0.0, atol=1e-12)
    assert np.isnan(result.curvature[0, 0])
    assert np.isnan(result.normals[0, 0]).all()
    assert np.isfinite(result.curvature[0, 1:]).all()


def test_distance_runs_along_the_chain() -> None:
    result = comb(PROFILE, 400)
    assert result.distance[0, 0] == 0.0
    assert result.distance[1, 0] == result.distance[0, -1]
    whole = sum(arc_length(segment) for segment in PROFILE.segments)
    assert result.distance[-1, -1] == pytest.approx(whole, rel=1e-5)


def test_profiles_without_extent_have_no_curvature() -> None:
    result = comb(Profile((Segment(np.ones((4, 2))),)), 5)
    assert np.isnan(result.curvature).all()
    with pytest.raises(ValueError, match="at least 2"):
        comb(PROFILE, 1)
