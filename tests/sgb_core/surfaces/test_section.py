from __future__ import annotations

from itertools import pairwise
from math import pi

import numpy as np
import pytest

from sgb_core.arrays import Floats
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.section import Rows, assemble, section_of
from sgb_core.surfaces.tessellation import sweep
from sgb_core.surfaces.turn import turn_of
from tests.sgb_core.surfaces.chains import CROSSING, TOWER, chain, degenerate_count


def wall(*corners: tuple[float, float]) -> list[Rows]:
    """Straight pieces from corner to corner, the material on their left."""
    pieces = []
    for start, end in pairwise(np.array(corners, float)):
        step = (end - start) / np.hypot(*(end - start))
        normal = np.array([step[1], -step[0]])
        pieces.append(polyline(np.linspace(start, end, 5), normal))
    return pieces


def polyline(points: Floats, normal: Floats) -> Rows:
    """A piece that all angles share, with one normal (r, h)."""
    steps = np.diff(points, axis=0)
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))])
    normals = np.tile([normal[0], 0.0, normal[1]], (len(points), 1))
    return Rows(points[None], normals[None], lengths[None])


def test_a_walls_polygon_takes_the_same_way_as_a_generatrix() -> None:
    section = assemble(wall((2, 0), (3, 0), (3, 2), (2, 2), (2, 0)), 2.0)
    assert section.rings.max() + 1 == 16
    assert len(section.rings) == 20
    np.testing.assert_allclose(section.lengths[0, [0, 4, 9, 14, 19]], [0, 1 / 6, 0.5, 4 / 6, 1])
    # The surface only says which way is out and how far to turn.
    surface = RevolutionSurface(chain([[[2, 0], [2, 1], [2, 1.5], [2, 2]]]))
    mesh = sweep(section, turn_of(surface, 64), surface)
    assert mesh.is_watertight
    share = np.sin(2 * pi / 64) / (2 * pi / 64)
    assert mesh.volume == pytest.approx(10 * pi * share)
    flat = mesh.triangle_normals / (2.0 * mesh.areas[:, None])
    facing = np.einsum("tx,tcx->tc", flat, mesh.normals[mesh.triangles])
    assert facing.min() > 0.99


def test_a_filled_polygon_closes_at_the_axis() -> None:
    section = assemble(wall((0, 0), (3, 0), (3, 2), (1e-12, 2)), 3.0)
    surface = RevolutionSurface(chain([[[2, 0], [2, 1], [2, 1.5], [2, 2]]]))
    mesh = sweep(section, turn_of(surface, 12), surface)
    assert mesh.is_watertight
    assert degenerate_count(mesh) == 0


def test_pieces_apart_stay_apart_and_close_samples_become_one() -> None:
    apart = assemble(wall((1, 0), (1, 1)) + wall((1, 2), (1, 3)), 3.0)
    assert apart.rings.max() + 1 == 10
    assert list(apart.linked) == [True] * 4 + [False] + [True] * 4
    points = np.array([[1, 0], [1, 1e-7], [1, 1], [1, 2 - 1e-7], [1, 2]])
    merged = assemble([polyline(points, np.array([1.0, 0.0]))], 2.0)
    np.testing.assert_allclose(merged.points[0, :, 1], [0, 1, 2])
    with pytest.raises(ValueError, match="single point"):
        assemble([polyline(points[:1].repeat(3, 0), np.ones(2))], 2.0)


def test_the_axis_is_crossed_at_a_sample_of_its_own() -> None:
    surface = RevolutionSurface(chain(CROSSING))
    section = section_of(surface, (7,), turn_of(surface, 8))
    assert len(section.rings) == 10
    assert section.rings.max() + 1 == 9
    assert np.count_nonzero(section.points[0, :, 0] == 0.0) == 2


def test_counts_must_fit_the_segments() -> None:
    surface = RevolutionSurface(chain(TOWER))
    for counts in ((1, 1), (1, 0, 1)):
        with pytest.raises(ValueError, match="each segment"):
            section_of(surface, counts, turn_of(surface, 8))
