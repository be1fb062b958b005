"""Laws of the radius whose strength changes along the height, against independent quadrature."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from math import pi

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.interpolate import CubicHermiteSpline, PchipInterpolator
from scipy.optimize import brentq

from sgb_core.bodies.body import body_mesh
from sgb_core.bodies.solid import Solid
from sgb_core.bodies.vessel import vessel_measures
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.findings.refusal import RefusalError
from sgb_core.surfaces.measures import (
    area,
    bending_energy,
    bounds,
    generatrix_length,
    largest_diameter,
    volume,
)
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.tessellation import deviation, tessellate
from sgb_core.surfaces.turning_joints import measure_turning_joints
from sgb_core.surfaces.twist import Twist
from sgb_core.surfaces.variation import Law
from tests.sgb_core.surfaces.chains import TOWER, chain

KEYS = ((0.0, 0.0), (0.25, 1.0), (0.6, 0.7), (1.0, 0.1))
FLUTES = Law("radius", "lobes", 0.85, 1.1, count=6, along=KEYS)
CONE = Profile.of([line((20.0, 5.0), (26.0, 65.0))])
MIXED = (FLUTES, Law("omega", "raised-cosine", 0.2, 1.0))
TWO = (FLUTES, Law("radius", "polygon", 1.1, 0.9, count=5, along=((0.1, 0.2), (0.8, 1.0))))


def strength(u: np.ndarray, order: int = 0) -> np.ndarray:
    """The curve through the keys: the slopes of PCHIP inside, none at the ends."""
    at, k = np.array(KEYS).T
    slopes = PchipInterpolator(at, k).derivative()(at)
    slopes[[0, -1]] = 0.0
    return CubicHermiteSpline(at, k, slopes)(u, order)


def of_cone(theta: np.ndarray, h: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Radius of the fluted cone, and its derivatives by θ and h."""
    plain, u = 20.0 + (h - 5.0) / 10.0, (h - 5.0) / 60.0
    away = FLUTES.start + (FLUTES.end - FLUTES.start) * FLUTES.fraction(theta) - 1.0
    turn = (FLUTES.end - FLUTES.start) * FLUTES.fraction_rate(theta)
    factor = 1.0 + strength(u) * away
    return (
        plain * factor,
        plain * strength(u) * turn,
        factor / 10.0 + plain * strength(u, 1) / 60.0 * away,
    )


def integral(value: Callable[[np.ndarray, np.ndarray], np.ndarray]) -> float:
    """Composite Gauss between the keys and the waves."""
    x, w = np.polynomial.legendre.leggauss(24)
    marks = 5.0 + 60.0 * np.array([u for u, _ in KEYS])
    total = 0.0
    for a, b in pairwise(np.linspace(0.0, 2.0 * pi, 25)):
        theta = (a + b) / 2.0 + (b - a) / 2.0 * x
        for c, d in pairwise(marks):
            h = (c + d) / 2.0 + (d - c) / 2.0 * x
            total += float(w @ value(theta[:, None], h[None]) @ w) * (b - a) * (d - c) / 4.0
    return total


def test_volume_and_area_are_those_of_an_independent_quadrature() -> None:
    surface = RevolutionSurface(CONE, laws=(FLUTES,))
    wanted = integral(lambda t, h: 0.5 * of_cone(t, h)[0] ** 2)
    assert volume(surface) == pytest.approx(wanted, rel=1e-11)

    def element(t: np.ndarray, h: np.ndarray) -> np.ndarray:
        r, turn, rise = of_cone(t, h)
        return np.sqrt(r**2 * (1.0 + rise**2) + turn**2)

    assert area(surface) == pytest.approx(integral(element), rel=1e-9)
    # A filled body holds as much; a twist changes neither that nor the volume.
    filled = vessel_measures(surface, Solid(kind="filled"))
    assert filled.material_volume == pytest.approx(wanted, rel=1e-9)
    twisted = replace(surface, twist=Twist(0.4))
    assert volume(twisted) == volume(surface)

    def leaning(t: np.ndarray, h: np.ndarray) -> np.ndarray:
        r, turn, rise = of_cone(t, h)
        return np.sqrt(r**2 + turn**2 + (r * (rise - 0.8 * pi / 60.0 * turn)) ** 2)

    assert area(twisted) == pytest.approx(integral(leaning), rel=1e-9)


def test_capacity_is_that_of_an_independent_quadrature() -> None:
    wall, base = 2.0, 4.0
    surface = RevolutionSurface(CONE, laws=(FLUTES,))
    found = vessel_measures(surface, Solid(kind="vessel", wall=wall, base=base))
    x, w = np.polynomial.legendre.leggauss(16)
    # Half a wave stands for all: the waves are mirrored at their extremes.
    theta, weights = (x + 1.0) * pi / 12.0, w * pi / 12.0
    wanted = 12.0 * sum(
        weight * _cavity(angle, wall, base) for angle, weight in zip(theta, weights, strict=True)
    )
    assert found.capacity == pytest.approx(wanted, rel=1e-9)


