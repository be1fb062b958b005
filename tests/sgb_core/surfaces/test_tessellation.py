from __future__ import annotations

from dataclasses import replace
from math import pi

import manifold3d
import numpy as np
import pytest
import trimesh
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from sgb_core.surfaces import measures
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.tessellation import deviation, samples_for_tolerance, tessellate
from sgb_core.surfaces.variation import Law
from tests.sgb_core.surfaces.chains import (
    BALL,
    CROSSING,
    KEYS,
    PAPER,
    PLACED,
    RING,
    TOWER,
    WAVE,
    chain,
    degenerate_count,
    profiles,
    surfaces,
)


def meshed(surface: RevolutionSurface, **options: object) -> Mesh:
    """Return the mesh, or skip the example where the profile lies on the axis or is a point."""
    try:
        return tessellate(surface, **options)
    except ValueError as error:
        if "no surface" not in str(error):
            raise
    assume(False)
    raise AssertionError


def check_sound(mesh: Mesh) -> None:
    assert np.isfinite(mesh.positions).all()
    assert np.isfinite(mesh.normals).all()
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1.0, atol=1e-12)
    assert degenerate_count(mesh) == 0
    assert mesh.areas.min() > 0.0
    assert (mesh.uv >= 0.0).all()
    assert (mesh.uv <= 1.0).all()
    assert set(mesh.corner_positions) == set(range(len(mesh.positions)))


@settings(max_examples=60)
@given(surfaces(), st.integers(1, 9), st.integers(4, 11))
def test_any_surface_gives_a_sound_mesh(
    surface: RevolutionSurface, per_segment: int, around: int
) -> None:
    mesh = meshed(surface, samples=(per_segment, around))
    check_sound(mesh)


@settings(max_examples=30)
@given(surfaces(laws=True), st.integers(2, 9), st.integers(4, 11))
def test_laws_give_sound_meshes_too(
    surface: RevolutionSurface, per_segment: int, around: int
) -> None:
    check_sound(meshed(surface, samples=(per_segment, around)))


@settings(max_examples=60)
@given(profiles(ends=(0.0, 0.0), radii=st.floats(0.1, 2.0)), st.integers(3, 12))
def test_closed_at_the_axis_is_watertight_and_outward(profile: object, around: int) -> None:
    mesh = meshed(RevolutionSurface(profile, Axis.Y), samples=(7, around))
    check_sound(mesh)
    assert mesh.is_watertight
    assert mesh.is_oriented
    single = mesh.positions.astype(np.float32)[mesh.faces]
    assert (single != np.roll(single, 1, axis=1)).any(axis=2).all()


@settings(max_examples=30)
@given(surfaces(laws=True, ends=(0.0, 0.0), radii=st.floats(0.1, 2.0)), st.integers(2, 12))
def test_closed_at_the_axis_stays_watertight_under_laws(
    surface: RevolutionSurface, per_segment: int
) -> None:
    mesh = meshed(replace(surface, sweep=2 * pi), samples=(per_segment, 6))
    check_sound(mesh)
    assert mesh.is_watertight


def test_samples_that_coincide_at_one_angle_only_are_welded_there() -> None:
    # Out and back along one line: the two middle samples meet where λ1 = λ3.
    law = Law("lambda1", "cosine", 0.0, 1.0)
    flat = chain([[[0, 0], [1, 0], [1, 0], [0, 0]]], (0, 0, 0, 1))
    mesh = tessellate(RevolutionSurface(flat, laws=(law,)), samples=(9, 4))
    check_sound(mesh)
    assert mesh.is_watertight


@pytest.mark.parametrize("points", [BALL, RING])
@pytest.mark.parametrize("shape", [(1, 3, 1, 0), (4, 3, 4, 1), (4, 0, 4, 1), (0, 6, 0, 1)])
@pytest.mark.parametrize("laws", [(), (PAPER,), (WAVE, KEYS)])
def test_independent_judges_agree(points: object, shape: tuple, laws: tuple) -> None:
    surface = RevolutionSurface(chain(points, shape), Axis.Z, 0.4, laws=laws, placement=PLACED)
    mesh = tessellate(surface, samples=(40, 96))
    check_sound(mesh)
    assert mesh.is_watertight
    judge = trimesh.Trimesh(mesh.positions, mesh.faces, process=False)
    assert judge.is_watertight
    assert judge.is_winding_consistent
    assert judge.volume == pytest.approx(mesh.volume, rel=1e-9)
    assert judge.area == pytest.approx(mesh.area, rel=1e-9)
    solid = manifold3d.Manifold(
        manifold3d.Mesh(mesh.positions.astype(np.float32), mesh.faces.astype(np.uint32))
    )
    assert solid.status() == manifold3d.Error.NoError
    assert solid.volume() == pytest.approx(mesh.volume, rel=1e-5)
    assert mesh.volume == pytest.approx(measures.volume(surface), rel=0.01)


@pytest.mark.parametrize("reverse", [False, True])
@pytest.mark.parametrize("axis", Axis)
def test_normals_and_triangles_face_outward_whichever_way_the_profile_runs(
    reverse: bool, axis: Axis
) -> None:
    profile = chain(RING, (4, 3, 4, 1), closed=True)
    surface = RevolutionSurface(profile.reversed() if reverse else profile, axis, placement=PLACED)
    mesh = tessellate(surface, tolerance=1e-3)
    assert mesh.volume > 0.0
    flat = mesh.triangle_normals / (2.0 * mesh.areas[:, None])
    facing = np.einsum("tx,tcx->tc", flat, mesh.normals[mesh.triangles])
    assert facing.min() > 0.95


