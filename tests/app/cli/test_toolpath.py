"""The ``toolpath`` and ``printers`` commands: what they write, print and refuse."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

from app.cli.parser import main
from sgb_core.document.file import project_file
from tests.sgb_core.toolpaths.printing import chain

KEYS = {
    "points",
    "length",
    "extruded_volume",
    "material_volume",
    "time_s",
    "layers",
    "largest_sideways_step",
    "e_per_mm3",
    "bounds",
    "warnings",
}


@pytest.fixture
def cup(tmp_path):
    path = tmp_path / "cup.sgb"
    project_file.save(chain((25.0, 0.0), (30.0, 40.0)), path)
    return path


def test_a_path_is_written_and_told(cup, tmp_path, capsys) -> None:
    out = tmp_path / "cup.gcode"
    assert main(["toolpath", str(cup), str(out), "--json", "--walls", "1", "--chord", "0.1"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert set(told) >= KEYS
    assert told["bounds"][1][2] == pytest.approx(40.0)
    text = out.read_text()
    assert ";TYPE:WALL" in text
    assert f";LAYER:{told['layers'] - 1}" in text
    assert f";LAYER:{told['layers']}\n" not in text
    assert main(["toolpath", str(cup), str(out), "--printer", "clay-auger", "--as", "fired"]) == 0
    assert "time:" in capsys.readouterr().out


def test_nothing_pushed_out_with_a_bead_of_nothing(cup, tmp_path, capsys) -> None:
    out = tmp_path / "cup.gcode"
    assert main(["toolpath", str(cup), str(out), "--bead", "0", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["extruded_volume"] == 0.0


def test_the_printers_are_listed_and_one_of_ones_own_is_taken(cup, tmp_path, capsys) -> None:
    assert main(["printers"]) == 0
    listed = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in listed][:2] == ["generic-plastic", "generic-klipper"]
    assert main(["printers", "generic-clay"]) == 0
    own = json.loads(capsys.readouterr().out)
    own |= {"name": "mine", "title": "My own"}
    path = tmp_path / "mine.json"
    path.write_text(json.dumps(own))
    out = tmp_path / "cup.gcode"
    assert main(["toolpath", str(cup), str(out), "--printer", str(path)]) == 0
    assert "My own" in out.read_text()


@pytest.mark.parametrize(
    ("words", "status", "said"),
    [
        (["--printer", "none"], 1, "no printer 'none'; allowed is generic-plastic"),
        (["--printer", "none.json"], 1, "none.json: No such file"),
        (
            ["--layer", "9"],
            1,
            "a layer of 9 mm is beyond Plastic, Marlin; allowed is 0.05 to 0.32 mm",
        ),
        (["--layer", "-1"], 2, "allowed is"),
        (["--bead", "nan"], 2, "allowed is"),
        (["--walls", "0"], 2, "allowed is"),
        (["--walls", "99"], 1, "walls is 99; allowed is"),
        (["--as", "raw"], 2, "--as"),
    ],
)
def test_what_cannot_be_is_one_line_and_no_file(words, status, said, cup, tmp_path, capsys) -> None:
    out = tmp_path / "cup.gcode"
    assert main(["toolpath", str(cup), str(out), *words]) == status
    err = capsys.readouterr().err
    assert said in err
    assert err.count("\n") == 1
    assert not out.exists()


def test_the_project_itself_is_not_replaced(cup, capsys) -> None:
    assert main(["toolpath", str(cup), str(cup)]) == 1
    assert "the project itself" in capsys.readouterr().err


def test_neither_qt_nor_vtk_is_loaded(cup, tmp_path) -> None:
    code = (
        "import sys; from app.cli.parser import main; "
        f"main(['toolpath', {str(cup)!r}, {str(tmp_path / 'a.gcode')!r}]); "
        "assert not [m for m in sys.modules if m.split('.')[0] in ('PySide6', 'vtkmodules')]"
    )
    subprocess.run([sys.executable, "-c", code], check=True, capture_output=True)
