from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import pi

import numpy as np
import pytest
import trimesh
from hypothesis import example, given, settings
from hypothesis import strategies as st
from numpy.polynomial import Polynomial
from scipy.integrate import dblquad, quad

from sgb_core.curves.basis import bernstein
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.surfaces import measures
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.quadrature import integrate
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.tessellation import tessellate
from sgb_core.surfaces.variation import Law, varying_quartics
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
    profiles,
    surfaces,
)


def line(*ends: tuple[float, float]) -> list[np.ndarray]:
    return [np.linspace(a, b, 4) for a, b in pairwise(ends)]


NEAR_CUSP = np.array([(1.0, 1.0), (1.0 + 2.0**-9, 1.0), (0.0, 1.0), (0.0, 0.0)])


def over(profile: Profile, integrand: object) -> float:
    """Integrate over all segments, each cut where it is slowest: quad does not see near cusps."""
    return sum(
        quad(lambda s, g=g: integrand(g, s), a, b, epsabs=1e-14, epsrel=1e-12, limit=400)[0]
        for g in profile.segments
        for a, b in pairwise(slow_places(g))
    )


def slow_places(segment: Segment) -> list[float]:
    """Return 0, where the square of the speed has no slope, and 1."""
    to_powers = np.array([[1, 0, 0, 0], [-3, 3, 0, 0], [3, -6, 3, 0], [-1, 3, -3, 1]])
    dr, dh = (Polynomial(to_powers @ np.diff(column)) for column in segment.quartic.T)
    roots = (dr * dr + dh * dh).deriv().roots()
    inner = roots[np.abs(roots.imag) < 1e-6].real
    return [0.0, *np.sort(inner[(inner > 0.0) & (inner < 1.0)]).tolist(), 1.0]


@pytest.mark.parametrize("shape", [(1, 3, 1, 0), (4, 3, 4, 1), (0, 6, 0, 0.5)])
def test_closed_forms(shape: tuple[float, float, float, float]) -> None:
    cylinder = RevolutionSurface(chain(line((2, 0), (2, 5)), shape), placement=PLACED)
    assert measures.volume(cylinder) == pytest.approx(20 * pi, rel=1e-14)
    assert measures.area(cylinder) == pytest.approx(20 * pi, rel=1e-13)
    middle = PLACED.apply(np.array([0, 0, 2.5]))
    np.testing.assert_allclose(measures.centroid(cylinder), middle, rtol=1e-13)
    cone = RevolutionSurface(chain(line((3, 0), (0, 4)), shape), Axis.X)
    assert measures.volume(cone) == pytest.approx(12 * pi, rel=1e-13)
    assert measures.area(cone) == pytest.approx(15 * pi, rel=1e-13)
    np.testing.assert_allclose(measures.centroid(cone), [1, 0, 0], atol=1e-13)
    assert measures.bending_energy(cone.profile) == 0.0
    assert measures.generatrix_length(cone.profile) == pytest.approx(5.0, rel=1e-13)
    square = chain(line((2, 0), (3, 0), (3, 1), (2, 1), (2, 0)), shape, closed=True)
    ring = RevolutionSurface(square, Axis.Y)
    assert measures.volume(ring) == pytest.approx(5 * pi, rel=1e-13)
    assert measures.area(ring) == pytest.approx(2 * pi * (2.5 + 3 + 2.5 + 2), rel=1e-13)
    turned = RevolutionSurface(square.reversed())
    assert measures.volume(turned) == pytest.approx(5 * pi, rel=1e-13)
    assert turned.flips
    assert not ring.flips


