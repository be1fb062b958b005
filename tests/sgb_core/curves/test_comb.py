"""The curvature comb against the segments' own curvature, its sign and its scale."""

from __future__ import annotations

import numpy as np
import pytest

from sgb_core.curves.comb import comb, outward_sign, typical_curvature
from sgb_core.curves.nearest import arc_length
from sgb_core.curves.primitives import arc, line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from tests.app.helpers import tower

PROFILE = Profile(
    (
        Segment([[0, 3], [0, 1], [1, 0], [3, 0]], ShapeParameters(4, 3, 1, 1)),
        Segment([[3, 0], [5, 0], [7, 1], [7, 3]], ShapeParameters(1, 2, 3, 0.5)),
    )
)
# Up a straight wall, then round a shoulder of radius 10.
WALL = Profile.of([line((20, 0), (20, 30)), arc((10, 30), 10.0, 0.0, np.pi / 2)[0]], ["G1"])


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
    with pytest.raises(ValueError, match="2 or more"):
        comb(PROFILE, 1)


def test_the_sign_says_outward_whichever_way_the_profile_runs() -> None:
    assert outward_sign(WALL) == 1.0
    assert outward_sign(WALL.reversed()) == -1.0
    for profile in (WALL, WALL.reversed()):
        bends = outward_sign(profile) * comb(profile, 9).curvature
        assert bends.max() == pytest.approx(0.1, rel=0.02)
        assert bends.min() > -1e-3
    ring = edits.close_profile(tower()).profile
    assert outward_sign(ring) == -outward_sign(ring.reversed())


def test_one_cusp_does_not_set_the_scale() -> None:
    cusp = arc((10, 40.01), 0.01, np.pi / 2 * -1, np.pi / 2)[0]
    points = np.array(cusp.points) + (WALL.segments[1].points[3] - cusp.points[0])
    sharp = Profile((*WALL.segments, cusp.with_points(points)), ("G1", "G0"))
    assert typical_curvature(comb(sharp, 41)) == pytest.approx(0.1, rel=0.02)
    assert typical_curvature(comb(Profile.of([line((1, 0), (1, 2))]), 9)) == 0.0
