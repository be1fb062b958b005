"""The ``solve`` command: units, ways, what it prints and refuses."""

from __future__ import annotations

import json

import pytest

from sgb_core.bodies.vessel import vessel_measures
from sgb_core.curves.segment import ShapeParameters
from sgb_core.document import edits
from sgb_core.document.body_measures import mass_in_grams
from sgb_core.document.file import project_file
from tests.app.cli.test_fair import run
from tests.app.helpers import tower


@pytest.fixture
def cup(tmp_path):
    path = tmp_path / "cup.sgb"
    plain = edits.scale(edits.reverse_profile(tower(ShapeParameters(omega=1.0))), 5.0)
    project_file.save(edits.set_solid(plain, kind="vessel", wall=2.0, base=3.0), path)
    return str(path)


def test_targets_with_units_are_reached_together(cup, tmp_path, capsys):
    out = str(tmp_path / "out.sgb")
    status, text, _ = run(
        capsys, "solve", cup, out, "capacity=0.15l", "rim_diameter=5.2cm", "--json"
    )
    assert status == 0
    found, after = json.loads(text), project_file.load(out)
    capacity = vessel_measures(after.surface, after.solid).capacity
    assert capacity == pytest.approx(150_000.0, rel=1e-9)
    assert found["reached"] == pytest.approx(
        {"capacity": 150_000.0, "rim_diameter": 52.0}, rel=1e-9
    )
    assert found["factor"] is None
    before = project_file.load(cup).profile
    for segment, what, old, new in found["moved"]:
        if "." not in what:
            assert getattr(before.segments[segment].shape, what) == old
            assert getattr(after.profile.segments[segment].shape, what) == new


def test_a_mass_by_size_alone(cup, tmp_path, capsys):
    out = str(tmp_path / "out.sgb")
    status, text, _ = run(capsys, "solve", cup, out, "mass=0.2kg", "--by", "all")
    assert status == 0
    assert "factor: " in text
    after = project_file.load(out)
    material = vessel_measures(after.surface, after.solid).material_volume
    assert mass_in_grams(after, material) == pytest.approx(200.0, rel=1e-9)


def test_what_cannot_be_is_one_line(cup, tmp_path, capsys):
    out = tmp_path / "out.sgb"
    status, text, error = run(capsys, "solve", cup, str(out), "volume=5l", "--by", "1.lambda2")
    assert (status, text, error.count("\n")) == (1, "", 1)
    assert "volume 5e+06 is out of reach, the nearest is" in error
    assert "lambda2 of segment 1" in error
    assert not out.exists()
    for wrong in ("volume=5stone", "beauty=3", "height=-4mm", "height"):
        assert run(capsys, "solve", cup, str(out), wrong)[0] == 2
    assert run(capsys, "solve", cup, str(out), "height=5mm", "--by", "luck")[0] == 2
    assert run(capsys, "solve", cup, str(out), "height=5mm", "--by", "9.omega")[0] == 1
