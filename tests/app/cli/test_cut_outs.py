"""Holes by the command line: set, measured, exported, refused in one line."""

import json

import numpy as np
import pytest
import trimesh
from PIL import Image

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


def test_text_and_pictures_are_cut_by_name_and_from_a_file(cup, tmp_path, capsys):
    out, picture = tmp_path / "lantern.sgb", tmp_path / "dots.png"
    grey = np.full((60, 120), 255, np.uint8)
    grey[15:45, 20:50] = grey[15:45, 70:100] = 0
    Image.fromarray(grey).save(picture)
    text = "text,text=Ob,font=serif-bold,height=15,bridge=1,rim_margin=60"
    text += f"+picture,picture={picture},width=40,around=2,foot_margin=45"
    assert main(["edit", str(cup), str(out), "set-cut-outs", text]) == 0
    kept = project_file.load(out)
    assert [pattern.text for pattern in kept.cut_outs] == ["Ob", "LIGHT"]
    assert [kept.cut_outs[1].picture] == [each.name for each in kept.appearance.pictures]
    capsys.readouterr()
    assert main(["measure", str(out), "--json"]) == 0
    # Twice the O and the b in two halves each, and two squares in two places.
    assert json.loads(capsys.readouterr().out)["holes"] == 2 * 4 + 2 * 2
    assert main(["edit", str(out), str(out), "set-cut-outs", "picture,picture=lotus,bridge=1"]) == 0
    assert project_file.load(out).appearance.pictures == ()


@pytest.mark.parametrize(
    ("pattern", "said"),
    [
        ("star", "'star' is no shape of holes; allowed are circle, ellipse, slot, hexagon, text, "),
        ("slot,depth=3", "'depth=3' is no setting of holes; allowed are width=, height=, rows="),
        ("slot,stagger=perhaps", "'stagger=perhaps': allowed is yes or no"),
        ("text,text=O,bridge=0", "would fall out"),
        ("text,font=fancy", "'font=fancy': allowed is sans or sans-bold"),
        ("picture,picture=no.png", "No such file"),
        ("picture,picture=nothing", "texture"),
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
