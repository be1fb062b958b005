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
    assert "volume 5000 ml is out of reach, the nearest is" in error
    assert "lambda2 of segment 1" in error
    assert not out.exists()
    for wrong in ("volume=5stone", "beauty=3", "height=-4mm", "height"):
        assert run(capsys, "solve", cup, str(out), wrong)[0] == 2
    assert run(capsys, "solve", cup, str(out), "height=5mm", "--by", "luck")[0] == 2
    assert run(capsys, "solve", cup, str(out), "height=5mm", "--by", "9.omega")[0] == 1


def test_locks_hold_and_more_can_be_kept(cup, tmp_path, capsys):
    locked, out = str(tmp_path / "locked.sgb"), str(tmp_path / "out.sgb")
    assert run(capsys, "edit", cup, locked, "lock", "rim_diameter")[0] == 0
    before = project_file.load(cup).profile
    status, _, _ = run(
        capsys, "solve", locked, out, "capacity=160ml", "--keep", "height,foot_diameter"
    )
    after = project_file.load(out).profile
    assert status == 0
    low, high = (profile.bounds() for profile in (before, after))
    assert high[1][1] - high[0][1] == pytest.approx(low[1][1] - low[0][1], rel=1e-9)
    for end in ((0, 0), (-1, 3)):
        there, here = before.segments[end[0]].points[end[1]], after.segments[end[0]].points[end[1]]
        assert here[0] == pytest.approx(there[0], rel=1e-9)
    assert run(capsys, "solve", cup, out, "height=5mm", "--keep", "beauty")[0] == 2
