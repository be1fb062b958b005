import io

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings

from sgb_core.exchange import ply
from sgb_core.exchange.body import exported_mesh
from sgb_core.exchange.ply import position_normals, write_ply
from tests.sgb_core.exchange.shapes import closed_documents, spindle, tube


def read_back(mesh):
    stream = io.BytesIO()
    write_ply(mesh, stream)
    stream.seek(0)
    return trimesh.load(stream, file_type="ply", process=False)


@settings(max_examples=15)
@given(closed_documents())
def test_closed_bodies_are_watertight_as_stored(document):
    mesh = exported_mesh(document, samples=(10, 20))
    read = read_back(mesh)
    assert read.is_watertight
    assert read.is_winding_consistent
    assert read.volume == pytest.approx(mesh.volume, rel=1e-9)


def test_positions_are_stored_in_full():
    mesh = exported_mesh(spindle())
    read = read_back(mesh)
    assert np.array_equal(read.vertices, mesh.positions)
    assert np.array_equal(read.faces, mesh.faces)


def test_normals_are_the_surface_s_own():
    mesh = exported_mesh(tube(), samples=(3, 64))
    normals = position_normals(mesh, 0, len(mesh.positions))
    outward = mesh.positions * [1, 1, 0] / 20.0
    assert np.abs(np.abs(np.einsum("ij,ij->i", normals, outward)) - 1).max() < 1e-9
    assert np.allclose(read_back(mesh).vertex_normals, normals, atol=1e-6)


def test_at_a_pole_the_normals_mean_is_the_axis():
    mesh = exported_mesh(spindle(), samples=(16, 32))
    top = mesh.positions[:, 2].argmax()
    assert position_normals(mesh, 0, len(mesh.positions))[top] == pytest.approx([0, 0, 1], abs=1e-9)


def test_normals_a_part_at_a_time_are_those_of_all(monkeypatch):
    mesh = exported_mesh(spindle())
    whole = io.BytesIO()
    write_ply(mesh, whole)
    monkeypatch.setattr(ply, "_BLOCK", 7)
    parts = io.BytesIO()
    write_ply(mesh, parts)
    assert parts.getvalue() == whole.getvalue()
