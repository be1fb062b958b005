"""Energies and their derivatives against arbitrary precision."""

from __future__ import annotations

from math import pi

import mpmath as mp
import numpy as np
import pytest

from sgb_core.curves.primitives import arc
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.fairing.energy import Energy, energies, everywhere, expand
from sgb_core.design.fairing.measure import profile_energy
from sgb_core.design.fairing.nodes import exact_nodes, graded_nodes
from sgb_core.design.fairing.segments import fraction_moves, quartics_of
from sgb_core.surfaces.measures import bending_energy, surface_bending_energy
from sgb_core.surfaces.revolution import RevolutionSurface
from tests.sgb_core.design.fairing import oracle
from tests.sgb_core.surfaces.chains import BALL, TOWER, chain

POLYGONS = np.array(
    [
        [[5, 13], [6, 12], [3, 10], [2, 8]],
        [[0.2, 0.2], [0.9, 0.0], [0.9, 1.0], [0.2, 0.8]],
        [[1, 0], [3, 0.5], [0.5, 2], [2, 4]],
    ],
    dtype=float,
)
FRACTIONS = [(0.75, 0.5, 0.75), (0.2, 0.9, 1.0), (0.06, 0.3, 0.5)]
CASES = [(polygon, fractions) for polygon in POLYGONS for fractions in FRACTIONS]


def quartic(polygon: np.ndarray, fractions: tuple[float, float, float]) -> np.ndarray:
    return quartics_of(polygon[None], np.array([fractions]))


@pytest.mark.parametrize("kind", Energy)
@pytest.mark.parametrize(("polygon", "fractions"), CASES)
def test_values_are_those_of_arbitrary_precision(kind, polygon, fractions) -> None:
    points = quartic(polygon, fractions)
    found = energies(kind, points, exact_nodes(kind, points))[0]
    with mp.workdps(30):
        assert abs(mp.mpf(float(found)) / oracle.energy(kind, oracle.exact(points[0])) - 1) < 1e-12


@pytest.mark.parametrize("kind", Energy)
@pytest.mark.parametrize(("polygon", "fractions"), CASES[::4])
def test_gradients_by_fractions_are_those_of_differences_in_arbitrary_precision(
    kind, polygon, fractions
) -> None:
    points = quartic(polygon, fractions)
    found = expand(kind, points, exact_nodes(kind, points), fraction_moves(polygon[None]))
    moves = fraction_moves(polygon[None])
    with mp.workdps(40):
        step = mp.mpf(10) ** -12
        slopes = []
        for which, along in zip(moves.which, moves.along[0], strict=True):
            values = []
            for sign in (1, -1):
                moved = oracle.exact(points[0])
                for k in range(2):
                    moved[which][k] += sign * step * mp.mpf(float(along[k]))
                values.append(oracle.energy(kind, moved))
            slopes.append((values[0] - values[1]) / (2 * step))
        largest = max(abs(slope) for slope in slopes)
        for slope, value in zip(slopes, found.gradient[0].tolist(), strict=True):
            assert abs(mp.mpf(value) - slope) < 1e-8 * max(abs(slope), largest * mp.mpf("1e-6"))


@pytest.mark.parametrize("kind", Energy)
def test_gradient_by_all_points_in_a_random_direction(kind) -> None:
    rng = np.random.default_rng(3)
    for polygon, fractions in CASES[1::3]:
        points = quartic(polygon, fractions)
        direction = rng.normal(size=(5, 2))
        found = expand(kind, points, exact_nodes(kind, points), everywhere(1)).gradient[0]
        with mp.workdps(40):
            step = mp.mpf(10) ** -12
            values = []
            for sign in (1, -1):
                moved = oracle.exact(points[0])
                for k, row in enumerate(direction.tolist()):
                    for axis in range(2):
                        moved[k][axis] += sign * step * mp.mpf(row[axis])
                values.append(oracle.energy(kind, moved))
            slope = (values[0] - values[1]) / (2 * step)
            assert abs(mp.mpf(float(found @ direction.ravel())) / slope - 1) < 1e-8


