from __future__ import annotations

import json
from math import pi

import pytest
import trimesh

from app.cli.parser import main
from tests.app.cli.files import write_project

TUBE = [{"points": [[20, 0], [20, 20], [20, 40], [20, 60]]}]
VESSEL = {"kind": "vessel", "wall": 3, "side": "inside", "base": 4, "rim": "flat"}


def measured(capsys, path: str) -> dict:
    assert main(["measure", path, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_a_vessel_is_measured_as_the_worked_example(tmp_path, capsys):
    found = measured(capsys, write_project(tmp_path / "a.sgb", TUBE, solid=VESSEL))
    assert found["capacity"] == pytest.approx(pi * 17**2 * 56, rel=1e-12)
    assert found["material_volume"] == pytest.approx(pi * (400 * 60 - 17**2 * 56), rel=1e-12)
    assert found["wall_min"] == 3
    assert found["volume"] == pytest.approx(pi * 400 * 60, rel=1e-12)
    assert found["warnings"] == []


def test_a_fill_line_below_the_rim_is_set_and_measured(tmp_path, capsys):
    cup = write_project(tmp_path / "a.sgb", TUBE, solid=VESSEL)
    filled = str(tmp_path / "b.sgb")
    assert main(["edit", cup, filled, "fill", "10", "--below-rim"]) == 0
    capsys.readouterr()
    found = measured(capsys, filled)
    assert found["fill_height"] == 50
    assert found["filled"] == pytest.approx(pi * 17**2 * 46, rel=1e-12)
    assert main(["measure", filled]) == 0
    assert "to the line at 50 mm" in capsys.readouterr().out
    assert main(["edit", filled, filled, "fill", "none"]) == 0
    capsys.readouterr()
    assert "filled" not in measured(capsys, filled)


def test_a_bare_surface_has_no_such_keys_and_a_filled_one_no_capacity(tmp_path, capsys):
    bare = measured(capsys, write_project(tmp_path / "a.sgb", TUBE))
    assert not {"capacity", "material_volume", "wall_min"} & set(bare)
    filled = measured(capsys, write_project(tmp_path / "b.sgb", TUBE, solid={"kind": "filled"}))
    assert filled["material_volume"] == pytest.approx(pi * 400 * 60, rel=1e-12)
    assert "capacity" not in filled


def test_a_closed_hollow_body_has_no_capacity(tmp_path, capsys):
    found = measured(capsys, write_project(tmp_path / "a.sgb", solid={"kind": "vessel"}))
    assert found["capacity"] is None
    assert found["material_volume"] > 0


def test_a_body_that_cannot_be_made_measures_null_and_says_why(tmp_path, capsys):
    path = write_project(tmp_path / "a.sgb", TUBE, solid={**VESSEL, "wall": 25})
    found = measured(capsys, path)
    assert (found["capacity"], found["material_volume"], found["wall_min"]) == (None, None, None)
    assert "no cavity is left" in found["warnings"][-1]
    assert main(["check", path]) == 0
    assert "no cavity is left" in capsys.readouterr().out
    assert main(["measure", path]) == 0
    assert "none: no body can be made" in capsys.readouterr().out
    assert main(["export", path, str(tmp_path / "a.stl")]) == 1
    said = capsys.readouterr().err
    assert "no cavity is left" in said
    assert said.count("\n") == 1
    assert not (tmp_path / "a.stl").exists()


def test_the_table_names_capacity_material_and_wall(tmp_path, capsys):
    assert main(["measure", write_project(tmp_path / "a.sgb", TUBE, solid=VESSEL)]) == 0
    text = capsys.readouterr().out
    assert "capacity            50843.536 mm³ = 50.843536 ml" in text
    assert "smallest wall       3 mm" in text


@pytest.mark.parametrize("suffix", ["stl", "ply", "3mf", "glb", "obj"])
@pytest.mark.parametrize("sweep", [360, 200])
def test_vessels_are_closed_in_every_format(tmp_path, capsys, suffix: str, sweep: float):
    solid = {**VESSEL, "rim": "round", "drain_hole": 6}
    path = write_project(
        tmp_path / "a.sgb", TUBE, solid=solid, revolution={"axis": "z", "sweep_deg": sweep}
    )
    out = tmp_path / f"a.{suffix}"
    assert main(["export", path, str(out), "--tolerance", "0.05"]) == 0
    if suffix == "3mf":
        pytest.importorskip("lxml")
    found = trimesh.load_mesh(out, process=False)
    # Rendering corners share a position: welded by it.
    found.merge_vertices(merge_tex=True, merge_norm=True)
    assert found.is_watertight
    assert found.is_winding_consistent
    scale = 1e-9 if suffix == "glb" else 1.0
    volume = measured(capsys, path)["material_volume"]
    assert found.volume == pytest.approx(scale * volume, rel=0.01)
