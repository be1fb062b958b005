from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from scipy.special import comb

from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.rational import RationalPatch, paper_law_half_turn, rational_patches
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.transfinite import turn_angle
from tests.sgb_core.surfaces.chains import PAPER, PLACED, TOWER, WAVE, chain, surfaces


def evaluate(patch: RationalPatch, s: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Evaluate by the definition, one basis function at a time."""

    def basis(degree: int, x: np.ndarray) -> list[np.ndarray]:
        return [comb(degree, k) * x**k * (1 - x) ** (degree - k) for k in range(degree + 1)]

    rows, columns = patch.weights.shape
    above, below = np.zeros((*s.shape, 3)), np.zeros(s.shape)
    for i, f in enumerate(basis(rows - 1, s)):
        for j, g in enumerate(basis(columns - 1, u)):
            above += (f * g * patch.weights[i, j])[..., None] * patch.points[i, j]
            below += f * g * patch.weights[i, j]
    return above / below[..., None]


S, U = np.meshgrid(np.linspace(0, 1, 7), np.linspace(0, 1, 9), indexing="ij")


@settings(max_examples=30)
@given(surfaces())
def test_patches_are_the_surface(surface: RevolutionSurface) -> None:
    patches = rational_patches(surface)
    for patch in patches:
        assert (patch.weights > 0.0).all()
        assert patch.points.shape == (5, 3, 3)
        assert patch.end - patch.start <= pi / 2 + 1e-12
        points = evaluate(patch, S, U)
        # Along u the angle is not proportional; it is read off a point of radius 1.
        half = (patch.end - patch.start) / 2
        x, y = _unit_arc(half, U)
        theta = patch.start + np.arctan2(y, x)
        np.testing.assert_allclose(points, surface.point(patch.segment, S, theta), atol=1e-12)


def _unit_arc(half: float, u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    w = np.cos(half)
    a, b, c = (1 - u) ** 2, 2 * u * (1 - u) * w, u**2
    below = a + b + c
    x = (a + b + c * np.cos(2 * half)) / below
    y = (b * np.tan(half) + c * np.sin(2 * half)) / below
    np.testing.assert_allclose(np.hypot(x, y), 1.0, atol=1e-14)
    return x, y


def test_a_full_turn_has_four_quarters_with_the_usual_weights() -> None:
    patches = rational_patches(RevolutionSurface(chain(TOWER)))
    assert len(patches) == 12
    np.testing.assert_allclose(patches[0].weights[0], [1, np.sqrt(0.5), 1], rtol=1e-15)
    partial = rational_patches(RevolutionSurface(chain(TOWER), sweep=1.4 * pi))
    assert len(partial) == 9
    np.testing.assert_allclose([p.end - p.start for p in partial], 1.4 * pi / 3)


@pytest.mark.parametrize("axis", Axis)
@pytest.mark.parametrize("placement", [Placement(), PLACED])
def test_the_papers_law_is_rational_of_degree_three(axis: Axis, placement: Placement) -> None:
    surface = RevolutionSurface(
        chain(TOWER, (4, 1, 2, 0)), axis, 0.7, laws=(PAPER,), placement=placement
    )
    for segment in range(3):
        patch = paper_law_half_turn(surface, segment)
        np.testing.assert_allclose(patch.weights[0], [1, 1 / 3, 1 / 3, 1])
        expected = surface.point(segment, S, 0.7 + turn_angle(U))
        np.testing.assert_allclose(evaluate(patch, S, U), expected, atol=1e-12)


def test_what_is_not_rational_is_refused() -> None:
    with pytest.raises(ValueError, match="varies"):
        rational_patches(RevolutionSurface(chain(TOWER), laws=(PAPER,)))
    for surface in (
        RevolutionSurface(chain(TOWER), laws=(WAVE,)),
        RevolutionSurface(chain(TOWER), laws=(PAPER,), sweep=1.0),
    ):
        with pytest.raises(ValueError, match="paper's law"):
            paper_law_half_turn(surface, 0)
