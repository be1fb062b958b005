from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
import shapely
import shapely.affinity
from hypothesis import given, settings
from hypothesis import strategies as st

from sgb_core.arrays import Floats
from sgb_core.bodies.body import Body
from sgb_core.bodies.solid import Solid
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.surfaces import measures
from sgb_core.surfaces.grid import SweepGrid
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.tessellation import deviation, tessellate
from sgb_core.surfaces.turn import grid_columns
from sgb_core.surfaces.twist import Ease, Twist, Twisting
from tests.sgb_core.surfaces.chains import RADIUS_LAWS, surfaces

VASE = Profile.of([Segment([(20, 0), (45, 15), (35, 50), (22, 80)])])
LOBES = Law("radius", "lobes", 0.9, 1.1, count=5)
OMEGA = Law("omega", "cosine", 0.0, 1.0, count=3)
CUP = Solid(kind="vessel", wall=3.0, base=4.0)
TWISTS = st.builds(Twist, st.floats(-1.5, 1.5), st.sampled_from(Ease))


def _loops(mesh: Mesh, height: float) -> shapely.Geometry:
    """The horizontal section of a mesh, cut triangle by triangle."""
    corners = mesh.positions[mesh.faces]
    above = corners[..., 2] > height
    cut = above.any(axis=1) & ~above.all(axis=1)
    a, b = corners[cut], np.roll(corners[cut], -1, axis=1)
    crossing = (a[..., 2] > height) != (b[..., 2] > height)
    share = (height - a[..., 2]) / np.where(crossing, b[..., 2] - a[..., 2], 1.0)
    ends = (a + share[..., None] * (b - a))[crossing][:, :2].reshape(-1, 2, 2)
    return shapely.multilinestrings(shapely.linestrings(ends))


@settings(max_examples=20, deadline=None)
@given(surfaces(laws=True), TWISTS)
def test_partials_and_normals_are_those_of_differences(
    surface: RevolutionSurface, twist: Twist
) -> None:
    twisted = replace(surface, twist=twist)
    if twisted.twisting is None:
        return
    s, theta, d = 0.37, surface.start + 0.41 * surface.sweep, 1e-6
    along, around = twisted.partials(0, s, theta)
    by_s = (twisted.point(0, s + d, theta) - twisted.point(0, s - d, theta)) / (2 * d)
    np.testing.assert_allclose(along, by_s, atol=1e-6 * (1 + np.abs(by_s).max()) * 10)
    if all(abs(0.41 * surface.sweep - b) > 1e-4 for law in surface.laws for b in law.breaks):
        by_theta = (twisted.point(0, s, theta + d) - twisted.point(0, s, theta - d)) / (2 * d)
        np.testing.assert_allclose(around, by_theta, atol=1e-4)
    normal = twisted.normal(0, s, theta)
    assert np.linalg.norm(normal) == pytest.approx(1.0)
    assert abs(normal @ along) <= 1e-9 * (1 + np.linalg.norm(along))
    assert abs(normal @ around) <= 1e-9 * (1 + np.linalg.norm(around))


def test_area_is_that_of_independent_quadrature() -> None:
    for ease in Ease:
        surface = RevolutionSurface(VASE, laws=(LOBES,), twist=Twist(0.6, ease))

        # Equal angles over a period, whose sum converges faster than any power, and Gauss' rule.
        nodes, weights = np.polynomial.legendre.leggauss(120)
        theta = 2.0 * pi / 5.0 * np.arange(160) / 160.0
        along, around = surface.partials(0, (nodes[:, None] + 1.0) / 2.0, theta)
        density = np.linalg.norm(np.cross(along, around), axis=-1)
        expected = float(weights @ density.mean(axis=1)) / 2.0 * 2.0 * pi
        assert measures.area(surface) == pytest.approx(expected, rel=1e-9)
        assert measures.area(surface) > 1.001 * measures.area(replace(surface, twist=Twist()))


@settings(max_examples=4, deadline=None)
@given(RADIUS_LAWS, TWISTS)
def test_volume_capacity_and_material_stay_to_the_last_digits(law: Law, twist: Twist) -> None:
    plain = RevolutionSurface(VASE, laws=(law,))
    twisted = replace(plain, twist=twist)
    assert measures.volume(twisted) == pytest.approx(measures.volume(plain), rel=1e-14)
    before, after = Body(plain, CUP), Body(twisted, CUP)
    assert after.capacity == pytest.approx(before.capacity, rel=1e-14)
    assert after.material_volume == pytest.approx(before.material_volume, rel=1e-14)


