"""Layers of paint from the command line: text in a font and all others, raised too."""

import numpy as np
import pytest

from app.cli.parser import main
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document.appearance.model import Layer, LayerKind
from sgb_core.document.edits import usual_layer
from sgb_core.document.file import project_file
from sgb_core.document.model import Document

CUP = Document(Profile.of([line((30.0, 0.0), (30.0, 60.0))]))


@pytest.fixture
def cup(tmp_path):
    path = tmp_path / "cup.sgb"
    project_file.save(CUP, path)
    return path


def test_raised_text_is_painted_and_stands_out(cup, tmp_path):
    out = tmp_path / "out.sgb"
    words = "text,text=LIGHT,font=serif-bold,from=0.4,to=0.6,count=2,color=#204080,relief=1.5"
    assert main(["edit", str(cup), str(out), "add-layer", words]) == 0
    document = project_file.load(out)
    assert document.appearance.drawing == (
        Layer(
            LayerKind.TEXT,
            "#204080",
            0.4,
            0.6,
            count=2,
            text="LIGHT",
            font="serif-bold",
            relief=1.5,
        ),
    )
    positions = document.body().mesh().positions
    assert np.hypot(*positions[:, :2].T).max() == pytest.approx(31.5, abs=0.05)


@pytest.mark.parametrize("kind", LayerKind)
def test_every_kind_begins_as_in_the_window(cup, tmp_path, kind):
    out = tmp_path / "out.sgb"
    assert main(["edit", str(cup), str(out), "add-layer", kind]) == 0
    assert project_file.load(out).appearance.drawing == (usual_layer(kind),)


def test_lists_are_written_with_a_plus(cup, tmp_path):
    out = tmp_path / "out.sgb"
    words = "gradient,stops=0:#000000+0.5:#ff0000+1:#ffffff"
    assert main(["edit", str(cup), str(out), "add-layer", words]) == 0
    (layer,) = project_file.load(out).appearance.drawing
    assert layer.stops == ((0.0, "#000000"), (0.5, "#ff0000"), (1.0, "#ffffff"))


def test_a_layer_lies_over_the_others_and_is_removed(cup, tmp_path, capsys):
    out = tmp_path / "out.sgb"
    assert main(["edit", str(cup), str(out), "add-layer", "band"]) == 0
    assert main(["edit", str(out), str(out), "add-layer", "rings,count=5"]) == 0
    assert [each.kind for each in project_file.load(out).appearance.drawing] == ["band", "rings"]
    assert main(["edit", str(out), str(out), "remove-layer", "0"]) == 0
    assert [each.kind for each in project_file.load(out).appearance.drawing] == ["rings"]
    assert main(["edit", str(out), str(out), "remove-layer", "1"]) == 1
    assert "there is no layer 1" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("dots", "'dots' says nothing of a layer; allowed are gradient, band"),
        ("band,height=3", "'height=3' says nothing of a layer; allowed are color=, from=, to="),
        ("band,from", "'from' says nothing of a layer"),
        ("band,from=low", "allowed are from= and a number"),
        ("band,from=2", "from"),
        ("text,font=gothic", "font"),
        ("segments,segments=0+x", "allowed are segments= and a number"),
        ("gradient,stops=0:#000000", "stops"),
    ],
)
def test_what_is_no_layer_is_one_line(cup, tmp_path, capsys, words, said):
    out = tmp_path / "out.sgb"
    assert main(["edit", str(cup), str(out), "add-layer", words]) == 1
    told = capsys.readouterr().err
    assert said in told
    assert told.count("\n") == 1
    assert not out.exists()