@settings(max_examples=40)
@given(surfaces())
@example(RevolutionSurface(Profile.of([Segment(NEAR_CUSP, ShapeParameters(0, 0, 0, 0))]), Axis.X))
# Where a segment retraces itself scipy reaches its own rounding before what is asked of it.
@pytest.mark.filterwarnings("ignore::scipy.integrate.IntegrationWarning")
def test_volume_area_length_against_scipy(surface: RevolutionSurface) -> None:
    profile, size = surface.profile, surface.profile.size
    flux = over(profile, lambda g, s: g.point(s)[0] ** 2 * g.derivative(s)[1])
    assert measures.volume(surface) == pytest.approx(
        abs(flux) * surface.sweep / 2, rel=1e-10, abs=1e-12 * (size + 2) ** 3
    )
    span = over(profile, lambda g, s: abs(g.point(s)[0]) * np.hypot(*g.derivative(s)))
    assert measures.area(surface) == pytest.approx(span * surface.sweep, rel=1e-8, abs=1e-12)
    length = over(profile, lambda g, s: np.hypot(*g.derivative(s)))
    assert measures.generatrix_length(profile) == pytest.approx(length, rel=1e-8, abs=1e-12)


def test_area_counts_both_sides_of_the_axis() -> None:
    profile = chain(CROSSING, (2, 3, 1, 0.5))
    whole = over(profile, lambda g, s: abs(g.point(s)[0]) * np.hypot(*g.derivative(s)))
    found = measures.area(RevolutionSurface(profile))
    assert found == pytest.approx(2 * pi * whole, rel=1e-10)


@pytest.mark.parametrize("sweep", [2 * pi, 1.4 * pi, 0.3])
def test_the_centroid_of_a_wedge_is_that_of_its_solid(sweep: float) -> None:
    surface = RevolutionSurface(chain(TOWER, (4, 3, 4, 0.6)), Axis.Y, 0.8, sweep, placement=PLACED)
    found = measures.centroid(surface)
    # The solid between the surface and its axis, of thin wedges about each meridian.
    theta = surface.start + sweep * (np.arange(4000) + 0.5) / 4000
    profile = surface.profile
    whole = over(profile, lambda g, s: g.point(s)[0] ** 2 * g.derivative(s)[1] / 2)
    lift = over(profile, lambda g, s: g.point(s)[0] ** 2 * g.point(s)[1] * g.derivative(s)[1] / 2)
    reach = over(profile, lambda g, s: g.point(s)[0] ** 3 * g.derivative(s)[1] / 3) / whole
    local = [reach * np.sin(theta).mean(), lift / whole, reach * np.cos(theta).mean()]
    np.testing.assert_allclose(found, PLACED.apply(np.array(local)), atol=1e-6)


def test_no_volume_has_no_centroid() -> None:
    disc = RevolutionSurface(chain(line((0, 1), (2, 1))))
    assert measures.volume(disc) == 0.0
    assert measures.centroid(disc) is None
    assert measures.area(disc) == pytest.approx(4 * pi)
    assert not disc.flips


@pytest.mark.parametrize("laws", [(PAPER,), (WAVE,), (KEYS, PAPER)])
@pytest.mark.parametrize("points", [BALL, RING])
def test_with_laws_a_fine_mesh_converges_to_the_formulas(points: object, laws: tuple) -> None:
    surface = RevolutionSurface(chain(points, (4, 3, 4, 0.8)), Axis.X, 0.3, laws=laws)
    errors = []
    for samples in ((48, 72), (96, 144)):
        mesh = tessellate(surface, samples=samples)
        solid = trimesh.Trimesh(mesh.positions, mesh.faces, process=False)
        errors.append(
            [
                abs(solid.volume / measures.volume(surface) - 1),
                abs(solid.area / measures.area(surface) - 1),
                np.abs(solid.center_mass - measures.centroid(surface)).max(),
            ]
        )
    coarse, fine = np.array(errors)
    assert (fine < 2e-3).all()
    assert (fine < 0.5 * coarse + 1e-9).all()


