"""The surface's bending energy against closed forms and an independent integration."""

from __future__ import annotations

from math import hypot, log, pi

import numpy as np
import pytest
from scipy.integrate import quad

from sgb_core.curves.primitives import arc
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.surfaces.measures import surface_bending_energy
from sgb_core.surfaces.revolution import RevolutionSurface
from tests.sgb_core.surfaces.chains import BALL, PAPER, TOWER, chain

SHAPES = [(1, 3, 1, 0), (4, 3, 4, 1), (0, 6, 2, 0.5)]


def energy(profile: Profile) -> float | None:
    return surface_bending_energy(RevolutionSurface(profile))


@pytest.mark.parametrize("shape", SHAPES)
def test_cylinder_and_frustum_have_closed_forms_whatever_their_parameters(shape) -> None:
    cylinder = chain([np.linspace((2, 0), (2, 5), 4)], shape)
    assert energy(cylinder) == pytest.approx(2 * pi * 5 / 2, rel=1e-11)
    quarter = RevolutionSurface.of_degrees(cylinder, sweep_deg=90)
    assert surface_bending_energy(quarter) == pytest.approx(2 * pi * 5 / 8, rel=1e-11)
    # ∫ (dh/dl)² / r² · 2πr dl along a straight line from r = 1 to 3, rising by 4.
    frustum = chain([np.linspace((1, 0), (3, 4), 4)], shape)
    climb, spread = 4 / hypot(2, 4), 2 / hypot(2, 4)
    assert energy(frustum) == pytest.approx(2 * pi * climb**2 / spread * log(3), rel=1e-11)
    disc = chain([np.linspace((0, 1), (3, 1), 4)], shape)
    assert energy(disc) == 0.0


def test_a_sphere_has_eight_pi_at_any_size() -> None:
    for radius in (1e-150, 1e-3, 1.0, 1e6):
        lower, _ = arc((0, 0), radius, -pi / 2, 0)
        upper, _ = arc((0, 0), radius, 0, pi / 2)
        assert energy(Profile.of([lower, upper], ["G1"])) == pytest.approx(8 * pi, rel=1e-3)


def test_it_is_the_integral_of_both_squared_curvatures() -> None:
    for profile in (chain(TOWER, (2, 4, 1, 0.7)), chain(BALL, (0, 3, 0, 0.671))):
        surface = RevolutionSurface(profile)

        def density(s: float, k: int, surface: RevolutionSurface = surface) -> float:
            meridian, parallel = surface.curvatures(k, s, 0.0)
            along, around = surface.partials(k, s, 0.0)
            return (meridian**2 + parallel**2) * np.linalg.norm(np.cross(along, around))

        parts = [
            quad(density, 0, 1, args=(k,), epsrel=1e-11, limit=200)[0] for k in range(len(profile))
        ]
        assert surface_bending_energy(surface) == pytest.approx(2 * pi * sum(parts), rel=1e-9)


def test_where_it_diverges_there_is_none() -> None:
    # A vanishing derivative off the axis, the apex of a cone, a profile that cuts the axis.
    assert energy(chain(TOWER, (4, 3, 4, 1))) is None
    assert energy(chain([np.linspace((3, 0), (0, 4), 4)])) is None
    assert energy(chain([[[1, 0], [0.5, 1], [-0.5, 1], [-1, 2]]])) is None
    assert surface_bending_energy(RevolutionSurface(chain(BALL), laws=(PAPER,))) is None


def test_at_a_smooth_pole_a_vanishing_derivative_does_no_harm() -> None:
    # λ1 = λ3 = 4, ω = 1: the tangent is then that towards Q2, still square to the axis.
    def pole(omega: float) -> Segment:
        points = [(0, 0), (1, 0), (1, 0), (2, 3)]
        return Segment(points, ShapeParameters(4, 3, 1, omega))

    found = energy(Profile.of([pole(1.0)]))
    assert found is not None
    assert found == pytest.approx(energy(Profile.of([pole(1.0 - 1e-7)])), rel=1e-3)
