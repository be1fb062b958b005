"""Relief by the command line: set, measured, exported, refused in one line."""

import json

import pytest
import trimesh

from app.cli.parser import main
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.appearance.model import Layer, LayerKind, Texture
from sgb_core.document.file import project_file
from sgb_core.document.model import Document

TUBE = Document(Profile.of([line((40.0, 0.0), (40.0, 100.0))]), name="Cup")
CUP = edits.set_appearance(
    edits.set_solid(TUBE, kind="vessel", wall=3.0, base=4.0),
    drawing=(Layer(LayerKind.BAND, start=0.4, end=0.6),),
    textures=(Texture("lotus", repeat=(4.0, 0.0)),),
)


@pytest.fixture
def cup(tmp_path):
    path = tmp_path / "cup.sgb"
    project_file.save(CUP, path)
    return path


def test_a_relief_is_set_measured_and_exported(cup, tmp_path, capsys):
    out = tmp_path / "raised.sgb"
    assert main(["edit", str(cup), str(out), "set-relief", "layer-0", "depth=-1,edge=2"]) == 0
    assert main(["measure", str(out), "--json"]) == 0
    measured = json.loads(capsys.readouterr().out)
    whole = CUP.body()
    assert measured["wall_min"] == pytest.approx(2.0, abs=1e-6)
    assert measured["capacity"] == whole.capacity
    added = measured["material_volume"] - whole.material_volume
    assert added == pytest.approx(measured["relief_volume"], rel=1e-9)
    assert 0.0 < measured["relief_within"] < 1.0
    assert measured["warnings"] == []
    assert main(["measure", str(out)]) == 0
    told = capsys.readouterr().out
    assert "of it relief" in told
    assert "of a mesh within" in told
    for suffix in ("stl", "obj", "ply", "glb"):
        path = tmp_path / f"raised.{suffix}"
        assert main(["export", str(out), str(path)]) == 0
        mesh = trimesh.load(path, force="mesh")
        mesh.merge_vertices(merge_tex=True, merge_norm=True)
        assert mesh.is_volume
        # GLB is in metres.
        scale = 1e9 if suffix == "glb" else 1.0
        assert scale * mesh.volume == pytest.approx(measured["material_volume"], rel=5e-3)
    assert main(["export", str(out), str(tmp_path / "a.step")]) == 1
    assert "without relief" in capsys.readouterr().err


def test_a_texture_is_raised_by_its_dark_parts(cup, tmp_path, capsys):
    out = tmp_path / "raised.sgb"
    settings = "depth=1,edge=1.5,raised=dark"
    assert main(["edit", str(cup), str(out), "set-relief", "texture-0", settings]) == 0
    texture = project_file.load(out).appearance.textures[0]
    assert (texture.relief, texture.edge, str(texture.raised)) == (1.0, 1.5, "dark")
    assert main(["measure", str(out), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["relief_volume"] > 1000.0


@pytest.mark.parametrize(
    ("part", "settings", "said"),
    [
        ("band", "depth=1", "'band' says nothing of a relief; allowed are layer-0, texture-0"),
        ("layer-0", "height=1", "'height=1' says nothing of a relief; allowed are depth=, edge="),
        ("layer-0", "depth=deep", "allowed are depth= and a number"),
        ("texture-0", "raised=all", "allowed are raised=light, raised=dark"),
        ("layer-3", "depth=1", "there is no layer 3"),
        ("layer-0", "edge=-1", "edge"),
        ("layer-0", "depth=-3", "pierces the wall of 3"),
    ],
)
def test_what_is_no_relief_is_one_line(cup, tmp_path, capsys, part, settings, said):
    out = tmp_path / "out.sgb"
    assert main(["edit", str(cup), str(out), "set-relief", part, settings]) == 1
    told = capsys.readouterr().err
    assert said in told
    assert told.count("\n") == 1
    assert not out.exists()


def test_material_that_is_solved_for_is_what_is_measured(cup, tmp_path, capsys):
    raised, out = tmp_path / "raised.sgb", tmp_path / "out.sgb"
    assert main(["edit", str(cup), str(raised), "set-relief", "texture-0", "depth=1,edge=3"]) == 0
    assert main(["measure", str(raised), "--json"]) == 0
    wanted = 1.1 * json.loads(capsys.readouterr().out)["material_volume"]
    assert main(["solve", str(raised), str(out), f"material={wanted}", "--by", "height"]) == 0
    capsys.readouterr()
    assert main(["measure", str(out), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["material_volume"]
    assert found == pytest.approx(wanted, rel=2e-4)