@pytest.mark.parametrize("laws", [(PAPER,), (WAVE,)])
def test_area_with_laws_against_scipy(laws: tuple[Law, ...]) -> None:
    surface = RevolutionSurface(chain(BALL, (2, 3, 2, 0.5)), sweep=1.0, laws=laws)

    def density(s: float, theta: float) -> float:
        along, around = surface.partials(0, s, theta)
        return float(np.linalg.norm(np.cross(along, around)))

    expected = dblquad(density, 0, 1, 0, 1, epsabs=1e-9, epsrel=1e-9)[0]
    assert measures.area(surface) == pytest.approx(expected, rel=1e-8)


def test_constant_laws_change_nothing() -> None:
    held = tuple(
        Law(name, kind, value, value, keyframes=((0, 0), (100, 1)), count=5)
        for name, kind, value in (
            ("omega", "paper", 0.7),
            ("lambda1", "cosine", 2.0),
            ("lambda2", "keyframes", 5.0),
        )
    )
    stored = RevolutionSurface(chain(TOWER, (2, 5, 1, 0.7)), Axis.Y, 0.4, 4.0, (), PLACED)
    varied = RevolutionSurface(chain(TOWER), Axis.Y, 0.4, 4.0, held, PLACED)
    for measure in (measures.volume, measures.area, measures.height, measures.largest_diameter):
        assert measure(varied) == pytest.approx(measure(stored), rel=1e-11)
    np.testing.assert_allclose(measures.centroid(varied), measures.centroid(stored), rtol=1e-11)
    np.testing.assert_allclose(measures.bounds(varied), measures.bounds(stored), atol=1e-9)


@settings(max_examples=40)
@given(surfaces())
def test_bounds_hold_every_point_and_are_reached(surface: RevolutionSurface) -> None:
    low, high = measures.bounds(surface)
    s, theta = np.linspace(0, 1, 200)[:, None], surface.angles(200)
    points = np.concatenate(
        [surface.point(k, s, theta).reshape(-1, 3) for k in range(len(surface.profile))]
    )
    size = surface.profile.size
    assert (points >= low - 1e-12).all()
    assert (points <= high + 1e-12).all()
    np.testing.assert_allclose(points.min(axis=0), low, atol=1e-3 * (size + 2.0))
    np.testing.assert_allclose(points.max(axis=0), high, atol=1e-3 * (size + 2.0))


@settings(max_examples=5)
@given(surfaces(laws=True))
def test_bounds_with_laws(surface: RevolutionSurface) -> None:
    low, high = measures.bounds(surface)
    s, theta = np.linspace(0, 1, 151)[:, None], surface.angles(333)
    points = np.concatenate(
        [surface.point(k, s, theta).reshape(-1, 3) for k in range(len(surface.profile))]
    )
    assert (points >= low - 1e-9).all()
    assert (points <= high + 1e-9).all()
    np.testing.assert_allclose(points.min(axis=0), low, atol=5e-3)
    np.testing.assert_allclose(points.max(axis=0), high, atol=5e-3)


def test_bounds_of_a_partial_sweep() -> None:
    surface = RevolutionSurface(chain(line((2, 0), (2, 5))), start=pi / 4, sweep=pi / 2)
    low, high = measures.bounds(surface)
    np.testing.assert_allclose(low, [-np.sqrt(2), np.sqrt(2), 0], atol=1e-14)
    np.testing.assert_allclose(high, [np.sqrt(2), 2, 5], atol=1e-14)
    tilted = RevolutionSurface(chain(line((3, 0), (3, 1))), placement=Placement((0, 90, 0)))
    np.testing.assert_allclose(measures.bounds(tilted), [[0, -3, -3], [1, 3, 3]], atol=1e-12)


@settings(max_examples=40)
@given(profiles())
def test_energy_is_finite_exactly_where_no_derivative_vanishes(profile: Profile) -> None:
    energy = measures.bending_energy(profile)
    speeds = [
        np.hypot(*segment.derivative(np.linspace(0, 1, 400)).T).min()
        for segment in profile.segments
    ]
    if min(speeds) > 0.05:
        expected = over(
            profile, lambda g, s: float(g.curvature(s)) ** 2 * np.hypot(*g.derivative(s))
        )
        assert energy == pytest.approx(expected, rel=1e-8, abs=1e-12)


