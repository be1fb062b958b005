import numpy as np
import pytest
import trimesh

from sgb_core import exchange
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.segment import ShapeParameters
from sgb_core.document import edits
from sgb_core.document.appearance.model import ColourMap, Layer, LayerKind, MapKind
from sgb_core.document.errors import FileError
from sgb_core.document.model import Document, Revolution
from sgb_core.exchange import format as formats
from sgb_core.exchange.body import exported_mesh
from sgb_core.exchange.csv_profile import csv_lines
from sgb_core.surfaces.variation import Law
from tests.sgb_core.exchange.shapes import chain, spindle


@pytest.mark.parametrize("suffix", exchange.suffixes())
def test_each_suffix_writes_in_any_case(tmp_path, suffix):
    for name in (f"a{suffix}", f"b{suffix.upper()}"):
        exchange.write(spindle(), tmp_path / name, samples=(6, 8))
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix.upper()}").read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"a{suffix}", f"b{suffix.upper()}"]


@pytest.mark.parametrize("name", ["a.xyz", "a", "a.stl.txt", ".stl"])
def test_an_unknown_suffix_names_those_there_are(tmp_path, name):
    with pytest.raises(exchange.ExportError, match=r"suffix.*\.stl \.obj \.ply"):
        exchange.write(spindle(), tmp_path / name)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"tolerance": 0.1, "samples": (4, 8)}, "exclude"),
        ({"tolerance": float("nan")}, "nan"),
        ({"tolerance": float("inf")}, "inf"),
        ({"tolerance": 0.0}, "above 0"),
        ({"tolerance": -1.0}, "above 0"),
        ({"samples": (0, 8)}, "1 or more"),
        ({"samples": (8, 0)}, "1 or more"),
        ({"samples": (10**6, 10**6)}, "triangles"),
        ({"tolerance": 1e-15}, "triangles"),
    ],
)
def test_finenesses_that_are_refused(tmp_path, options, message):
    target = tmp_path / "a.stl"
    target.write_bytes(b"old")
    with pytest.raises(ValueError, match=message):
        exchange.write(spindle(), target, **options)
    assert target.read_bytes() == b"old"
    assert len(list(tmp_path.iterdir())) == 1


def test_samples_give_that_many_triangles(tmp_path):
    exchange.write(
        spindle(revolution=Revolution(sweep_deg=90.0)), tmp_path / "a.stl", samples=(5, 7)
    )
    # Two segments of 5 intervals; the two at the poles have one triangle a column, not two.
    assert len(trimesh.load_mesh(tmp_path / "a.stl").faces) == (2 * 10 - 2) * 7


def test_a_finer_tolerance_is_nearer_to_the_surface(tmp_path):
    counts = []
    for tolerance in (1.0, 0.1, 0.01):
        exchange.write(spindle(), tmp_path / "a.ply", tolerance=tolerance)
        counts.append(len(trimesh.load_mesh(tmp_path / "a.ply").faces))
    assert counts == sorted(set(counts))


def test_csv_follows_the_samples_and_the_tolerance(tmp_path):
    path = tmp_path / "a.csv"

    def written(**options):
        exchange.write(spindle(), path, **options)
        return path.read_text().splitlines()

    assert written() == csv_lines(spindle().profile, 65)
    assert written(samples=(4, 9)) == csv_lines(spindle().profile, 5)
    assert len(written(tolerance=1e-4)) > len(written(tolerance=1e-1))


def test_csv_of_a_varying_profile_is_the_section_at_the_start(tmp_path):
    law = Law("omega", "raised-cosine", 0.25, 1.0)
    document = spindle(variation=(law,), revolution=Revolution(start_deg=40.0))
    exchange.write(document, tmp_path / "a.csv")
    shapes = [ShapeParameters(0.5, 4.0, 2.0, 0.25), ShapeParameters(2.0, 3.5, 0.2, 0.25)]
    points = np.concatenate([s.points[:3] for s in spindle().profile.segments] + [[(0, 60)]])
    expected = csv_lines(chain(points.tolist(), shapes), 65)
    assert (tmp_path / "a.csv").read_text().splitlines() == expected


def test_targets_that_cannot_be_written(tmp_path):
    for target in (tmp_path / "none" / "a.stl", tmp_path / "folder.stl"):
        (tmp_path / "folder.stl").mkdir(exist_ok=True)
        with pytest.raises(FileError, match="cannot write"):
            exchange.write(spindle(), target)
    assert [path.name for path in tmp_path.iterdir()] == ["folder.stl"]


def test_a_body_that_cannot_be_built_is_refused(tmp_path):
    flat = Document(chain([(0, 0), (0, 1), (0, 2), (0, 3)], [ShapeParameters()]))
    for document in (flat, spindle(solid=Solid(BodyKind.VESSEL, wall=40.0))):
        with pytest.raises(ValueError):
            exchange.write(document, tmp_path / "a.stl")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("suffix", [".stl", ".obj", ".ply", ".glb", ".3mf"])
def test_a_mesh_that_is_there_is_not_made_again(tmp_path, monkeypatch, suffix):
    mesh = exported_mesh(spindle(), samples=(6, 8))
    exchange.write(spindle(), tmp_path / f"a{suffix}", samples=(6, 8))
    monkeypatch.setattr(formats, "exported_mesh", None)
    exchange.write(spindle(), tmp_path / f"b{suffix}", samples=(6, 8), mesh=mesh)
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()
    size = exchange.file_size(spindle(), suffix, samples=(6, 8), mesh=mesh)
    assert size == (tmp_path / f"a{suffix}").stat().st_size


LOOKS = {
    "": {},
    "; material": {"material": "metal"},
    "; material and paint": {"drawing": (Layer(LayerKind.BAND, end=0.5),)},
    "; the map's colours": {"map": ColourMap(MapKind.HEIGHT)},
}


@pytest.mark.parametrize("words", LOOKS)
def test_the_files_beside_an_obj_are_those_it_is_said_to_have(tmp_path, words):
    document = edits.set_appearance(spindle(), **LOOKS[words])
    said = exchange.format_for("a.obj").contents(exchange.Request(document))
    assert said.partition(", in ")[0] == f"Exact normals, texture coordinates{words}"
    exchange.write(document, tmp_path / "a.obj", samples=(6, 8))
    written = {path.suffix for path in tmp_path.iterdir()} - {".obj"}
    assert {suffix for suffix in (".mtl", ".png") if suffix in said} == written


def test_an_obj_whose_material_cannot_be_written_keeps_the_old_one(tmp_path):
    path = tmp_path / "a.obj"
    path.write_bytes(b"old")
    (tmp_path / "a.mtl").mkdir()
    with pytest.raises(FileError):
        exchange.write(edits.set_appearance(spindle(), material="metal"), path, samples=(6, 8))
    assert path.read_bytes() == b"old"
    assert sorted(each.name for each in tmp_path.iterdir()) == ["a.mtl", "a.obj"]