@pytest.mark.parametrize("laws", [(LOBES,), (OMEGA,)])
@pytest.mark.parametrize("solid", [Solid(kind="filled"), CUP])
def test_sections_of_meshes_are_the_untwisted_ones_turned(
    laws: tuple[Law, ...], solid: Solid
) -> None:
    tolerance = 0.2
    plain = RevolutionSurface(VASE, laws=laws)
    twisted = replace(plain, twist=Twist(0.4, Ease.SMOOTH))
    meshes = [Body(surface, solid).mesh(tolerance=tolerance) for surface in (plain, twisted)]
    for height in np.linspace(5.0, 75.0, 10):
        u = height / 80.0
        turned = 0.4 * 360.0 * (3.0 * u * u - 2.0 * u**3)
        before, after = (_loops(mesh, float(height)) for mesh in meshes)
        expected = shapely.affinity.rotate(before, turned, origin=(0.0, 0.0))
        assert shapely.hausdorff_distance(after, expected, densify=0.2) < 2.0 * tolerance


def test_the_mesh_keeps_its_tolerance() -> None:
    surface = RevolutionSurface(VASE, laws=(LOBES,), twist=Twist(0.5))
    for tolerance in (0.3, 0.1):
        mesh = tessellate(surface, tolerance=tolerance)
        assert deviation(mesh, surface, triangles=400) <= tolerance


def test_without_laws_only_the_paint_turns() -> None:
    plain = RevolutionSurface(VASE)
    twisted = replace(plain, twist=Twist(2.0))
    assert measures.area(twisted) == measures.area(plain)
    np.testing.assert_array_equal(measures.bounds(twisted), measures.bounds(plain))
    mesh = tessellate(twisted, tolerance=0.1)
    assert deviation(mesh, plain, triangles=2000) <= 0.1


@settings(max_examples=8, deadline=None)
@given(surfaces(laws=True), TWISTS)
def test_bounds_hold_the_mesh_and_are_reached(surface: RevolutionSurface, twist: Twist) -> None:
    twisted = replace(surface, twist=twist)
    low, high = measures.bounds(twisted)
    theta = surface.angles(96)
    points = np.concatenate(
        [
            twisted.point(k, np.linspace(0, 1, 33)[:, None], theta).reshape(-1, 3)
            for k in range(len(surface.profile))
        ]
    )
    size = surface.profile.size
    assert (points.min(axis=0) >= low - 1e-9 * size).all()
    assert (points.max(axis=0) <= high + 1e-9 * size).all()
    assert np.abs(points.min(axis=0) - low).max() <= 0.1 * size


def test_the_centroid_of_a_twisted_part_is_the_meshs() -> None:
    surface = RevolutionSurface(VASE, sweep=2.0, laws=(LOBES,), twist=Twist(0.3))
    solid = Body(surface, Solid(kind="filled")).mesh(tolerance=0.2)
    corners = solid.positions[solid.faces]
    six = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
    mean = (six[:, None] * corners.sum(axis=1) / 4.0).sum(axis=0) / six.sum()
    found = measures.centroid(surface)
    assert found is not None
    np.testing.assert_allclose(found, mean, atol=0.2)
    assert solid.is_watertight


@settings(max_examples=15, deadline=None)
@given(surfaces(laws=True), TWISTS)
def test_the_grid_of_the_window_holds_the_same_points(
    surface: RevolutionSurface, twist: Twist
) -> None:
    twisted = replace(surface, twist=twist)
    grid = SweepGrid(len(surface.profile), 4, 7)
    grid.write(twisted)
    theta = surface.start + grid_columns(surface, 7)[0]
    s = np.linspace(0, 1, 5)[:, None]
    exact = np.concatenate([twisted.point(k, s, theta) for k in range(len(surface.profile))])
    np.testing.assert_allclose(grid.points.reshape(exact.shape), exact, atol=3e-5)
    assert np.abs(np.linalg.norm(grid.normals, axis=1) - 1.0).max() < 1e-5


def test_the_grids_normals_are_the_exact_ones() -> None:
    surface = RevolutionSurface(VASE, laws=(LOBES,), twist=Twist(-0.7, Ease.SMOOTH))
    grid = SweepGrid(1, 6, 40)
    grid.write(surface)
    s, theta = np.linspace(0, 1, 7)[:, None], surface.angles(40)
    exact: Floats = surface.normal(0, s, theta)
    np.testing.assert_allclose(grid.normals.reshape(exact.shape), exact, atol=2e-5)


def test_the_rate_is_the_derivative() -> None:
    for ease in Ease:
        twisting = Twisting(-3.0, 7.0, 0.8, ease)
        h = np.linspace(-2.9, 6.9, 41)
        slope = (twisting.angle(h + 1e-6) - twisting.angle(h - 1e-6)) / 2e-6
        np.testing.assert_allclose(twisting.rate(h), slope, atol=1e-7)
        assert float(twisting.angle(np.array(-5.0))) == 0.0
        assert float(twisting.angle(np.array(9.0))) == pytest.approx(1.6 * pi)
        assert np.abs(twisting.rate(h)).max() <= twisting.steepest() + 1e-12
