from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sgb_core.surfaces.grid import SweepGrid
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.turn import grid_columns
from tests.sgb_core.surfaces.chains import BALL, PAPER, TOWER, chain, surfaces


@settings(max_examples=60)
@given(surfaces() | surfaces(laws=True), st.integers(1, 6), st.integers(1, 9))
def test_the_grid_holds_the_surfaces_points_and_normals(
    surface: RevolutionSurface, per_segment: int, columns: int
) -> None:
    grid = SweepGrid(len(surface.profile), per_segment, columns)
    grid.write(surface)
    s, theta = np.linspace(0, 1, per_segment + 1), surface.start + grid_columns(surface, columns)[0]
    exact = np.concatenate(
        [surface.point(k, s[:, None], theta) for k in range(len(surface.profile))]
    )
    written = grid.points.reshape(exact.shape)
    np.testing.assert_allclose(written, exact, rtol=0, atol=1e-5)
    assert np.isfinite(grid.normals).all()
    lengths = np.linalg.norm(grid.normals, axis=1)
    np.testing.assert_allclose(lengths, 1.0, atol=1e-5)
    np.testing.assert_allclose(grid.section(surface)[:, :], _section(surface, s), atol=1e-12)


def _section(surface: RevolutionSurface, s: np.ndarray) -> np.ndarray:
    profile = surface.profile_at(surface.start)
    return np.concatenate([segment.point(s) for segment in profile.segments])


@settings(max_examples=40)
@given(surfaces())
def test_normals_are_the_exact_ones(surface: RevolutionSurface) -> None:
    grid = SweepGrid(len(surface.profile), 4, 6)
    grid.write(surface)
    s, theta = np.linspace(0, 1, 5), surface.angles(6)
    exact = np.concatenate(
        [surface.normal(k, s[:, None], theta) for k in range(len(surface.profile))]
    )
    # Where the section touches the axis both sides are one-sided limits; there either may count.
    clear = np.abs(grid.section(surface)[:, 0]) > 1e-6
    written = grid.normals.reshape(exact.shape)
    np.testing.assert_allclose(written[clear], exact[clear], atol=1e-5)


def test_memory_is_shared_and_never_replaced() -> None:
    grid = SweepGrid(3, 8, 12)
    points, normals, quads = grid.points, grid.normals, grid.quads
    assert points.dtype == np.float32
    assert points.flags.c_contiguous
    assert quads.dtype == np.int32
    first = RevolutionSurface(chain(TOWER))
    grid.write(first)
    before = points.copy()
    grid.write(RevolutionSurface(chain(TOWER, (4, 3, 4, 1))))
    grid.write(RevolutionSurface(chain(TOWER), start=1.0, laws=(PAPER,)))
    assert grid.points is points
    assert grid.normals is normals
    grid.write(first)
    np.testing.assert_array_equal(points, before)


def test_quads_are_wound_outward() -> None:
    grid = SweepGrid(3, 8, 12)
    for profile in (chain(TOWER), chain(TOWER).reversed()):
        grid.write(RevolutionSurface(profile))
        a, b, c, d = np.moveaxis(grid.points[grid.outward_quads].astype(float), 1, 0)
        facing = np.einsum(
            "qx,qx->q", np.cross(c - a, d - b), grid.normals[grid.outward_quads[:, 0]]
        )
        assert (facing > 0.0).all()
        # Outward also means away from the axis for a tower without overhangs that face it.
        radial = np.einsum("vx,vx->v", grid.points[:, :2], grid.normals[:, :2])
        assert radial.min() > 0.0
    grid.write(RevolutionSurface(chain(TOWER)), flip=False)
    assert not grid.flipped
    assert len(grid.quads) == 3 * 8 * 12


def test_rows_and_columns_are_counted_as_promised() -> None:
    grid = SweepGrid(1, 4, 6)
    assert (grid.rows, grid.columns) == (5, 7)
    assert len(grid.points) == 35
    grid.write(RevolutionSurface(chain(BALL)))
    np.testing.assert_allclose(grid.points[0:7], 0.0, atol=1e-7)
    np.testing.assert_allclose(grid.points[::7], grid.points[6::7], atol=1e-6)


def test_degenerate_ends_have_the_normal_of_the_true_tangent() -> None:
    # λ = 4 and ω = 1: the end derivatives vanish and the tangent points to Q2 = (2, 1).
    grid = SweepGrid(1, 4, 4)
    grid.write(RevolutionSurface(chain([[[1, 0], [2, 0], [2, 2], [1, 2]]], (4, 3, 4, 1))))
    down = np.array([1.0, 0.0, -1.0]) / np.sqrt(2.0)
    np.testing.assert_allclose(grid.normals[0], down, atol=1e-6)


def test_what_does_not_fit_is_refused() -> None:
    with pytest.raises(ValueError, match="at least one"):
        SweepGrid(1, 0, 4)
    with pytest.raises(ValueError, match="3 segments"):
        SweepGrid(3, 1, 4).write(RevolutionSurface(chain(BALL), sweep=pi))


@pytest.mark.parametrize("translation", [(0.0, 0.0, 0.0), (3.0, -2.0, 1.0)])
def test_a_large_grid_written_in_pieces_holds_what_a_small_one_does(
    translation: tuple[float, float, float],
) -> None:
    surface = replace(RevolutionSurface(chain(TOWER)), placement=Placement(translation=translation))
    small, large = SweepGrid(3, 60, 8), SweepGrid(3, 240, 480)
    for grid in (small, large):
        grid.write(surface)
    for one, other in ((small.points, large.points), (small.normals, large.normals)):
        some = other.reshape(3, 241, 481, 3)[:, ::4, ::60]
        np.testing.assert_allclose(one.reshape(3, 61, 9, 3), some, rtol=0, atol=1e-5)