def test_energy_diverges_at_degenerate_ends_and_cusps_only() -> None:
    assert measures.bending_energy(chain(TOWER, (4, 3, 4, 1))) is None
    assert measures.bending_energy(chain(TOWER, (4, 3, 1, 1))) is None
    assert measures.bending_energy(chain(line((1, 0), (2, 3)), (4, 3, 4, 1))) == 0.0
    near = measures.bending_energy(chain(TOWER, (4, 3, 4, 0.999)))
    assert near is not None
    assert near > 1.0
    # This cubic has a cusp at s = 1/2.
    cusp = chain([[[1, 0], [2, 1], [1, 1], [2, 0]]])
    assert cusp.segments[0].derivative(0.5) == pytest.approx([0.0, 0.0])
    assert measures.bending_energy(cusp) is None
    assert measures.generatrix_length(cusp) == pytest.approx(
        2 * quad(lambda s: np.hypot(*cusp.segments[0].derivative(s)), 0, 0.5)[0], rel=1e-12
    )


def test_height_and_diameter_are_those_of_the_curve() -> None:
    surface = RevolutionSurface(chain(BALL), laws=(PAPER,))
    assert measures.height(surface) == pytest.approx(2.0)
    wide = RevolutionSurface(chain(BALL, (1, 3, 1, 0)))
    assert measures.largest_diameter(wide) == pytest.approx(1.8)


# Where one is highest the others are not: the widest place lies between.
LOBES = (
    Law("radius", "lobes", 1.0, 1.5, count=7),
    Law("radius", "lobes", 1.0, 1.28125, count=2),
)


@settings(max_examples=60)
@given(surfaces(laws=True), st.sampled_from((0.6, 1.3, 2.0)))
@example(RevolutionSurface(chain(line((0.2, 0.0), (0.5, 1.0))), laws=LOBES), 0.6)
def test_height_and_diameter_are_reached_by_some_section(surface, end) -> None:
    radius = Law("radius", "lobes", 1.0, end, count=3)
    surface = replace(surface, laws=(*surface.laws, radius))
    theta = np.linspace(0.0, surface.sweep, 14401)
    quartics = varying_quartics(surface.profile, surface.laws, theta)[0]
    points = np.einsum("st,anti->ansi", bernstein(4, np.linspace(0.0, 1.0, 65)), quartics)
    size = 2.0 * surface.profile.size
    widest = 2.0 * float(np.abs(points[..., 0]).max())
    assert measures.largest_diameter(surface) == pytest.approx(widest, abs=1e-3 * size)
    assert measures.height(surface) == pytest.approx(float(np.ptp(points[..., 1])), abs=1e-3 * size)
    assert measures.largest_diameter(surface) >= widest - 1e-4 * size


@given(st.integers(1, 40))
def test_cosines_of_any_count_are_integrated(count: int) -> None:
    law = Law("lambda2", "cosine", 0, 6, count=count)
    surface = RevolutionSurface(chain(BALL, (1, 3, 1, 1)), laws=(law,))
    once = RevolutionSurface(
        chain(BALL, (1, 3, 1, 1)), laws=(Law("lambda2", "raised-cosine", 0, 6),)
    )
    assert measures.volume(surface) == pytest.approx(measures.volume(once), rel=1e-12)


def test_a_function_that_is_only_rounding_is_not_halved_for_ever():
    asked = []

    def noise(s):
        asked.append(len(s))
        return 1.0 + np.modf(1e6 * np.sin(1e9 * s))[0]

    assert integrate(noise, np.array([0.0, 1.0])) == pytest.approx(1.0, abs=0.05)
    assert sum(asked) < 2_000_000
