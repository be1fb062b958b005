from __future__ import annotations

import numpy as np
import pytest

from sgb_core.surfaces.mesh import Mesh, compact
from tests.sgb_core.surfaces.chains import degenerate_count

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
FACES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]


def tetrahedron(faces: object = FACES, offset: float = 0.0) -> Mesh:
    normals = np.tile([0.0, 0.0, 1.0], (4, 1))
    return Mesh(CORNERS + offset, np.arange(4), normals, np.zeros((4, 2)), np.array(faces))


def test_a_tetrahedron_is_measured() -> None:
    mesh = tetrahedron()
    assert mesh.is_watertight
    assert mesh.is_oriented
    assert mesh.volume == pytest.approx(1 / 6)
    assert mesh.area == pytest.approx(1.5 + np.sqrt(3) / 2)
    assert degenerate_count(mesh) == 0
    np.testing.assert_array_equal(mesh.bounds, [[0, 0, 0], [1, 1, 1]])
    assert tetrahedron(offset=1e6).volume == pytest.approx(1 / 6, rel=1e-9)


def test_what_is_not_closed_or_not_oriented_is_told() -> None:
    opened = tetrahedron(FACES[:3])
    assert not opened.is_watertight
    assert opened.is_oriented
    turned = tetrahedron([*FACES[:3], FACES[3][::-1]])
    assert not turned.is_watertight
    assert not turned.is_oriented
    doubled = tetrahedron(FACES + FACES)
    assert not doubled.is_watertight
    assert tetrahedron([f[::-1] for f in FACES]).volume == pytest.approx(-1 / 6)


def test_degenerate_triangles_are_counted_and_compacted_away() -> None:
    faces = np.array([*FACES, [0, 0, 1]])
    assert degenerate_count(tetrahedron(faces)) == 1
    positions = np.vstack([CORNERS, [[9, 9, 9]]])
    mesh = compact(positions, np.arange(5), np.zeros((5, 3)), np.zeros((5, 2)), faces)
    assert degenerate_count(mesh) == 0
    assert len(mesh.positions) == len(mesh.normals) == 4


def test_an_empty_mesh_has_nothing() -> None:
    nothing = tetrahedron(np.zeros((0, 3), int))
    assert nothing.volume == nothing.area == 0.0
    assert not nothing.is_watertight


def test_arrays_are_frozen_copies_and_checked() -> None:
    mesh = tetrahedron()
    with pytest.raises(ValueError, match="read-only"):
        mesh.positions[0] = 1.0
    with pytest.raises(ValueError, match="needed"):
        Mesh(CORNERS, np.arange(4), np.zeros((3, 3)), np.zeros((4, 2)), np.array(FACES))
    with pytest.raises(ValueError, match="outside"):
        tetrahedron([[0, 1, 4]])
