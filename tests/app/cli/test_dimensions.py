"""The verbs ``dimension``, ``lock`` and ``unlock``, and what other verbs do with locks."""

from __future__ import annotations

import json

import pytest

from sgb_core.document.file import project_file
from tests.app.cli.test_fair import run
from tests.sgb_core.design.locks.samples import pot


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "pot.sgb"
    project_file.save(pot(4), path)
    return str(path)


def edit(capsys, file: str, *words: str) -> str:
    status, out, _ = run(capsys, "edit", file, file, *words)
    assert status == 0
    return out


def test_a_lock_holds_while_another_dimension_is_given_a_value(file, capsys):
    edit(capsys, file, "lock", "capacity")
    edit(capsys, file, "dimension", "rim_diameter", "8.5cm")
    edit(capsys, file, "set", "1", "omega", "0.4")
    status, out, _ = run(capsys, "measure", file, "--json")
    assert status == 0
    capacity, rim = json.loads(out)["dimensions"]
    assert (capacity["kind"], capacity["locked"]) == ("capacity", True)
    assert capacity["value"] == pytest.approx(json.loads(out)["capacity"], rel=1e-9)
    assert project_file.load(file).dimensions[0].value == pytest.approx(capacity["value"], rel=1e-8)
    # The rim only tells: it was 85 until the slider moved.
    assert (rim["locked"], rim["kind"]) == (False, "rim_diameter")
    assert json.loads(out)["warnings"] == []
    checked = run(capsys, "check", file)[1]
    assert "lock        Capacity" in checked
    assert "dimension   Rim diameter" in checked


@pytest.mark.parametrize(
    "name",
    ["diameter_at:40", "point:1.3", "distance:0.0-3.3", "angle:1.3-1.2", "radius:2@0.5", "joint:1"],
)
def test_dimensions_with_places_are_locked_and_unlocked(file, capsys, name):
    edit(capsys, file, "lock", name)
    assert [each.locked for each in project_file.load(file).dimensions] == [True]
    edit(capsys, file, "unlock", name)
    assert [each.locked for each in project_file.load(file).dimensions] == [False]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("lock", "girth"), "the dimension is 'girth'; allowed is height"),
        (("lock", "point"), "allowed is point:SEGMENT.POINT"),
        (("lock", "point:9.0"), "this object has no such dimension"),
        (("lock", "height:3"), "allowed is height"),
        (("lock", "fill_line"), "this object has no such dimension"),
        (("dimension", "height", "3kg"), "Height is '3kg'; allowed is a number with mm"),
        (("dimension", "height", "-3"), "dimension.value is -3.0; allowed is a positive number"),
        (("dimension", "joint:1", "3"), "have no value"),
    ],
)
def test_what_is_not_there_is_one_line(file, tmp_path, capsys, words, said):
    out = tmp_path / "out.sgb"
    status, _, error = run(capsys, "edit", file, str(out), *words)
    assert (status, out.exists()) == (1, False)
    assert said in error
    assert error.count("\n") == 1


def test_a_locked_whole_is_not_scaled(file, tmp_path, capsys):
    edit(capsys, file, "lock", "height")
    out = tmp_path / "out.sgb"
    status, _, error = run(capsys, "edit", file, str(out), "scale", "2")
    assert (status, out.exists()) == (1, False)
    assert "Height 150 mm is locked and cannot hold with this" in error