def test_a_profile_that_crosses_the_axis_is_cut_there() -> None:
    surface = RevolutionSurface(chain(CROSSING))
    mesh = tessellate(surface, samples=(8, 16))
    on_axis = np.hypot(mesh.positions[:, 0], mesh.positions[:, 1]) == 0.0
    assert on_axis.sum() == 1
    flat = mesh.triangle_normals / (2.0 * mesh.areas[:, None])
    facing = np.einsum("tx,tcx->tc", flat, mesh.normals[mesh.triangles])
    assert facing.min() > 0.9


@settings(max_examples=25)
@given(surfaces(), st.sampled_from([3e-2, 1e-2, 3e-3]), st.sampled_from(["angle", "rational"]))
def test_the_mesh_keeps_the_tolerance(
    surface: RevolutionSurface, share: float, spacing: str
) -> None:
    assume(surface.profile.size > 0.1)
    tolerance = share * surface.profile.size
    mesh = meshed(surface, tolerance=tolerance, spacing=spacing)
    assert deviation(mesh, surface, 400) <= tolerance


@settings(max_examples=8)
@given(surfaces(laws=True), st.sampled_from([3e-2, 1e-2]))
def test_the_mesh_keeps_the_tolerance_under_laws(surface: RevolutionSurface, share: float) -> None:
    assume(surface.profile.size > 0.1)
    # Within the meridian a chord across a steep flank lies far from it, in space beside it.
    assume(not any(law.kind in ("square", "sawtooth") for law in surface.laws))
    tolerance = share * surface.profile.size
    mesh = meshed(surface, tolerance=tolerance)
    assert deviation(mesh, surface, 300) <= tolerance


def test_a_coarse_mesh_is_measured_as_coarse() -> None:
    surface = RevolutionSurface(chain([[[1, 0], [1, 1], [1, 2], [1, 3]]]))
    mesh = tessellate(surface, samples=(1, 6))
    assert deviation(mesh, surface) == pytest.approx(1.0 - np.cos(pi / 6), rel=1e-12)


def test_samples_are_counted_as_the_command_line_says() -> None:
    mesh = tessellate(RevolutionSurface(chain(TOWER)), samples=(5, 12))
    assert len(mesh.triangles) == 2 * 3 * 5 * 12
    assert len(mesh.positions) == (3 * 5 + 1) * 12
    assert len(mesh.normals) == 3 * 6 * 13
    half = tessellate(RevolutionSurface(chain(TOWER), sweep=pi), samples=(5, 12))
    assert len(half.positions) == (3 * 5 + 1) * 13


def test_equal_angles_and_the_rational_option() -> None:
    surface = RevolutionSurface(chain(TOWER), sweep=1.4 * pi)
    for spacing in ("angle", "rational"):
        mesh = tessellate(surface, samples=(1, 20), spacing=spacing)
        angles = np.unique(np.round(np.mod(np.arctan2(*mesh.positions[:, 1::-1].T), 2 * pi), 9))
        assert len(angles) == 21
        assert angles[-1] == pytest.approx(1.4 * pi)
        equal = np.allclose(np.diff(angles), 0.07 * pi, atol=1e-8)
        assert equal is (spacing == "angle")
        radii = np.hypot(mesh.positions[:, 0], mesh.positions[:, 1])
        assert set(np.round(radii, 9)) == {5.0, 2.0, 8.0}


def test_texture_coordinates_are_shares_of_angle_and_length() -> None:
    profile = chain([[[1, 0], [1, 1], [1, 2], [1, 3]], [[1, 3], [2, 3], [3, 3], [4, 3]]])
    mesh = tessellate(RevolutionSurface(profile, start=0.5), samples=(3, 4))
    v = mesh.uv[:, 1].reshape(8, 5)
    np.testing.assert_allclose(v[:, 0], [0, 1 / 6, 2 / 6, 0.5, 0.5, 4 / 6, 5 / 6, 1], atol=1e-14)
    np.testing.assert_allclose(mesh.uv[:5, 0], [0, 0.25, 0.5, 0.75, 1], atol=1e-15)


def test_the_papers_law_creases_the_mesh_on_its_meridian() -> None:
    mesh = tessellate(RevolutionSurface(chain(BALL, (4, 3, 4, 0)), laws=(PAPER,)), samples=(6, 8))
    assert mesh.is_watertight
    assert len(mesh.normals) > (6 + 1) * 9
    _, copies = np.unique(mesh.corner_positions, return_counts=True)
    assert (copies > 1).sum() >= 2 * 5


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"tolerance": 0.1, "samples": (3, 4)}, "exclude each other"),
        ({"tolerance": 0.0}, "above 0"),
        ({"tolerance": float("nan")}, "above 0"),
        ({"tolerance": 1e-12}, "triangles"),
        ({"samples": (1, 2)}, "needs 3"),
        ({"samples": (0, 8)}, "1 or more"),
        ({"samples": (5000, 5000)}, "triangles"),
    ],
)
def test_impossible_requests_are_refused_in_words(options: dict, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        tessellate(RevolutionSurface(chain(TOWER)), **options)


def test_a_point_and_a_line_on_the_axis_are_no_surface() -> None:
    for points in ([[[1, 1]] * 4], [[[0, 0], [0, 1], [0, 2], [0, 3]]]):
        with pytest.raises(ValueError, match="no surface"):
            tessellate(RevolutionSurface(chain(points)), samples=(4, 8))


def test_a_straight_segment_needs_one_interval() -> None:
    profile = chain([[[1, 0], [1, 1], [1, 2], [1, 3]], [[1, 3], [2, 3], [2, 4], [3, 4]]])
    counts, around = samples_for_tolerance(RevolutionSurface(profile), 1e-3)
    assert counts[0] == 1
    assert counts[1] > 10
    assert around > 50
