"""Holes by the command line: set, measured, exported, refused in one line."""

import json

import pytest
import trimesh

from app.cli.parser import main
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.file import project_file
from sgb_core.document.model import Document

TUBE = Document(Profile.of([line((40.0, 0.0), (40.0, 100.0))]), name="Cup")
CUP = edits.set_solid(TUBE, kind="vessel", wall=3.0, base=4.0)


@pytest.fixture
def cup(tmp_path):
    path = tmp_path / "cup.sgb"
    project_file.save(CUP, path)
    return path


def test_holes_are_set_measured_and_exported(cup, tmp_path, capsys):
    out = tmp_path / "lantern.sgb"
    text = "slot,width=5,height=20,rows=2,around=12,stagger=no+circle,width=4,rows=1,foot_margin=66"
    assert main(["edit", str(cup), str(out), "set-cut-outs", text]) == 1
    assert capsys.readouterr().err.count("\n") == 1
    assert main(["edit", str(cup), str(out), "set-cut-outs", text.partition("+")[0]]) == 0
    capsys.readouterr()
    assert main(["measure", str(out), "--json"]) == 0
    measured = json.loads(capsys.readouterr().out)
    assert measured["holes"] == 24
    assert measured["material_volume"] < CUP.body().material_volume
    for suffix in ("stl", "obj", "ply", "glb"):
        path = tmp_path / f"lantern.{suffix}"
        assert main(["export", str(out), str(path)]) == 0
        mesh = trimesh.load(path, force="mesh")
        mesh.merge_vertices(merge_tex=True, merge_norm=True)
        assert mesh.is_volume
        assert mesh.euler_number == 2 - 2 * 24
    assert main(["edit", str(out), str(out), "set-cut-outs", "none"]) == 0
    assert project_file.load(out).cut_outs == ()


@pytest.mark.parametrize(
    "text",
    ["disk", "circle,size=4", "circle,rows=0", "circle,width=wide", "circle,stagger=?", ""],
)
def test_what_is_no_pattern_is_one_line(cup, tmp_path, capsys, text):
    assert main(["edit", str(cup), str(tmp_path / "a.sgb"), "set-cut-outs", text]) == 1
    assert capsys.readouterr().err.count("\n") == 1
    assert not (tmp_path / "a.sgb").exists()


def test_step_holds_the_holes(cup, tmp_path):
    pytest.importorskip("OCP")
    out = tmp_path / "lantern.sgb"
    project_file.save(edits.set_cut_out(CUP, rows=1, around=2), out)
    assert main(["export", str(out), str(tmp_path / "a.step")]) == 0
    assert (tmp_path / "a.step").read_text().startswith("ISO-10303-21")


@pytest.mark.parametrize(
    ("pattern", "said"),
    [
        ("star", "'star' is no shape of holes; allowed are circle, ellipse, slot, hexagon, none"),
        ("slot,depth=3", "'depth=3' is no setting of holes; allowed are width=, height=, rows="),
        ("slot,stagger=perhaps", "'stagger=perhaps': allowed is yes or no"),
        ("slot,rows=two", "'rows=two': allowed is a number"),
    ],
)
def test_a_word_that_is_none_of_a_pattern_is_one_line(tmp_path, capsys, pattern, said):
    file = tmp_path / "cup.sgb"
    project_file.save(CUP, file)
    assert main(["edit", str(file), str(tmp_path / "out.sgb"), "set-cut-outs", pattern]) == 1
    told = capsys.readouterr().err
    assert said in told
    assert told.count("\n") == 1
