import io

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings

from sgb_core.exchange.body import exported_mesh
from sgb_core.exchange.obj import write_obj
from tests.sgb_core.exchange.shapes import closed_documents, spindle


def text_of(mesh) -> str:
    stream = io.BytesIO()
    write_obj(mesh, stream)
    return stream.getvalue().decode("ascii")


def parsed(text: str):
    rows = {"v": [], "vt": [], "vn": [], "f": []}
    for line in text.splitlines():
        keyword, *words = line.split(" ")
        if keyword in rows:
            assert "" not in words, "one space between numbers"
            rows[keyword].append(words)
    corners = np.array([[word.split("/") for word in row] for row in rows.pop("f")], dtype=int)
    return {name: np.array(values, dtype=float) for name, values in rows.items()}, corners - 1


@settings(max_examples=15)
@given(closed_documents())
def test_position_indices_are_the_welded_mesh(document):
    mesh = exported_mesh(document, samples=(8, 12))
    rows, corners = parsed(text_of(mesh))
    assert np.array_equal(corners[..., 0], mesh.faces)
    assert np.array_equal(corners[..., 1], mesh.triangles)
    assert np.array_equal(corners[..., 2], mesh.triangles)
    size = np.abs(mesh.positions).max()
    assert np.abs(rows["v"] - mesh.positions).max() <= 1e-10 * size
    read = trimesh.Trimesh(rows["v"], corners[..., 0], process=False)
    assert read.is_watertight
    assert read.volume == pytest.approx(mesh.volume, rel=1e-8)


def test_texture_coordinates_and_normals():
    mesh = exported_mesh(spindle(), samples=(20, 30))
    rows, _ = parsed(text_of(mesh))
    assert np.abs(rows["vt"] - mesh.uv).max() < 1e-6
    assert np.abs(rows["vn"] - mesh.normals).max() < 1e-6


def test_trimesh_reads_it():
    mesh = exported_mesh(spindle(), samples=(20, 30))
    read = trimesh.load(io.StringIO(text_of(mesh)), file_type="obj")
    read.merge_vertices(merge_tex=True, merge_norm=True)
    assert read.is_watertight
    assert read.volume == pytest.approx(mesh.volume, rel=1e-8)
