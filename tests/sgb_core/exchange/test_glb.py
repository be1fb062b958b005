import io
import json
import struct

import numpy as np
import pytest
import trimesh

from sgb_core.document.model import Unit
from sgb_core.exchange.body import exported_mesh
from sgb_core.exchange.glb import write_glb
from tests.sgb_core.exchange.shapes import spindle, tube


def glb(document, unit=Unit.MM, name="A pot"):
    mesh = exported_mesh(document, samples=(12, 24))
    stream = io.BytesIO()
    write_glb(mesh, stream, unit=unit, name=name)
    return mesh, stream.getvalue()


def parts(data: bytes):
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<II", data, 12)
    assert kind == 0x4E4F534A
    assert size % 4 == 0
    binary_size, kind = struct.unpack_from("<II", data, 20 + size)
    assert kind == 0x004E4942
    assert binary_size % 4 == 0
    binary = data[28 + size :]
    assert len(binary) == binary_size
    return json.loads(data[20 : 20 + size]), binary


def accessor(scene, binary, index):
    info = scene["accessors"][index]
    view = scene["bufferViews"][info["bufferView"]]
    dtype = {5126: "<f4", 5125: "<u4"}[info["componentType"]]
    columns = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[info["type"]]
    raw = binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    return np.frombuffer(raw, dtype).reshape(info["count"], columns)


def test_every_array_is_the_mesh_s():
    mesh, data = glb(spindle())
    scene, binary = parts(data)
    positions, normals, uv, indices = (accessor(scene, binary, k) for k in range(4))
    assert np.allclose(positions, mesh.positions[mesh.corner_positions], rtol=1e-6, atol=1e-5)
    assert np.abs(np.linalg.norm(normals, axis=1) - 1).max() < 1e-6
    assert np.allclose(uv[:, 0], mesh.uv[:, 0], atol=1e-6)
    assert np.allclose(uv[:, 1], 1 - mesh.uv[:, 1], atol=1e-6)
    assert np.array_equal(indices.reshape(-1, 3), mesh.triangles)
    # The limits must be those of the stored numbers, bit by bit.
    assert scene["accessors"][0]["min"] == positions.min(axis=0).tolist()
    assert scene["accessors"][0]["max"] == positions.max(axis=0).tolist()


@pytest.mark.parametrize(("unit", "metres"), [(Unit.MM, 0.06), (Unit.CM, 0.6), (Unit.IN, 1.524)])
def test_it_stands_upright_and_is_as_large_as_it_says(unit, metres):
    _, data = glb(spindle(unit=unit), unit)
    read = trimesh.load(io.BytesIO(data), file_type="glb").to_geometry()
    assert read.extents[1] == pytest.approx(metres, rel=1e-5)
    assert read.bounds[0][1] == pytest.approx(0.0, abs=1e-6)


def test_welded_it_is_watertight_and_outward():
    mesh, data = glb(spindle())
    read = trimesh.load(io.BytesIO(data), file_type="glb").to_geometry()
    read.merge_vertices(merge_tex=True, merge_norm=True)
    assert read.is_watertight
    assert read.volume == pytest.approx(mesh.volume * 1e-9, rel=1e-4)


def test_only_open_surfaces_show_their_inside():
    assert parts(glb(tube())[1])[0]["materials"][0]["doubleSided"] is True
    assert parts(glb(spindle())[1])[0]["materials"][0]["doubleSided"] is False


def test_any_name():
    name = 'Gefäß "№ 1"\n\\'
    scene, _ = parts(glb(spindle(), name=name)[1])
    assert scene["nodes"][0]["name"] == name
