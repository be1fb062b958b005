from dataclasses import replace
from math import pi, radians, tan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.scene.camera import MARGIN, VIEW_ANGLE, axis_frame, standard_pose
from app.scene.standard_views import STANDARD_VIEWS
from sgb_core.surfaces.revolution import Axis

angles = st.floats(-3.0, 3.0)
axes = st.sampled_from(list(Axis))


def projected(pose, points):
    """Return where points appear, in half-heights from the middle of the picture."""
    eye = (np.asarray(points, float) - np.asarray(pose.focal)) @ pose.basis.T
    depth = 1.0 if pose.parallel else 1.0 - eye[..., 2] / pose.distance
    return (eye[..., :2].T / (depth * pose.parallel_scale)).T


@given(axes, angles, angles)
def test_basis_is_right_handed_and_upright(axis, azimuth, elevation):
    pose = standard_pose(axis).orbited(azimuth, elevation)
    assert np.allclose(pose.basis @ pose.basis.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(pose.basis) == pytest.approx(1.0)
    height = axis_frame(axis)[2]
    # No roll: the axis never leans in the picture, and never points down.
    assert abs(pose.basis[0] @ height) < 1e-12
    assert pose.basis[1] @ height >= -1e-12


@given(axes, angles, angles, st.tuples(angles, angles, angles), st.booleans())
def test_orbit_keeps_the_pivot_in_its_place(axis, azimuth, elevation, pivot, parallel):
    pose = replace(standard_pose(axis, parallel=parallel), pivot=pivot, distance=20.0)
    turned = pose.orbited(azimuth, elevation)
    assert np.allclose(projected(pose, pivot), projected(turned, pivot), atol=1e-9)


@given(st.floats(0.2, 5.0), angles, angles)
def test_zoom_keeps_what_is_at_the_cursor(factor, x, y):
    pose = replace(standard_pose(Axis.Z), distance=20.0)
    at_cursor = np.asarray(pose.focal) + (np.array([x, y]) * pose.parallel_scale) @ pose.basis[:2]
    zoomed = pose.zoomed(factor, x, y)
    assert projected(zoomed, at_cursor) == pytest.approx([x, y], abs=1e-9)
    assert zoomed.distance == pytest.approx(20.0 * factor)


def test_pan_follows_the_hand():
    pose = replace(standard_pose(Axis.Y), distance=20.0)
    focal = pose.focal
    assert projected(pose.panned(0.3, -0.2), focal) == pytest.approx([0.3, -0.2])


@given(axes, angles, st.floats(0.4, 3.0), st.booleans(), st.integers(0, 1000))
def test_fit_touches_the_margin_and_cuts_nothing(axis, azimuth, aspect, parallel, seed):
    points = np.random.default_rng(seed).normal(size=(40, 3)) * [1, 5, 2] + [100, 0, -7]
    pose = standard_pose(axis, parallel=parallel).orbited(azimuth, 0.0).fitted(points, aspect)
    seen = np.abs(projected(pose, points)) / [aspect, 1.0]
    assert seen.max() == pytest.approx(1.0 - MARGIN, rel=1e-6)


@pytest.mark.parametrize("axis", list(Axis))
def test_front_view_shows_the_profile_plane_as_the_editor_does(axis):
    pose = standard_pose(axis, "front")
    start, _, height = axis_frame(axis)
    assert pose.basis[0] == pytest.approx(start)
    assert pose.basis[1] == pytest.approx(height)


def test_front_of_the_z_axis_looks_along_y():
    assert -standard_pose(Axis.Z, "front").basis[2] == pytest.approx([0, 1, 0])


@pytest.mark.parametrize(
    ("one", "other"), [("front", "back"), ("left", "right"), ("top", "bottom")]
)
def test_opposite_views_look_opposite_ways(one, other):
    first, second = (standard_pose(Axis.X, name) for name in (one, other))
    assert first.basis[2] == pytest.approx(-second.basis[2])


def test_all_views_are_turns_that_the_turntable_reaches():
    for view in STANDARD_VIEWS.values():
        azimuth, elevation = view.direction
        pose = standard_pose(Axis.Z).turned_to(azimuth, elevation)
        assert (pose.azimuth, pose.elevation) == (azimuth, elevation)
        assert abs(elevation) <= pi / 2


@given(axes, axes)
def test_changing_the_axis_carries_the_camera_along(before, after):
    pose = replace(standard_pose(before), focal=(1, 2, 3), pivot=(1, 0, 0), distance=9.0)
    local = np.random.default_rng(1).normal(size=(5, 3))
    seen = projected(pose, local @ axis_frame(before))
    carried = pose.carried_to(after)
    assert np.allclose(projected(carried, local @ axis_frame(after)), seen, atol=1e-12)


def test_projection_keeps_the_size_at_the_focal_point():
    pose = replace(standard_pose(Axis.Z), distance=20.0)
    assert pose.parallel_scale == pytest.approx(20.0 * tan(VIEW_ANGLE / 2))
    assert radians(10) < VIEW_ANGLE < radians(60)


def test_picking_finds_the_nearest_quad_or_nothing():
    pose = replace(standard_pose(Axis.Z, "front"), distance=20.0)
    square = np.array([[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]], float)
    points = np.concatenate([square + np.array([0, 3, 0]), square + np.array([0, -3, 0])])
    quads = np.arange(8).reshape(2, 4)
    assert pose.seen_at(points, quads, 0.0, 0.0) == pytest.approx((0.0, -3.0, 0.0))
    assert pose.seen_at(points, quads, 0.9, 0.0) is None


@pytest.mark.parametrize("parallel", [False, True])
def test_what_is_picked_is_seen_where_it_was_picked(parallel):
    pose = standard_pose(Axis.Z, "iso", parallel=parallel).orbited(0.3, -0.2).panned(0.1, 0.2)
    square = np.array([[-1, -1, 0.2], [1, -1, 0], [1, 1, -0.1], [-1, 1, 0]], float)
    for at in ((0.05, -0.1), (-0.15, 0.02)):
        found = pose.seen_at(0.4 * square, np.arange(4).reshape(1, 4), *at)
        assert projected(pose, found) == pytest.approx(at, abs=1e-12)
