import io
import zipfile
from xml.etree import ElementTree

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings

from sgb_core.document.model import Unit
from sgb_core.exchange.body import exported_mesh
from sgb_core.exchange.threemf import write_threemf
from tests.sgb_core.exchange.shapes import closed_documents, spindle, tube

CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


def written(mesh, unit=Unit.MM, name="A pot") -> bytes:
    stream = io.BytesIO()
    write_threemf(mesh, stream, unit=unit, name=name)
    return stream.getvalue()


def model_of(data: bytes) -> ElementTree.Element:
    with zipfile.ZipFile(io.BytesIO(data)) as package:
        assert package.testzip() is None
        assert package.namelist() == ["[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"]
        for name in package.namelist()[:2]:
            ElementTree.fromstring(package.read(name))
        return ElementTree.fromstring(package.read("3D/3dmodel.model"))


@settings(max_examples=10)
@given(closed_documents())
def test_the_model_holds_the_welded_mesh(document):
    mesh = exported_mesh(document, samples=(8, 12))
    model = model_of(written(mesh))
    vertices = [[float(v.get(k)) for k in "xyz"] for v in model.iter(f"{CORE}vertex")]
    faces = [[int(t.get(f"v{k}")) for k in (1, 2, 3)] for t in model.iter(f"{CORE}triangle")]
    assert np.allclose(vertices, mesh.positions, rtol=0, atol=1e-10 * np.abs(mesh.positions).max())
    assert np.array_equal(faces, mesh.faces)
    assert trimesh.Trimesh(vertices, faces, process=False).is_watertight


@pytest.mark.parametrize(
    ("unit", "stated"), [(Unit.MM, "millimeter"), (Unit.CM, "centimeter"), (Unit.IN, "inch")]
)
def test_the_unit_is_stated(unit, stated):
    assert model_of(written(exported_mesh(spindle()), unit)).get("unit") == stated


def test_an_open_surface_is_no_model():
    for document, kind in ((tube(), "surface"), (spindle(), "model")):
        model = model_of(written(exported_mesh(document)))
        assert next(model.iter(f"{CORE}object")).get("type") == kind


def test_any_name():
    model = model_of(written(exported_mesh(spindle()), name='a <b> & "c"\x01\n é'))
    assert next(model.iter(f"{CORE}object")).get("name") == 'a <b> & "c"   é'


def test_the_same_mesh_gives_the_same_bytes():
    mesh = exported_mesh(spindle())
    assert written(mesh) == written(mesh)


def test_the_strict_reader_has_no_warning(tmp_path):
    lib3mf = pytest.importorskip("lib3mf")
    path = tmp_path / "spindle.3mf"
    mesh = exported_mesh(spindle())
    path.write_bytes(written(mesh))
    model = lib3mf.get_wrapper().CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(str(path))
    assert reader.GetWarningCount() == 0
    objects = model.GetMeshObjects()
    assert objects.MoveNext()
    read = objects.GetCurrentMeshObject()
    assert read.GetTriangleCount() == len(mesh.triangles)
    assert read.IsManifoldAndOriented()