@pytest.mark.parametrize("kind", Energy)
def test_hessians_are_the_gradients_differences(kind) -> None:
    points = np.concatenate([quartic(polygon, fractions) for polygon, fractions in CASES])
    nodes, moves, step = exact_nodes(kind, points), everywhere(len(points)), 1e-6
    found = expand(kind, points, nodes, moves).hessian
    for place in range(10):
        shift = np.zeros((5, 2))
        shift[divmod(place, 2)] = step
        up, down = (expand(kind, points + s * shift, nodes, moves).gradient for s in (1, -1))
        largest = np.abs(found).max(axis=(1, 2))
        assert np.abs((up - down) / (2 * step) - found[:, place]).max(axis=1) == pytest.approx(
            np.zeros(len(points)), abs=1e-6 * largest.max()
        )
        assert (
            np.abs((up - down) / (2 * step) - found[:, place]).max(axis=1) < 1e-5 * largest
        ).all()


@pytest.mark.parametrize("end", [0, 2])
def test_a_short_leg_costs_no_digits(end) -> None:
    fractions = [0.6, 0.3, 0.7]
    fractions[end] = 2.0**-20
    points = quartic(POLYGONS[2], tuple(fractions))
    found = energies(Energy.BENDING, points, exact_nodes(Energy.BENDING, points))[0]
    edges = [f"1e-{k}" for k in range(12, 0, -1)]
    edges = ["0", *edges, "0.5", *(str(1 - mp.mpf(edge)) for edge in edges[::-1]), "1"]
    with mp.workdps(30):
        truth = oracle.energy(Energy.BENDING, oracle.exact(points[0]), edges)
        assert abs(mp.mpf(float(found)) / truth - 1) < 1e-11


@pytest.mark.parametrize("kind", Energy)
def test_the_search_integrates_nearly_as_well(kind) -> None:
    points = np.concatenate([quartic(polygon, fractions) for polygon, fractions in CASES])
    exact = energies(kind, points, exact_nodes(kind, points))
    assert energies(kind, points, graded_nodes(kind, points)) == pytest.approx(exact, rel=1e-4)


def test_whole_profiles_measure_as_elsewhere() -> None:
    for profile in (chain(TOWER, (2, 4, 1, 0.7)), chain(BALL, (0, 3, 0, 0.671))):
        surface = RevolutionSurface(profile, sweep=2.0)
        assert profile_energy(profile, Energy.BENDING) == pytest.approx(
            bending_energy(profile), rel=1e-11
        )
        assert profile_energy(profile, Energy.SURFACE, 2.0) == pytest.approx(
            surface_bending_energy(surface), rel=1e-10
        )


def test_arcs_and_lines_have_closed_forms_at_any_size() -> None:
    for radius in (1e-3, 1.0, 1e6):
        quarter, _ = arc((0, 5 * radius), radius, -pi / 2, 0)
        profile = Profile((quarter,))
        assert profile_energy(profile, Energy.BENDING) == pytest.approx(pi / 2 / radius, rel=1e-3)
        # A true arc has none; the variation of its approximation is small for its size.
        assert profile_energy(profile, Energy.VARIATION) < 0.02 / radius**3
    line = Profile((Segment(np.linspace((1, 0), (3, 4), 4), ShapeParameters(4, 3, 4, 1)),))
    assert profile_energy(line, Energy.BENDING) == profile_energy(line, Energy.VARIATION) == 0.0


@pytest.mark.parametrize(
    ("points", "shape", "infinite"),
    [
        # A vanishing end derivative, and a cusp inside.
        (POLYGONS[1], (4, 3, 1, 1), (True, True, True)),
        ([[1, 0], [2, 1], [1, 1], [2, 0]], (1, 3, 1, 0), (True, True, True)),
        # Q0, Q2 and Q3 in line: no curvature there but, unless it is stationary, a variation.
        ([[1, 0], [1, 0], [2, 1], [3, 0]], (1, 3, 0, 1), (False, True, False)),
        ([[1, 0], [1, 0], [2, 1], [3, 0]], (1, 4, 0, 1), (False, False, False)),
        # A level end on the axis, and the tip of a cone.
        ([[0, 0], [1, 0], [2, 1], [2, 2]], (1, 3, 1, 0), (False, False, False)),
        ([[0, 0], [1, 1], [2, 1], [2, 2]], (1, 3, 1, 0), (False, False, True)),
        # Across the axis.
        ([[1, 0], [0, 1], [-1, 1.5], [-1, 3]], (1, 3, 1, 0), (False, False, True)),
    ],
)
def test_infinite_energies_are_known(points, shape, infinite) -> None:
    profile = Profile((Segment(np.array(points, float), ShapeParameters(*shape)),))
    found = tuple(profile_energy(profile, kind) is None for kind in Energy)
    assert found == infinite
    assert (bending_energy(profile) is None) == infinite[0]
    assert (surface_bending_energy(RevolutionSurface(profile)) is None) == infinite[2]