def _cavity(theta: float, wall: float, base: float) -> float:
    """½ ∫ ρ² dη of the wall's section moved along its normal, from the floor to the rim."""
    away = FLUTES.start + (FLUTES.end - FLUTES.start) * float(FLUTES.fraction(theta)) - 1.0

    def moved(h: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        r, _, rise = of_cone(np.asarray(theta), h)
        u = (h - 5.0) / 60.0
        plain = 20.0 + (h - 5.0) / 10.0
        bend = away * (strength(u, 1) / 300.0 + plain * strength(u, 2) / 3600.0)
        length = np.hypot(1.0, rise)
        return r - wall / length, h + wall * rise / length, 1.0 + wall * bend / length**3

    ends = [
        brentq(lambda h, at=at: float(moved(np.asarray(h))[1]) - at, 5.0, 65.0, xtol=1e-14)
        for at in (5.0 + base, 65.0)
    ]
    x, w = np.polynomial.legendre.leggauss(24)
    marks = [5.0 + 60.0 * u for u, _ in KEYS]
    edges = np.unique([*ends, *(mark for mark in marks if ends[0] < mark < ends[1])])
    total = 0.0
    for a, b in pairwise(np.unique(np.concatenate([edges, (edges[1:] + edges[:-1]) / 2.0]))):
        radius, _, rate = moved((a + b) / 2.0 + (b - a) / 2.0 * x)
        total += (b - a) / 4.0 * float(w @ (radius**2 * rate))
    return total


@pytest.mark.parametrize("laws", [(FLUTES,), MIXED, TWO])
@pytest.mark.parametrize("twist", [Twist(), Twist(0.3)])
def test_derivatives_and_normals_are_those_of_differences(
    laws: tuple[Law, ...], twist: Twist
) -> None:
    surface = RevolutionSurface(chain(TOWER, (3, 3, 2, 0.6)), laws=laws, twist=twist)
    rng = np.random.default_rng(5)
    s, theta = 0.001 + 0.998 * rng.random(300), 2.0 * pi * rng.random(300)
    for segment in range(len(surface.profile)):
        along, around = surface.partials(segment, s, theta)
        step = 1e-6
        up = surface.point(segment, s + step, theta) - surface.point(segment, s - step, theta)
        on = surface.point(segment, s, theta + step) - surface.point(segment, s, theta - step)
        np.testing.assert_allclose(along, up / (2.0 * step), atol=1e-7)
        np.testing.assert_allclose(around, on / (2.0 * step), atol=1e-7)
        found = np.cross(on, up)
        found /= np.linalg.norm(found, axis=1)[:, None]
        normal = surface.normal(segment, s, theta)
        assert np.abs((found * normal).sum(axis=1)).min() > 1.0 - 1e-9


@pytest.mark.parametrize("laws", [(FLUTES,), MIXED, TWO])
def test_meshes_keep_the_tolerance_and_bodies_are_closed(laws: tuple[Law, ...]) -> None:
    surface = RevolutionSurface(CONE, laws=laws, twist=Twist(0.1))
    mesh = tessellate(surface, tolerance=0.4)
    assert deviation(mesh, surface, 300) <= 0.4
    # A coarse mesh of the part of a turn, and of all of it.
    for solid, sweep in (
        (Solid(kind="filled"), 2.0 * pi),
        (Solid(kind="vessel", wall=2.0, base=3.0), 0.8),
    ):
        part = replace(surface, sweep=sweep)
        body = body_mesh(part, solid, tolerance=1.5)
        assert body.is_watertight
        measured = vessel_measures(part, solid).material_volume
        assert body.volume == pytest.approx(measured, rel=0.08)


def test_bounds_and_diameters_hold_all_points_and_are_reached() -> None:
    surface = RevolutionSurface(CONE, laws=TWO, twist=Twist(0.2))
    low, high = bounds(surface)
    s, theta = np.linspace(0.0, 1.0, 400)[:, None], np.linspace(0.0, 2.0 * pi, 800)[None]
    points = surface.point(0, s, theta).reshape(-1, 3)
    np.testing.assert_allclose(points.min(axis=0), low, atol=1e-3)
    np.testing.assert_allclose(points.max(axis=0), high, atol=1e-3)
    assert (points >= low - 1e-9).all()
    assert (points <= high + 1e-9).all()
    widest = float(np.hypot(points[:, 0], points[:, 1]).max())
    assert widest - 1e-9 <= largest_diameter(surface) / 2.0 <= widest + 1e-3


def test_a_hexagon_that_sets_in_with_the_height_is_one_on_the_mesh() -> None:
    law = Law("radius", "polygon", 0.0, 1.0, count=6, along=((0.2, 0.0), (0.7, 1.0)))
    tube = Profile.of([line((20.0, 0.0), (20.0, 60.0))])
    mesh = tessellate(RevolutionSurface(tube, laws=(law,)), samples=(60, 96))
    points = mesh.positions
    foot, top = (points[np.abs(points[:, 2] - at) < 1e-9] for at in (6.0, 54.0))
    np.testing.assert_allclose(np.hypot(foot[:, 0], foot[:, 1]), 20.0, atol=1e-5)
    # From its middle a side of the hexagon is cos 30° of the corners away.
    turn = np.mod(np.arctan2(top[:, 1], top[:, 0]) + pi / 6.0, pi / 3.0) - pi / 6.0
    corner = np.hypot(top[:, 0], top[:, 1])
    apothem = 20.0 * np.cos(pi / 6.0)
    np.testing.assert_allclose(corner * np.cos(pi / 6.0 - np.abs(turn)), apothem, rtol=1e-6)


def test_full_strength_everywhere_is_the_law_itself_and_none_is_no_law() -> None:
    plain = replace(FLUTES, along=())
    full = replace(FLUTES, along=((0.0, 1.0), (0.5, 1.0), (1.0, 1.0)))
    none = replace(FLUTES, along=((0.3, 0.0),))
    half = replace(FLUTES, along=((0.3, 0.5),))
    cone, laws = RevolutionSurface(CONE), (plain, full, none, half)
    volumes = [volume(replace(cone, laws=(law,))) for law in laws]
    assert volumes[0] == volumes[1]
    assert volumes[2] == pytest.approx(volume(cone), rel=1e-14)
    milder = Law("radius", "lobes", 0.925, 1.05, count=6)
    assert volumes[3] == pytest.approx(volume(replace(cone, laws=(milder,))), rel=1e-13)
    # Keys that agree but for rounding go the long way, and come to the same.
    nearly = replace(FLUTES, along=((0.0, 1.0), (1.0, 1.0 - 1e-13)))
    assert volume(replace(cone, laws=(nearly,))) == pytest.approx(volumes[0], rel=1e-12)
    assert area(replace(cone, laws=(nearly,))) == pytest.approx(
        area(replace(cone, laws=(plain,))), rel=1e-9
    )


def test_length_and_energy_are_those_of_the_section_at_the_start() -> None:
    surface = RevolutionSurface(CONE, laws=(FLUTES,))
    zero = np.zeros(())

    def speed(h: float) -> float:
        return float(np.hypot(1.0, of_cone(zero, np.asarray(h))[2]))

    marks = [5.0 + 60.0 * u for u, _ in KEYS][1:-1]
    length = quad(speed, 5.0, 65.0, points=marks, epsabs=1e-11)[0]
    assert generatrix_length(surface) == pytest.approx(length, rel=1e-11)

    def bending(h: float) -> float:
        u, plain = (h - 5.0) / 60.0, 20.0 + (h - 5.0) / 10.0
        away = FLUTES.start + (FLUTES.end - FLUTES.start) * float(FLUTES.fraction(0.0)) - 1.0
        bend = away * (strength(u, 1) / 300.0 + plain * strength(u, 2) / 3600.0)
        return float(bend**2 / speed(h) ** 5)

    energy = quad(bending, 5.0, 65.0, points=marks, epsabs=1e-14)[0]
    assert bending_energy(surface) == pytest.approx(energy, rel=1e-9)
    section = surface.profile_at(0.0)
    h = section.sample(5).reshape(-1, 2)[:, 1]
    np.testing.assert_allclose(
        section.sample(5).reshape(-1, 2)[:, 0], of_cone(zero, h)[0], atol=1e-6
    )


def test_a_joint_at_a_key_is_smooth_but_for_its_curvature() -> None:
    tube = Profile.of([line((20.0, 0.0), (20.0, 24.0)), line((20.0, 24.0), (20.0, 60.0))], ["G1"])
    law = replace(FLUTES, along=((0.0, 0.0), (0.4, 1.0), (1.0, 0.0)))
    (report,) = measure_turning_joints(RevolutionSurface(tube, laws=(law,)))
    assert report.measured == "G1"
    assert report.kink_deg == pytest.approx(0.0, abs=1e-9)
    # k'' beside a key that is highest: ∓6 Δk over the square of each step.
    jump = 20.0 * 0.15 * (6.0 / 36.0**2 - 6.0 / 24.0**2)
    assert abs(report.curvature_jump) == pytest.approx(abs(jump), rel=1e-9)
    between = replace(law, along=((0.0, 0.0), (0.3, 1.0), (1.0, 0.0)))
    (smooth,) = measure_turning_joints(RevolutionSurface(tube, laws=(between,)))
    assert smooth.measured == "G2"


@pytest.mark.parametrize(
    ("parameter", "along"),
    [
        ("omega", ((0.0, 1.0),)),
        ("radius", ((0.5, 1.0), (0.5, 0.0))),
        ("radius", ((0.0, 1.0), (1.5, 0.0))),
        ("radius", ((0.0, 9.0), (1.0, 0.0))),
    ],
)
def test_keys_that_cannot_be_are_refused(
    parameter: str, along: tuple[tuple[float, float], ...]
) -> None:
    with pytest.raises(RefusalError, match="along"):
        Law(parameter, "cosine", 0.8, 1.0, count=4, along=along)  # type: ignore[arg-type]
